//! Command-line arguments.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use cageless_study::THREADS_MAX;
use cageless_study::sweep::Shard;
use clap::{Args as Group, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

mod cad;
mod case;
mod tolerances;

pub use cad::{ExportArgs, MeasureArgs};
pub use case::{CaseArgs, Output};
pub use tolerances::{DrawingTolerances, ToleranceArgs};

use case::whole;

/// Simulate and design cageless ball bearings with a discrete raceway.
#[derive(Debug, Parser)]
#[command(name = "cageless", version, max_term_width = 100, after_help = EXIT_CODES)]
pub struct Args {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,
    /// Limit the vector instructions to these. Results are bit-identical with all of them.
    #[arg(long, value_enum, global = true)]
    pub isa: Option<Isa>,
    /// Print neither progress nor results as text; errors and --json are printed.
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

/// Vector instructions.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Isa {
    /// Baseline of the processor family.
    Baseline,
    /// 256-bit vectors.
    Avx2,
    /// 512-bit vectors.
    Avx512,
}

/// Exit codes, in the words of docs/command-line.md.
const EXIT_CODES: &str = "Exit codes: 0 success; 1 any other error; 2 invalid input; 3 no valid \
    result: a run that stopped, a search that found no raceway, points of a plain groove, --drops that came to fewer, \
    a sweep in which every variant failed.\nResults go to stdout, progress to stderr.";

/// One task.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Regenerate every table and figure of Zhao 2022 next to the paper's numbers.
    Reproduce(Reproduce),
    /// Print a commented case file.
    New(New),
    /// Validate a case.
    #[command(mut_arg("open", |open| open.hide(true)))]
    Check(CheckArgs),
    /// Static equilibrium: ring displacement, load per ball, contact pressure.
    Static(StaticArgs),
    /// One sheet for the decision: life, limits, clearance, benefit, drawing of the outer ring.
    Sheet(SheetArgs),
    /// Constraints, β0, the lC–θ curve, critical gap, verdict and recommendation.
    Design(DesignArgs),
    /// Sensitivity of the verdict to machining tolerances, ball grade, friction, clearance, speed and load.
    Tolerance(ToleranceArgs),
    /// Simulate a case.
    Run(RunArgs),
    /// Drop a rotor onto its bearing, or that of a rotor file onto several: impacts, whirl, spin-up,
    /// loads and heat.
    Drop(DropArgs),
    /// Does it help? Rings or remedies in steady operation with the same real balls; or finished runs side by side.
    Compare(CompareArgs),
    /// The outer ring for CAD and machining: STEP, STL or a table of points.
    Export(ExportArgs),
    /// Fit the ring of a case to points of a measured one: frame, dimensions with their uncertainties, PASS or FAIL,
    /// and the case as made.
    Measure(MeasureArgs),
    /// Compute many variants of a case; an interrupted sweep resumes.
    Sweep(SweepArgs),
    /// Analyse a finished sweep: main effects, maps, best and failed variants.
    Report(ReportArgs),
    /// The interactive page: change a bearing, watch the balls, compare; served to this machine only.
    Studio(StudioArgs),
    /// Print the completions of a shell.
    Completions(CompletionsArgs),
    /// Print the man page of cageless or of one of its commands.
    Man(ManArgs),
}

/// `completions`.
#[derive(Debug, Group)]
#[command(after_help = COMPLETIONS)]
pub struct CompletionsArgs {
    /// Shell.
    #[arg(value_enum)]
    pub shell: Shell,
}

const COMPLETIONS: &str = "\
bash:  cageless completions bash > ~/.local/share/bash-completion/completions/cageless
zsh:   cageless completions zsh > ~/.zfunc/_cageless    (with fpath+=~/.zfunc before compinit)
fish:  cageless completions fish > ~/.config/fish/completions/cageless.fish";

/// `man`.
#[derive(Debug, Group)]
pub struct ManArgs {
    /// Command, for example run; that of cageless itself if left out.
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
    /// Write all pages, cageless.1, cageless-run.1 and so on, into a folder instead.
    #[arg(long, value_name = "DIR", conflicts_with = "command")]
    pub out: Option<PathBuf>,
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
    /// Open the page in the browser.
    #[arg(long)]
    pub open: bool,
}

