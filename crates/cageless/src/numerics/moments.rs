//! Mean and deviation of a series as it comes.
//!
//! ```
//! use cageless::numerics::Moments;
//!
//! let mut moments = Moments::default();
//! for value in [1.0, 2.0, 3.0] {
//!     moments.add(value, 1.0);
//! }
//! assert_eq!(moments.mean, 2.0);
//! ```

/// Mean and variance of values with weights (times for which they are held, say), by West's
/// update (1979).
#[derive(Debug, Clone, Copy, Default)]
pub struct Moments {
    /// Sum of the weights.
    pub weight: f64,
    /// Mean; 0 if nothing was added.
    pub mean: f64,
    squares: f64,
}

impl Moments {
    /// Adds a value.
    pub fn add(&mut self, value: f64, weight: f64) {
        self.weight += weight;
        let before = value - self.mean;
        self.mean += before * weight / self.weight;
        self.squares += weight * before * (value - self.mean);
    }

    /// Standard deviation; NaN if nothing was added.
    pub fn deviation(&self) -> f64 {
        (self.squares / self.weight).sqrt()
    }
}
