//! Quantiles of samples.
//!
//! ```
//! use cageless::numerics::quantile;
//!
//! assert_eq!([0.0, 0.5, 1.0].map(|p| quantile(&[1.0, 2.0, 4.0, 8.0], p)), [1.0, 3.0, 8.0]);
//! ```

/// Quantile of a sample in ascending order, linear between the values of ranks (n − 1)·p around it: definition 7 of
/// Hyndman and Fan (The American Statistician 50, 1996, 361–365), as in NumPy and R.
///
/// # Panics
/// If there is no value, or `p` is not from 0 to 1.
pub fn quantile(ascending: &[f64], p: f64) -> f64 {
    let place = p * (ascending.len() - 1) as f64;
    let [low, high] = [place.floor(), place.ceil()].map(|rank| ascending[rank as usize]);
    low + (place - place.floor()) * (high - low)
}
