//! The support of the outer ring: spring and damper to the ground, and a hard stop.

use crate::ball::{AxialMotion, Centre};
use crate::rotor::Support;

/// Constants of the support; all 0 without one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SupportJoint {
    /// ks, N/m.
    pub stiffness: f64,
    /// cs, N·s/m.
    pub damping: f64,
    /// Displacement at which the hard stop is reached, m.
    pub stop_gap: f64,
    /// Stiffness of the stop, N/m; 0 without one.
    pub stop_stiffness: f64,
}

impl SupportJoint {
    /// The joint that `support` describes.
    pub(crate) fn new(support: &Support) -> Self {
        Self {
            stiffness: support.stiffness_n_m,
            damping: support.damping_n_s_m,
            stop_gap: support.stop.map_or(0.0, |s| s.gap_m),
            stop_stiffness: support.stop.map_or(0.0, |s| s.stiffness_n_m),
        }
    }

    /// Force on the ring, N: −ks zo − cs żo, and beyond the gap of the stop the force that it
    /// adds radially. The weight of the ring is carried at its rest place already.
    #[inline(always)]
    pub(crate) fn force(&self, motion: &Centre) -> [f64; 2] {
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

    /// Force along the axis, N: the hard stop is radial.
    #[inline(always)]
    pub(crate) fn force_along_axis(&self, motion: &AxialMotion) -> f64 {
        -self.stiffness * motion.z - self.damping * motion.vz
    }

    /// Power that the damping takes out, W.
    #[inline(always)]
    pub(crate) fn damping_power(&self, motion: &Centre, vz: f64) -> f64 {
        self.damping * (motion.vx * motion.vx + motion.vy * motion.vy) + self.damping * vz * vz
    }

    /// Stored energy, J.
    pub(crate) fn energy_j(&self, motion: &Centre, z: f64) -> f64 {
        let distance = (motion.x * motion.x + motion.y * motion.y).sqrt();
        let beyond = (distance - self.stop_gap).max(0.0);
        0.5 * self.stiffness * distance * distance
            + 0.5 * self.stop_stiffness * beyond * beyond
            + 0.5 * self.stiffness * z * z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without its damping the support pushes back by the derivative of the energy that it stores,
    /// short of the stop and beyond it.
    #[test]
    fn energy_belongs_to_the_force() {
        let support = SupportJoint {
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
        let energy_j = |distance: f64| support.energy_j(&at(distance), 0.0);
        for distance in [1e-5, 2.9e-5, 3.1e-5, 5e-5, 2e-4] {
            let [x, y] = support.force(&at(distance));
            let h = 1e-3 * distance;
            let slope = (energy_j(distance + h) - energy_j(distance - h)) / (2.0 * h);
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
        assert_eq!(support.damping_power(&moving, 2.0), 4e3 * 29.0);
        assert_eq!(support.force(&moving), [-1.2e4, 1.6e4]);
        let along_axis = AxialMotion { z: 1e-5, vz: 2.0 };
        assert_eq!(support.force_along_axis(&along_axis), -8200.0);
    }
}
