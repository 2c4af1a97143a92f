//! Units of readers that results share with settings.

/// A time in µs.
pub(crate) fn microseconds(time_s: f64) -> f64 {
    time_s * 1e6
}

/// A viscosity in mPa·s.
pub fn millipascal_seconds(viscosity_pa_s: f64) -> f64 {
    viscosity_pa_s * 1e3
}
