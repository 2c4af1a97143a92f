//! The energy ledger: terms, and the energy stored in the bodies.
//!
//! ```
//! use cageless::dynamics::energy::EnergyTerm;
//!
//! assert_eq!(EnergyTerm::Damping.name(), "damping");
//! assert!(EnergyTerm::Damping.is_loss());
//! ```

use super::model::Model;
use super::state::State;
use crate::contact::{ball_deflection, hertz, inner_deflection, outer_deflection};

/// Terms of the energy ledger, carried in the state so that they are integrated
/// with the accuracy of the motion. All in joules since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyTerm {
    /// Work of the drive that keeps the inner ring at ωi.
    Drive,
    /// Work of the radial load.
    Load,
    /// Work of gravity on balls and ring.
    Weight,
    /// Heat of friction at the inner raceway.
    InnerFriction,
    /// Heat of friction at the outer raceway.
    OuterFriction,
    /// Heat of friction between balls.
    BallFriction,
    /// Heat of the damping of the contacts.
    Damping,
    /// Heat of the drag on the inner ring.
    Drag,
    /// `paper` profile: work of the centrifugal force added to Zhao 2022, Eq. (12).
    Centrifugal,
    /// `paper` profile: work of outer friction along the contact path that friction along the
    /// sliding velocity would not do.
    FrictionDirection,
    /// `paper` profile: work of the relative spin of Eq. (13) in place of the absolute one.
    RelativeSpin,
}

/// One row of the table of terms.
struct Row {
    term: EnergyTerm,
    name: &'static str,
    is_loss: bool,
}

const fn row(term: EnergyTerm, name: &'static str, is_loss: bool) -> Row {
    Row {
        term,
        name,
        is_loss,
    }
}

/// The terms in the order of the state vector.
const TABLE: [Row; 11] = [
    row(EnergyTerm::Drive, "drive", false),
    row(EnergyTerm::Load, "radial_load", false),
    row(EnergyTerm::Weight, "weight", false),
    row(EnergyTerm::InnerFriction, "inner_friction", true),
    row(EnergyTerm::OuterFriction, "outer_friction", true),
    row(EnergyTerm::BallFriction, "ball_friction", true),
    row(EnergyTerm::Damping, "damping", true),
    row(EnergyTerm::Drag, "drag", true),
    row(EnergyTerm::Centrifugal, "centrifugal_force", false),
    row(EnergyTerm::FrictionDirection, "friction_direction", false),
    row(EnergyTerm::RelativeSpin, "relative_spin", false),
];

impl EnergyTerm {
    /// All terms, in the order of the state vector.
    pub const ALL: [Self; TABLE.len()] = {
        let mut all = [Self::Drive; TABLE.len()];
        let mut k = 0;
        while k < TABLE.len() {
            all[k] = TABLE[k].term;
            k += 1;
        }
        all
    };

    /// Whether the term counts what leaves the bearing.
    pub fn is_loss(self) -> bool {
        TABLE[self as usize].is_loss
    }

    /// Name in tables and files.
    pub fn name(self) -> &'static str {
        TABLE[self as usize].name
    }
}

/// Kinetic energy ½ m v², J.
fn kinetic_j(mass: f64, vx: f64, vy: f64) -> f64 {
    0.5 * mass * (vx * vx + vy * vy)
}

impl Model {
    /// Kinetic and elastic energy, J. In the `paper` profile the spin is that of
    /// Eq. (13), relative to the orbit.
    pub fn energy_j(&self, state: &State) -> f64 {
        let ring = state.ring_motion();
        let mut sum = kinetic_j(self.ring.mass, ring.vx, ring.vy);
        for (k, ball) in self.balls.iter().enumerate() {
            let motion = state.ball_motion(k);
            let next = state.ball_motion((k + 1) % self.balls());
            let polar = motion.about(&self.outer_centre());
            let geometry = self.outer_geometry(k, &polar);
            let inner = motion.about(&ring);
            let pair = ball_deflection(ball, next.x - motion.x, next.y - motion.y);
            sum += kinetic_j(ball.mass, motion.vx, motion.vy)
                + 0.5 * self.inertia[k] * motion.spin * motion.spin
                + hertz::energy_j(
                    ball.outer_stiffness,
                    outer_deflection(polar.distance, &geometry),
                )
                + hertz::energy_j(ball.inner_stiffness, inner_deflection(inner.distance, ball))
                + hertz::energy_j(ball.pair_stiffness, pair);
        }
        sum
    }

    /// What the state lacks to balance its ledger: energy now − energy at the start −
    /// net work, J, and the sum of the absolute terms including the change of
    /// energy, to which it is to be compared.
    pub fn energy_residual_j(&self, start_energy_j: f64, state: &State) -> (f64, f64) {
        let change = self.energy_j(state) - start_energy_j;
        let (mut net, mut sum) = (0.0, change.abs());
        for term in EnergyTerm::ALL {
            let value = state.energy_term_j(term);
            net += if term.is_loss() { -value } else { value };
            sum += value.abs();
        }
        (change - net, sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_index_their_table() {
        for (k, term) in EnergyTerm::ALL.into_iter().enumerate() {
            assert_eq!(term as usize, k);
        }
    }
}
