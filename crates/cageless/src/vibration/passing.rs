//! Vibration at the passing frequencies and between them.
//!
//! Balls that keep their order and their gaps repeat every load and every raceway once per
//! orbit of the balls: what the passing of the balls excites lies at the multiples of the
//! orbital frequency (evenly spaced equal balls: at the multiples of N times that). What does
//! not recur from orbit to orbit lies between: impacts between balls and the slip that they
//! leave. This is the discrete–random separation of bearing diagnostics (Antoni, Randall
//! 2004), done on the spectrum.

use super::spectrum::spectrum;

/// Distance from a multiple of the orbital frequency within which a value of the spectrum
/// belongs to it, in values of the spectrum: the half width of the Hann window's main lobe.
const LOBE: f64 = 2.0;
/// Least number of orbits in a signal: with fewer no value of the spectrum lies between the
/// lobes of two multiples.
pub(crate) const LEAST_ORBITS: f64 = 6.0;

/// Mean square of a signal about its mean, in two parts that add up to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassingSplit {
    /// Amplitudes at the multiples of the orbital frequency.
    pub at_passing: f64,
    /// All the rest.
    pub between: f64,
}

impl PassingSplit {
    /// Splits the mean square of `values`, `interval_s` apart, over the power spectrum under a
    /// Hann window, scaled to the mean square of the signal. Around each multiple of `orbit_hz`
    /// two values of the spectrum to either side are at passing, less the level between
    /// this multiple and its neighbours.
    ///
    /// `None` if the signal is shorter than `LEAST_ORBITS` orbits.
    pub fn new(values: &[f64], interval_s: f64, orbit_hz: f64) -> Option<Self> {
        let n = values.len();
        let stretch_s = n as f64 * interval_s;
        if !(orbit_hz > 0.0 && stretch_s * orbit_hz >= LEAST_ORBITS) {
            return None;
        }
        let mean = values.iter().sum::<f64>() / n as f64;
        let mean_square = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n as f64;
        let spectrum = spectrum(values, interval_s);
        let power: Vec<f64> = spectrum.amplitude.iter().map(|a| a * a).collect();
        let all: f64 = power.iter().sum();
        if all == 0.0 {
            return Some(Self {
                at_passing: 0.0,
                between: 0.0,
            });
        }
        let mut passing = 0.0;
        let multiples = (power.len() as f64 / stretch_s / orbit_hz).ceil() as usize;
        for multiple in 1..=multiples {
            // In values of the spectrum.
            let line = multiple as f64 * orbit_hz * stretch_s;
            let half = 0.5 * orbit_hz * stretch_s;
            let from = ((line - half).ceil() as usize).min(power.len());
            let to = ((line + half).ceil() as usize).min(power.len());
            let (mut at, mut at_count, mut level, mut level_count) = (0.0, 0.0, 0.0, 0.0);
            for (k, p) in (from..).zip(&power[from..to]) {
                if (k as f64 - line).abs() <= LOBE {
                    at += p;
                    at_count += 1.0;
                } else {
                    level += p;
                    level_count += 1.0;
                }
            }
            if level_count > 0.0 {
                passing += f64::max(at - level / level_count * at_count, 0.0);
            }
        }
        let at_passing = mean_square * passing / all;
        Some(Self {
            at_passing,
            between: mean_square - at_passing,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const INTERVAL_S: f64 = 2e-4;
    const ORBIT_HZ: f64 = 19.82;

    /// Reproducible noise of a standard deviation of 1.
    fn noise(count: usize) -> Vec<f64> {
        let mut state = 1u64;
        (0..count)
            .map(|_| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                ((state >> 11) as f64 / (1u64 << 53) as f64 - 0.5) * 12f64.sqrt()
            })
            .collect()
    }

    fn lines(count: usize) -> Vec<f64> {
        (0..count)
            .map(|k| {
                let t = k as f64 * INTERVAL_S;
                [(1.0, 0.8), (14.0, 1.5), (31.0, 0.4)]
                    .iter()
                    .map(|(m, a)| a * (TAU * m * ORBIT_HZ * t + m).sin())
                    .sum()
            })
            .collect()
    }

    fn mean_square(values: &[f64]) -> f64 {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64
    }

    /// The parts add up to the mean square over time, and each holds what belongs to it.
    #[test]
    fn lines_are_at_passing_and_noise_is_between() {
        let (lines, noise) = (lines(5000), noise(5000));
        let both: Vec<f64> = lines.iter().zip(&noise).map(|(a, b)| a + b).collect();
        for values in [&lines, &noise, &both] {
            let split = PassingSplit::new(values, INTERVAL_S, ORBIT_HZ).unwrap();
            let all = mean_square(values);
            assert!(((split.at_passing + split.between) / all - 1.0).abs() < 1e-12);
        }
        let split = |values: &[f64]| PassingSplit::new(values, INTERVAL_S, ORBIT_HZ).unwrap();
        let pure = split(&lines);
        assert!(pure.between < 2e-3 * pure.at_passing, "{pure:?}");
        let random = split(&noise);
        assert!(random.at_passing < 0.15 * random.between, "{random:?}");
        let mixed = split(&both);
        assert!(
            (mixed.at_passing / mean_square(&lines) - 1.0).abs() < 0.1,
            "{mixed:?}"
        );
        assert!(
            (mixed.between / mean_square(&noise) - 1.0).abs() < 0.15,
            "{mixed:?}"
        );
    }

    #[test]
    fn a_signal_of_few_orbits_is_not_split() {
        let orbits = |count: f64| (count / ORBIT_HZ / INTERVAL_S).round() as usize;
        let split = |count: f64| PassingSplit::new(&lines(orbits(count)), INTERVAL_S, ORBIT_HZ);
        assert!(split(5.0).is_none());
        assert!(split(7.0).is_some());
        assert!(PassingSplit::new(&[], INTERVAL_S, ORBIT_HZ).is_none());
    }
}
