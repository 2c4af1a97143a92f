//! The outer ring on its support: constants and acceleration.

use super::ball::Centre;
use crate::rotor::Support;

/// Constants of the outer ring with its housing, which does not turn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct OuterRing {
    /// mo, kg; 0 if it is fixed.
    pub mass: f64,
    /// 1/mo, 1/kg; 0 if it is fixed.
    pub inverse_mass: f64,
    /// ks, N/m.
    pub stiffness: f64,
    /// cs, N·s/m.
    pub damping: f64,
    /// Displacement at which the hard stop is reached, m.
    pub stop_gap: f64,
    /// Stiffness of the stop, N/m; 0 without one.
    pub stop_stiffness: f64,
}

impl OuterRing {
    /// The outer ring on `support`; fixed without one.
    pub fn new(support: Option<&Support>) -> Self {
        let Some(support) = support else {
            return Self::default();
        };
        Self {
            mass: support.mass_kg,
            inverse_mass: 1.0 / support.mass_kg,
            stiffness: support.stiffness_n_m,
            damping: support.damping_n_s_m,
            stop_gap: support.stop.map_or(0.0, |s| s.gap_m),
            stop_stiffness: support.stop.map_or(0.0, |s| s.stiffness_n_m),
        }
    }

    /// Force of the support, N: −ks zo − cs żo, and beyond the gap of the stop the force that it
    /// adds radially. The weight of the ring is carried at its rest place already.
    #[inline(always)]
    pub fn support_force(&self, motion: &Centre) -> [f64; 2] {
        let distance = (motion.x * motion.x + motion.y * motion.y).sqrt();
        let beyond = distance - self.stop_gap;
        let stop = if beyond > 0.0 && self.stop_stiffness > 0.0 {
            self.stop_stiffness * beyond / distance
        } else {
            0.0
        };
        [
            -(self.stiffness + stop) * motion.x - self.damping * motion.vx,
            -(self.stiffness + stop) * motion.y - self.damping * motion.vy,
        ]
    }

    /// Acceleration under the sum of the balls' reactions: mo z̈o + cs żo + ks zo = Σ reactions.
    #[inline(always)]
    pub fn acceleration(&self, motion: &Centre, reactions: [f64; 2]) -> [f64; 2] {
        let support = self.support_force(motion);
        [
            (reactions[0] + support[0]) * self.inverse_mass,
            (reactions[1] + support[1]) * self.inverse_mass,
        ]
    }

    /// Power that the damping of the support dissipates, W.
    #[inline(always)]
    pub fn damping_power(&self, motion: &Centre) -> f64 {
        self.damping * (motion.vx * motion.vx + motion.vy * motion.vy)
    }

    /// Kinetic energy of the ring and energy stored in the support, J.
    pub fn energy_j(&self, motion: &Centre) -> f64 {
        let distance = (motion.x * motion.x + motion.y * motion.y).sqrt();
        let beyond = (distance - self.stop_gap).max(0.0);
        0.5 * self.mass * (motion.vx.powi(2) + motion.vy.powi(2))
            + 0.5 * self.stiffness * distance * distance
            + 0.5 * self.stop_stiffness * beyond * beyond
    }
}
