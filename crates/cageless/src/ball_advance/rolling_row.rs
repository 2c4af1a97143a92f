//! Balls of one row that roll between the rings, the inner one held in its place.

use crate::case::{Case, Gaps};
use crate::equilibrium::space::{RollingBall, SpatialEquilibrium, rolling_balls};

/// Equal balls of one row, evenly around the bearing.
#[derive(Debug, Clone)]
pub(super) struct RollingRow {
    case: Case,
    /// **R**, p, q of the inner ring.
    ring: [f64; 5],
}

impl RollingRow {
    /// Row of `case` whose balls all deviate by `deviation_m` in radius; the inner ring, and the outer one of the row,
    /// stay where `settled` has them. `None` where the deviation is none of a ball.
    pub(super) fn new(
        case: &Case,
        settled: &SpatialEquilibrium,
        row: usize,
        deviation_m: f64,
    ) -> Option<Self> {
        let mut held = case.clone();
        if let Some(mut of_row) = case.rows.get(row).cloned() {
            (of_row.preload_m, of_row.preload_n) = (settled.row_preload_m[row], 0.0);
            held.rows = vec![of_row];
        }
        let deviations_m = vec![deviation_m; case.bearing.balls()];
        let bearing = case.bearing.clone();
        held.bearing = bearing.with_ball_radius_deviations(deviations_m).ok()?;
        held.start.gaps = Gaps::Uniform;
        let rest = &settled.rest;
        let [p, q] = [settled.tilt_y_rad, -settled.tilt_x_rad];
        Some(Self {
            case: held,
            ring: [rest.ring_x_m, rest.ring_y_m, settled.ring_z_m, p, q],
        })
    }

    /// Balls of the row, the first at ψ = `lead_rad`.
    pub(super) fn balls(&mut self, lead_rad: f64) -> Vec<RollingBall> {
        self.case.start.lead_ball_angle_rad = lead_rad;
        rolling_balls(&self.case, self.ring)
    }
}
