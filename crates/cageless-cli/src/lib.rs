//! The command `cageless` as a function, for its program and for the Python package.
//!
//! ```
//! assert_eq!(cageless_cli::command(["cageless", "check", "no-such-case.toml"]), 2);
//! ```

mod args;
mod commands;
mod driver;
mod failure;
mod finished_run;
mod format;
mod interrupt;
mod progress;
mod studio;
mod suggestion;

use std::ffi::OsString;
use std::io::Write;

use cageless_io::bounded;
use clap::Parser;

pub use failure::Failure;

/// The exit code of the command with these words, the first of which is its own name: 0, or 1
/// where it was interrupted or could not go on, 2 for bad input, 3 where the motion left what
/// is physical or nothing converged. Answers go to standard output, messages to standard error.
pub fn command<W: Into<OsString> + Clone>(words: impl IntoIterator<Item = W>) -> u8 {
    let code = match args::Args::try_parse_from(words) {
        Ok(args) => match commands::dispatch(args) {
            Ok(()) => 0,
            Err(failure) => {
                progress::message(&bounded(format!("error: {failure}")));
                failure.exit_code()
            }
        },
        // Help and version are answers; everything else is bad input.
        Err(error) => {
            let error = suggestion::with_nearest_command(error);
            let _ = error.print();
            if error.use_stderr() { 2 } else { 0 }
        }
    };
    // Only the end of a Rust program would flush it.
    let _ = std::io::stdout().flush();
    code
}