/// `new`.
#[derive(Debug, Group)]
pub struct New {
    /// Print the case of a conventional bearing, without a discrete raceway.
    #[arg(long)]
    pub conventional: bool,
    /// Z, number of balls of a bearing by its own dimensions.
    #[arg(long, value_parser = whole, value_name = "Z", requires_all = ["ball_diameter_mm", "pitch_diameter_mm"], conflicts_with_all = ["bearing", "conventional"])]
    pub balls: Option<u64>,
    /// Dw, ball diameter.
    #[arg(long, requires = "balls", value_name = "MM")]
    pub ball_diameter_mm: Option<f64>,
    /// Dpw, pitch diameter.
    #[arg(long, requires = "balls", value_name = "MM")]
    pub pitch_diameter_mm: Option<f64>,
    /// Gr, radial internal clearance. Default: 0.
    #[arg(long, requires = "balls", value_name = "UM")]
    pub clearance_um: Option<f64>,
    /// Speed of the inner ring, for a bearing by designation or dimensions.
    #[arg(long, allow_negative_numbers = true, value_name = "RPM")]
    pub speed_rpm: Option<f64>,
    /// Fr, radial load.
    #[arg(long, value_name = "N")]
    pub radial_load_n: Option<f64>,
    /// Fa, axial load.
    #[arg(long, allow_negative_numbers = true, value_name = "N")]
    pub axial_load_n: Option<f64>,
    /// Start from a deep groove ball bearing of ISO 15: series 60, 62, 63, 160, 68 (618) or 69 (619)
    /// with a bore of up to 100 mm; or from two angular contact ball bearings back to back: series 70, 72,
    /// 73 or 719 with C (15°), AC (25°) or B (40°), such as 7205C. Suffixes of makers may follow. Comments name the maker of the balls or the formula, and all that
    /// is assumed.
    #[arg(long, value_name = "DESIGNATION", conflicts_with = "conventional")]
    pub bearing: Option<String>,
    /// As many balls as the pitch circle holds.
    #[arg(long, requires = "bearing", conflicts_with = "balls")]
    pub full_complement: bool,
    /// A touch-down bearing: inner ring, rotor and support filled in with assumed values for `drop`.
    #[arg(long, requires = "bearing", conflicts_with = "balls")]
    pub touchdown: bool,
    /// Write the case file instead of printing it; one that exists is not replaced.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// `run`.
#[derive(Debug, Group)]
pub struct RunArgs {
    /// Case, output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Verify by perturbed starts and half step (17x cost): classify each result as converged,
    /// statistical or step-biased
    #[arg(long)]
    pub verify: bool,
}

/// `drop`.
#[derive(Debug, Group)]
pub struct DropArgs {
    /// Case with a [rotor], or file of a rotor on several bearings; output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Drop the rotor onto another outer ring as well, in all bearings, and show both; with --samples
    /// say whether the raceway helps in the same drops.
    #[arg(long, value_enum, value_name = "RING")]
    pub compare: Option<Reference>,
    /// Drop the rotor N times with random friction (±30 %), clearance (±10 %), support damping
    /// (factor 2), direction of the unbalance and arrangement of the balls, drawn for each bearing
    /// on its own; --set solver.seed=S for other draws.
    #[arg(long, value_parser = whole, allow_negative_numbers = true, value_name = "N")]
    pub samples: Option<u64>,
    /// Repeat the drop from perturbed starts and at half the step, and show which results are
    /// converged.
    #[arg(long)]
    pub verify: bool,
    /// Drop the rotor N times one after the other, each time spinning down to standstill: the bearing
    /// keeps the heat, and its clearances change with it ([thermal], [[limit]]).
    #[arg(long, value_parser = whole, allow_negative_numbers = true, value_name = "N")]
    pub drops: Option<u64>,
}

/// `compare`.
#[derive(Debug, Group)]
pub struct CompareArgs {
    /// Case files (TOML or JSON), or folders of finished runs; all are compared with the first.
    #[arg(value_name = "CASE", required = true, num_args = 1..)]
    pub cases: Vec<PathBuf>,
    /// Compare the cases with the conventional ring of the first, which comes before them.
    #[arg(long)]
    pub with_conventional: bool,
    /// Compare one case with its remedies: plain ring, raceway, one and two balls fewer.
    #[arg(long, conflicts_with = "with_conventional")]
    pub remedies: bool,
    /// Draws of real balls, the same for every ring. Default: 8.
    #[arg(long, value_parser = whole, allow_negative_numbers = true, value_name = "N")]
    pub draws: Option<u64>,
    /// Short runs from so many uneven starts of the balls of the case instead; nothing is judged.
    #[arg(long, value_parser = whole, allow_negative_numbers = true, value_name = "N", conflicts_with = "draws")]
    pub starts: Option<u64>,
    /// Replace a value of the case files; may be repeated.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
    /// Output.
    #[command(flatten)]
    pub output: Output,
}

/// Outer rings to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Reference {
    /// A plain raceway.
    Conventional,
}

