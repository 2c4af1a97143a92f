//! Suggestions for mistyped commands.

use cageless_io::case_file::nearest;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};

use crate::args::Args;

/// The error with the command nearest to the one given. Clap itself compares without regard to
/// exchanged letters: `rnu` is far from `run` for it.
pub fn with_nearest_command(mut error: clap::Error) -> clap::Error {
    let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidSubcommand) else {
        return error;
    };
    if error.get(ContextKind::SuggestedSubcommand).is_none() {
        let commands = Args::command();
        let names: Vec<&str> = commands.get_subcommands().map(|c| c.get_name()).collect();
        if let Some(near) = nearest(given, names.iter().copied()) {
            let near = ContextValue::Strings(vec![near.to_owned()]);
            error.insert(ContextKind::SuggestedSubcommand, near);
        }
    }
    error
}
