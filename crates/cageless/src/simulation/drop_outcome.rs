//! Outcome of the drop of a rotor into its touchdown bearings.

use super::outcome::RunOutcome;
use crate::dynamics::plane_path::PlaneDisplacement;

/// Outcome of a drop.
#[derive(Debug)]
pub struct RotorDropOutcome {
    /// Outcome of each bearing; the work of its journal is the drive of its energy ledger.
    pub bearings: Vec<RunOutcome>,
    /// Outcome of the rotor.
    pub rotor: RotorOutcome,
}

/// Outcome of a rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorOutcome {
    /// Energy balance error of the rotor alone, relative to the sum of the absolute terms.
    pub energy_residual_relative: f64,
    /// Planes of the rotor with a clearance to the stator; none of a rotor of a case.
    pub planes: Vec<PlaneDisplacement>,
}

/// Outcome of the drop of the rotor of a case, from the run of its bearing.
impl From<RunOutcome> for RotorDropOutcome {
    fn from(outcome: RunOutcome) -> Self {
        Self::new(vec![outcome], vec![])
    }
}

impl RotorDropOutcome {
    /// Outcome of the bearings below a rotor with these planes.
    pub(crate) fn new(bearings: Vec<RunOutcome>, planes: Vec<PlaneDisplacement>) -> Self {
        let mut residuals = (bearings.iter()).filter_map(|b| b.rotor_energy_residual_relative);
        let rotor = RotorOutcome {
            // All bearings have that of their common rotor.
            energy_residual_relative: residuals.next().unwrap_or(0.0),
            planes,
        };
        Self { bearings, rotor }
    }

    /// Index of the bearing that ended the drop of all, if one did: it stopped, or could not be
    /// recorded.
    pub fn stopped_bearing(&self) -> Option<usize> {
        self.bearings.iter().position(RunOutcome::has_failed)
    }
}