/// `sweep`.
#[derive(Debug, Group)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct SweepArgs {
    /// Joining shards instead of computing.
    #[command(subcommand)]
    pub command: Option<SweepCommand>,
    /// Plan (TOML): a case or a rotor file, what varies in it, what to compute.
    #[arg(value_name = "PLAN", required = true)]
    pub plan: Option<PathBuf>,
    /// Compute shard I of N into its own file.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Number of threads; default: number of cores.
    #[arg(long, value_parser = threads, allow_negative_numbers = true, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Output folder.
    #[command(flatten)]
    pub output: SweepOutput,
}

/// Operations on shards.
#[derive(Debug, Subcommand)]
pub enum SweepCommand {
    /// Join the results of all shards into one file and report missing ones.
    Merge(MergeArgs),
}

/// `sweep merge`.
#[derive(Debug, Group)]
pub struct MergeArgs {
    /// Results of the shards.
    #[arg(value_name = "SHARD", required = true)]
    pub shards: Vec<PathBuf>,
    /// Output folder.
    #[command(flatten)]
    pub output: SweepOutput,
}

/// Output of a sweep.
#[derive(Debug, Group)]
pub struct SweepOutput {
    /// Folder for `sweep.parquet`; by default `out/` and the name of the plan, for shards
    /// theirs.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

/// `report`.
#[derive(Debug, Group)]
pub struct ReportArgs {
    /// Result of a sweep, or its folder.
    #[arg(value_name = "SWEEP")]
    pub sweep: PathBuf,
    /// Column to minimise; may be repeated.
    #[arg(long, value_name = "COLUMN")]
    pub low: Vec<String>,
    /// Column to maximise; may be repeated.
    #[arg(long, value_name = "COLUMN")]
    pub high: Vec<String>,
    /// Folder for the report; that of the result by default.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print all numbers as one JSON document.
    #[arg(long)]
    pub json: bool,
    /// Open the page in the browser.
    #[arg(long)]
    pub open: bool,
}

/// `design`.
#[derive(Debug, Group)]
pub struct DesignArgs {
    /// Case, output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Search for the best raceway for the speeds and loads of the section [search], or of the
    /// case. With --out an interrupted search resumes.
    #[arg(long)]
    pub search: bool,

    /// Say whether the raceway helps in steady operation, against a plain ring and one ball fewer.
    /// With --search find the one that helps most.
    #[arg(long)]
    pub benefit: bool,

    /// Find the axial load and tilt up to which the raceway still works, by motion in space.
    #[arg(long)]
    pub axial: bool,
}

/// `check`.
#[derive(Debug, Group)]
pub struct CheckArgs {
    /// Case and output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Show the defaults that were taken and the scope of the model, too; --json has them.
    #[arg(long)]
    pub all: bool,
}

/// `static`.
#[derive(Debug, Group)]
pub struct StaticArgs {
    /// Case and output.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Show the load, pressure and speeds of every ball, too; --json, --csv and the page have them.
    #[arg(long)]
    pub balls: bool,
}

/// `sheet`.
#[derive(Debug, Group)]
pub struct SheetArgs {
    /// Case, output: `report.html`, `drawing.svg`, `drawing.pdf`, `sheet.json`.
    #[command(flatten)]
    pub case: CaseArgs,
    /// Tolerances of the drawing.
    #[command(flatten)]
    pub drawing: DrawingTolerances,
    /// Leave out the long runs that say whether the raceway helps.
    #[arg(long)]
    pub without_benefit: bool,
}

/// `studio`.
#[derive(Debug, Group)]
pub struct StudioArgs {
    /// Case file (TOML) to begin with; the one that `cageless new` prints if left out.
    #[arg(value_name = "CASE")]
    pub case: Option<PathBuf>,
    /// Replace a value of the case file; may be repeated.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
    /// Write the stand-alone page, which computes in the browser, instead of serving it.
    #[arg(long, value_name = "FILE")]
    pub page: Option<PathBuf>,
    /// Only print the address.
    #[arg(long)]
    pub no_browser: bool,
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let count = text
        .parse()
        .ok()
        .filter(|n: &NonZeroUsize| n.get() <= THREADS_MAX);
    count.ok_or_else(|| format!("1 to {THREADS_MAX} are allowed"))
}
