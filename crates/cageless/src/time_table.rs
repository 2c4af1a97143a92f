//! Quantities that are given over time.
//!
//! ```
//! use cageless::TimeTable;
//!
//! // Run-up to 100 rad/s within two seconds.
//! let speed = TimeTable::new("inner_speed_rad_s", vec![0.0, 2.0], vec![0.0, 100.0])?;
//! assert_eq!([0.5, 3.0].map(|time_s| speed.value(time_s)), [25.0, 100.0]);
//! # Ok::<(), cageless::InputError>(())
//! ```

use std::ops::Range;

use crate::error::InputError;
use crate::limits::require;

/// A quantity that is piecewise linear in time and holds its first value before the table and
/// its last value after it.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeTable {
    times_s: Vec<f64>,
    values: Vec<f64>,
}

/// Time of interest around a corner, s.
const CORNER_S: f64 = 1e-4;

impl TimeTable {
    /// Table of the quantity `field` with `values` at `times_s`.
    ///
    /// # Errors
    /// An [`InputError`] of `field` if there are no values, not as many as times, one is not
    /// finite, or the times do not increase from 0 or later.
    pub fn new(
        field: &'static str,
        times_s: Vec<f64>,
        values: Vec<f64>,
    ) -> Result<Self, InputError> {
        let as_many = !times_s.is_empty() && times_s.len() == values.len();
        let rule = format!("as many values as times ({}), at least one", times_s.len());
        require(field, values.len() as f64, as_many, rule)?;
        for &value in &values {
            let rule = "a finite number at each time";
            require(field, value, value.is_finite(), rule)?;
        }
        for &time_s in &times_s {
            let kept = time_s.is_finite() && time_s >= 0.0;
            require(field, time_s, kept, "given at times of 0 s or later")?;
        }
        for pair in times_s.windows(2) {
            let rule = "given at times that increase; a step is a short ramp";
            require(field, pair[1], pair[0] < pair[1], rule)?;
        }
        Ok(Self { times_s, values })
    }

    /// Times, s.
    pub(crate) fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// Values at these times.
    pub(crate) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Index of the piece at `time_s`: 0 before the first time, the number of times after the
    /// last one.
    pub(crate) fn piece(&self, time_s: f64) -> usize {
        self.times_s.partition_point(|t| *t <= time_s)
    }

    /// A function of time that is zero at the corners, with one sign in each piece and the other in
    /// the next.
    pub(crate) fn corner(&self, time_s: f64) -> f64 {
        let next = self.piece(time_s);
        let sign = if next.is_multiple_of(2) { -1.0 } else { 1.0 };
        let since = next.checked_sub(1).map(|k| time_s - self.times_s[k]);
        let until = self.times_s.get(next).map(|t| t - time_s);
        sign * match (since, until) {
            (Some(since), Some(until)) => since * until / (since + until),
            (since, until) => since.or(until).unwrap_or(0.0),
        } / CORNER_S
    }

    /// Value at `time_s`.
    pub fn value(&self, time_s: f64) -> f64 {
        let next = self.piece(time_s);
        match (next.checked_sub(1), self.values.get(next)) {
            (None, _) => self.values[0],
            (Some(last), None) => self.values[last],
            (Some(here), Some(_)) => {
                self.values[here] + self.slope(time_s) * (time_s - self.times_s[here])
            }
        }
    }

    /// Rate of change at `time_s`, per second; of the piece that begins there at a corner.
    pub(crate) fn slope(&self, time_s: f64) -> f64 {
        let next = self.piece(time_s);
        if next == 0 || next == self.values.len() {
            return 0.0;
        }
        let here = next - 1;
        (self.values[next] - self.values[here]) / (self.times_s[next] - self.times_s[here])
    }

    /// Table of the quantity with its time counted from `time_s`.
    pub(crate) fn beginning_at(&self, time_s: f64) -> Self {
        let rest = self.piece(time_s);
        let times = self.times_s[rest..].iter().map(|t| t - time_s);
        let mut table = Self {
            times_s: vec![0.0],
            values: vec![self.value(time_s)],
        };
        table.times_s.extend(times);
        table.values.extend(&self.values[rest..]);
        table
    }

