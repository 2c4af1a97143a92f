//! A drop by the production method and by a textbook Runge–Kutta method, in one run.

use std::time::Instant;

use anyhow::{Result, bail};
use cageless::initial_conditions::initial_state;
use cageless::simulation::{self, Control, Ending};
use cageless::{Case, IntegrationMethod};
use cageless_io::case_file::CaseFile;
use clap::Args;

use crate::textbook_drop::TextbookDrop;

/// Options of `touchdown`.
#[derive(Debug, Args)]
pub struct Options {
    /// Coefficients of friction of the balls.
    #[arg(long, value_delimiter = ',', default_values_t = [0.1, 0.3])]
    coefficients: Vec<f64>,
    /// Simulated time of each timing, s.
    #[arg(long, default_value_t = 0.1)]
    duration_s: f64,
    /// Repetitions; both methods take turns in each.
    #[arg(long, default_value_t = 3)]
    repetitions: usize,
    /// Error 2 ms after the impact up to which a step is good.
    #[arg(long, default_value_t = 1e-2)]
    at_error: f64,
}

const CASE: &str = include_str!("../../../cases/touchdown-d.toml");
/// Time at which errors are taken, s; the rotor starts just above contact.
const ERROR_S: f64 = 0.002;
/// Steps tried by the Runge–Kutta method, s.
const STEPS_S: [f64; 10] = [
    3e-6, 2.5e-6, 2e-6, 1.5e-6, 1e-6, 7e-7, 5e-7, 3e-7, 2e-7, 1e-7,
];

fn case(coefficient: f64, near: bool) -> Result<Case> {
    let friction = format!("contact.friction_coefficient={coefficient:?}");
    let mut case = CaseFile::parse(CASE, "touchdown-d.toml", &[friction])?
        .case()
        .clone();
    if let (true, Some(rotor)) = (near, &mut case.rotor) {
        rotor.y_m = -0.995 * rotor.air_gap_m;
        rotor.vy_m_s = -(2.0 * case.operation.gravity_m_s2 * rotor.air_gap_m).sqrt();
    }
    Ok(case)
}

fn run_of(case: &Case) -> Result<(simulation::RunOutcome, f64)> {
    let clock = Instant::now();
    let outcome = simulation::run(case, &mut [], &mut |_| Control::Continue(()))?;
    let wall_s = clock.elapsed().as_secs_f64();
    match outcome.ending {
        Ending::Complete => Ok((outcome, wall_s)),
        ending => bail!("the run ended early: {ending:?}"),
    }
}

/// Prints the table.
///
/// # Errors
/// The case is not what it was, or a run ended early.
pub fn run(options: &Options) -> Result<()> {
    println!("friction | production step, error at 2 ms, s/s | RK4 step, error, s/s | ratio");
    for &coefficient in &options.coefficients {
        let mut near = case(coefficient, true)?;
        near.solver.duration_s = ERROR_S;
        let drop = TextbookDrop::new(&near)?;
        let start = drop.state(&initial_state(&near)?.0)?;
        near.solver.method = IntegrationMethod::Adaptive;
        near.solver.tolerance = 1e-11;
        let reference = drop.state(&run_of(&near)?.0.state)?;
        near.set_method(IntegrationMethod::VelocityVerlet);
        let error = drop.error(&drop.state(&run_of(&near)?.0.state)?, &reference);
        let errors = STEPS_S.map(|step_s| {
            let mut state = start.clone();
            let steps = (ERROR_S / step_s).round();
            drop.runge_kutta(&mut state, ERROR_S / steps, steps as u64);
            drop.error(&state, &reference)
        });
        let Some(good) = errors.iter().position(|e| *e < options.at_error) else {
            bail!("no step of the Runge-Kutta method is good");
        };
        let mut long = case(coefficient, false)?;
        long.set_method(IntegrationMethod::VelocityVerlet);
        long.solver.duration_s = options.duration_s;
        let from = drop.state(&initial_state(&long)?.0)?;
        let (mut ours, mut theirs) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..options.repetitions {
            ours = ours.min(run_of(&long)?.1 / options.duration_s);
            let clock = Instant::now();
            let mut state = from.clone();
            let steps = (options.duration_s / STEPS_S[good]).round() as u64;
            drop.runge_kutta(&mut state, STEPS_S[good], steps);
            theirs = theirs.min(clock.elapsed().as_secs_f64() / options.duration_s);
            std::hint::black_box(&state);
        }
        println!(
            "{coefficient} | {:e}, {error:.1e}, {ours:.3} | {:e}, {:.1e}, {theirs:.3} | {:.1}",
            long.solver.step_s,
            STEPS_S[good],
            errors[good],
            theirs / ours
        );
    }
    Ok(())
}
