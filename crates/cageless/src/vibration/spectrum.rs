//! Amplitude spectra.

use std::f64::consts::TAU;

use realfft::RealFftPlanner;

/// Single-sided amplitude spectrum.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Spectrum {
    /// Frequencies.
    pub frequency_hz: Vec<f64>,
    /// Amplitude of a sine at that frequency.
    pub amplitude: Vec<f64>,
    /// Length of the stretches of signal whose spectra were averaged; its inverse is the
    /// distance of the frequencies. 0 if there is no spectrum.
    pub stretch_s: f64,
    /// Number of segments, each overlapping half of the one before.
    pub stretches: usize,
}

/// Spectrum of the deviation from the mean, under a Hann window scaled so that a sine
/// on a bin shows its amplitude. Empty for less than four values.
pub fn spectrum(values: &[f64], interval_s: f64) -> Spectrum {
    let n = values.len();
    if n < 4 {
        return Spectrum::default();
    }
    let mean = values.iter().sum::<f64>() / n as f64;
    let window = |k: usize| 0.5 * (1.0 - (TAU * k as f64 / n as f64).cos());
    let mut input: Vec<f64> = values
        .iter()
        .enumerate()
        .map(|(k, v)| (v - mean) * window(k))
        .collect();
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(n);
    let mut output = plan.make_output_vec();
    // Lengths come from the plan; the only error is a wrong length.
    if plan.process(&mut input, &mut output).is_err() {
        return Spectrum::default();
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
    let stretch_s = n as f64 * interval_s;
    Spectrum {
        frequency_hz: (0..output.len()).map(|k| k as f64 / stretch_s).collect(),
        amplitude,
        stretch_s,
        stretches: 1,
    }
}

/// Spectrum of a signal of any length in bounded memory: Welch's average (1967) of the
/// squared amplitudes of stretches that overlap by half. A signal shorter than one stretch
/// gives the spectrum of all of it; of a longer one the rest that fills no stretch is left
/// out.
#[derive(Debug, Clone)]
pub struct Welch {
    interval_s: f64,
    length: usize,
    values: Vec<f64>,
    squares: Vec<f64>,
    stretches: usize,
}

impl Welch {
    /// Stretches of `length` values (an even number), `interval_s` apart.
    pub fn new(length: usize, interval_s: f64) -> Self {
        Self {
            interval_s,
            length,
            values: vec![],
            squares: vec![],
            stretches: 0,
        }
    }

    /// Takes the next value.
    pub fn push(&mut self, value: f64) {
        self.values.push(value);
        if self.values.len() < self.length {
            return;
        }
        let stretch = spectrum(&self.values, self.interval_s);
        self.squares.resize(stretch.amplitude.len(), 0.0);
        for (sum, amplitude) in self.squares.iter_mut().zip(&stretch.amplitude) {
            *sum += amplitude * amplitude;
        }
        self.stretches += 1;
        self.values.drain(..self.length / 2);
    }

    /// The spectrum of what was taken so far.
    pub fn spectrum(&self) -> Spectrum {
        if self.stretches == 0 {
            return spectrum(&self.values, self.interval_s);
        }
        let stretch_s = self.length as f64 * self.interval_s;
        Spectrum {
            frequency_hz: (0..self.squares.len())
                .map(|k| k as f64 / stretch_s)
                .collect(),
            amplitude: self
                .squares
                .iter()
                .map(|sum| (sum / self.stretches as f64).sqrt())
                .collect(),
            stretch_s,
            stretches: self.stretches,
        }
    }
}
