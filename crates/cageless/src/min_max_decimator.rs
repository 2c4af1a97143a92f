//! Long series in bounded memory that keep their extremes.
//!
//! ```
//! use cageless::min_max_decimator::MinMaxDecimator;
//!
//! let mut series = MinMaxDecimator::new(8);
//! (0..1000).for_each(|k| series.push([k as f64]));
//! let rows = series.into_rows();
//! assert!(rows.len() <= 10);
//! assert_eq!(rows[0], [0.0]);
//! ```

use std::sync::Arc;

/// A row of values whose minima and maxima are taken value by value.
pub trait Row: Clone {
    /// Replaces each value by the result of `choose` on it and that of `other`.
    fn combine(&mut self, other: &Self, choose: fn(f64, f64) -> f64);
}

impl<const N: usize> Row for [f64; N] {
    fn combine(&mut self, other: &Self, choose: fn(f64, f64) -> f64) {
        for (value, other) in self.iter_mut().zip(other) {
            *value = choose(*value, *other);
        }
    }
}

impl Row for Arc<[f64]> {
    fn combine(&mut self, other: &Self, choose: fn(f64, f64) -> f64) {
        for (value, other) in Arc::make_mut(self).iter_mut().zip(other.iter()) {
            *value = choose(*value, *other);
        }
    }
}

/// Reduces a series to at most a given number of rows that keep its minima and maxima.
///
/// A series within the limit is kept unchanged. A longer one is divided into stretches
/// of equal length, each shown by two rows, of which one holds the lowest and one the
/// highest of each value (of the time: its begin and its end). When the rows fill up, two
/// stretches become one.
#[derive(Debug, Clone)]
pub struct MinMaxDecimator<T> {
    rows: Vec<T>,
    most: usize,
    stretch: usize,
    /// Lowest and highest of the stretch under way, and how many rows are in it.
    open: Option<(T, T, usize)>,
}

impl<T: Row> MinMaxDecimator<T> {
    /// Keeps `most` rows, rounded down to a multiple of four, at least four.
    pub fn new(most: usize) -> Self {
        Self {
            rows: vec![],
            most: (most / 4 * 4).max(4),
            stretch: 1,
            open: None,
        }
    }

    /// Adds a row.
    pub fn push(&mut self, row: T) {
        if self.stretch == 1 {
            self.rows.push(row);
        } else {
            match &mut self.open {
                None => self.open = Some((row.clone(), row, 1)),
                Some((low, high, count)) => {
                    low.combine(&row, f64::min);
                    high.combine(&row, f64::max);
                    *count += 1;
                }
            }
            if let Some((low, high, _)) = self.open.take_if(|o| o.2 == self.stretch) {
                self.rows.extend([low, high]);
            }
        }
        if self.rows.len() >= self.most {
            self.halve();
        }
    }

    /// Four rows become two: four that were pushed, or lows and highs of two stretches.
    fn halve(&mut self) {
        for k in 0..self.rows.len() / 4 {
            let mut low = self.rows[4 * k].clone();
            let mut high = low.clone();
            for other in &self.rows[4 * k + 1..4 * k + 4] {
                low.combine(other, f64::min);
                high.combine(other, f64::max);
            }
            self.rows[2 * k] = low;
            self.rows[2 * k + 1] = high;
        }
        self.rows.truncate(self.rows.len() / 2);
        self.stretch = if self.stretch == 1 {
            4
        } else {
            2 * self.stretch
        };
    }

    /// Number of pushed rows in a stretch; 1 if every row was kept.
    pub fn stretch(&self) -> usize {
        self.stretch
    }

    /// The rows; the last stretch may be a short one.
    pub fn into_rows(mut self) -> Vec<T> {
        if let Some((low, high, _)) = self.open {
            self.rows.extend([low, high]);
        }
        self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decimated(n: usize, most: usize) -> (Vec<[f64; 2]>, usize) {
        let mut decimator = MinMaxDecimator::new(most);
        for k in 0..n {
            let value = if k == 12_345 {
                9.0
            } else {
                (k as f64 * 0.1).sin()
            };
            decimator.push([k as f64, value]);
        }
        let stretch = decimator.stretch();
        (decimator.into_rows(), stretch)
    }

    #[test]
    fn a_short_series_is_kept() {
        let (rows, stretch) = decimated(399, 400);
        assert_eq!((rows.len(), stretch), (399, 1));
        assert_eq!(rows[7], [7.0, (7.0_f64 * 0.1).sin()]);
    }

    #[test]
    fn a_long_series_keeps_its_extremes_where_they_were() {
        for n in [400, 401, 20_000, 100_003] {
            let (rows, stretch) = decimated(n, 400);
            assert!(
                rows.len() <= 402 && rows.len() >= 190,
                "{n}: {}",
                rows.len()
            );
            assert_eq!(rows.len(), 2 * n.div_ceil(stretch), "{n}");
            assert_eq!(rows[rows.len() - 1][0], (n - 1) as f64);
            assert!(rows.windows(2).all(|w| w[0][0] <= w[1][0]));
            for pair in rows.chunks(2) {
                assert!(pair[0][1] <= pair[1][1]);
                // 9 stands in the stretch of row 12 345 and nowhere else.
                let within = pair[0][0] <= 12_345.0 && 12_345.0 <= pair[1][0];
                assert_eq!(pair[1][1] == 9.0, within, "{n}: {pair:?}");
            }
        }
    }
}
