//! Measured acceleration in one direction.

use super::filter::Decimator;
use super::spectrum::{Spectrum, Welch};
use crate::min_max_decimator::MinMaxDecimator;
use crate::numerics::moments::Moments;

/// Values in a stretch of [`Welch`]'s average: 1.6 s at 5 kHz.
pub(crate) const STRETCH: usize = 8192;
/// Most points of the trace over time.
const TRACE_POINTS: usize = 8192;

/// Measured acceleration in one direction: sampled behind a filter,
/// the transient left out.
#[derive(Debug, Clone)]
pub struct Measurement {
    after_s: f64,
    start_s: f64,
    decimator: Decimator,
    seen: u64,
    moments: Moments,
    /// Largest absolute value.
    pub peak: f64,
    trace: MinMaxDecimator<[f64; 2]>,
    welch: Welch,
}

impl Measurement {
    /// Measurement of a signal with values every `interval_s` from `interval_s` on, sampled at
    /// `rate_hz`, leaving out what comes before `after_s`.
    pub(crate) fn new(interval_s: f64, rate_hz: f64, after_s: f64) -> Self {
        let decimator = Decimator::new(interval_s, rate_hz);
        let welch = Welch::new(STRETCH, decimator.interval_s());
        Self {
            after_s,
            start_s: interval_s,
            decimator,
            seen: 0,
            moments: Moments::default(),
            peak: 0.0,
            trace: MinMaxDecimator::new(TRACE_POINTS),
            welch,
        }
    }

    /// Takes the next value of the signal.
    pub(crate) fn push(&mut self, value: f64) {
        let Some(value) = self.decimator.push(value) else {
            return;
        };
        let time_s = self.start_s + self.seen as f64 * self.decimator.interval_s();
        self.seen += 1;
        if time_s < self.after_s {
            return;
        }
        self.moments.add(value, 1.0);
        self.peak = self.peak.max(value.abs());
        self.trace.push([time_s, value]);
        self.welch.push(value);
    }

    /// Number of samples.
    pub fn samples(&self) -> u64 {
        self.moments.weight as u64
    }

    /// Root mean square of the deviation from the mean; NaN without samples.
    pub fn rms(&self) -> f64 {
        self.moments.deviation()
    }

    /// Times and values: every sample of a short measurement, else the lowest and the
    /// highest of stretches of [`Self::trace_stretch_s`].
    pub fn trace(&self) -> Vec<[f64; 2]> {
        self.trace.clone().into_rows()
    }

    /// Length of the stretches of the trace; `None` if it holds every sample.
    pub fn trace_stretch_s(&self) -> Option<f64> {
        let samples = self.trace.stretch();
        (samples > 1).then(|| samples as f64 * self.decimator.interval_s())
    }

    /// Time between samples.
    pub fn interval_s(&self) -> f64 {
        self.decimator.interval_s()
    }

    /// Amplitude spectrum, averaged over stretches of `STRETCH` samples if there are as
    /// many.
    pub fn spectrum(&self) -> Spectrum {
        self.welch.spectrum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::spectrum::spectrum;
    use std::f64::consts::TAU;

    fn sine(rate: f64, seconds: f64, parts: &[(f64, f64)]) -> Vec<f64> {
        (0..(rate * seconds) as usize)
            .map(|k| {
                parts
                    .iter()
                    .map(|(f, a)| a * (TAU * f * k as f64 / rate).sin())
                    .sum()
            })
            .collect()
    }

    #[test]
    fn spectrum_shows_amplitudes() {
        let s = spectrum(&sine(5000.0, 1.0, &[(100.0, 2.0), (1200.0, 0.5)]), 2e-4);
        assert!((s.amplitude[100] - 2.0).abs() < 1e-9);
        assert!((s.amplitude[1200] - 0.5).abs() < 1e-9);
        assert!(s.amplitude[600] < 1e-9);
        assert!((s.frequency_hz[100] - 100.0).abs() < 1e-9);
    }

    #[test]
    fn filter_passes_below_and_stops_what_would_fold_back() {
        // 4600 Hz would appear at 400 Hz.
        let mut decimator = Decimator::new(1e-5, 5000.0);
        assert!((decimator.interval_s() - 2e-4).abs() < 1e-12);
        let sampled: Vec<f64> = sine(1e5, 1.0, &[(300.0, 1.0), (4600.0, 1.0)])
            .into_iter()
            .filter_map(|v| decimator.push(v))
            .collect();
        let s = spectrum(&sampled[1000..], 2e-4);
        let at = |f: f64| {
            let k = s
                .frequency_hz
                .iter()
                .position(|x| (x - f).abs() < 0.7)
                .unwrap();
            s.amplitude[k]
        };
        assert!((at(300.0) - 1.0).abs() < 1e-3, "{}", at(300.0));
        assert!(at(400.0) < 2e-3, "{}", at(400.0));
    }

    /// The result of the streamed signal equals that of a computation on all of it.
    #[test]
    fn a_measurement_in_passing_equals_one_afterwards() {
        let (rate, after_s) = (1e5, 0.1);
        // 305.175… Hz is a bin of 8192 samples at 5 kHz; a slow sine gives rms and peak.
        let bin = 500.0 * 5000.0 / STRETCH as f64;
        for seconds in [1.0, 8.0] {
            let signal = sine(rate, seconds, &[(bin, 2.0), (3.7, 0.3)]);
            let mut measurement = Measurement::new(1.0 / rate, 5000.0, after_s);
            let mut decimator = Decimator::new(1.0 / rate, 5000.0);
            let mut kept = vec![];
            for (k, value) in signal.into_iter().enumerate() {
                measurement.push(value);
                if let Some(v) = decimator.push(value)
                    && (k + 1) as f64 / rate >= after_s
                {
                    kept.push(v);
                }
            }
            let n = kept.len() as f64;
            let mean = kept.iter().sum::<f64>() / n;
            let rms = (kept.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt();
            let peak = kept.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            assert_eq!(measurement.samples(), kept.len() as u64);
            assert!((measurement.rms() / rms - 1.0).abs() < 1e-12);
            // √((2² + 0.3²)/2), but for the part of a period of the slow sine.
            assert!((rms - 1.430).abs() < 0.01, "{rms}");
            assert_eq!(measurement.peak, peak);
            let trace = measurement.trace();
            assert!(trace.iter().any(|[_, v]| v.abs() == peak));
            let s = measurement.spectrum();
            if kept.len() < STRETCH {
                assert_eq!(trace.len(), kept.len());
                assert_eq!(s, spectrum(&kept, 2e-4));
            } else {
                assert!(trace.len() <= TRACE_POINTS + 2);
                assert_eq!(
                    s.stretches,
                    2 * (kept.len() / STRETCH) - 1 + kept.len() % STRETCH * 2 / STRETCH
                );
                // The filter's gain there is 1 to 1e-13.
                assert!(
                    (s.amplitude[500] - 2.0).abs() < 2e-6,
                    "{}",
                    s.amplitude[500]
                );
                assert!((s.stretch_s - STRETCH as f64 * 2e-4).abs() < 1e-9);
            }
        }
    }
}
