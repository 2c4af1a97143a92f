//! Random numbers that depend on nothing but what they are for.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Purpose of random numbers; each has its own streams.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Purpose {
    /// Shift of Sobol's sequence.
    Shift = 1,
    /// Order of the slices of a Latin hypercube.
    Order = 2,
    /// Place within a slice, or on an axis.
    Place = 3,
    /// Deviations.
    Scatter = 4,
}

/// A stream of ChaCha8, which jumps to any place at no cost.
pub(crate) struct Stream(ChaCha8Rng);

impl Stream {
    /// The stream of `index` for one dimension of a purpose.
    pub(crate) fn new(seed: u64, purpose: Purpose, dimension: usize, index: u64) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&(purpose as u64).to_le_bytes());
        key[16..24].copy_from_slice(&(dimension as u64).to_le_bytes());
        let mut rng = ChaCha8Rng::from_seed(key);
        rng.set_stream(index);
        Self(rng)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Uniform in [0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2f64.powi(-53)
    }

    /// Normal with standard deviation 1 (Box and Muller).
    pub(crate) fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }

    /// Exponential with mean 1.
    pub(crate) fn exponential(&mut self) -> f64 {
        -(1.0 - self.uniform()).ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_distributions() {
        let n = 20_000;
        let mean = |f: fn(&mut Stream) -> f64| {
            let draw = |k| f(&mut Stream::new(7, Purpose::Scatter, 0, k));
            (0..n).map(draw).sum::<f64>() / n as f64
        };
        // Four standard errors.
        let close = |value: f64, expected: f64, deviation: f64| {
            assert!((value - expected).abs() < 4.0 * deviation / (n as f64).sqrt());
        };
        close(mean(|s| s.uniform()), 0.5, 12f64.recip().sqrt());
        close(mean(|s| s.normal()), 0.0, 1.0);
        close(mean(|s| s.normal().powi(2)), 1.0, 2f64.sqrt());
        close(mean(|s| s.normal().powi(4)), 3.0, 96f64.sqrt());
        close(mean(|s| s.exponential()), 1.0, 1.0);
    }

    #[test]
    fn streams_are_of_their_own() {
        let first =
            |seed, purpose, dimension, index| Stream::new(seed, purpose, dimension, index).bits();
        let all = [
            first(1, Purpose::Place, 0, 0),
            first(2, Purpose::Place, 0, 0),
            first(1, Purpose::Scatter, 0, 0),
            first(1, Purpose::Place, 1, 0),
            first(1, Purpose::Place, 0, 1),
        ];
        for (k, one) in all.iter().enumerate() {
            assert!(!all[k + 1..].contains(one));
        }
        // Kept for good: plans of today must give the same variants tomorrow.
        assert_eq!(all[0], first(1, Purpose::Place, 0, 0));
    }
}
