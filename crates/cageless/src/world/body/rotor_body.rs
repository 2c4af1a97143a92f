//! A rotor above its bearings: what a world asks of it.

use super::rotor::{ROTOR, RotorCompliance};
use crate::dynamics::plane_path::PlaneDisplacement;
use crate::integrator::SecondOrderBlock;
use crate::world::joint::TouchLoads;

/// Term of the energy ledger of a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotorEnergyTerm {
    /// Work of the inner rings on the journals.
    Journals,
    /// Work of gravity and of given loads along the axis.
    Weight,
    /// Work of the drive.
    Drive,
    /// Energy that the damping of the rotor, its cross-coupled stiffness and Ksdt take out.
    Loss,
}

impl RotorEnergyTerm {
    /// All, in the order of the ledger.
    pub(crate) const ALL: [Self; 4] = [Self::Journals, Self::Weight, Self::Drive, Self::Loss];
}

/// A rotor in its part of the vector of a world, or one for each of several bearings side by side: motion, then energy
/// ledger. All places are counted from the start of that part, and all slices start there.
pub(crate) trait RotorBody: Send {
    /// Length of the part.
    fn dimension(&self) -> usize;

    /// Places of the coordinates at bearing `k`, of those side by side at the first.
    fn places(&self, k: usize) -> [usize; ROTOR];

    /// Place of a term of the energy ledger of the rotor in bearing `k`.
    fn energy_term(&self, term: RotorEnergyTerm, k: usize) -> usize;

    /// Positions and their rates.
    fn second_order_block(&self) -> SecondOrderBlock;

    /// Sets the rates of a state under the loads of the bearings.
    fn set_rates(&mut self, y: &[f64], loads: &[TouchLoads], dydt: &mut [f64]);

    /// Accelerations at bearing `k` under unit loads there, in a state.
    fn compliance(&mut self, y: &[f64], k: usize) -> RotorCompliance;

    /// Adds accelerations under loads of bearing `k` alone that act over a step of `h_s` to the velocities and rates,
    /// in the state of the last [`Self::compliance`].
    fn add_loads(
        &mut self,
        k: usize,
        loads: &TouchLoads,
        h_s: f64,
        y: &mut [f64],
        dydt: &mut [f64],
    );

    /// Kinetic and elastic energy of the rotor in bearing `k`, J.
    fn energy_j(&self, y: &[f64], k: usize) -> f64;

    /// Sets the torque of the drive, N·m.
    fn set_drive_torque(&mut self, torque_n_m: f64);

    /// Size of a difference of two states beside that at the bearings.
    fn error_norm(&self, _difference: &[f64]) -> f64 {
        0.0
    }

    /// Takes the state at the end of a step.
    fn look(&mut self, _y: &[f64]) {}

    /// Planes with a clearance to the stator, with their largest displacements so far.
    fn planes(&self) -> Vec<PlaneDisplacement> {
        vec![]
    }
}
