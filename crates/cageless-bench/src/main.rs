//! Measurements of Cageless, one command each: see README.md.

mod clock;
mod endurance;
mod equations;
mod friction;
mod friction_solvers;
mod instructions;
mod peers;
mod problem;
mod rk4;
mod statistics;
mod sweep;
mod textbook;
mod textbook_drop;
mod touchdown;

use anyhow::Result;
use clap::{Parser, Subcommand};

#[derive(Debug, Parser)]
#[command(version, about = "Measurements of Cageless")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Work against precision on CB74, beside other solvers
    Peers(peers::Options),
    /// Instructions and time per evaluation of the right-hand side
    Instructions(instructions::Options),
    /// Statistics of an ensemble of CB74 against the reference ones
    Statistics(statistics::Options),
    /// A long run of CB74 without damping: drift of energy, lost balls
    Endurance(endurance::Options),
    /// Cost and statistics of dry friction, beside other solvers
    Friction(friction::Options),
    /// A drop beside a textbook Runge–Kutta method
    Touchdown(touchdown::Options),
    /// Speed of a sweep against that of the bare library
    Sweep(sweep::Options),
    /// Evaluates the right-hand side, for a counter of instructions around it
    #[command(hide = true)]
    Evaluate(instructions::EvaluateOptions),
}

fn main() -> Result<()> {
    match Arguments::parse().command {
        Command::Peers(options) => peers::run(&options),
        Command::Instructions(options) => instructions::run(&options),
        Command::Statistics(options) => statistics::run(&options),
        Command::Endurance(options) => endurance::run(&options),
        Command::Friction(options) => friction::run(&options),
        Command::Touchdown(options) => touchdown::run(&options),
        Command::Sweep(options) => sweep::run_command(&options),
        Command::Evaluate(options) => instructions::evaluate(&options),
    }
}
