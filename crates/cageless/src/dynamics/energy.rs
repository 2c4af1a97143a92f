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
use crate::contact::{
    ball_deflection, hertz, inner_deflection, journal_energy_j, outer_deflection,
};

/// Terms of the energy ledger, carried in the state so that they are integrated
/// with the accuracy of the motion. All in joules since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyTerm {
    /// Work of the drive that turns the inner ring at ωi; with a rotor that of its drive.
    Drive,
    /// Work of the radial load.
    Load,
    /// Work of gravity on balls, inner ring and rotor.
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
    /// Heat of friction between rotor and inner ring.
    RotorFriction,
    /// Heat of the damping of the contact between rotor and inner ring.
    RotorDamping,
    /// Heat of the damping of the support.
    SupportDamping,
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
const TABLE: [Row; 14] = [
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
    row(EnergyTerm::RotorFriction, "rotor_friction", true),
    row(EnergyTerm::RotorDamping, "rotor_contact_damping", true),
    row(EnergyTerm::SupportDamping, "support_damping", true),
];

/// Number of terms of a bearing without a rotor; those of the rotor come after them.
const WITHOUT_ROTOR: usize = EnergyTerm::RotorFriction as usize;

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

    /// The terms of a bearing without a rotor.
    pub fn without_rotor() -> &'static [Self] {
        &Self::ALL_TERMS[..WITHOUT_ROTOR]
    }

    const ALL_TERMS: &'static [Self] = &Self::ALL;

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
        let outer_ring = state.outer_ring_motion();
        let mut sum = kinetic_j(self.ring.mass, ring.vx, ring.vy) + self.rotor_energy_j(state);
        for (k, ball) in self.balls.iter().enumerate() {
            let motion = state.ball_motion(k);
            let next = state.ball_motion((k + 1) % self.balls());
            let polar = motion.about(&outer_ring);
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

    /// Energy of rotor, turning inner ring and outer ring on its support; 0 without a rotor.
    fn rotor_energy_j(&self, state: &State) -> f64 {
        let (Some(body), Some(motion)) = (&self.rotor, state.rotor_motion()) else {
            return 0.0;
        };
        let ring_speed = state.ring_speed_rad_s().unwrap_or(0.0);
        let contact = body.contact(&motion, &state.ring_motion(), ring_speed);
        kinetic_j(body.mass, motion.vx, motion.vy)
            + 0.5 * body.polar_inertia * motion.speed * motion.speed
            + 0.5 * body.ring_inertia * ring_speed * ring_speed
            + journal_energy_j(&body.journal, contact.contact.deflection)
            + self.outer_ring.energy_j(&state.outer_ring_motion())
    }

    /// What the state lacks to balance its ledger: energy now − energy at the start −
    /// net work, J, and the sum of the absolute terms including the change of
    /// energy, to which it is to be compared.
    pub fn energy_residual_j(&self, start_energy_j: f64, state: &State) -> (f64, f64) {
        let change = self.energy_j(state) - start_energy_j;
        let (mut net, mut sum) = (0.0, change.abs());
        for &term in state.layout().energy_terms() {
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
