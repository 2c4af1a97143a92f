//! The program `cageless`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(cageless_cli::command(std::env::args_os()))
}
