//! Interpolation within a step.

use super::Step;

/// Cubic Hermite interpolation of component `k` at `time_s` within the step; error
/// h⁴/384 times the fourth derivative.
pub fn hermite(step: &Step<'_>, k: usize, time_s: f64) -> f64 {
    let h = step.to_s - step.from_s;
    let s = (time_s - step.from_s) / h;
    let (y0, y1) = (step.before[k], step.after[k]);
    let (f0, f1) = (step.rate_before[k] * h, step.rate_after[k] * h);
    let r = 1.0 - s;
    y0 * r * r * (1.0 + 2.0 * s) + y1 * s * s * (3.0 - 2.0 * s) + s * r * (f0 * r - f1 * s)
}
