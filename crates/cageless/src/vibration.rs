//! Vibration of the outer ring: the reaction of the balls through a housing.
//!
//! Each direction is one mass on a spring and a damper, M ẍ + c ẋ + k x = F(t), driven
//! by what the balls put on the outer ring. The ring stays fixed in the equations of
//! motion: the housing is stiff against what moves the balls.

use biquad::{Biquad, Coefficients, DirectForm2Transposed, Type};
use realfft::RealFftPlanner;

use crate::case::Housing;
use crate::simulation::{Control, Observer, ObserverError, Scene, View};

/// Values at regular times.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Time of the first value.
    pub start_s: f64,
    /// Time between values.
    pub interval_s: f64,
    /// The values.
    pub values: Vec<f64>,
}

impl Signal {
    /// Time of value `k`.
    pub fn time_s(&self, k: usize) -> f64 {
        self.start_s + k as f64 * self.interval_s
    }

    /// What follows `time_s`.
    pub fn after(&self, time_s: f64) -> Self {
        let skip = ((time_s - self.start_s) / self.interval_s).ceil().max(0.0) as usize;
        let skip = skip.min(self.values.len());
        Self {
            start_s: self.time_s(skip),
            interval_s: self.interval_s,
            values: self.values[skip..].to_vec(),
        }
    }

    /// Root mean square of the deviation from the mean; 0 for an empty signal.
    pub fn rms(&self) -> f64 {
        if self.values.is_empty() {
            return 0.0;
        }
        let n = self.values.len() as f64;
        let mean = self.values.iter().sum::<f64>() / n;
        (self.values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt()
    }
}

/// Order of the anti-alias filter.
pub const FILTER_ORDER: usize = 8;
/// Corner of the anti-alias filter as a share of the sampling rate it protects.
pub const FILTER_CORNER: f64 = 0.4;

/// Records the acceleration of the housing.
///
/// The force is averaged over the time between samples (a first defence against
/// aliasing of the 30 kHz bounce of the balls), then moves the housing exactly as a
/// force constant over that time would.
pub struct VibrationRecorder {
    housing: Housing,
    interval_s: f64,
    /// Impulse gathered since the last sample.
    impulse: [f64; 2],
    since_s: f64,
    last_force: [f64; 2],
    motion: Option<[Oscillator; 2]>,
    /// Acceleration in x and y.
    acceleration: [Vec<f64>; 2],
}

/// Sampling of the housing's motion; resolves 10 kHz and all housings below it.
pub const HOUSING_INTERVAL_S: f64 = 1e-5;

impl VibrationRecorder {
    /// For a housing.
    pub fn new(housing: &Housing) -> Self {
        Self {
            housing: housing.clone(),
            interval_s: HOUSING_INTERVAL_S,
            impulse: [0.0; 2],
            since_s: 0.0,
            last_force: [0.0; 2],
            motion: None,
            acceleration: [vec![], vec![]],
        }
    }

    /// Acceleration of the outer ring along x and y, m/s².
    pub fn acceleration(&self) -> [Signal; 2] {
        self.acceleration.clone().map(|values| Signal {
            start_s: self.interval_s,
            interval_s: self.interval_s,
            values,
        })
    }

    /// Adds what acted until `to_s`, closing samples on the way.
    fn add(&mut self, from_s: f64, to_s: f64, force: [f64; 2]) {
        let slope = |k: usize| (force[k] - self.last_force[k]) / (to_s - from_s);
        let slopes = [slope(0), slope(1)];
        let mut at = from_s;
        loop {
            let sample_end = self.since_s + self.interval_s;
            let until = sample_end.min(to_s);
            for (k, slope) in slopes.iter().enumerate() {
                let middle = self.last_force[k] + slope * ((at + until) / 2.0 - from_s);
                self.impulse[k] += middle * (until - at);
            }
            if sample_end > to_s {
                break;
            }
            self.close_sample();
            at = until;
        }
        self.last_force = force;
    }

    fn close_sample(&mut self) {
        let mean = self.impulse.map(|i| i / self.interval_s);
        let motion = self.motion.get_or_insert_with(|| {
            mean.map(|f| Oscillator::new(&self.housing, self.interval_s, f))
        });
        for k in 0..2 {
            self.acceleration[k].push(motion[k].push(mean[k]));
        }
        self.impulse = [0.0; 2];
        self.since_s += self.interval_s;
    }
}

impl Observer for VibrationRecorder {
    fn begin(&mut self, scene: &Scene<'_>) -> Result<(), ObserverError> {
        let mut rhs = crate::dynamics::RightHandSide::new(scene.model);
        let snapshot = rhs.snapshot(0.0, scene.start, scene.start_angle_rad);
        self.last_force = [snapshot.ring.outer_force_x_n, snapshot.ring.outer_force_y_n];
        Ok(())
    }