    /// Integral of the quantity from one time to a later one.
    pub(crate) fn integral(&self, between_s: Range<f64>) -> f64 {
        let (from_s, to_s) = (between_s.start, between_s.end);
        let corners = self.times_s.iter().copied();
        let corners = corners.filter(|t| (from_s < *t) & (*t < to_s));
        let (mut last_s, mut sum) = (from_s, 0.0);
        for time_s in corners.chain([to_s]) {
            sum += 0.5 * (time_s - last_s) * (self.value(last_s) + self.value(time_s));
            last_s = time_s;
        }
        sum
    }

    /// Smallest and largest value from t = 0 up to a time.
    pub(crate) fn range_until(&self, end_s: f64) -> [f64; 2] {
        let corners = self.times_s.iter().zip(&self.values);
        let before = corners.filter(|(t, _)| **t < end_s).map(|(_, v)| *v);
        let first = self.value(0.0);
        (before.chain([self.value(end_s)]))
            .fold([first; 2], |[low, high], v| [low.min(v), high.max(v)])
    }

    /// Smallest and largest value.
    pub(crate) fn range(&self) -> [f64; 2] {
        let first = self.values[0];
        let values = self.values.iter();
        values.fold([first; 2], |[low, high], v| [low.min(*v), high.max(*v)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run-up of 2 s to 4/s that is held: 4 up to its end, 4 a second after it; ranges are those up to a time.
    #[test]
    fn integrals_and_ranges_are_those_of_their_times() {
        let table = TimeTable::new("f", vec![1.0, 3.0, 5.0], vec![0.0, 4.0, 2.0]).unwrap();
        for (from, to, expected) in [
            (0.0, 1.0, 0.0),
            (0.0, 3.0, 4.0),
            (2.0, 3.0, 3.0),
            (2.0, 5.0, 9.0),
            (4.0, 7.0, 6.5),
        ] {
            let found = table.integral(from..to);
            assert!((found - expected).abs() < 1e-12, "{from} {to}: {found}");
        }
        assert_eq!(table.range_until(2.0), [0.0, 2.0]);
        assert_eq!(table.range_until(4.0), [0.0, 4.0]);
        assert_eq!(table.range_until(9.0), [0.0, 4.0]);
        assert_eq!(table.range(), [0.0, 4.0]);
    }

    #[test]
    fn values_are_linear_between_times_and_held_beyond_them() {
        let table = TimeTable::new("f", vec![1.0, 2.0, 4.0], vec![3.0, 5.0, 1.0]).unwrap();
        for (time_s, value, slope) in [
            (0.0, 3.0, 0.0),
            (1.0, 3.0, 2.0),
            (1.5, 4.0, 2.0),
            (2.0, 5.0, -2.0),
            (3.0, 3.0, -2.0),
            (4.0, 1.0, 0.0),
            (9.0, 1.0, 0.0),
        ] {
            assert_eq!((table.value(time_s), table.slope(time_s)), (value, slope));
        }
        assert_eq!(table.range(), [1.0, 5.0]);
    }

    #[test]
    fn a_table_can_be_counted_from_later() {
        let table = TimeTable::new("f", vec![1.0, 2.0, 4.0], vec![3.0, 5.0, 1.0]).unwrap();
        for from_s in [0.0, 0.5, 1.0, 1.5, 3.0, 4.0, 7.0] {
            let later = table.beginning_at(from_s);
            for time_s in [0.0, 0.25, 0.5, 1.0, 2.0, 5.0] {
                let (a, b) = (later.value(time_s), table.value(from_s + time_s));
                assert!((a - b).abs() < 1e-12, "{from_s} + {time_s}: {a} and {b}");
            }
        }
    }

    #[test]
    fn impossible_tables_are_refused() {
        for (times_s, values) in [
            (vec![], vec![]),
            (vec![0.0, 1.0], vec![1.0]),
            (vec![0.0, 0.0], vec![1.0, 2.0]),
            (vec![1.0, 0.5], vec![1.0, 2.0]),
            (vec![-1.0, 0.5], vec![1.0, 2.0]),
            (vec![0.0, f64::NAN], vec![1.0, 2.0]),
            (vec![0.0, 1.0], vec![1.0, f64::INFINITY]),
        ] {
            assert!(TimeTable::new("f", times_s, values).is_err());
        }
    }
}
