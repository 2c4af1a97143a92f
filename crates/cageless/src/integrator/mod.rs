//! Integration of ordinary differential equations. Nothing here knows of bearings.

mod abm4;
mod adaptive;
mod hermite;
mod runge_kutta;
mod symplectic;
pub mod tableau;

pub use abm4::Abm4;
pub use adaptive::Adaptive;
pub use hermite::hermite;
pub use runge_kutta::{CrossingError, Made, RungeKutta};
pub use symplectic::{Drift, Symplectic};

/// A system of ordinary differential equations dy/dt = f(t, y).
pub trait System {
    /// Length of y.
    fn dimension(&self) -> usize;

    /// Writes f(t, y) into `dydt`.
    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]);

    /// Fingerprint of the smooth piece of f that the last evaluation lay in. Where it
    /// changes between two steps, f has jumped, or changed so abruptly that the history of
    /// a multistep method must not reach across. The system decides what counts.
    fn regime(&self) -> u64 {
        0
    }

    /// Which components are places and which their rates, in ascending order of the places;
    /// for methods that advance them one after the other.
    fn drifts(&self) -> &[Drift] {
        &[]
    }

    /// Size of a difference of two states in the scales of the problem; 1 is as large
    /// as what is of interest.
    fn error_norm(&self, difference: &[f64]) -> f64 {
        difference.iter().fold(0.0, |m, d| m.max(d.abs()))
    }
}

/// One accepted step: states and rates at both ends.
#[derive(Debug, Clone, Copy)]
pub struct Step<'a> {
    /// Start.
    pub from_s: f64,
    /// End.
    pub to_s: f64,
    /// State at the start.
    pub before: &'a [f64],
    /// f at the start.
    pub rate_before: &'a [f64],
    /// State at the end.
    pub after: &'a [f64],
    /// f at the end; the system's work arrays are as of this evaluation.
    pub rate_after: &'a [f64],
}

/// A method that advances a system step by step.
pub trait Integrator {
    /// Forgets all history and starts at `y`.
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]);

    /// Makes the next step, which ends at `limit_s` at the latest.
    ///
    /// # Errors
    /// [`CrossingError`] if a step could not be resolved.
    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), CrossingError>;

    /// The last step. The system's last evaluation was at its end.
    fn step(&self) -> Step<'_>;
}

/// End of a step of size `h` that should end at `end_s` but not pass `limit_s`. What
/// would be left after it, if it is rounding, is taken along.
fn bounded(end_s: f64, limit_s: f64, h: f64) -> f64 {
    if end_s > limit_s - 1e-6 * h {
        limit_s
    } else {
        end_s
    }
}
