//! The anti-alias filter of a measurement.

use biquad::{Biquad, Coefficients, DirectForm2Transposed, Type};

/// Order of the anti-alias filter.
pub const FILTER_ORDER: usize = 8;
/// Corner of the anti-alias filter as a fraction of the sampling rate it protects.
pub const FILTER_CORNER: f64 = 0.4;

/// Samples a signal at a lower rate behind a Butterworth low-pass of order
/// [`FILTER_ORDER`] with its corner at [`FILTER_CORNER`] × that rate.
///
/// The filter starts in equilibrium with the first value. Of a signal that is not sampled
/// faster than the wanted rate every value is passed on as it is; else every k-th, with k
/// the nearest integer to the ratio of the rates.
#[derive(Debug, Clone)]
pub(crate) struct Decimator {
    cascade: Vec<DirectForm2Transposed<f64, f64>>,
    keep: usize,
    offset: Option<f64>,
    seen: usize,
    interval_s: f64,
}

impl Decimator {
    /// Decimator from a signal with a value every `interval_s` to `rate_hz`.
    pub(crate) fn new(interval_s: f64, rate_hz: f64) -> Self {
        let keep = (1.0 / interval_s / rate_hz).round() as usize;
        let sections = if keep < 2 { 0 } else { FILTER_ORDER / 2 };
        // In units of half the input rate; 0.4 at most, since `keep` is 2 or more.
        let corner = 2.0 * FILTER_CORNER / keep as f64;
        let cascade = (0..sections)
            .map(|k| {
                // Poles of the Butterworth prototype in pairs.
                let angle = std::f64::consts::PI * (2 * k + 1) as f64 / (2 * FILTER_ORDER) as f64;
                let q = 1.0 / (2.0 * angle.cos());
                Coefficients::from_normalized_params(Type::LowPass, corner, q)
                    .expect("corner below Nyquist, q above 0")
            })
            .map(DirectForm2Transposed::new)
            .collect();
        Self {
            cascade,
            keep: keep.max(1),
            offset: None,
            seen: 0,
            interval_s: interval_s * keep.max(1) as f64,
        }
    }

    /// Time between the values that are passed on.
    pub(crate) fn interval_s(&self) -> f64 {
        self.interval_s
    }

    /// Takes the next value; the first and then every k-th comes out filtered.
    pub(crate) fn push(&mut self, value: f64) -> Option<f64> {
        let offset = *self.offset.get_or_insert(value);
        let filtered = self
            .cascade
            .iter_mut()
            .fold(value - offset, |x, section| section.run(x))
            + offset;
        let due = self.seen.is_multiple_of(self.keep);
        self.seen += 1;
        due.then_some(filtered)
    }
}
