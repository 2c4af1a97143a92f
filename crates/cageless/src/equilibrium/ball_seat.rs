//! Where the balls of a case are along the raceway, and the outer raceway under each.

use crate::case::{Case, Gaps};
use crate::outer_contact_geometry::{OuterContactGeometry, flank_section, outer_contact_geometry};

/// ψ of every ball at the start, increasing from ψ of ball 1 (Zhao 2022, Section 4.1).
pub(crate) fn start_angles_rad(case: &Case) -> Vec<f64> {
    let bearing = &case.bearing;
    let n = bearing.balls();
    let mut angle = case.start.lead_ball_angle_rad;
    (0..n)
        .map(|k| {
            let here = angle;
            angle += bearing.pair_angle_rad(k)
                + match &case.start.gaps {
                    Gaps::Uniform => bearing.mean_gap_rad(),
                    Gaps::List(gaps) => gaps[k],
                };
            here
        })
        .collect()
}

/// Geometry of the outer contact of ball `k` of a case at ψ = `angle_rad`.
pub(crate) fn ball_outer_geometry(case: &Case, k: usize, angle_rad: f64) -> OuterContactGeometry {
    let radius = case.bearing.ball(k).radius_m;
    outer_contact_geometry(&case.bearing, &case.raceways, angle_rad, radius)
}

/// r of ball `k` of a case at ψ = `angle_rad` and |rb| = `distance_m`, m: on elastic flanks a ball
/// that is pressed in has a larger one.
pub(crate) fn effective_radius_m(case: &Case, k: usize, angle_rad: f64, distance_m: f64) -> f64 {
    let geometry = ball_outer_geometry(case, k, angle_rad);
    let radius_m = case.bearing.ball(k).radius_m;
    match flank_section(&case.bearing, &case.raceways, angle_rad, radius_m) {
        Some(flanks) if case.flanks.yields() => {
            let press = flanks.press(distance_m - geometry.outer_orbit_radius_m);
            radius_m * press.cosine
        }
        _ => geometry.effective_radius_m,
    }
}
