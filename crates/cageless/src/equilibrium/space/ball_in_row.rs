//! A ball of a row as the equilibrium takes it.

use super::ball::SpatialBall;
use super::outer_section::{Flanks, OuterSection};
use crate::ball::BothContacts;
use crate::case::{Case, Row};
use crate::equilibrium::ball_outer_geometry;
use crate::kinematics::orbit_speed_in_space_rad_s;
use crate::raceway::Slot;

/// Ball `k` of a row at ψ, rolling as in the plane.
pub(super) fn ball_in_row(
    case: &Case,
    row: &Row,
    planar: bool,
    k: usize,
    angle_rad: f64,
    inner_speed_rad_s: f64,
) -> SpatialBall {
    let bearing = &case.bearing;
    let (d, ball) = (bearing.dimensions(), bearing.ball(k));
    let sin_cos = angle_rad.sin_cos();
    let geometry = ball_outer_geometry(case, k, angle_rad);
    let arms_m = BothContacts {
        outer: geometry.effective_radius_m,
        inner: ball.radius_m,
    };
    let speed = bearing.pitch_radius_m()
        * orbit_speed_in_space_rad_s(bearing, inner_speed_rad_s, arms_m, 0.0);
    let doubled = match case.formulation.equations().centrifugal_force {
        true => ball.mass_kg * speed * speed / bearing.pitch_radius_m(),
        false => 0.0,
    };
    let [inner_stiffness_n_m1_5, mut outer_stiffness_n_m1_5, _] = case.ball_stiffness_n_m1_5(k);
    let mut outer = outer_section(case, row, k, angle_rad);
    let mut orbit_radius_m = d.outer_groove_bottom_radius_m - ball.radius_m;
    if planar && !case.flanks.yields() {
        outer.flanks = None;
        orbit_radius_m = geometry.outer_orbit_radius_m;
    }
    if planar && let Some(flanks) = &mut outer.flanks {
        flanks.slot = None;
    }
    if let Some(slot) = outer.flanks.and_then(|flanks| flanks.slot) {
        outer_stiffness_n_m1_5 *= slot.stiffness_ratio[0];
    }
    SpatialBall {
        planar,
        number: k,
        row: 0,
        angle_rad,
        sin_cos,
        radius_m: ball.radius_m,
        mass_kg: ball.mass_kg,
        orbit_radius_m,
        outer,
        axial_m: row.axial_position_m,
        inner_gap_m: d.inner_groove_curvature_radius_m - ball.radius_m,
        inner_centre_m: d.inner_groove_bottom_radius_m + d.inner_groove_curvature_radius_m,
        inner_axial_m: row.contact_sign * bearing.groove_offset_m(),
        inner_stiffness_n_m1_5,
        outer_stiffness_n_m1_5,
        steady_n: ball.mass_kg * case.operation.gravity_m_s2 * sin_cos.1 + doubled,
        turning_n_m: ball.mass_kg * speed * speed,
    }
}

/// The slot at ψ, and ψ from its middle.
pub(crate) fn slot(case: &Case, angle_rad: f64) -> Option<(&Slot, f64)> {
    let raceway = case.raceways.iter().find(|r| r.contains(angle_rad))?;
    Some((raceway.slot()?, raceway.local_angle_rad(angle_rad)))
}

/// Section of the outer raceway at ball `k` of a row, from 0, at ψ.
pub(super) fn outer_section(case: &Case, row: &Row, k: usize, angle_rad: f64) -> OuterSection {
    let bearing = &case.bearing;
    let groove_m = bearing.dimensions().outer_groove_curvature_radius_m;
    let side = row.contact_sign;
    OuterSection {
        gap_m: groove_m - bearing.ball(k).radius_m,
        axial_m: -side * bearing.groove_offset_m() - side * row.preload_m,
        flanks: flanks(case, angle_rad, side),
    }
}

/// Flanks of the raceway at ψ, in a row of this sign.
fn flanks(case: &Case, angle_rad: f64, sign: f64) -> Option<Flanks> {
    let d = case.bearing.dimensions();
    let raceway = case.raceways.iter().find(|r| r.contains(angle_rad))?;
    let flank = raceway.met_angle_rad(raceway.local_angle_rad(angle_rad));
    Some(Flanks {
        angle_rad: flank,
        section_angle_rad: sign * raceway.section_angle_rad(),
        nominal_gap_m: d.outer_groove_curvature_radius_m - d.ball_radius_m,
        depth_error_m: raceway.depth_error_at_m(angle_rad),
        depth_m: raceway.depth_at_m(angle_rad)[0],
        slot: slot(case, angle_rad).map(|(slot, local)| slot.at(local)),
    })
}
