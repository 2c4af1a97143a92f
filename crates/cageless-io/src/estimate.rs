//! Means over independent starts, with their standard error.

use cageless::numerics::Moments;
use cageless::numerics::two_sided_limit;
use serde::{Deserialize, Serialize};

use cageless_results::number_text::{fixed, significant};

/// Probability of calling a difference significant that is none.
pub const SIGNIFICANCE: f64 = 0.05;

/// Mean over independent starts with its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Mean.
    pub mean: f64,
    /// Standard error of the mean; NaN for a single start.
    pub standard_error: f64,
    /// Number of starts that have a value.
    pub starts: usize,
}

/// Significance of a difference between two rings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Lower, significantly.
    Lower,
    /// Higher, significantly.
    Higher,
    /// Not significant.
    Undecided,
}

impl Estimate {
    /// Mean of the finite values; `None` if there are none.
    pub fn new(values: &[f64]) -> Option<Self> {
        let mut moments = Moments::default();
        values
            .iter()
            .filter(|v| v.is_finite())
            .for_each(|v| moments.add(*v, 1.0));
        let n = moments.weight;
        (n > 0.0).then(|| Self {
            mean: moments.mean,
            // Deviation of the values over n − 1, of the mean over n.
            standard_error: moments.deviation() / (n - 1.0).sqrt(),
            starts: n as usize,
        })
    }

    /// The estimate in another unit: numbers `factor` times as large.
    pub fn times(&self, factor: f64) -> Self {
        Self {
            mean: factor * self.mean,
            standard_error: factor * self.standard_error,
            ..*self
        }
    }

    /// Mean of the differences `values` − `reference`, start by start.
    pub fn of_differences(values: &[f64], reference: &[f64]) -> Option<Self> {
        let pairs = values.iter().zip(reference);
        Self::new(&pairs.map(|(a, b)| a - b).collect::<Vec<f64>>())
    }

    /// Sign of a mean difference under Student's two-sided test at [`SIGNIFICANCE`].
    pub fn change(&self) -> Change {
        if self.starts < 2 {
            return Change::Undecided;
        }
        let limit = two_sided_limit(SIGNIFICANCE, self.starts - 1) * self.standard_error;
        if self.mean > limit {
            Change::Higher
        } else if self.mean < -limit {
            Change::Lower
        } else {
            Change::Undecided
        }
    }

    /// `0.43 ± 0.02`: the error with two significant digits, the mean to the same decimal.
    pub fn text(&self) -> String {
        let (mean, error) = (self.mean, self.standard_error);
        if !error.is_finite() || error == 0.0 {
            return significant(mean, 4);
        }
        let decimals = (1.0 - error.log10().floor()).max(0.0);
        // Numbers of more decimals are written by powers of ten.
        if decimals > 6.0 {
            let digits = 2.0 + (mean.abs().log10().floor() - error.log10().floor()).max(0.0);
            let digits = digits as usize;
            return format!("{} ± {}", significant(mean, digits), significant(error, 2));
        }
        let number = |v: f64| fixed(Some(v), decimals as usize);
        format!("{} ± {}", number(mean), number(error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean 3, deviation √2.5 over n − 1, standard error √0.5; t(5 %, 4) = 2.776.
    #[test]
    fn an_estimate_has_its_standard_error() {
        let e = Estimate::new(&[1.0, 2.0, 3.0, 4.0, 5.0, f64::NAN]).unwrap();
        assert_eq!((e.mean, e.starts), (3.0, 5));
        assert!((e.standard_error - 0.5f64.sqrt()).abs() < 1e-15);
        assert_eq!(e.change(), Change::Higher);
        let shifted = |by: f64| Estimate::new(&[1.0, 2.0, 3.0, 4.0, 5.0].map(|v| v - by)).unwrap();
        assert_eq!(shifted(6.0).change(), Change::Lower);
        assert_eq!(shifted(1.1).change(), Change::Undecided);
        assert!(Estimate::new(&[f64::NAN]).is_none());
        assert_eq!(Estimate::new(&[1.0]).unwrap().change(), Change::Undecided);
    }

    #[test]
    fn an_estimate_ends_where_its_error_does() {
        let text = |mean, standard_error| {
            Estimate {
                mean,
                standard_error,
                starts: 8,
            }
            .text()
        };
        assert_eq!(text(3.0, 0.5f64.sqrt()), "3.00 ± 0.71");
        assert_eq!(text(-0.25, 0.0123), "\u{2212}0.250 ± 0.012");
        assert_eq!(text(1251.0, 134.0), "1251 ± 134");
        assert_eq!(text(2.0e-8, 3.1e-9), "2.00 × 10⁻⁸ ± 3.1 × 10⁻⁹");
        assert_eq!(text(2.16, f64::NAN), "2.16");
    }

    /// Starts scatter by 10, their pairs differ by 0.9 to 1.1.
    #[test]
    fn differences_are_taken_start_by_start() {
        let e = Estimate::of_differences(&[10.9, 21.0, 31.1], &[10.0, 20.0, 30.0]).unwrap();
        assert!((e.mean - 1.0).abs() < 1e-12);
        assert!((e.standard_error - 0.1 / 3f64.sqrt()).abs() < 1e-12);
        assert_eq!(e.change(), Change::Higher);
    }
}
