//! Dry friction: what it costs in the production method, whether the statistics stay where an
//! explicit method puts them, and what other solvers need on the same equations.

use std::time::Instant;

use anyhow::{Result, bail};
use cageless::Case;
use cageless::simulation::{self, Control, Ending};
use clap::Args;

use crate::friction_solvers;
use crate::problem;
use crate::statistics::{STATISTICS, Sums};

/// Options of `friction`.
#[derive(Debug, Args)]
pub struct Options {
    /// Coefficients of friction of the first table.
    #[arg(long, value_delimiter = ',', default_values_t = [0.007, 0.1, 0.2, 0.3])]
    coefficients: Vec<f64>,
    /// Simulated time, s; its second half counts for the statistics.
    #[arg(long, default_value_t = 0.1)]
    duration_s: f64,
    /// Repetitions; all coefficients and solvers take turns in each.
    #[arg(long, default_value_t = 5)]
    pub(crate) repetitions: usize,
    /// Coefficient at which the solvers are compared.
    #[arg(long, default_value_t = 0.3)]
    pub(crate) compared: f64,
    /// Simulated time of the comparison of solvers, ms; its second half counts for the
    /// statistics.
    #[arg(long, default_value_t = 40.0)]
    pub(crate) window_ms: f64,
    /// Members of the reference ensemble, spread over one ball pitch.
    #[arg(long, default_value_t = 16)]
    pub(crate) members: usize,
    /// Deviation that a statistic of one run may have, in spreads of one member.
    #[arg(long, default_value_t = 3.0)]
    pub(crate) spreads: f64,
    /// Only the cost of the production method.
    #[arg(long)]
    cost_only: bool,
}

/// Structure (d) with the friction coefficient, method and further overrides.
pub(crate) fn case(coefficient: f64, method: &str, overrides: &[String]) -> Result<Case> {
    let mut all = vec![
        format!("contact.friction_coefficient={coefficient:?}"),
        format!("solver.method={method}"),
        "solver.step_us=auto".to_owned(),
    ];
    all.extend_from_slice(overrides);
    problem::structure_d(&all)
}

/// Runs a case; statistics over its second half and wall seconds per simulated second.
fn timed(case: &Case) -> Result<([f64; STATISTICS], f64, f64)> {
    let mut sums = Sums::new(0.5 * case.solver.duration_s);
    let clock = Instant::now();
    let outcome = simulation::run(case, &mut [&mut sums], &mut |_| Control::Continue(()))?;
    let wall = clock.elapsed().as_secs_f64() / case.solver.duration_s;
    match outcome.ending {
        Ending::Complete => Ok((sums.statistics(), wall, outcome.energy_residual_relative)),
        ending => bail!("the run ended early: {ending:?}"),
    }
}

/// Prints both tables.
///
/// # Errors
/// The case is not what it was, or a run ended early.
pub fn run(options: &Options) -> Result<()> {
    cost(options)?;
    if options.cost_only {
        return Ok(());
    }
    friction_solvers::compare(options)
}

/// Cost and statistics over the coefficient.
fn cost(options: &Options) -> Result<()> {
    let duration = [format!("solver.duration_s={:?}", options.duration_s)];
    let cases = options
        .coefficients
        .iter()
        .map(|&c| case(c, "symplectic", &duration))
        .collect::<Result<Vec<_>>>()?;
    let mut walls = vec![vec![]; cases.len()];
    let mut results = vec![([0.0; STATISTICS], 0.0); cases.len()];
    for _ in 0..options.repetitions {
        for (k, case) in cases.iter().enumerate() {
            let (statistics, wall, residual) = timed(case)?;
            walls[k].push(wall);
            results[k] = (statistics, residual);
        }
    }
    println!(
        "Structure (d), production method, automatic step, one core, least of {} runs",
        options.repetitions
    );
    println!(
        "{:>6} {:>8} {:>9} {:>7} {:>13} {:>10} {:>11} {:>11} {:>10}",
        "mu",
        "step us",
        "s/s",
        "ratio",
        "ring y um",
        "std y um",
        "ball m/s",
        "spin 1/s",
        "residual"
    );
    let least: Vec<f64> = walls
        .iter()
        .map(|w| w.iter().copied().fold(f64::INFINITY, f64::min))
        .collect();
    for (k, case) in cases.iter().enumerate() {
        let ([y, deviation, _, speed, spin, _], residual) = results[k];
        println!(
            "{:>6} {:>8} {:>9.3} {:>7.2} {y:>13.5} {deviation:>10.5} {speed:>11.6} {spin:>11.4} \
             {residual:>10.1e}",
            options.coefficients[k],
            case.solver.step_s * 1e6,
            least[k],
            least[k] / least[0],
        );
    }
    Ok(())
}
