//! Latin hypercubes by index.

use cageless::numerics::split_mix;

use super::random::Purpose;

/// `count` points, one in each of `count` slices of every axis.
#[derive(Debug, Clone)]
pub(crate) struct LatinHypercube {
    count: u64,
    seed: u64,
    /// Keys of the rounds that order the slices of each axis.
    keys: Vec<[u64; ROUNDS]>,
}

const ROUNDS: usize = 6;

impl LatinHypercube {
    pub(crate) fn new(dimensions: usize, count: u64, seed: u64) -> Self {
        let keys = |k| {
            let mut stream = Purpose::Order.stream(seed, k, 0);
            std::array::from_fn(|_| stream.bits())
        };
        Self {
            count,
            seed,
            keys: (0..dimensions).map(keys).collect(),
        }
    }

    /// Place of point `index` on an axis, in [0, 1).
    pub(crate) fn at(&self, index: u64, dimension: usize) -> f64 {
        let slice = permuted(index, self.count, &self.keys[dimension]);
        let within = Purpose::Position
            .stream(self.seed, dimension, index)
            .uniform();
        ((slice as f64 + within) / self.count as f64).min(1.0 - f64::EPSILON / 2.0)
    }
}

/// Image of `index` under a random permutation of 0 … count − 1. A Feistel network permutes
/// the next larger power of 4; from outside `count` it repeats until it is inside again
/// (Black and Rogaway, "Ciphers with arbitrary finite domains", CT-RSA 2002).
fn permuted(index: u64, count: u64, keys: &[u64; ROUNDS]) -> u64 {
    let bits = 64 - count.saturating_sub(1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1 << half) - 1;
    let mut at = index;
    loop {
        let (mut left, mut right) = (at >> half, at & mask);
        for key in keys {
            (left, right) = (right, left ^ (split_mix(right ^ key, 1) & mask));
        }
        at = left << half | right;
        if at < count {
            return at;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_slice_of_every_axis_has_one_point() {
        for count in [1, 2, 3, 10, 64, 1000] {
            let hypercube = LatinHypercube::new(5, count, 3);
            for dimension in 0..5 {
                let mut seen = vec![false; count as usize];
                for index in 0..count {
                    let slice = (hypercube.at(index, dimension) * count as f64) as usize;
                    assert!(!std::mem::replace(&mut seen[slice], true));
                }
            }
        }
    }

    #[test]
    fn axes_are_not_correlated() {
        let count = 1000;
        let hypercube = LatinHypercube::new(4, count, 3);
        for (one, other) in [(0, 1), (0, 2), (1, 3), (2, 3)] {
            let product = |k| (hypercube.at(k, one) - 0.5) * (hypercube.at(k, other) - 0.5);
            let correlation = 12.0 * (0..count).map(product).sum::<f64>() / count as f64;
            // Four standard errors of independent axes.
            assert!(
                correlation.abs() < 4.0 / (count as f64).sqrt(),
                "{correlation}"
            );
        }
        let order: Vec<u64> = (0..count)
            .map(|k| permuted(k, count, &hypercube.keys[0]))
            .collect();
        let kept = order.iter().enumerate().filter(|(k, at)| *k as u64 == **at);
        assert!(kept.count() < 10);
    }
}
