//! Energy stored in the bodies and contacts, and the balance of the ledger.

use super::energy::EnergyBalance;
use super::model::Model;
use super::space;
use super::state::State;
use crate::contact::{ball_deflection, hertz, inner_deflection};

/// Kinetic energy ½ m v², J.
fn kinetic_j(mass: f64, vx: f64, vy: f64) -> f64 {
    0.5 * mass * (vx * vx + vy * vy)
}

impl Model {
    /// Kinetic and elastic energy, J. In the `paper` formulation the spin is that of
    /// Eq. (13), relative to the orbit.
    pub(crate) fn energy_j(&self, state: &State) -> f64 {
        if let Some(space) = &self.space {
            return space::energy_j(self, space, state);
        }
        let ring = state.ring_motion();
        let outer_ring = state.outer_ring_motion();
        let mut sum =
            kinetic_j(self.ring.mass, ring.vx, ring.vy) + self.energy_under_rotor_j(state);
        for (k, ball) in self.balls.iter().enumerate() {
            let motion = state.ball_motion(k);
            let next = state.ball_motion((k + 1) % self.balls());
            let polar = motion.about(&outer_ring);
            let inner = motion.about(&ring);
            let pair = ball_deflection(ball, next.x - motion.x, next.y - motion.y);
            sum += kinetic_j(ball.mass, motion.vx, motion.vy)
                + 0.5 * self.inertia[k] * motion.spin * motion.spin
                + hertz::energy_j(
                    ball.outer_stiffness_n_m1_5,
                    self.outer_deflection_m(k, &polar),
                )
                + hertz::energy_j(
                    ball.inner_stiffness_n_m1_5,
                    inner_deflection(inner.distance, ball),
                )
                + hertz::energy_j(ball.pair_stiffness, pair);
        }
        sum
    }

    /// Energy of the bodies under a rotor and of their joints; 0 without a rotor.
    pub(super) fn energy_under_rotor_j(&self, state: &State) -> f64 {
        let under = self.under_rotor.as_ref();
        under.map_or(0.0, |under| under.energy_j(state.layout(), state.values()))
    }

    /// Balance of the ledger of a state.
    pub(crate) fn energy_balance(&self, start_energy_j: f64, state: &State) -> EnergyBalance {
        let flows = state.layout().energy_terms().iter().map(|&term| {
            let value = state.energy_term_j(term);
            if term.is_loss() { -value } else { value }
        });
        EnergyBalance::new(start_energy_j, self.energy_j(state), flows)
    }
}
