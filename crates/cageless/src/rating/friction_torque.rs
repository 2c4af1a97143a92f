//! Friction torque of a lubricated bearing by a rule of catalogues.

use super::equivalent_load::EquivalentLoad;
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

/// [`rolling_torque_n_m`] under P of ISO 281; `None` where load or speed is not constant, without P, and of a case
/// with a contact angle or several rows, for which μ is another.
pub fn skf_friction_torque_n_m(case: &Case) -> Option<f64> {
    let rated = case.has_constant_operation() && is_single_deep_groove(case);
    let load = rated.then(|| EquivalentLoad::new(case)).flatten()?;
    Some(rolling_torque_n_m(&case.bearing, load.dynamic_n))
}

/// Whether a case is a single-row deep groove ball bearing, as SKF's rules have it.
pub(super) fn is_single_deep_groove(case: &Case) -> bool {
    case.bearing.contact_angle_rad() == 0.0 && case.rows.len() <= 1
}
