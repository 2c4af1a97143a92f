//! Units of readers that results share with settings.

/// A time in µs.
pub(crate) fn microseconds(time_s: f64) -> f64 {
    time_s * 1e6
}
