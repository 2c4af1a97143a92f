//! Balls of one row that roll between the rings, the inner one held in its place.

use std::convert::Infallible;

use super::ball::Ring;
use super::{RollingBall, SpatialEquilibrium, arms_m, rolling};
use crate::case::{Case, Gaps};
use crate::kinematics::orbit_speed_in_space_rad_s;

/// Equal balls of one row, evenly around the bearing.
#[derive(Debug, Clone)]
pub(crate) struct RollingRow {
    case: Case,
    planar: bool,
    ring: Ring,
}

impl RollingRow {
    /// Row of `case` whose balls all deviate by `deviation_m` in radius; the inner ring, and the outer one of the row,
    /// stay where `settled` has them. `None` where the deviation is none of a ball.
    pub fn new(
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
            planar: !case.moves_in_space(),
            ring: [rest.ring_x_m, rest.ring_y_m, settled.ring_z_m, p, q],
        })
    }

    /// Its balls, the first at ψ = `lead_rad`.
    pub fn balls(&mut self, lead_rad: f64) -> Vec<RollingBall> {
        self.case.start.lead_ball_angle_rad = lead_rad;
        let (case, ring) = (&self.case, self.ring);
        let inner_speed_rad_s = case.operation.inner_speed_rad_s;
        let Ok((balance, seated)) = rolling(case, self.planar, inner_speed_rad_s, |balance| {
            Ok::<_, Infallible>(balance.around(ring))
        });
        let balls = balance.balls.iter().zip(&seated.rests);
        let rolling = balls.map(|(ball, rest)| {
            let (arms, angle) = arms_m(case, ball, rest.place, ring);
            let orbit = orbit_speed_in_space_rad_s(&case.bearing, inner_speed_rad_s, arms, angle);
            RollingBall {
                angle_rad: ball.angle_rad,
                distance_m: ball.distance_m(rest.place),
                speed_m_s: orbit * case.bearing.pitch_radius_m(),
                outer_arm: arms[0] / ball.radius_m,
                inner_depth_m: ball.inner_depth_m(rest.place, ring),
            }
        });
        rolling.collect()
    }
}
