//! Rolling kinematics of a ball between the rings (Zhao 2022, Eq. (1) to (3)).
//!
//! ```
//! use cageless::reference;
//! use cageless::kinematics::rolling_orbit_speed_rad_s;
//!
//! # use cageless::Bearing;
//! let bearing = reference::bearing(); // Zhao 2022, Table 1
//!
//! // A ball that rolls on a smaller radius r in the raceway orbits more slowly.
//! let rw = bearing.ball_radius_m();
//! let [plain, raceway] = [rw, 0.9 * rw].map(|r| rolling_orbit_speed_rad_s(&bearing, 1000.0, r));
//! assert!(raceway < plain);
//! # Ok::<(), cageless::InputError>(())
//! ```

use std::ops::Range;

use crate::ball::BothContacts;
use crate::bearing::Bearing;
use crate::numerics::quadrature;
use crate::raceway::Raceway;

/// Intervals of a smooth stretch of a raceway in which its steepest place is sought.
const CHANGE_PLACES: usize = 200;

/// Ω(r) = ωi·Ri/Rm · (1 − Rw/(r + Rw)), the orbital speed of pure rolling with
/// effective contact radius `r` at the outer raceway (Zhao 2022, Eq. (3)), rad/s.
pub fn rolling_orbit_speed_rad_s(bearing: &Bearing, inner_speed_rad_s: f64, r_m: f64) -> f64 {
    orbit_speed_of_rad_s(bearing, bearing.ball_radius_m(), inner_speed_rad_s, r_m)
}

/// Ω(r) of a ball of radius `ball_radius_m` in place of Rw, rad/s.
pub fn orbit_speed_of_rad_s(
    bearing: &Bearing,
    ball_radius_m: f64,
    inner_speed_rad_s: f64,
    r_m: f64,
) -> f64 {
    inner_speed_rad_s * bearing.dimensions().inner_groove_bottom_radius_m / bearing.pitch_radius_m()
        * (1.0 - ball_radius_m / (r_m + ball_radius_m))
}

/// Ω of a ball that rolls under a contact angle, rad/s: with the arms of its rotation at the two
/// contacts, m, and the inner contact at αi,
///
///   Ω = ωi (Ri + ri (1 − cos αi))/Rm · ro/(ro + ri′),
///
/// which is Ω(r) for αi = 0, ro = r, ri′ = Rw.
pub(crate) fn orbit_speed_in_space_rad_s(
    bearing: &Bearing,
    inner_speed_rad_s: f64,
    arms_m: BothContacts,
    inner_angle_rad: f64,
) -> f64 {
    let d = bearing.dimensions();
    let higher = d.inner_groove_curvature_radius_m * (1.0 - inner_angle_rad.cos());
    inner_speed_rad_s * (d.inner_groove_bottom_radius_m + higher) / bearing.pitch_radius_m()
        * (arms_m.outer / (arms_m.outer + arms_m.inner))
}

/// Spin of pure rolling relative to the frame that turns with the ball's orbit,
/// ωb = Ω(r + Rm)/r (Zhao 2022, Eq. (1) with ΔVo = 0), rad/s, clockwise.
pub fn rolling_relative_rotation_rad_s(bearing: &Bearing, orbit_speed_rad_s: f64, r_m: f64) -> f64 {
    orbit_speed_rad_s * (r_m + bearing.pitch_radius_m()) / r_m
}

/// Absolute spin of pure rolling, ω = Ω·Rm/r, rad/s, clockwise: the surface of the
/// ball rests on the outer raceway.
pub fn rolling_rotation_rad_s(bearing: &Bearing, orbit_speed_rad_s: f64, r_m: f64) -> f64 {
    orbit_speed_rad_s * bearing.pitch_radius_m() / r_m
}

/// Largest |d ln Ω/dψ| of a ball that rolls through a raceway: the change of its orbital speed over
/// an angle of 1 rad in fractions of it. Friction that the ball needs to roll grows with it.
pub fn speed_change_max(bearing: &Bearing, raceway: &Raceway) -> f64 {
    let rw = bearing.ball_radius_m();
    // Ω ∝ r/(Rw + r) and r = Rw cos αc.
    let change = |local: f64| {
        let [angle, _] = raceway.contact_angle_rad(local);
        let r = rw * angle.cos();
        rw * rw * raceway.contact_angle_sine_slope(local).abs() / (r * (rw + r))
    };
    let pieces = raceway.pieces().iter().map(|piece| piece.range_rad());
    let largest = pieces.map(|Range { start, end }| {
        let at = |k: usize| change(start + (end - start) * k as f64 / CHANGE_PLACES as f64);
        let places: Vec<f64> = (0..=CHANGE_PLACES).map(at).collect();
        let tops = places.windows(3).map(|v| match [v[1] - v[0], v[1] - v[2]] {
            // The top of the parabola through three places.
            [before, after] if before > 0.0 && after > 0.0 => {
                v[1] + (before - after).powi(2) / (8.0 * (before + after))
            }
            _ => v[0].max(v[2]),
        });
        tops.fold(0.0, f64::max)
    });
    largest.fold(0.0, f64::max)
}

/// Angle by which a ball that rolls through every raceway lags, once per orbit, behind one that
/// rolls on the plain outer ring: ∫ (Ω(Rw)/Ω(r) − 1) dψ.
pub fn raceway_delay_rad(bearing: &Bearing, raceways: &[Raceway]) -> f64 {
    let rw = bearing.ball_radius_m();
    let speed = |r: f64| rolling_orbit_speed_rad_s(bearing, 1.0, r);
    let outside = speed(rw);
    raceways
        .iter()
        .map(|raceway| {
            let centre = raceway.dimensions().centre_angle_rad;
            let excess = |psi: f64| outside / speed(raceway.effective_radius_m(centre + psi)) - 1.0;
            let pieces = raceway.pieces().iter().map(|p| p.range_rad());
            let half = pieces.map(|p| quadrature::gauss(excess, p.start, p.end * (1.0 - 1e-12), 8));
            2.0 * half.sum::<f64>()
        })
        .sum()
}
