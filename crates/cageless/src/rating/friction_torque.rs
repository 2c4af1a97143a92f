//! Friction torque of a lubricated bearing by a rule of catalogues.

use crate::bearing::{Bearing, BearingDimensions};
use crate::case::Case;

/// μ of a deep groove ball bearing in SKF's rule, good lubrication and P ≈ 0.1 C (SKF, *General
/// catalogue* 6000, table 1; NTN 2203/E has 1.0 to 1.5·10⁻³).
const SKF_FRICTION: f64 = 0.0015;

/// Thickness of the inner ring below its groove over the diameter of the ball.
const WALL: f64 = 0.3;

/// Bore radius of an inner ring of which none is given, m: 0.3 ball diameters below the groove.
pub fn bore_radius_estimate_m(d: &BearingDimensions) -> f64 {
    let bottom = d.inner_groove_bottom_radius_m;
    (bottom - WALL * (2.0 * d.ball_radius_m)).max(0.5 * bottom)
}

/// d/2 of a bearing, or the estimate.
pub(super) fn bore_radius_m(bearing: &Bearing) -> f64 {
    (bearing.bore_radius_m()).unwrap_or_else(|| bore_radius_estimate_m(bearing.dimensions()))
}

/// M = ½ μ P d of SKF with P = Fr, N·m: the estimate for a lubricated bearing with a cage, which the
/// motion of dry balls does not give; `None` where load or speed is not constant, and of a case with an
/// axial load, moments, a tilt, a contact angle or several rows, for which P is not Fr and μ another.
pub fn skf_friction_torque_n_m(case: &Case) -> Option<f64> {
    let load_n = case.operation.radial_load_n;
    let bore_m = 2.0 * bore_radius_m(&case.bearing);
    (case.has_constant_operation() && case.spatial_field().is_none())
        .then_some(0.5 * SKF_FRICTION * load_n * bore_m)
}
