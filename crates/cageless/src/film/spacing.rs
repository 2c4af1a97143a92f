//! Spacing of balls that lose speed.

use std::f64::consts::TAU;

use crate::bearing::Bearing;

/// Gap that opens behind a ball over the lag of its neighbours, of prototypes at two speeds: 0.80 to 0.92.
const OPENING: f64 = 0.85;
/// Speed deficit over the free share of the pitch circle from which slowed balls may queue: never below 1.1, always
/// from 1.45 on in prototypes.
pub(super) const MAY_QUEUE: f64 = 1.1;
/// Speed deficit over the free share of the pitch circle from which slowed balls queue as a rule.
pub const QUEUE: f64 = 1.3;

/// g_f = 0.85 d · 2π/N, gap that opens behind a ball that enters the load zone, rad; d the share of its speed that it
/// has lost.
pub fn opening_gap_rad(bearing: &Bearing, speed_deficit: f64) -> f64 {
    OPENING * speed_deficit * TAU / bearing.balls() as f64
}

/// s = 1 − N ε/2π, share of the pitch circle that balls leave free.
pub fn free_share(bearing: &Bearing) -> f64 {
    1.0 - bearing.balls() as f64 * bearing.ball_angle_rad() / TAU
}
