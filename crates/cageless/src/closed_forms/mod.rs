//! Gap and lag of a raceway in closed form: Eq. (11) of the paper and rolling without slip.
//!
//! ```
//! use cageless::closed_forms::{Eq11, theoretical_gap_rad};
//! use cageless::reference::{self, Structure};
//!
//! let bearing = reference::bearing(); // Zhao 2022, Table 1
//! let raceway = Structure::D.raceway(&bearing)?;
//!
//! let gap = theoretical_gap_rad(&bearing, &raceway, Eq11::Published);
//! assert!((gap.to_degrees() - 1.817).abs() < 2e-3); // Table 2: 1.8171°
//! # Ok::<(), cageless::InputError>(())
//! ```

mod contact_angle;
mod friction_demand;

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::bearing::Bearing;
use crate::kinematics::raceway_delay_rad;
use crate::numerics::{quadrature, root};
use crate::raceway::{Raceway, RacewayDimensions, RacewayForm, axial_span_limit_m};

pub use contact_angle::{
    ContactAngleEstimate, kinematic_gap_rad, kinematic_lag_rad, rolling_lag_fraction, seats,
};
pub use friction_demand::friction_demand;

/// Reading of φ in Zhao 2022, Eq. (11).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Eq11 {
    /// x = Ro·sin φ, as published. It takes φ for the polar angle.
    Published,
    /// φ is the position angle ψ of the ball.
    Polar,
}

/// β0 = ½ ∫ (r + Rw)/r dφ − ε over [−ε/2, ε/2], the gap that a passage without slip
/// closes exactly (Zhao 2022, Eq. (11)), rad.
pub fn theoretical_gap_rad(bearing: &Bearing, raceway: &Raceway, meaning: Eq11) -> f64 {
    let epsilon = bearing.ball_angle_rad();
    let (rw, ro) = (
        bearing.ball_radius_m(),
        bearing.dimensions().outer_groove_bottom_radius_m,
    );
    let theta = raceway.half_angle_rad();
    let centre = raceway.dimensions().centre_angle_rad;
    let integrand = |phi: f64| {
        let r = match meaning {
            Eq11::Published => raceway.effective_radius_at_x_m(ro * phi.sin()),
            Eq11::Polar => raceway.effective_radius_m(centre + phi),
        };
        (r + rw) / r
    };
    // φ of the place ψ of a ball.
    let phi = |psi: f64| match meaning {
        Eq11::Published => {
            let distance =
                bearing.outer_orbit_radius_m() + raceway.effective_radius_m(centre + psi);
            (distance * psi.sin() / ro).min(1.0).asin()
        }
        Eq11::Polar => psi,
    };
    // The integrand is even, smooth over each piece up to θ and 2 beyond.
    let end = (epsilon / 2.0).min(theta);
    let (mut inside, mut from) = (0.0, 0.0);
    for junction in raceway.pieces()[1..]
        .iter()
        .map(|p| phi(p.range_rad().start))
    {
        let to = junction.min(end);
        inside += quadrature::gauss(integrand, from, to, 8);
        from = to;
    }
    inside += quadrature::gauss(integrand, from, end, 8);
    inside + 2.0 * (epsilon / 2.0 - end) - epsilon
}

/// θ at which a raceway of this form and span lC has β0 = `gap_rad` (Zhao 2022, Fig. 5), or `None`
/// if no angle that the bearing allows does.
pub fn half_angle_for_gap_rad(
    bearing: &Bearing,
    form: RacewayForm,
    axial_span_m: f64,
    gap_rad: f64,
    meaning: Eq11,
) -> Option<f64> {
    let gap = |theta: f64| {
        let dimensions = RacewayDimensions {
            axial_span_m,
            half_angle_rad: theta,
            centre_angle_rad: 0.0,
        };
        Raceway::formed(dimensions, form, bearing)
            .map(|raceway| theoretical_gap_rad(bearing, &raceway, meaning))
    };
    // β0 grows with θ; the path exists up to an angle that depends on the span, and a raceway takes its
    // ends from an angle on.
    let least = (1.0 + 1e-9) * form.half_angle_min_rad(bearing, axial_span_m);
    let (mut low, mut high) = (least.max(1e-3), FRAC_PI_2 * 0.999);
    if gap(high).is_err() {
        gap(low).ok()?;
        high = root::last_where(low, high, 1e-9, |theta| gap(theta).is_ok());
    }
    if gap(low).ok()? > gap_rad {
        low = least.max(1e-6);
    }
    root::try_brent(|theta| gap(theta).map(|g| g - gap_rad), low, high, 1e-12).ok()?
}

/// One point of the lC–θ curve of a form, for that of the paper Zhao 2022, Fig. 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// lC.
    pub axial_span_m: f64,
    /// θ by Eq. (11) as published.
    pub half_angle_rad: Option<f64>,
    /// θ by Eq. (11) with the true polar angle.
    pub half_angle_polar_rad: Option<f64>,
}

/// θ over lC of raceways of a form for the gap of evenly spaced balls, at `points` spans up to the limit of
/// Eq. (8); spans that no angle serves are left out.
pub fn span_angle_curve(bearing: &Bearing, form: RacewayForm, points: usize) -> Vec<CurvePoint> {
    let limit = axial_span_limit_m(bearing);
    let gap = bearing.nominal_gap_rad();
    (1..points)
        .map(|k| {
            let axial_span_m = limit * k as f64 / points as f64;
            let angle = |meaning| half_angle_for_gap_rad(bearing, form, axial_span_m, gap, meaning);
            CurvePoint {
                axial_span_m,
                half_angle_rad: angle(Eq11::Published),
                half_angle_polar_rad: angle(Eq11::Polar),
            }
        })
        .filter(|p| p.half_angle_rad.is_some() || p.half_angle_polar_rad.is_some())
        .collect()
}

/// Largest number of balls inside a raceway at once, when they touch: ⌊2θ/ε⌋ + 1.
pub fn balls_in_raceway_max(bearing: &Bearing, raceway: &Raceway) -> usize {
    (2.0 * raceway.half_angle_rad() / bearing.ball_angle_rad()).floor() as usize + 1
}

/// Gap outside the raceways when N balls roll by evenly in time, without slip: each
/// takes T = (1/N) ∮ dψ/Ω(r(ψ)), and the balls outside are Ω·T apart. It is wider than
/// 2π/N − ε, because the balls inside are closer.
pub fn steady_gap_rad(bearing: &Bearing, raceways: &[Raceway]) -> f64 {
    gap_of_delay_rad(bearing, raceway_delay_rad(bearing, raceways))
}

/// Gap outside the raceways of N balls that come by evenly in time and lag by `delay_rad` an orbit.
pub fn gap_of_delay_rad(bearing: &Bearing, delay_rad: f64) -> f64 {
    (TAU + delay_rad) / bearing.balls() as f64 - bearing.ball_angle_rad()
}
