//! Purposes of the random numbers of a sweep.

use cageless::numerics::RandomStream;

/// Purpose of random numbers; each has its own streams. The numbers are kept for good: a plan
/// gives the same variants in every version.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Purpose {
    /// Shift of Sobol's sequence.
    Shift = 1,
    /// Order of the slices of a Latin hypercube.
    Order = 2,
    /// Position within a slice, or on an axis.
    Position = 3,
    /// Deviations.
    Scatter = 4,
}

impl Purpose {
    /// Stream of `index` for one dimension.
    pub(crate) fn stream(self, seed: u64, dimension: usize, index: u64) -> RandomStream {
        RandomStream::new(seed, self as u64, dimension as u64, index)
    }
}
