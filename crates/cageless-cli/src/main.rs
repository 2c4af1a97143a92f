//! The `cageless` command.

mod args;
mod commands;
mod failure;
mod format;
mod progress;
mod studio;
mod suggestion;
mod whole;

use std::process::ExitCode;

use cageless_io::on_terminal;
use clap::Parser;

fn main() -> ExitCode {
    let args = match args::Args::try_parse() {
        Ok(args) => args,
        // Help and version are answers; everything else is bad input.
        Err(error) => {
            let error = suggestion::with_nearest_command(error);
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    match commands::dispatch(args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {}", on_terminal(&failure.to_string()));
            failure.exit_code()
        }
    }
}
