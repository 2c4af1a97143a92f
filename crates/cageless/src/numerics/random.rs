//! Random numbers that depend only on a seed and an index: the same whatever the order in which,
//! and the thread on which, they are drawn.
//!
//! ```
//! use cageless::numerics::RandomStream;
//!
//! let draw = |index| RandomStream::new(7, 0, 0, index).uniform();
//! assert_eq!(draw(5), draw(5));
//! assert_ne!(draw(5), draw(6));
//! ```

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Stream of ChaCha8 numbers, which reaches any index at no cost.
#[derive(Debug)]
pub struct RandomStream(ChaCha8Rng);

impl RandomStream {
    /// Stream number `index` of one `dimension` of a `purpose`; streams of different arguments
    /// are independent.
    pub fn new(seed: u64, purpose: u64, dimension: u64, index: u64) -> Self {
        let mut key = [0; 32];
        for (part, value) in key.chunks_mut(8).zip([seed, purpose, dimension]) {
            part.copy_from_slice(&value.to_le_bytes());
        }
        let mut rng = ChaCha8Rng::from_seed(key);
        rng.set_stream(index);
        Self(rng)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Number with uniform distribution in [0, 1).
    pub fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2f64.powi(-53)
    }

    /// Number with uniform distribution in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.uniform() * (high - low)
    }

    /// Number with normal distribution of mean 0 and standard deviation 1 (Box and Muller 1958).
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }

    /// Number with exponential distribution of mean 1.
    pub fn exponential(&mut self) -> f64 {
        -(1.0 - self.uniform()).ln()
    }
}

/// Increment between successive numbers of SplitMix64: 2⁶⁴ over the golden ratio.
const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// Number `k` of SplitMix64, from 1, after a seed: over the seeds a bijection of 64 bits without visible structure
/// (Steele, Lea and Flood, OOPSLA 2014).
pub fn split_mix(seed: u64, k: u64) -> u64 {
    let value = seed.wrapping_add(k.wrapping_mul(GOLDEN_GAMMA));
    let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    value ^ (value >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_distributions() {
        let n = 20_000;
        let mean = |f: fn(&mut RandomStream) -> f64| {
            let draw = |k| f(&mut RandomStream::new(7, 4, 0, k));
            (0..n).map(draw).sum::<f64>() / n as f64
        };
        // Four standard errors.
        let close = |value: f64, expected: f64, deviation: f64| {
            assert!((value - expected).abs() < 4.0 * deviation / (n as f64).sqrt());
        };
        close(mean(|s| s.uniform()), 0.5, 12f64.recip().sqrt());
        close(
            mean(|s| s.between(-1.0, 3.0)),
            1.0,
            4.0 * 12f64.recip().sqrt(),
        );
        close(mean(|s| s.normal()), 0.0, 1.0);
        close(mean(|s| s.normal().powi(2)), 1.0, 2f64.sqrt());
        close(mean(|s| s.normal().powi(4)), 3.0, 96f64.sqrt());
        close(mean(|s| s.exponential()), 1.0, 1.0);
    }

    #[test]
    fn every_argument_makes_another_stream() {
        let first = |seed, purpose, dimension, index| {
            RandomStream::new(seed, purpose, dimension, index).bits()
        };
        let all = [
            first(1, 3, 0, 0),
            first(2, 3, 0, 0),
            first(1, 4, 0, 0),
            first(1, 3, 1, 0),
            first(1, 3, 0, 1),
        ];
        for (k, one) in all.iter().enumerate() {
            assert!(!all[k + 1..].contains(one));
        }
    }

    #[test]
    fn mix_gives_the_published_sequence() {
        // First numbers of SplitMix64 from seed 0.
        let drawn: Vec<u64> = (1..4u64).map(|k| split_mix(0, k)).collect();
        let published = [
            0xe220_a839_7b1d_cdaf,
            0x6e78_9e6a_a1b9_65f4,
            0x06c4_5d18_8009_454f,
        ];
        assert_eq!(drawn, published);
    }
}
