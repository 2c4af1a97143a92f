//! Speed factor n·Dpw of a bearing.

use std::f64::consts::TAU;

use crate::case::Case;

/// Largest n·Dpw of ball bearings in service, mm/min: hybrid spindle bearings under oil
/// jets and bearings of aircraft engines reach 3 million.
pub(crate) const SPEED_PARAMETER_MAX_MM_RPM: f64 = 3e6;

/// n·Dpw, speed of the inner ring times pitch diameter, mm/min.
pub(crate) fn speed_factor_mm_rpm(case: &Case) -> f64 {
    let rpm = case.operation.inner_speed_rad_s.abs() * 60.0 / TAU;
    rpm * 2e3 * case.bearing.pitch_radius_m()
}

/// Warning if n·Dpw exceeds `SPEED_PARAMETER_MAX_MM_RPM`.
pub fn speed_warning(speed_factor_mm_rpm: f64) -> Option<String> {
    (speed_factor_mm_rpm > SPEED_PARAMETER_MAX_MM_RPM).then(|| {
        format!(
            "n·Dpw is {:.2} million mm/min, above the {} million that ball bearings reach",
            speed_factor_mm_rpm * 1e-6,
            SPEED_PARAMETER_MAX_MM_RPM * 1e-6
        )
    })
}
