//! Work against precision: Cageless beside other solvers on case CB74.

mod cageless_methods;
pub mod cvode;
#[cfg(feature = "peers")]
mod diffsol;
#[cfg(feature = "peers")]
mod ode_solvers;
pub mod others;
mod output;
pub mod peer;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::Result;
use clap::Args;
use serde::Serialize;

use crate::equations::Implementation;
use crate::problem::{self, REFERENCE_S};
use peer::{Peer, Problem};

/// Options of `peers`.
#[derive(Debug, Args)]
pub struct Options {
    /// Repetitions of each timing; all solvers take turns in each.
    #[arg(long, default_value_t = 11)]
    repetitions: usize,
    /// Simulated time of each timing, ms.
    #[arg(long, default_value_t = 10.0)]
    window_ms: f64,
    /// Error at which solvers are compared.
    #[arg(long, default_value_t = 1e-3)]
    at_error: f64,
    /// Only solvers whose name contains this.
    #[arg(long)]
    only: Option<String>,
    /// Folder for peers.json and peers.html.
    #[arg(long, default_value = "out/bench")]
    out: PathBuf,
}

/// One solver with one setting.
#[derive(Debug, Clone, Serialize)]
pub struct Point {
    /// Step in µs or tolerance in the scales of the states.
    pub setting: f64,
    /// RMS scaled error at 2 ms; none if the solver gave up.
    pub error: Option<f64>,
    /// Why it gave up.
    pub failure: Option<String>,
    /// Evaluations of the right-hand side per simulated second.
    pub evaluations_per_s: f64,
    /// Wall seconds per simulated second, every repetition.
    pub wall: Vec<f64>,
}

impl Point {
    /// Fastest repetition.
    pub fn least(&self) -> f64 {
        self.wall.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Median of the repetitions.
    pub fn median(&self) -> f64 {
        let mut sorted = self.wall.clone();
        sorted.sort_by(f64::total_cmp);
        match sorted.len() {
            0 => f64::NAN,
            n => 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]),
        }
    }
}

/// One solver over its settings, coarse to fine.
#[derive(Debug, Clone, Serialize)]
pub struct Curve {
    /// Solver and method.
    pub name: String,
    /// Right-hand side.
    pub equations: &'static str,
    /// What the settings are.
    pub setting_name: &'static str,
    /// Points.
    pub points: Vec<Point>,
}

impl Curve {
    /// Wall time at `error` by interpolation between the last pair of neighbouring
    /// settings that has it between them, both logarithmic.
    pub fn time_at(&self, error: f64, time: impl Fn(&Point) -> f64) -> Option<f64> {
        let usable: Vec<_> = self
            .points
            .iter()
            .filter_map(|p| Some((p.error?, time(p))))
            .filter(|(e, t)| *e > 0.0 && t.is_finite())
            .collect();
        usable
            .windows(2)
            .rev()
            .find(|pair| pair[0].0 >= error && pair[1].0 <= error)
            .map(|pair| {
                let [(e0, t0), (e1, t1)] = [pair[0], pair[1]];
                let share = (error / e0).ln() / (e1 / e0).ln();
                t0 * (t1 / t0).powf(share)
            })
    }
}

/// Runs the comparison.
///
/// # Errors
/// The case is not what it was, or a file cannot be written.
pub fn run(options: &Options) -> Result<()> {
    let problem = Problem::new()?;
    let (own, mut notes) = cageless_methods::Cageless::all()?;
    let driver = match cvode::Driver::new() {
        Ok(driver) => {
            notes.push(format!("CVODE of SUNDIALS {}", driver.version()?));
            Some(driver)
        }
        Err(error) => {
            notes.push(format!(
                "CVODE left out: {error}. Debian's package is libsundials-dev."
            ));
            None
        }
    };
    notes.extend(others::LEFT_OUT.map(str::to_owned));
    let mut peers: Vec<Box<dyn Peer + '_>> = own
        .into_iter()
        .map(|method| Box::new(method) as Box<dyn Peer>)
        .collect();
    for equations in Implementation::ALL {
        let others = others::others(&problem, driver.as_ref(), equations);
        peers.extend(others.into_iter().map(|solver| solver as Box<dyn Peer>));
    }
    if let Some(only) = &options.only {
        peers.retain(|peer| peer.name().contains(only.as_str()));
    }
    for note in &notes {
        eprintln!("{note}");
    }
    let mut curves: Vec<Curve> = peers.iter().map(|peer| errors(peer.as_ref())).collect();
    time(&peers, &mut curves, options);
    output::write(&curves, &notes, options)
}

/// Error of every setting.
fn errors(peer: &dyn Peer) -> Curve {
    let reference = problem::reference();
    let points = peer
        .settings()
        .into_iter()
        .map(|setting| {
            let result = peer.integrate(setting, REFERENCE_S);
            let (error, failure) = match &result {
                Ok(reached) => (Some(problem::rms_difference(&reached.z, &reference)), None),
                Err(error) => (None, Some(error.to_string())),
            };
            Point {
                setting,
                error,
                failure,
                evaluations_per_s: f64::NAN,
                wall: vec![],
            }
        })
        .collect();
    Curve {
        name: peer.name(),
        equations: peer.equations(),
        setting_name: peer.setting_name(),
        points,
    }
}

/// Times every setting, all solvers taking turns, so that a slow spell of the machine
/// hits them alike.
fn time(peers: &[Box<dyn Peer + '_>], curves: &mut [Curve], options: &Options) {
    let window_s = options.window_ms * 1e-3;
    for repetition in 0..options.repetitions {
        eprintln!("repetition {} of {}", repetition + 1, options.repetitions);
        for (peer, curve) in peers.iter().zip(curves.iter_mut()) {
            for point in curve.points.iter_mut().filter(|p| p.failure.is_none()) {
                let clock = Instant::now();
                let result = peer.integrate(point.setting, window_s);
                let wall_s = clock.elapsed().as_secs_f64();
                match result {
                    Ok(reached) => {
                        point.evaluations_per_s = reached.evaluations as f64 / window_s;
                        point.wall.push(wall_s / window_s);
                    }
                    Err(error) => point.failure = Some(error.to_string()),
                }
            }
        }
    }
}
