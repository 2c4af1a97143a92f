//! Speed of Cageless beside a general solver: see README.md.

mod integration;
mod own_law;
mod problem;
mod right_hand_side;

use anyhow::Result;
use clap::{Parser, Subcommand};

#[derive(Debug, Parser)]
#[command(version, about = "Speed of Cageless beside a general solver")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Time per evaluation of the right-hand side, by instruction set
    Rhs(right_hand_side::Options),
    /// Cost of a law of friction of one's own beside the built-in one
    OwnLaw(own_law::Options),
    /// Work against precision on cases/cb74.toml
    Run(integration::Options),
    /// Work against precision on cases/touchdown-d.toml
    Drop(integration::Options),
}

fn main() -> Result<()> {
    match Arguments::parse().command {
        Command::Rhs(options) => right_hand_side::measure(&options),
        Command::OwnLaw(options) => own_law::measure(&options),
        Command::Run(options) => {
            integration::measure(&problem::Problem::run(&options.set)?, &options)
        }
        Command::Drop(options) => {
            integration::measure(&problem::Problem::drop(&options.set)?, &options)
        }
    }
}
