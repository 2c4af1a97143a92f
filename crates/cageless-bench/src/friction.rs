//! Dry friction: what it costs in the production method, whether the statistics stay where an
//! explicit method puts them, and what other solvers need on the same equations.

use std::time::Instant;

use anyhow::{Result, bail};
use cageless::Case;
use cageless::simulation::{self, Control, Ending};
use cageless_io::case_file::CaseFile;
use clap::Args;

use crate::equations::{Equations, Implementation};
use crate::peers::peer::{Peer, Problem, Reached};
use crate::peers::{cvode, diffsol, ode_solvers};
use crate::problem;
use crate::statistics::Sums;

/// Options of `friction`.
#[derive(Debug, Args)]
pub struct Options {
    /// Coefficients of friction of the first table.
    #[arg(long, value_delimiter = ',', default_values_t = [0.007, 0.1, 0.2, 0.3])]
    coefficients: Vec<f64>,
    /// Coefficient at which the solvers are compared.
    #[arg(long, default_value_t = 0.3)]
    compared: f64,
    /// Simulated time, s; its second half counts for the statistics.
    #[arg(long, default_value_t = 0.1)]
    duration_s: f64,
    /// Simulated time of each timing of the other solvers, ms.
    #[arg(long, default_value_t = 2.0)]
    window_ms: f64,
    /// Repetitions; all coefficients and solvers take turns in each.
    #[arg(long, default_value_t = 5)]
    repetitions: usize,
    /// Error at 2 ms that a solver must reach to count as good for statistics.
    #[arg(long, default_value_t = 1e-2)]
    at_error: f64,
}

const CASE: &str = include_str!("../../../cases/zhao-d.toml");
/// Time at which errors are taken.
const ERROR_S: f64 = 0.002;
/// Tolerance of the reference trajectory.
const REFERENCE_TOLERANCE: f64 = 1e-9;

/// Structure (d) with the friction coefficient, method and further overrides.
fn case(coefficient: f64, method: &str, overrides: &[String]) -> Result<Case> {
    let mut all = vec![
        format!("contact.friction_coefficient={coefficient:?}"),
        format!("solver.method={method}"),
        "solver.step_us=auto".to_owned(),
    ];
    all.extend_from_slice(overrides);
    Ok(CaseFile::parse(CASE, "zhao-d.toml", &all)?.case().clone())
}

