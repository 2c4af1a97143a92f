//! What can be said on the command line.

use std::path::PathBuf;

use clap::{Args as Group, Parser, Subcommand, ValueEnum};

/// Simulate and design cageless ball bearings with a discrete raceway.
#[derive(Debug, Parser)]
#[command(name = "cageless", version, max_term_width = 100, after_help = EXIT_CODES)]
pub struct Args {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Vector instructions to compute with, at most those of this processor. Results have
    /// the same bits with all of them.
    #[arg(long, value_enum, global = true)]
    pub isa: Option<Isa>,
}

/// Vector instructions.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Isa {
    /// What every processor of this kind has.
    Baseline,
    /// 256-bit vectors.
    Avx2,
    /// 512-bit vectors.
    Avx512,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 2 bad input; 3 the run left the physical range or did \
    not converge; 1 anything else.\nResults go to stdout, progress to stderr.";

/// One task.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Regenerate every table and figure of Zhao 2022 beside the paper's numbers.
    Reproduce(Reproduce),
    /// Print a commented case file.
    New(New),
    /// Validate a case.
    Check(CaseArgs),
    /// Static equilibrium: ring displacement, load per ball, contact stress.
    Static(CaseArgs),
    /// Constraints, β0, the lC–θ curve, critical gap, verdict and recommendation.
    Design(CaseArgs),
    /// Simulate a case.
    Run(RunArgs),
}

/// `reproduce`.
#[derive(Debug, Group)]
pub struct Reproduce {
    /// Folder for the report and its numbers.
    #[arg(long, value_name = "DIR", default_value = "out/reproduce")]
    pub out: PathBuf,
    /// Print all numbers as one JSON document.
    #[arg(long)]
    pub json: bool,
}

/// `new`.
#[derive(Debug, Group)]
pub struct New {
    /// Without a discrete raceway.
    #[arg(long)]
    pub conventional: bool,
}

/// `run`.
#[derive(Debug, Group)]
pub struct RunArgs {
    /// Case, output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Repeat the run from turned starts and at half the step, and say which numbers are
    /// converged, which are statistical and which the step biases: 17 times the work.
    #[arg(long)]
    pub verify: bool,
}

/// Whatever works on a case.
#[derive(Debug, Group)]
pub struct CaseArgs {
    /// Case file (TOML); `cageless new` prints one.
    #[arg(value_name = "CASE")]
    pub case: PathBuf,
    /// Replace a value of the case file; may be repeated.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
    /// Folder for files.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
