//! The angle of the flanks along a stretch of a raceway.

use std::fmt::Debug;
use std::sync::Arc;

use super::contact_path::ContactPath;

/// αc over ψ, each smooth within the raceway between its junctions.
pub(super) trait FlankAngle: Debug + Send + Sync {
    /// αc and dαc/dψ at local ψ within ±θ; at the ends the limit from within.
    fn at(&self, local_angle_rad: f64) -> [f64; 2];

    /// sin αc dαc/dψ, which is finite up to the ends also where dαc/dψ is not.
    fn sine_slope(&self, local_angle_rad: f64) -> f64 {
        let [angle, slope] = self.at(local_angle_rad);
        angle.sin() * slope
    }

    /// Whether αc runs out at a right angle to the plain raceway: dαc/dψ has no limit at the ends.
    fn ends_at_right_angle(&self) -> bool {
        false
    }

    /// Local ψ at which αc is less smooth than between them.
    fn junctions_rad(&self) -> Vec<f64> {
        vec![]
    }

    /// r = Rw cos αc at local ψ.
    fn radius_m(&self, local_angle_rad: f64, ball_radius_m: f64) -> f64 {
        let [angle, _] = self.at(local_angle_rad);
        ball_radius_m * angle.cos()
    }

    /// n such that αc/(sin²θ − sin²ψ)ⁿ is smooth over sin²ψ.
    fn order(&self) -> f64 {
        1.0
    }

    /// αc/(sin²θ − sin²ψ)ⁿ at `square` = sin²ψ, with sin²θ = `end`.
    fn regular(&self, square: f64, end: f64) -> f64 {
        self.at(square.sqrt().asin())[0] / (end - square)
    }

    /// The quartic path of Zhao 2022, if these are its flanks.
    fn contact_path(&self) -> Option<&ContactPath> {
        None
    }
}

/// Flanks that pieces of a raceway share.
pub(super) type Flanks = Arc<dyn FlankAngle>;
