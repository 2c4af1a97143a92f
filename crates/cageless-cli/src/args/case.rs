//! Arguments of commands that work on a case, and the numbers of options.

use std::path::PathBuf;

use clap::Args as Group;

/// Arguments of commands that work on a case.
#[derive(Debug, Group)]
pub struct CaseArgs {
    /// Case file (TOML); `cageless new` prints one.
    #[arg(value_name = "CASE")]
    pub case: PathBuf,
    /// Replace a value of the case file; may be repeated.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
    /// Output.
    #[command(flatten)]
    pub output: Output,
}

/// Output of commands that compute.
#[derive(Debug, Group)]
pub struct Output {
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
    /// Folder for files.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write the results as CSV, too, with the tables of a run or drop.
    #[arg(long, requires = "out")]
    pub csv: bool,
    /// Open the page in the browser.
    #[arg(long, requires = "out")]
    pub open: bool,
}

/// A number.
pub(super) fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "it must be a number".to_owned())
}

/// A whole number.
pub(super) fn whole(text: &str) -> Result<u64, String> {
    let allowed = |_| "it must be a whole number, 0 or more".to_owned();
    text.parse().map_err(allowed)
}
