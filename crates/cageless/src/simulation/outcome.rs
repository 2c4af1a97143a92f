//! Outcome of a run.

use super::guard::{Cause, Stop};
use super::observer::ObserverError;
use crate::case::Case;
use crate::dynamics::InstructionSet;
use crate::dynamics::state::State;

/// Ending of a run.
#[derive(Debug)]
pub enum Ending {
    /// Completed its duration.
    Complete,
    /// Interrupted by the caller.
    Interrupted,
    /// Stopped because it left the physical range.
    Stopped(Stop),
    /// Stopped because an observer failed.
    ObserverFailed(ObserverError),
}

/// Outcome of a run.
#[derive(Debug)]
pub struct RunOutcome {
    /// Ending of the run.
    pub ending: Ending,
    /// Simulated time reached.
    pub end_s: f64,
    /// Steps made.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub rhs_evaluations: u64,
    /// Last state, with the energy ledger.
    pub state: State,
    /// Kinetic and elastic energy at the start.
    pub start_energy_j: f64,
    /// Kinetic and elastic energy at the end.
    pub end_energy_j: f64,
    /// Energy now − energy at the start − net work, over the sum of absolute flows, at least
    /// 1e-6 of the energy at the start.
    pub energy_residual_relative: f64,
    /// Energy balance error of the rotor alone, which all bearings below it have in common; `None` without a rotor.
    pub rotor_energy_residual_relative: Option<f64>,
    /// Instructions used.
    pub instruction_set: InstructionSet,
}

/// Largest energy balance error, relative, of numbers that can be trusted.
pub const RESIDUAL_FRACTION: f64 = 0.01;

impl RunOutcome {
    /// The outcome of a whole run of the case: one whose energy does not balance at its end stopped there, as its
    /// numbers are no evidence.
    pub(super) fn of_whole_run(mut self, case: &Case) -> Self {
        let (of_bearing, of_rotor) = (
            self.energy_residual_relative,
            self.rotor_energy_residual_relative.unwrap_or(0.0),
        );
        let residual_fraction = if of_rotor.abs() > of_bearing.abs() {
            of_rotor
        } else {
            of_bearing
        };
        let balanced = residual_fraction.abs() <= RESIDUAL_FRACTION;
        if matches!(self.ending, Ending::Complete) && !balanced {
            let cause = Cause::Unbalanced { residual_fraction };
            self.ending = Ending::Stopped(Stop::new(case, self.end_s, cause));
        }
        self
    }

    /// Whether the run stopped, or could not be recorded.
    pub fn has_failed(&self) -> bool {
        matches!(self.ending, Ending::Stopped(_) | Ending::ObserverFailed(_))
    }
}
