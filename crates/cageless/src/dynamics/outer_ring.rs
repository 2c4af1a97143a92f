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
    pub(crate) fn new(support: Option<&Support>) -> Self {
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
    pub(crate) fn support_force(&self, motion: &Centre) -> [f64; 2] {
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

    /// Force of the support along the axis, N: the hard stop is radial.
    #[inline(always)]
    pub(crate) fn support_force_along_axis(&self, z: f64, vz: f64) -> f64 {
        -self.stiffness * z - self.damping * vz
    }

    /// Acceleration under the sum of the balls' reactions: mo z̈o + cs żo + ks zo = Σ reactions.
    #[inline(always)]
    pub(crate) fn acceleration(&self, motion: &Centre, reactions: [f64; 2]) -> [f64; 2] {
        let support = self.support_force(motion);
        [
            (reactions[0] + support[0]) * self.inverse_mass,
            (reactions[1] + support[1]) * self.inverse_mass,
        ]
    }

    /// Power that the damping of the support dissipates, W.
    #[inline(always)]
    pub(crate) fn damping_power(&self, motion: &Centre) -> f64 {
        self.damping * (motion.vx * motion.vx + motion.vy * motion.vy)
    }

    /// Kinetic energy of the ring and energy stored in the support, J.
    pub(crate) fn energy_j(&self, motion: &Centre) -> f64 {
        let distance = (motion.x * motion.x + motion.y * motion.y).sqrt();
        let beyond = (distance - self.stop_gap).max(0.0);
        0.5 * self.mass * (motion.vx.powi(2) + motion.vy.powi(2))
            + 0.5 * self.stiffness * distance * distance
            + 0.5 * self.stop_stiffness * beyond * beyond
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without its damping the support pushes back by the derivative of the energy that it stores,
    /// short of the stop and beyond it.
    #[test]
    fn energy_belongs_to_the_force() {
        let ring = OuterRing {
            mass: 0.5,
            inverse_mass: 2.0,
            stiffness: 2e7,
            damping: 4e3,
            stop_gap: 3e-5,
            stop_stiffness: 1e8,
        };
        let at = |distance: f64| Centre {
            x: 0.6 * distance,
            y: -0.8 * distance,
            ..Centre::default()
        };
        for distance in [1e-5, 2.9e-5, 3.1e-5, 5e-5, 2e-4] {
            let [x, y] = ring.support_force(&at(distance));
            let h = 1e-3 * distance;
            let slope =
                (ring.energy_j(&at(distance + h)) - ring.energy_j(&at(distance - h))) / (2.0 * h);
            let back = -(0.6 * x - 0.8 * y);
            assert!(
                (slope / back - 1.0).abs() < 1e-9,
                "{distance}: {slope} {back}"
            );
            let beyond = (distance - 3e-5).max(0.0);
            assert!((back / (2e7 * distance + 1e8 * beyond) - 1.0).abs() < 1e-12);
        }
        let moving = Centre {
            vx: 3.0,
            vy: -4.0,
            ..at(0.0)
        };
        assert_eq!(ring.energy_j(&moving), 0.5 * 0.5 * 25.0);
        assert_eq!(ring.damping_power(&moving), 4e3 * 25.0);
        assert_eq!(ring.support_force(&moving), [-1.2e4, 1.6e4]);
    }
}
