//! Error and time of Cageless and of a general solver on the same equations.

use std::time::Instant;

use anyhow::{Result, anyhow};
use cageless::dynamics::Layout;
use cageless::reference::Textbook;
use cageless::{Case, IntegrationMethod};
use clap::Args;
use ode_solvers::{DVector, Dopri5, OutputType, System};

use crate::problem::{Problem, complete, rms_difference, scaled, start};

/// Options of `run` and `drop`.
#[derive(Debug, Args)]
pub struct Options {
    /// Repetitions of each timing; all solvers take turns in each.
    #[arg(long, default_value_t = 5)]
    repetitions: usize,
    /// Error at which solvers are compared.
    #[arg(long, default_value_t = 1e-2)]
    at_error: f64,
    /// Changes of the case.
    #[arg(long, value_name = "SECTION.KEY=VALUE")]
    pub set: Vec<String>,
}

/// Parts of the automatic step of a method that a fixed one is tried with.
const PARTS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
/// Absolute tolerances on the scaled states.
const TOLERANCES: [f64; 8] = [1e-3, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 1e-7, 1e-8];

/// A solver with its precision.
#[derive(Debug, Clone, Copy)]
enum Solver {
    /// A method of Cageless at a part of its automatic step.
    Step(IntegrationMethod, f64),
    /// The adaptive method of Cageless.
    Adaptive(f64),
    /// Dormand and Prince's pair on the equations of the textbook.
    Dopri5(f64),
}

impl Solver {
    fn all() -> Vec<Self> {
        let fixed = [IntegrationMethod::VelocityVerlet, IntegrationMethod::Abm4]
            .into_iter()
            .flat_map(|method| PARTS.map(|part| Self::Step(method, part)));
        let errors = [Self::Adaptive as fn(f64) -> Self, Self::Dopri5];
        fixed
            .chain(errors.into_iter().flat_map(|solver| TOLERANCES.map(solver)))
            .collect()
    }

    fn name(self) -> &'static str {
        match self {
            Self::Step(method, _) => method.name(),
            Self::Adaptive(_) => IntegrationMethod::Adaptive.name(),
            Self::Dopri5(_) => "Dopri5 of ode_solvers",
        }
    }

    /// The case with the solver's precision, prepared before the clock starts.
    fn prepare(self, case: &Case) -> Case {
        let mut case = case.clone();
        match self {
            Self::Step(method, part) => {
                case.set_method(method);
                case.solver.step_s /= part;
            }
            Self::Adaptive(tolerance) => {
                case.set_method(IntegrationMethod::Adaptive);
                case.solver.tolerance = tolerance;
            }
            Self::Dopri5(_) => {}
        }
        case
    }

    fn setting(self, prepared: &Case) -> String {
        match self {
            Self::Step(..) => format!("{:.3} µs", prepared.solver.step_s * 1e6),
            Self::Adaptive(tolerance) | Self::Dopri5(tolerance) => format!("{tolerance:e}"),
        }
    }

    /// Scaled state at the end of a prepared case.
    fn integrate(self, case: &Case) -> Result<Vec<f64>> {
        if let Self::Dopri5(tolerance) = self {
            return dopri5(case, tolerance);
        }
        Ok(scaled(&complete(case)?.state))
    }
}

/// The textbook's equations on scaled states.
struct Scaled {
    textbook: Textbook,
    scales: Vec<f64>,
}

impl System<f64, DVector<f64>> for Scaled {
    fn system(&self, _time_s: f64, z: &DVector<f64>, dzdt: &mut DVector<f64>) {
        let y: Vec<f64> = z.iter().zip(&self.scales).map(|(z, s)| z * s).collect();
        self.textbook.derivative(&y, dzdt.as_mut_slice());
        for (d, scale) in dzdt.iter_mut().zip(&self.scales) {
            *d /= scale;
        }
    }
}

/// Defaults of the solver, but for its output, whole steps only, and its number of steps, without limit.
fn dopri5(case: &Case, tolerance: f64) -> Result<Vec<f64>> {
    let start = start(case)?;
    let end_s = case.solver.duration_s;
    let system = Scaled {
        scales: Textbook::scales(Layout::of_case(case)),
        textbook: Textbook::new(case),
    };
    let mut solver = Dopri5::from_param(
        system,
        0.0,
        end_s,
        end_s,
        DVector::from_vec(start),
        0.0,
        tolerance,
        0.9,
        0.04,
        0.2,
        10.0,
        end_s,
        0.0,
        u32::MAX,
        u32::MAX,
        OutputType::Sparse,
    );
    solver.integrate().map_err(|error| anyhow!("{error}"))?;
    let end = solver.y_out().last().ok_or_else(|| anyhow!("no output"))?;
    Ok(end.as_slice().to_vec())
}

/// A solver with its error and its fastest time.
struct Measured {
    solver: Solver,
    timed: Case,
    /// RMS scaled error at 2 ms, or why there is none.
    error: Result<f64>,
    /// Wall seconds per simulated second.
    s_per_s: f64,
}

/// Prints the fastest setting of each solver below an error.
fn print_fastest(all: &[Measured], at_error: f64) {
    println!("\nFastest setting with an error below {:e}:", at_error);
    let mut best: Vec<&Measured> = vec![];
    for measured in all
        .iter()
        .filter(|m| matches!(m.error, Ok(e) if e < at_error))
    {
        match best
            .iter_mut()
            .find(|b| b.solver.name() == measured.solver.name())
        {
            Some(best) if measured.s_per_s < best.s_per_s => *best = measured,
            Some(_) => {}
            None => best.push(measured),
        }
    }
    let least = best.iter().map(|b| b.s_per_s).fold(f64::INFINITY, f64::min);
    for b in best {
        let (name, setting) = (b.solver.name(), b.solver.setting(&b.timed));
        println!(
            "{name}, {setting}: {:.3} s/s, {:.1} times the least",
            b.s_per_s,
            b.s_per_s / least
        );
    }
}

/// Prints error and time of every solver, and the fastest setting of each below the error.
///
/// # Errors
/// A timed case that ends early.
pub fn measure(problem: &Problem, options: &Options) -> Result<()> {
    let mut all: Vec<Measured> = Solver::all()
        .into_iter()
        .map(|solver| Measured {
            solver,
            timed: solver.prepare(&problem.timed),
            error: solver
                .integrate(&solver.prepare(&problem.short))
                .map(|end| rms_difference(&end, &problem.reference)),
            s_per_s: f64::INFINITY,
        })
        .collect();
    for _ in 0..options.repetitions.max(1) {
        for measured in all.iter_mut().filter(|measured| measured.error.is_ok()) {
            let clock = Instant::now();
            std::hint::black_box(measured.solver.integrate(&measured.timed)?);
            let s_per_s = clock.elapsed().as_secs_f64() / measured.timed.solver.duration_s;
            measured.s_per_s = measured.s_per_s.min(s_per_s);
        }
    }
    println!("| solver | step or tolerance | error at 2 ms | s per simulated s |");
    println!("|---|---|---|---|");
    for Measured {
        solver,
        timed,
        error,
        s_per_s,
    } in &all
    {
        let (name, setting) = (solver.name(), solver.setting(timed));
        match error {
            Ok(error) => println!("| {name} | {setting} | {error:.1e} | {s_per_s:.3} |"),
            Err(reason) => println!("| {name} | {setting} | {reason} | |"),
        }
    }
    print_fastest(&all, options.at_error);
    Ok(())
}
