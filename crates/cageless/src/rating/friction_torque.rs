//! Friction torque of a lubricated bearing by a rule of catalogues.

use crate::bearing::Bearing;
use crate::case::Case;

/// μ of a deep groove ball bearing in SKF's rule, good lubrication and P ≈ 0.1 C (SKF, *General
/// catalogue* 6000, table 1; NTN 2203/E has 1.0 to 1.5·10⁻³).
const SKF_FRICTION: f64 = 0.0015;

/// M = ½ μ P d of SKF under a load P, N·m: the estimate for a lubricated bearing with a cage, which the
/// motion of dry balls does not give.
pub fn rolling_torque_n_m(bearing: &Bearing, load_n: f64) -> f64 {
    SKF_FRICTION * load_n * bearing.bore_radius_or_estimate_m()
}

/// [`rolling_torque_n_m`] with P = Fr; `None` where load or speed is not constant, and of a case with an
/// axial load, moments, a tilt, a contact angle or several rows, for which P is not Fr and μ another.
pub fn skf_friction_torque_n_m(case: &Case) -> Option<f64> {
    let load_n = case.operation.radial_load_n;
    (case.has_constant_operation() && case.spatial_field().is_none())
        .then(|| rolling_torque_n_m(&case.bearing, load_n))
}
