//! Energy of a ball that rolls on the outer raceway.

use crate::case::Case;
use crate::equilibrium::space::RollingBall;

/// Kinetic and potential energy of a ball that rolls on the outer raceway.
#[derive(Debug, Clone, Copy)]
pub(super) struct RollingEnergy {
    /// Kinetic energy over ½ m vt², 1 + ⅖ (R/ro)².
    kinetic_ratio: f64,
    /// g y, m²/s².
    potential_m2_s2: f64,
}

impl RollingEnergy {
    pub(super) fn new(case: &Case, ball: &RollingBall) -> Self {
        let height_m = -ball.distance_m * ball.angle_rad.cos();
        Self {
            kinetic_ratio: 1.0 + 0.4 / ball.outer_arm.powi(2),
            potential_m2_s2: case.operation.gravity_m_s2 * height_m,
        }
    }

    /// Twice the energy over the mass at vt, m²/s².
    pub(super) fn at_speed_m2_s2(&self, speed_m_s: f64) -> f64 {
        speed_m_s * speed_m_s * self.kinetic_ratio + 2.0 * self.potential_m2_s2
    }

    /// vt with an energy, m/s; `None` where the ball falls off the outer raceway, vt² < g y.
    pub(super) fn speed_m_s(&self, energy_m2_s2: f64) -> Option<f64> {
        let square = (energy_m2_s2 - 2.0 * self.potential_m2_s2) / self.kinetic_ratio;
        (square > self.potential_m2_s2).then(|| square.sqrt())
    }
}
