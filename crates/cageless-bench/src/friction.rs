//! Dry friction: what it costs in the production method, whether the statistics stay where an
//! explicit method puts them, and what other solvers need on the same equations.

use anyhow::{Result, bail};
use cageless::Case;
use cageless::simulation::{self, Control, Ending};
use clap::Args;

use crate::clock::Clock;
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

/// Statistics over the second half of a run and the relative residual of its energy balance.
fn statistics(case: &Case) -> Result<([f64; STATISTICS], f64)> {
    let mut sums = Sums::new(0.5 * case.solver.duration_s);
    let outcome = simulation::run(case, &mut [&mut sums], &mut |_| Control::Continue(()))?;
    match outcome.ending {
        Ending::Complete => Ok((sums.statistics(), outcome.energy_residual_relative)),
        ending => bail!("the run ended early: {ending:?}"),
    }
}

/// Seconds of processor time per simulated second of a run that nobody looks at.
fn cost_of(case: &Case) -> Result<f64> {
    let clock = Clock::start();
    simulation::run(case, &mut [], &mut |_| Control::Continue(()))?;
    Ok(clock.elapsed_s() / case.solver.duration_s)
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
    let mut least = vec![f64::INFINITY; cases.len()];
    let results = cases.iter().map(statistics).collect::<Result<Vec<_>>>()?;
    for _ in 0..options.repetitions {
        for (k, case) in cases.iter().enumerate() {
            least[k] = cost_of(case)?.min(least[k]);
        }
    }
    println!(
        "Structure (d), production method, automatic step; seconds of processor time per simulated \
         second, least of {} runs",
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
