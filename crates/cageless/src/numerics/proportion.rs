//! Interval of a probability that was estimated by counting.
//!
//! ```
//! use cageless::numerics::wilson_interval;
//!
//! let [low, high] = wilson_interval(0, 10);
//! assert!(low == 0.0 && (high - 0.2775).abs() < 5e-5);
//! ```

/// 97.5 % quantile of the normal distribution.
const NORMAL_975: f64 = 1.959_963_984_540_054;

/// Wilson's interval of the probability of success if `passed` of `count` trials succeeded, 95 %
/// (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927, 209–212).
pub fn wilson_interval(passed: usize, count: usize) -> [f64; 2] {
    let (n, p) = (count as f64, passed as f64 / count as f64);
    let z2 = NORMAL_975 * NORMAL_975;
    let middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
    let half = (z2 * (p * (1.0 - p) / n + z2 / (4.0 * n * n))).sqrt() / (1.0 + z2 / n);
    [(middle - half).max(0.0), (middle + half).min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Limits as tabulated: 0 of 10, 5 of 10, 10 of 10.
    #[test]
    fn the_interval_is_that_of_the_tables() {
        for (passed, low, high) in [(0, 0.0, 0.2775), (5, 0.2366, 0.7634), (10, 0.7225, 1.0)] {
            let [a, b] = wilson_interval(passed, 10);
            assert!(
                (a - low).abs() < 5e-5 && (b - high).abs() < 5e-5,
                "{passed}: {a} {b}"
            );
        }
    }
}
