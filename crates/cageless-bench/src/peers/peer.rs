//! What every solver in the comparison has in common.

use anyhow::Result;
use cageless::Case;

use crate::problem;

/// End of one integration.
pub struct Reached {
    /// Scaled state at the end, as of [`problem::scaled`].
    pub z: Vec<f64>,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// One solver with one implementation of the equations.
pub trait Peer {
    /// Solver and method.
    fn name(&self) -> String;

    /// Which right-hand side it calls.
    fn equations(&self) -> &'static str;

    /// What [`Peer::settings`] are: `step, µs` or `tolerance`.
    fn setting_name(&self) -> &'static str;

    /// Settings, coarse to fine.
    fn settings(&self) -> Vec<f64>;

    /// Integrates CB74 from its start over `duration_s`.
    ///
    /// # Errors
    /// The solver gave up.
    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached>;
}

/// A solver whose steps can be looked at.
pub trait Follow: Peer {
    /// Integrates as [`Peer::integrate`] does; `each_step` gets time and scaled state at the end
    /// of every step.
    ///
    /// # Errors
    /// The solver gave up.
    fn follow(
        &self,
        setting: f64,
        duration_s: f64,
        each_step: &mut EachStep<'_>,
    ) -> Result<Reached>;
}

/// What is called at the end of every step, with the time in s and the scaled state.
pub type EachStep<'a> = dyn FnMut(f64, &[f64]) + 'a;

/// Tolerances of the adaptive solvers, absolute on the scaled states, coarse to fine.
pub const TOLERANCES: [f64; 11] = [
    1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8,
];

/// The case and its scaled start, made once: no solver is charged for it.
pub struct Problem {
    /// The case.
    pub case: Case,
    /// Scaled start.
    pub start: Vec<f64>,
}

impl Problem {
    /// CB74.
    ///
    /// # Errors
    /// The case file is not what it was.
    pub fn new() -> Result<Self> {
        Self::of(problem::cb74(&[])?)
    }

    /// Any case.
    ///
    /// # Errors
    /// The case has no start.
    pub fn of(case: Case) -> Result<Self> {
        let (state, _) = problem::start(&case)?;
        Ok(Self {
            start: problem::scaled(&state),
            case,
        })
    }
}