    fn step(&mut self, view: &View<'_, '_>) -> Result<Control, ObserverError> {
        self.add(
            view.step.from_s,
            view.step.to_s,
            view.contacts.outer_ring_force_n(),
        );
        Ok(Control::Continue)
    }
}

/// A damped oscillator under a force constant over each interval, advanced exactly.
struct Oscillator {
    mass: f64,
    stiffness: f64,
    damping: f64,
    /// exp(A h) of d(x, v)/dt = A (x, v) about the static deflection.
    propagator: [[f64; 2]; 2],
    state: [f64; 2],
}

impl Oscillator {
    /// At rest under `force`.
    fn new(housing: &Housing, h: f64, force: f64) -> Self {
        let (m, k, c) = (
            housing.mass_kg,
            housing.stiffness_n_m,
            housing.damping_n_s_m,
        );
        Self {
            mass: m,
            stiffness: k,
            damping: c,
            propagator: exponential([[0.0, h], [-k / m * h, -c / m * h]]),
            state: [force / k, 0.0],
        }
    }

    /// Advances one interval; returns the acceleration at its end.
    fn push(&mut self, force: f64) -> f64 {
        let rest = force / self.stiffness;
        let [[a, b], [c, d]] = self.propagator;
        let (x, v) = (self.state[0] - rest, self.state[1]);
        self.state = [rest + a * x + b * v, c * x + d * v];
        (force - self.stiffness * self.state[0] - self.damping * self.state[1]) / self.mass
    }
}

/// Matrix exponential by scaling and squaring of its Taylor series.
fn exponential(matrix: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let multiply = |p: [[f64; 2]; 2], q: [[f64; 2]; 2]| {
        let mut r = [[0.0; 2]; 2];
        for i in 0..2 {
            for j in 0..2 {
                r[i][j] = p[i][0] * q[0][j] + p[i][1] * q[1][j];
            }
        }
        r
    };
    let size = matrix.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let squarings = if size > 0.1 {
        (size / 0.1).log2().ceil() as i32
    } else {
        0
    };
    let small = matrix.map(|row| row.map(|x| x / 2f64.powi(squarings)));
    let mut sum = [[1.0, 0.0], [0.0, 1.0]];
    let mut term = sum;
    for k in 1..=14 {
        term = multiply(term, small).map(|row| row.map(|x| x / f64::from(k)));
        for i in 0..2 {
            for j in 0..2 {
                sum[i][j] += term[i][j];
            }
        }
    }
    for _ in 0..squarings {
        sum = multiply(sum, sum);
    }
    sum
}

/// Samples a signal at `rate_hz` behind a Butterworth low-pass of order
/// [`FILTER_ORDER`] with its corner at [`FILTER_CORNER`] × `rate_hz`.
///
/// The filter starts in equilibrium with the first value. Returns the signal as it is
/// if it is not sampled faster than `rate_hz`; else every k-th value, with k the nearest
/// integer to the ratio of the rates.
pub fn sample_behind_filter(signal: &Signal, rate_hz: f64) -> Signal {
    let input_rate = 1.0 / signal.interval_s;
    let keep = (input_rate / rate_hz).round() as usize;
    if keep < 2 || signal.values.is_empty() {
        return signal.clone();
    }
    // In units of half the input rate; 0.4 at most, since `keep` is 2 or more.
    let corner = 2.0 * FILTER_CORNER / keep as f64;
    let mut cascade: Vec<DirectForm2Transposed<f64, f64>> = (0..FILTER_ORDER / 2)
        .map(|k| {
            // Poles of the Butterworth prototype in pairs.
            let angle = std::f64::consts::PI * (2 * k + 1) as f64 / (2 * FILTER_ORDER) as f64;
            let q = 1.0 / (2.0 * angle.cos());
            Coefficients::from_normalized_params(Type::LowPass, corner, q)
                .expect("corner below Nyquist, q above 0")
        })
        .map(DirectForm2Transposed::new)
        .collect();
    let offset = signal.values[0];
    let filtered: Vec<f64> = signal
        .values
        .iter()
        .map(|&v| {
            cascade
                .iter_mut()
                .fold(v - offset, |x, section| section.run(x))
                + offset
        })
        .collect();
    Signal {
        start_s: signal.start_s,
        interval_s: signal.interval_s * keep as f64,
        values: filtered.into_iter().step_by(keep).collect(),
    }
}

/// Single-sided amplitude spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Frequencies.
    pub frequency_hz: Vec<f64>,
    /// Amplitude of a sine at that frequency.
    pub amplitude: Vec<f64>,
}

