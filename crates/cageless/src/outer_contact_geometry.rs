//! Geometry of the outer contact of a ball of any radius.
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
use crate::contact::FlankSection;
use crate::error::{Allowed, InputError};
use crate::raceway::Raceway;

/// Orbit radius and effective contact radius of a ball that just touches the outer ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OuterContactGeometry {
    /// Distance of the ball centre from the bearing axis, m.
    pub outer_orbit_radius_m: f64,
    /// r, effective contact radius, m.
    pub effective_radius_m: f64,
}

/// OuterContactGeometry of the outer contact of a ball of radius `ball_radius_m` at ψ = `angle_rad`.
pub(crate) fn outer_contact_geometry(
    bearing: &Bearing,
    raceways: &[Raceway],
    angle_rad: f64,
    ball_radius_m: f64,
) -> OuterContactGeometry {
    let d = bearing.dimensions();
    let Some(raceway) = raceways.iter().find(|r| r.contains(angle_rad)) else {
        return OuterContactGeometry {
            outer_orbit_radius_m: d.outer_groove_bottom_radius_m - ball_radius_m,
            effective_radius_m: ball_radius_m,
        };
    };
    let nominal = raceway.effective_radius_m(angle_rad);
    let error = raceway.depth_error_at_m(angle_rad);
    let touching = bearing.outer_orbit_radius_m() + raceway.depth_at_m(angle_rad)[0];
    if ball_radius_m == d.ball_radius_m && error == 0.0 {
        return OuterContactGeometry {
            outer_orbit_radius_m: touching,
            effective_radius_m: nominal,
        };
    }
    let cosine = nominal / d.ball_radius_m;
    let [own, other, square] = above_flanks(bearing, cosine, error, ball_radius_m);
    let h = square.sqrt();
    OuterContactGeometry {
        outer_orbit_radius_m: touching + h - other * cosine,
        effective_radius_m: ball_radius_m * h / own,
    }
}

/// Flanks at a ball of radius `ball_radius_m` at ψ = `angle_rad`; `None` on the plain raceway.
pub(crate) fn flank_section(
    bearing: &Bearing,
    raceways: &[Raceway],
    angle_rad: f64,
    ball_radius_m: f64,
) -> Option<FlankSection> {
    let raceway = raceways.iter().find(|r| r.contains(angle_rad))?;
    let cosine = raceway.effective_radius_m(angle_rad) / bearing.ball_radius_m();
    let error = raceway.depth_error_at_m(angle_rad);
    let [gap, _, square] = above_flanks(bearing, cosine, error, ball_radius_m);
    Some(FlankSection {
        gap,
        height: square.sqrt(),
        cosine,
    })
}

/// Re + e − R, Re − Rw and h², which is negative where the ball touches no flank.
fn above_flanks(bearing: &Bearing, cosine: f64, error_m: f64, ball_radius_m: f64) -> [f64; 3] {
    let d = bearing.dimensions();
    let re = d.outer_groove_curvature_radius_m;
    let (own, other) = (re + error_m - ball_radius_m, re - d.ball_radius_m);
    [
        own,
        other,
        own * own - other * other * (1.0 - cosine * cosine),
    ]
}

/// Angles at which [`check`] tests the geometry, from the middle of a raceway to its end.
const TRIED: u32 = 32;

/// Checks that every ball touches both flanks of every raceway, all along it.
///
/// # Errors
/// An [`InputError`] naming the deviation of the ball that does not, or the depth error.
pub(crate) fn check(bearing: &Bearing, raceways: &[Raceway]) -> Result<(), InputError> {
    let rw = bearing.ball_radius_m();
    let largest = bearing
        .ball_radius_deviations_m()
        .iter()
        .fold(0.0, |most: f64, d| most.max(*d));
    // Edges of a slot reach any ball.
    for raceway in raceways.iter().filter(|r| r.slot().is_none()) {
        let middle = raceway.dimensions().centre_angle_rad;
        for k in 0..TRIED {
            let angle = middle + raceway.half_angle_rad() * f64::from(k) / f64::from(TRIED);
            let cosine = raceway.effective_radius_m(angle) / rw;
            let error = raceway.depth_error_at_m(angle);
            let [own, _, square] = above_flanks(bearing, cosine, error, rw + largest);
            if own > 0.0 && square > 0.0 {
                continue;
            }
            let room = bearing.dimensions().outer_groove_curvature_radius_m - rw;
            // own = (Re − Rw) sin α is where the two flanks meet.
            let most = room + error - room * (1.0 - cosine * cosine).sqrt();
            return Err(if largest > 0.0 {
                let why = "a larger ball does not reach down to both flanks of the raceway";
                InputError::new(
                    "ball_radius_deviation_m",
                    largest,
                    Allowed::Below(most, why),
                )
            } else {
                let depth_m = raceway.depth_error_m();
                let why = "the balls do not reach down to both flanks of the raceway";
                InputError::new(
                    "depth_error_m",
                    depth_m,
                    Allowed::Above(depth_m - most, why),
                )
            });
        }
    }
    Ok(())
}
