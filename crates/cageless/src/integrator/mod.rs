//! Integration of ordinary differential equations. Nothing here knows of bearings.

mod abm4;
mod hermite;
mod runge_kutta;

pub use abm4::Abm4;
pub use hermite::hermite;
pub use runge_kutta::{CrossingError, RungeKutta};

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

/// A method that advances a system in fixed steps.
pub trait Integrator {
    /// Forgets all history and starts at `y`.
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]);

    /// Advances one step of the fixed size.
    ///
    /// # Errors
    /// [`CrossingError`] if a step across a jump of f could not be resolved.
    fn advance<S: System>(&mut self, system: &mut S) -> Result<(), CrossingError>;

    /// The last step.
    fn step(&self) -> Step<'_>;
}
