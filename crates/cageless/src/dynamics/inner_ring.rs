//! The inner ring: constants and acceleration.

use super::ball::Centre;
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Constants of the inner ring and the forces on it that do not come from the balls.
    pub(crate) struct InnerRing per lane InnerRingLanes {
        /// mi, kg.
        mass,
        /// C, viscous damping of its translation, N·s/m.
        drag,
        /// Fr, N, along −Y.
        radial_load,
        /// g, m/s², along −Y.
        gravity,
    }
}

impl InnerRing {
    /// Acceleration of the centre under the sum of the balls' reactions, m/s²:
    /// mi(Ẍ, Ÿ) + C(Ẋ, Ẏ) = Fr + weight + Σ reactions (Zhao 2022, Eq. (14)).
    #[inline(always)]
    pub(crate) fn acceleration(&self, motion: &Centre, reactions_n: [f64; 2]) -> [f64; 2] {
        let [x, y] = reactions_n;
        [
            (x - self.drag * motion.vx) / self.mass,
            (y - self.drag * motion.vy - self.radial_load - self.weight_n()) / self.mass,
        ]
    }

    /// mi·g, N.
    #[inline(always)]
    pub(crate) fn weight_n(&self) -> f64 {
        self.mass * self.gravity
    }
}
