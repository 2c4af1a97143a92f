//! Angle over which the inner ring does not reach the balls.

use std::f64::consts::TAU;

use crate::case::{Case, Row};
use crate::equilibrium::space::SpatialEquilibrium;
use crate::numerics::root::brent;

/// Places around the bearing.
const PLACES: usize = 360;
/// Error of the place at which the ring meets a ball, rad.
const EDGE_RAD: f64 = 1e-12;

/// Angle over which the inner ring does not reach balls that lie on the plain outer raceway by their centrifugal force,
/// rad; of the row where it is largest.
pub(super) fn unreached_arc_rad(case: &Case, settled: &SpatialEquilibrium) -> f64 {
    let rows = case.all_rows();
    let arcs = rows
        .iter()
        .zip(&settled.row_preload_m)
        .map(|(row, preload_m)| {
            let bottom = Bottom::new(case, settled, row, *preload_m);
            arc_below_zero_rad(|angle_rad| bottom.depth_m(angle_rad))
        });
    arcs.fold(0.0, f64::max)
}

/// Balls of a row at the bottom of the plain outer raceway, and the inner ring in its place.
struct Bottom {
    /// Place of the inner ring, m.
    ring_m: [f64; 3],
    /// Axis of the inner ring.
    axis: [f64; 3],
    /// Distance of the balls from the axis of the bearing, and their z, m.
    distance_m: f64,
    axial_m: f64,
    /// Distance of the centre of the inner groove from the axis of its ring, and its place along it, m.
    groove_m: f64,
    groove_axial_m: f64,
    /// Radius of the groove less that of a ball, m.
    gap_m: f64,
}

impl Bottom {
    fn new(case: &Case, settled: &SpatialEquilibrium, row: &Row, preload_m: f64) -> Self {
        let (bearing, rest) = (&case.bearing, &settled.rest);
        let radii = bearing.dimensions();
        let pressed_m = (case.centrifugal_force_n() / rest.outer_stiffness_n_m1_5).powf(2.0 / 3.0);
        let [p, q] = [settled.tilt_y_rad, -settled.tilt_x_rad];
        let offset_m = row.contact_sign * bearing.groove_offset_m();
        let groove_radius_m = radii.inner_groove_curvature_radius_m;
        Self {
            ring_m: [rest.ring_x_m, rest.ring_y_m, settled.ring_z_m],
            axis: [p, q, (1.0 - p * p - q * q).sqrt()],
            distance_m: bearing.outer_orbit_radius_m() + pressed_m,
            axial_m: row.axial_position_m - offset_m - row.contact_sign * preload_m,
            groove_m: radii.inner_groove_bottom_radius_m + groove_radius_m,
            groove_axial_m: row.axial_position_m + offset_m,
            gap_m: groove_radius_m - bearing.ball_radius_m(),
        }
    }

    /// Depth by which the inner groove would press a ball at ψ, m, below 0 its distance.
    fn depth_m(&self, angle_rad: f64) -> f64 {
        let (sin, cos) = angle_rad.sin_cos();
        let place_m = [
            self.distance_m * sin - self.ring_m[0],
            -self.distance_m * cos - self.ring_m[1],
            self.axial_m - self.ring_m[2],
        ];
        let along_m: f64 = (0..3).map(|i| place_m[i] * self.axis[i]).sum();
        let across_m: [f64; 3] = std::array::from_fn(|i| place_m[i] - along_m * self.axis[i]);
        let radial_m = across_m.iter().map(|part| part * part).sum::<f64>().sqrt();
        (self.groove_m - radial_m).hypot(along_m - self.groove_axial_m) - self.gap_m
    }
}

/// Angle over which a function of ψ is below zero, rad.
fn arc_below_zero_rad(depth: impl Fn(f64) -> f64) -> f64 {
    let step_rad = TAU / PLACES as f64;
    let of_step = |place: usize| {
        let ends_rad = [place as f64 * step_rad, (place + 1) as f64 * step_rad];
        match ends_rad.map(|angle_rad| depth(angle_rad) < 0.0) {
            [true, true] => step_rad,
            [false, false] => 0.0,
            [is_below, _] => {
                let edge_rad = brent(&depth, ends_rad[0], ends_rad[1], EDGE_RAD);
                let part_rad = edge_rad.unwrap_or(ends_rad[0]) - ends_rad[0];
                if is_below {
                    part_rad
                } else {
                    step_rad - part_rad
                }
            }
        }
    };
    (0..PLACES).map(of_step).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::equilibrium::settle;
    use crate::reference;

    /// In the plane the ring, displaced by e, leaves balls at ρ alone where cos ψ from the direction of e is below
    /// (ρ² + e² − (Ri + Rw)²)/(2ρe).
    #[test]
    fn arc_of_a_displaced_ring_in_the_plane() {
        let case = reference::conventional();
        let settled = settle(&case).unwrap();
        let (bearing, rest) = (&case.bearing, &settled.rest);
        let pressed_m = (case.centrifugal_force_n() / rest.outer_stiffness_n_m1_5).powf(2.0 / 3.0);
        let distance_m = bearing.outer_orbit_radius_m() + pressed_m;
        let shift_m = rest.ring_x_m.hypot(rest.ring_y_m);
        let reach_m = bearing.dimensions().inner_groove_bottom_radius_m + bearing.ball_radius_m();
        let square = distance_m.powi(2) + shift_m.powi(2) - reach_m.powi(2);
        let expected_rad = 2.0 * (PI - (square / (2.0 * distance_m * shift_m)).acos());
        let arc_rad = unreached_arc_rad(&case, &settled);
        assert!(
            (arc_rad - expected_rad).abs() < 1e-8,
            "{arc_rad} {expected_rad}"
        );
        assert!((3.0..3.6).contains(&arc_rad), "{arc_rad}");
    }

    /// An axial load that presses all balls leaves none alone; a light one beside a radial load leaves some.
    #[test]
    fn arc_under_axial_load() {
        let arc_rad = |axial_n: f64| {
            let mut case = reference::conventional();
            case.operation.space.axial_load_n = axial_n;
            unreached_arc_rad(&case, &settle(&case).unwrap())
        };
        let [light, heavy] = [200.0, 4000.0].map(arc_rad);
        assert!((0.5..3.2).contains(&light), "{light}");
        assert_eq!(heavy, 0.0);
    }
}
