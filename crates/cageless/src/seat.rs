//! Where a ball of any radius sits in the outer ring.
//!
//! A discrete raceway is laid out for nominal balls: they touch its two flanks, circles of
//! radius Re about Oe (Zhao 2022, Eq. (7)), at the contact angle α with cos α = r/Rw, and
//! their centres stay at Ro − Rw. The centre of a ball of radius R that touches both flanks
//! lies Re − R from either Oe, whose axial distance from the plane of the balls is
//! s = (Re − Rw) sin α. Along the radius it lies h = √((Re − R)² − s²) beyond Oe, a nominal
//! ball (Re − Rw) cos α. With that difference
//!
//!   distance from the axis = Ro − Rw + h − (Re − Rw) cos α,   r = R·h/(Re − R).
//!
//! On the plain raceway, α = 0, these are Ro − R and R. A raceway milled too deep by e along the
//! normals of its flanks has flanks of radius Re + e about the same Oe.

use crate::bearing::Bearing;
use crate::raceway::Raceway;

/// Place of a ball's centre when it just touches the outer ring, and its arm there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seat {
    /// Distance from the bearing axis.
    pub touching_radius_m: f64,
    /// r, effective contact radius.
    pub effective_radius_m: f64,
}

/// Seat of a ball of radius `ball_radius_m` at ψ = `angle_rad`.
pub fn seat(bearing: &Bearing, raceways: &[Raceway], angle_rad: f64, ball_radius_m: f64) -> Seat {
    let d = bearing.dimensions();
    let Some(raceway) = raceways.iter().find(|r| r.contains(angle_rad)) else {
        return Seat {
            touching_radius_m: d.outer_groove_bottom_radius_m - ball_radius_m,
            effective_radius_m: ball_radius_m,
        };
    };
    let nominal = raceway.effective_radius_m(angle_rad);
    let error = raceway.depth_error_at_m(angle_rad);
    if ball_radius_m == d.ball_radius_m && error == 0.0 {
        return Seat {
            touching_radius_m: bearing.touching_radius_m(),
            effective_radius_m: nominal,
        };
    }
    let cosine = nominal / d.ball_radius_m;
    let re = d.outer_groove_curvature_radius_m;
    let (own, other) = (re + error - ball_radius_m, re - d.ball_radius_m);
    let h = (own * own - other * other * (1.0 - cosine * cosine)).sqrt();
    Seat {
        touching_radius_m: bearing.touching_radius_m() + h - other * cosine,
        effective_radius_m: ball_radius_m * h / own,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raceway::RacewayDimensions;
    use crate::{BearingDimensions, Material};

    fn bearing() -> Bearing {
        let dimensions = BearingDimensions {
            balls: 14,
            ball_radius_m: 4.7625e-3,
            inner_groove_bottom_radius_m: 18.24e-3,
            outer_groove_bottom_radius_m: 27.765e-3,
            outer_shoulder_radius_m: 26e-3,
            inner_groove_curvature_radius_m: 4.953e-3,
            outer_groove_curvature_radius_m: 4.953e-3,
            inner_ring_mass_kg: 0.2,
            inner_ring_drag_n_s_m: 2000.0,
        };
        let material = Material {
            density_kg_m3: 7850.0,
            youngs_modulus_pa: 206e9,
            poisson_ratio: 0.3,
        };
        Bearing::new(dimensions, material).unwrap()
    }

    /// The distance of the ball's centre from Oe, taken from the surface itself, is Re − R.
    #[test]
    fn the_ball_touches_both_flanks() {
        let bearing = bearing();
        let dimensions = RacewayDimensions {
            axial_span_m: 5.1e-3,
            half_angle_rad: 25.2f64.to_radians(),
            centre_angle_rad: 0.0,
        };
        let raceway = Raceway::new(dimensions, &bearing).unwrap();
        let re = bearing.dimensions().outer_groove_curvature_radius_m;
        for angle in [0.0, 0.1, -0.3, 0.43] {
            for deviation in [-20e-6, -1e-6, 0.0, 1e-6, 20e-6] {
                let radius = bearing.ball_radius_m() + deviation;
                let raceways = [raceway.clone()];
                let seat = seat(&bearing, &raceways, angle, radius);
                let centre = raceway.groove_centre_m(raceway.path_x_m(angle));
                let radial = centre[0].hypot(centre[1]);
                let distance = (seat.touching_radius_m - radial).hypot(centre[2]);
                assert!(
                    (distance - (re - radius)).abs() < 1e-12,
                    "{angle} {deviation}"
                );
                // The contact points lie on the line from Oe through the centre.
                let arm = radius * (seat.touching_radius_m - radial) / distance;
                assert!((seat.effective_radius_m - arm).abs() < 1e-12);
            }
        }
    }

    /// In the middle, too deep by e is what a ball smaller by e sees, but for its arm.
    #[test]
    fn depth_lets_the_ball_out() {
        let bearing = bearing();
        let dimensions = RacewayDimensions {
            axial_span_m: 5.1e-3,
            half_angle_rad: 25.2f64.to_radians(),
            centre_angle_rad: 0.0,
        };
        let raceway = Raceway::new(dimensions, &bearing).unwrap();
        let radius = bearing.ball_radius_m();
        let deep = [raceway.clone().with_depth_error(2e-6).unwrap()];
        let smaller = seat(&bearing, &[raceway], 0.0, radius - 2e-6);
        let deeper = seat(&bearing, &deep, 0.0, radius);
        assert!((deeper.touching_radius_m - smaller.touching_radius_m).abs() < 1e-15);
        // It sits 2 µm over cos α further out.
        let out = deeper.touching_radius_m - bearing.touching_radius_m();
        let cosine = deep[0].effective_radius_m(0.0) / radius;
        assert!((out / (2e-6 / cosine) - 1.0).abs() < 0.02, "{out}");
        let end = seat(&bearing, &deep, 25.199f64.to_radians(), radius);
        assert!((end.touching_radius_m - bearing.touching_radius_m()).abs() < 1e-9);
    }

    #[test]
    fn the_plain_raceway_holds_any_ball_at_its_bottom() {
        let bearing = bearing();
        let seat = seat(&bearing, &[], 1.0, 4.77e-3);
        assert!((seat.touching_radius_m - (27.765e-3 - 4.77e-3)).abs() < 1e-15);
        assert_eq!(seat.effective_radius_m, 4.77e-3);
    }
}