/// Runs a case; statistics over its second half and wall seconds per simulated second.
fn timed(case: &Case) -> Result<([f64; 6], f64, f64)> {
    let mut sums = Sums::new(0.5 * case.solver.duration_s);
    let clock = Instant::now();
    let outcome = simulation::run(case, &mut [&mut sums], &mut |_| Control::Continue(()))?;
    let wall = clock.elapsed().as_secs_f64() / case.solver.duration_s;
    match outcome.ending {
        Ending::Complete => Ok((sums.statistics(), wall, outcome.energy_residual_relative)),
        ending => bail!("the run ended early: {ending:?}"),
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Prints both tables.
///
/// # Errors
/// The case is not what it was, or a run ended early.
pub fn run(options: &Options) -> Result<()> {
    cost(options)?;
    solvers(options)
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
    let mut results = vec![([0.0; 6], 0.0); cases.len()];
    for _ in 0..options.repetitions {
        for (k, case) in cases.iter().enumerate() {
            let (statistics, wall, residual) = timed(case)?;
            walls[k].push(wall);
            results[k] = (statistics, residual);
        }
    }
    println!("Structure (d), production method, automatic step, one core");
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
    let medians: Vec<f64> = walls.iter_mut().map(|w| median(w)).collect();
    for (k, case) in cases.iter().enumerate() {
        let ([y, deviation, _, speed, spin, _], residual) = results[k];
        println!(
            "{:>6} {:>8} {:>9.3} {:>7.2} {y:>13.5} {deviation:>10.5} {speed:>11.6} {spin:>11.4} \
             {residual:>10.1e}",
            options.coefficients[k],
            case.solver.step_s * 1e6,
            medians[k],
            medians[k] / medians[0],
        );
    }
    Ok(())
}

/// One solver at one setting.
struct Entry<'p> {
    name: String,
    setting: f64,
    setting_name: &'static str,
    error: f64,
    walls: Vec<f64>,
    peer: Box<dyn Peer + 'p>,
}

/// The loosest setting of every solver that reaches the error, timed in turns.
fn solvers(options: &Options) -> Result<()> {
    let window_s = options.window_ms * 1e-3;
    let reference_case = case(
        options.compared,
        "adaptive",
        &[
            format!("solver.tolerance={REFERENCE_TOLERANCE:?}"),
            format!("solver.duration_s={ERROR_S:?}"),
        ],
    )?;
    let outcome = simulation::run(&reference_case, &mut [], &mut |_| Control::Continue(()))?;
    let reference = problem::scaled(&outcome.state);
    let problem = Problem::of(reference_case)?;
    let driver = cvode::Driver::new();
    if let Err(error) = &driver {
        eprintln!("CVODE left out: {error}. Debian's package is libsundials-dev.");
    }
    let mut peers: Vec<Box<dyn Peer + '_>> = vec![];
    for equations in Implementation::ALL {
        let problem = &problem;
        peers.push(Box::new(Rk4 { problem, equations }));
        for method in [ode_solvers::Method::Dopri5, ode_solvers::Method::Dop853] {
            peers.push(Box::new(ode_solvers::OdeSolvers {
                problem,
                method,
                equations,
            }));
        }
        for method in [diffsol::Method::Tsit45, diffsol::Method::Bdf] {
            peers.push(Box::new(diffsol::Diffsol {
                problem,
                method,
                equations,
            }));
        }
        if let Ok(driver) = &driver {
            peers.push(Box::new(cvode::Cvode {
                problem,
                driver,
                equations,
            }));
        }
    }
    let mut entries = vec![];
    for peer in peers {
        let found = peer.settings().into_iter().find_map(|setting| {
            let reached = peer.integrate(setting, ERROR_S).ok()?;
            let error = problem::rms_difference(&reached.z, &reference);
            (error <= options.at_error).then_some((setting, error))
        });
        match found {
            Some((setting, error)) => entries.push(Entry {
                name: format!("{}, {}", peer.name(), peer.equations()),
                setting,
                setting_name: peer.setting_name(),
                error,
                walls: vec![],
                peer,
            }),
            None => println!("{} does not reach the error", peer.name()),
        }
    }
    let own = case(
        options.compared,
        "symplectic",
        &[format!("solver.duration_s={:?}", options.duration_s)],
    )?;
    let mut own_walls = vec![];
    for _ in 0..options.repetitions {
        own_walls.push(timed(&own)?.1);
        for entry in &mut entries {
            let clock = Instant::now();
            entry.peer.integrate(entry.setting, window_s)?;
            entry.walls.push(clock.elapsed().as_secs_f64() / window_s);
        }
    }
    let own_wall = median(&mut own_walls);
    println!(
        "\nmu = {}, error at 2 ms below {}",
        options.compared, options.at_error
    );
    println!(
        "{:<32} {:>14} {:>10} {:>9} {:>9} {:>7}",
        "", "", "setting", "error", "s/s", "ratio"
    );
    println!(
        "{:<32} {:>14} {:>10} {:>9} {own_wall:>9.3} {:>7.1}",
        "Cageless, production",
        "step, µs",
        own.solver.step_s * 1e6,
        "-",
        1.0
    );
    for entry in &mut entries {
        let wall = median(&mut entry.walls);
        println!(
            "{:<32} {:>14} {:>10.1e} {:>9.1e} {wall:>9.3} {:>7.1}",
            entry.name,
            entry.setting_name,
            entry.setting,
            entry.error,
            wall / own_wall
        );
    }
    Ok(())
}

/// The classical Runge–Kutta method with a fixed step.
struct Rk4<'p> {
    problem: &'p Problem,
    equations: Implementation,
}

impl Peer for Rk4<'_> {
    fn name(&self) -> String {
        "RK4".into()
    }

    fn equations(&self) -> &'static str {
        self.equations.name()
    }

    fn setting_name(&self) -> &'static str {
        "step, µs"
    }

    fn settings(&self) -> Vec<f64> {
        vec![1.0, 0.5, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.03]
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        let steps = (duration_s / (setting * 1e-6)).ceil();
        let h = duration_s / steps;
        let mut z = self.problem.start.clone();
        let n = z.len();
        self.equations
            .with(&self.problem.case, |equations: &mut dyn Equations| {
                let before = equations.evaluations();
                let mut k = [vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]];
                let mut trial = vec![0.0; n];
                for _ in 0..steps as u64 {
                    equations.derivative(&z, &mut k[0]);
                    for (stage, fraction) in [(1, 0.5), (2, 0.5), (3, 1.0)] {
                        for i in 0..n {
                            trial[i] = z[i] + h * fraction * k[stage - 1][i];
                        }
                        equations.derivative(&trial, &mut k[stage]);
                    }
                    for i in 0..n {
                        z[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
                    }
                }
                if z.iter().any(|v| !v.is_finite()) {
                    bail!("the states are no longer finite");
                }
                let evaluations = equations.evaluations() - before;
                Ok(Reached { z, evaluations })
            })?
    }
}