/// Spectrum of the deviation from the mean, under a Hann window scaled so that a sine
/// on a bin shows its amplitude.
pub fn spectrum(signal: &Signal) -> Spectrum {
    let n = signal.values.len();
    if n < 4 {
        return Spectrum {
            frequency_hz: vec![],
            amplitude: vec![],
        };
    }
    let mean = signal.values.iter().sum::<f64>() / n as f64;
    let window = |k: usize| 0.5 * (1.0 - (std::f64::consts::TAU * k as f64 / n as f64).cos());
    let mut input: Vec<f64> = signal
        .values
        .iter()
        .enumerate()
        .map(|(k, v)| (v - mean) * window(k))
        .collect();
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(n);
    let mut output = plan.make_output_vec();
    // Lengths come from the plan; the only error is a wrong length.
    if plan.process(&mut input, &mut output).is_err() {
        return Spectrum {
            frequency_hz: vec![],
            amplitude: vec![],
        };
    }
    // Mean of the window is 1/2; both halves of the spectrum count.
    let scale = 4.0 / n as f64;
    let mut amplitude: Vec<f64> = output.iter().map(|c| c.norm() * scale).collect();
    // The Nyquist frequency has no other half.
    if n.is_multiple_of(2)
        && let Some(last) = amplitude.last_mut()
    {
        *last /= 2.0;
    }
    Spectrum {
        frequency_hz: (0..output.len())
            .map(|k| k as f64 / (n as f64 * signal.interval_s))
            .collect(),
        amplitude,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn sine(rate: f64, seconds: f64, parts: &[(f64, f64)]) -> Signal {
        let n = (rate * seconds) as usize;
        let values = (0..n)
            .map(|k| {
                parts
                    .iter()
                    .map(|(f, a)| a * (TAU * f * k as f64 / rate).sin())
                    .sum()
            })
            .collect();
        Signal {
            start_s: 0.0,
            interval_s: 1.0 / rate,
            values,
        }
    }

    #[test]
    fn spectrum_shows_amplitudes() {
        let s = spectrum(&sine(5000.0, 1.0, &[(100.0, 2.0), (1200.0, 0.5)]));
        assert!((s.amplitude[100] - 2.0).abs() < 1e-9);
        assert!((s.amplitude[1200] - 0.5).abs() < 1e-9);
        assert!(s.amplitude[600] < 1e-9);
        assert!((s.frequency_hz[100] - 100.0).abs() < 1e-9);
    }

    #[test]
    fn filter_passes_below_and_stops_what_would_fold_back() {
        // 4600 Hz would appear at 400 Hz.
        let signal = sine(1e5, 1.0, &[(300.0, 1.0), (4600.0, 1.0)]);
        let sampled = sample_behind_filter(&signal, 5000.0);
        assert!((sampled.interval_s - 2e-4).abs() < 1e-12);
        let s = spectrum(&sampled.after(0.2));
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

    /// Steady state of the driven oscillator: |a| = F ω²/√((k − mω²)² + (cω)²).
    #[test]
    fn housing_follows_the_closed_form() {
        let housing = Housing {
            mass_kg: 1.0,
            stiffness_n_m: 1e7,
            damping_n_s_m: 500.0,
        };
        let h = 1e-6;
        let omega = 2000.0;
        let mut o = Oscillator::new(&housing, h, 0.0);
        let mut largest = 0.0f64;
        for k in 0..200_000 {
            let a = o.push((omega * (k as f64 + 0.5) * h).sin());
            if k > 100_000 {
                largest = largest.max(a.abs());
            }
        }
        let expected =
            omega * omega / ((1e7 - omega * omega).powi(2) + (500.0f64 * omega).powi(2)).sqrt();
        assert!(
            (largest / expected - 1.0).abs() < 1e-3,
            "{largest} {expected}"
        );
    }
}
