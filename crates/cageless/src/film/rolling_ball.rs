//! Rolling of a ball in static equilibrium: load and speed of each of its contacts.

use super::rolling_force::Rolling;
use crate::case::Case;
use crate::equilibrium::space::SpatialEquilibrium;

/// Contact of a ball with a flank of the outer raceway.
#[derive(Debug, Clone, Copy)]
pub(super) struct RollingFlank {
    /// cos α of its normal.
    pub cosine: f64,
    /// Load and speed.
    pub rolling: Rolling,
    /// (ρ + 2R cos α)/ρ, part of the orbit in 2u.
    pub gear: f64,
    /// Rotation across the normal, rad/s.
    pub turn_rad_s: f64,
}

/// Ball that rolls on both raceways at the speed that its contact angles give.
#[derive(Debug, Clone, Copy)]
pub(super) struct RollingBall {
    /// At the inner raceway.
    pub inner: Rolling,
    /// Rotation against the ring there, across the normal, rad/s.
    pub inner_turn_rad_s: f64,
    /// (ρA − R cos α)/(ρA + R cos α), part of the orbit in 2u there.
    pub inner_gear: f64,
    /// cos α there over the distance of the contact from the axis of the ring, 1/m.
    pub inner_curvature: f64,
    /// At the flanks of the outer raceway; at the plain one the first is all.
    pub outer: [RollingFlank; 2],
}

impl RollingBall {
    /// Ball of all rows, from 0. It turns about an axis across the force at the outer raceway, α′ its angle:
    ///
    ///   outer: 2u = vt (ρ + 2R cos α)/ρ + ωR cos(α − α′),   vt = ωr,
    ///   inner: 2u = ωi ρA + ωR cos(α − α′) − vt (ρA − R cos α)/(ρA + R cos α).
    pub(super) fn new(case: &Case, settled: &SpatialEquilibrium, ball: usize) -> Self {
        let (bearing, rest) = (&case.bearing, &settled.rest);
        let radii = bearing.dimensions();
        let radius_m = bearing.ball_radius_m();
        let speed_m_s = settled.orbit_speed_rad_s[ball] * bearing.pitch_radius_m();
        let spin_rad_s = speed_m_s / rest.effective_radius_m[ball];
        let pitch_rad = or_zero(settled.outer_contact_angle_rad[ball]);
        let turn_rad_s = |angle_rad: f64| spin_rad_s * (angle_rad - pitch_rad).cos();
        let distance_m = rest.ball_distance_m[ball];
        let flank = |flank: usize| {
            let angle_rad = or_zero(settled.flank_angle_rad[ball][flank]);
            let cosine = angle_rad.cos();
            let gear = (distance_m + 2.0 * radius_m * cosine) / distance_m;
            let turn_rad_s = turn_rad_s(angle_rad);
            RollingFlank {
                cosine,
                rolling: Rolling {
                    load_n: settled.flank_force_n[ball][flank],
                    speed_m_s: 0.5 * (gear * speed_m_s + radius_m * turn_rad_s),
                },
                gear,
                turn_rad_s,
            }
        };
        let angle_rad = or_zero(settled.inner_contact_angle_rad[ball]);
        let cosine = angle_rad.cos();
        let contact_m = radii.inner_groove_bottom_radius_m
            + radii.inner_groove_curvature_radius_m * (1.0 - cosine);
        let (reach_m, inner_rad_s) = (radius_m * cosine, case.operation.inner_speed_rad_s);
        let turned_m_s = radius_m * turn_rad_s(angle_rad);
        let inner_gear = (contact_m - reach_m) / (contact_m + reach_m);
        Self {
            inner: Rolling {
                load_n: rest.inner_force_n[ball],
                speed_m_s: 0.5 * (inner_rad_s * contact_m + turned_m_s - inner_gear * speed_m_s),
            },
            inner_turn_rad_s: turn_rad_s(angle_rad) + inner_rad_s * cosine,
            inner_gear,
            inner_curvature: cosine / contact_m,
            outer: [flank(0), flank(1)],
        }
    }
}

/// An angle, 0 without contact.
fn or_zero(angle_rad: f64) -> f64 {
    if angle_rad.is_nan() { 0.0 } else { angle_rad }
}
