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
pub(crate) fn spectrum(values: &[f64], interval_s: f64) -> Spectrum {
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
pub(crate) struct Welch {
    interval_s: f64,
    length: usize,
    values: Vec<f64>,
    squares: Vec<f64>,
    stretches: usize,
}

impl Welch {
    /// Stretches of `length` values (an even number), `interval_s` apart.
    pub(crate) fn new(length: usize, interval_s: f64) -> Self {
        Self {
            interval_s,
            length,
            values: vec![],
            squares: vec![],
            stretches: 0,
        }
    }

    /// Takes the next value.
    pub(crate) fn push(&mut self, value: f64) {
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
    pub(crate) fn spectrum(&self) -> Spectrum {
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

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH: usize = 256;
    const INTERVAL_S: f64 = 2e-4;

    /// `amplitude` on line `line` of a stretch of [`LENGTH`] values, for `stretches` of them.
    fn sine(line: usize, amplitude: f64, stretches: usize) -> Vec<f64> {
        let turn = TAU * line as f64 / LENGTH as f64;
        let value = |k| amplitude * (turn * k as f64 + 0.3).sin();
        (0..LENGTH * stretches).map(value).collect()
    }

    fn welch(values: impl IntoIterator<Item = f64>) -> Spectrum {
        let mut welch = Welch::new(LENGTH, INTERVAL_S);
        values.into_iter().for_each(|value| welch.push(value));
        welch.spectrum()
    }

    /// The scale of every line, the last one included: a signal of ±a at the Nyquist frequency has
    /// the amplitude a.
    #[test]
    fn lines_have_their_amplitude() {
        for (line, expected) in [(3, 0.5), (64, 2.0), (125, 7.0)] {
            let values = sine(line, expected, 1);
            let s = spectrum(&values, INTERVAL_S);
            assert!((s.amplitude[line] - expected).abs() < 1e-9, "{line}");
            // The Hann window spreads half of it to either side, and no further.
            assert!((s.amplitude[line + 1] - expected / 2.0).abs() < 1e-9);
            assert!((s.amplitude[line - 1] - expected / 2.0).abs() < 1e-9);
            assert!(s.amplitude[(line + 60) % 120] < 1e-9);
            assert_eq!(
                s.frequency_hz[line],
                line as f64 / (LENGTH as f64 * INTERVAL_S)
            );
        }
        let alternating: Vec<f64> = (0..LENGTH).map(|k| [3.0, -3.0][k % 2]).collect();
        let s = spectrum(&alternating, INTERVAL_S);
        assert_eq!((s.amplitude.len(), s.stretches), (LENGTH / 2 + 1, 1));
        assert!((s.frequency_hz[LENGTH / 2] - 2500.0).abs() < 1e-9);
        assert!((s.amplitude[LENGTH / 2] - 3.0).abs() < 1e-9);
        // An odd length has no line there, and the last one keeps both halves.
        let odd: Vec<f64> = (0..255)
            .map(|k| 2.0 * (TAU * 126.0 * f64::from(k) / 255.0).sin())
            .collect();
        let s = spectrum(&odd, INTERVAL_S);
        assert_eq!(s.amplitude.len(), 128);
        assert!((s.amplitude[126] - 2.0).abs() < 1e-9);
        assert!((s.amplitude[127] - 1.0).abs() < 1e-9);
        // The mean is no line.
        assert!(
            spectrum(&[5.0; 64], INTERVAL_S)
                .amplitude
                .iter()
                .all(|a| *a < 1e-12)
        );
        assert_eq!(spectrum(&[1.0, 2.0, 3.0], INTERVAL_S), Spectrum::default());
        assert_eq!(
            spectrum(&[1.0, 2.0, 3.0, 1.0], INTERVAL_S).amplitude.len(),
            3
        );
    }

    /// The average is that of the squares: a line of 2 shows 2, one of 1 and 5 in turn the root
    /// mean square of what each stretch shows alone.
    #[test]
    fn stretches_are_averaged_by_their_squares() {
        let s = welch(sine(40, 2.0, 5));
        assert_eq!(s.stretches, 9);
        assert!((s.amplitude[40] - 2.0).abs() < 1e-9, "{}", s.amplitude[40]);
        assert!((s.stretch_s - LENGTH as f64 * INTERVAL_S).abs() < 1e-12);
        assert!((s.frequency_hz[40] - 40.0 / s.stretch_s).abs() < 1e-9);

        let values: Vec<f64> = [1.0, 5.0].iter().flat_map(|a| sine(40, *a, 1)).collect();
        let s = welch(values.iter().copied());
        assert_eq!(s.stretches, 3);
        let alone = |from: usize| spectrum(&values[from..from + LENGTH], INTERVAL_S).amplitude[40];
        let [a, b, c] = [0, LENGTH / 2, LENGTH].map(alone);
        assert!((a - 1.0).abs() < 1e-9 && (c - 5.0).abs() < 1e-9);
        let expected = ((a * a + b * b + c * c) / 3.0).sqrt();
        assert!((s.amplitude[40] - expected).abs() < 1e-12);
        // What fills no stretch is left out; less than one is all there is.
        assert_eq!(
            welch(values.iter().copied().chain(sine(7, 9.0, 1)).take(600)),
            s
        );
        let short = &values[..200];
        assert_eq!(welch(short.iter().copied()), spectrum(short, INTERVAL_S));
    }
}
