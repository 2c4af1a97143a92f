//! The range of raceways that work, between sliding and collisions.

use super::{Eq11, SLIP_SHORTFALL, half_angle_for_gap_rad, theoretical_gap_rad};
use crate::case::Case;
use crate::numerics::root;
use crate::raceway::{Raceway, RacewayDimensions, axial_span_limit_m};
use crate::spacing::{CriticalGapError, PairTest, critical_gap_rad};

/// Raceways on the curve of Zhao 2022, Eq. (11), for the gap of evenly spaced balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recommendation {
    /// Smallest θ, below which slip takes more than [`SLIP_SHORTFALL`] of the separation.
    pub half_angle_min_rad: f64,
    /// Largest θ = ε + uniform gap, above which three evenly spaced balls are inside at once.
    pub half_angle_max_rad: f64,
    /// Recommended θ, in the middle.
    pub half_angle_rad: f64,
    /// lC that goes with it.
    pub axial_span_m: f64,
}

/// Raceway of span lC on the curve of Eq. (11), in the place of the case's own.
fn on_curve(case: &Case, axial_span_m: f64) -> Option<Raceway> {
    let gap = case.bearing.uniform_gap_rad();
    let half_angle_rad = half_angle_for_gap_rad(&case.bearing, axial_span_m, gap, Eq11::Published)?;
    let centre_angle_rad = case
        .raceways
        .first()
        .map_or(0.0, |raceway| raceway.dimensions().centre_angle_rad);
    let dimensions = RacewayDimensions {
        axial_span_m,
        half_angle_rad,
        centre_angle_rad,
    };
    Raceway::new(dimensions, &case.bearing).ok()
}

/// Span on the curve at which θ is `half_angle`; θ falls with the span.
fn span_for_angle(case: &Case, half_angle: f64) -> Option<f64> {
    let limit = axial_span_limit_m(&case.bearing) * (1.0 - 1e-9);
    // The curve begins at the narrowest span that any angle serves.
    let (mut none, mut some) = (0.0, limit);
    on_curve(case, limit)?;
    while some - none > 1e-4 * limit {
        let middle = 0.5 * (none + some);
        if on_curve(case, middle).is_some() {
            some = middle
        } else {
            none = middle
        }
    }
    let difference =
        |span: f64| on_curve(case, span).map_or(f64::NAN, |r| r.half_angle_rad() - half_angle);
    root::brent(difference, some, limit, 1e-9)
}

/// Share of β0 that slip takes from the critical gap.
fn shortfall(case: &Case, raceway: Raceway) -> Result<f64, CriticalGapError> {
    let beta0 = theoretical_gap_rad(&case.bearing, &raceway, Eq11::Published);
    let case = case.with_raceways(vec![raceway]);
    Ok(1.0 - critical_gap_rad(&case, &PairTest::default())? / beta0)
}

/// Finds the range of θ on the curve of Eq. (11) within which the separation neither
/// suffers from slip nor lets three balls into the raceway at once, and the raceway in
/// its middle. `None` if there is no such range: slip takes over before the third ball
/// is kept out.
///
/// # Errors
/// The case is impossible or one of its runs fails.
pub fn recommend(case: &Case) -> Result<Option<Recommendation>, CriticalGapError> {
    let bearing = &case.bearing;
    let half_angle_max_rad = bearing.ball_angle_rad() + bearing.uniform_gap_rad();
    let limit = axial_span_limit_m(bearing) * (1.0 - 1e-6);
    let (Some(narrow), Some(deepest)) = (
        span_for_angle(case, half_angle_max_rad),
        on_curve(case, limit),
    ) else {
        return Ok(None);
    };
    let excess = |span: f64| match on_curve(case, span) {
        Some(raceway) => Ok(shortfall(case, raceway)? - SLIP_SHORTFALL),
        None => Err(CriticalGapError::NeverCloses),
    };
    if excess(narrow)? > 0.0 {
        return Ok(None);
    }
    let half_angle_min_rad = if excess(limit)? <= 0.0 {
        deepest.half_angle_rad()
    } else {
        // To a hundredth of the ball's radius: finer than the threshold means anything.
        let tolerance = 1e-3 * bearing.ball_radius_m();
        let wide = root::try_brent(excess, narrow, limit, tolerance)?.unwrap_or(limit);
        on_curve(case, wide).map_or(half_angle_max_rad, |raceway| raceway.half_angle_rad())
    };
    let half_angle_rad = 0.5 * (half_angle_min_rad + half_angle_max_rad);
    Ok(
        span_for_angle(case, half_angle_rad).map(|axial_span_m| Recommendation {
            half_angle_min_rad,
            half_angle_max_rad,
            half_angle_rad,
            axial_span_m,
        }),
    )
}
