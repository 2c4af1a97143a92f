//! Constants of the rolling force of a contact that changes, as polynomials.

use std::ops::RangeInclusive;

use super::curve::RollingCurve;
use crate::numerics::chebyshev::Polynomial;

/// Coefficients of the constants over `scale` x + `shift`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CurvePolynomial {
    /// From that of the power 0; all have the heat.
    pub coefficients: Vec<RollingCurve>,
    pub scale: f64,
    pub shift: f64,
}

impl CurvePolynomial {
    /// One curve at every place.
    pub(super) fn constant(curve: RollingCurve) -> Self {
        Self {
            coefficients: vec![curve],
            scale: 0.0,
            shift: 0.0,
        }
    }

    /// Polynomials of a degree over a range of places.
    pub(super) fn new(
        at: impl Fn(f64) -> RollingCurve,
        range: RangeInclusive<f64>,
        degree: usize,
    ) -> Self {
        let (from, to) = range.into_inner();
        let fit = |of: fn(&RollingCurve) -> f64| {
            Polynomial::of_degree(|place| of(&at(place)), from, to, degree)
        };
        let [rigid, elastic, load] = [
            fit(|curve| curve.rigid),
            fit(|curve| curve.elastic),
            fit(|curve| curve.load),
        ];
        let heat = at(0.5 * (from + to)).heat;
        let coefficients = (0..=degree).map(|k| RollingCurve {
            rigid: rigid.coefficients[k],
            elastic: elastic.coefficients[k],
            load: load.coefficients[k],
            heat,
        });
        Self {
            coefficients: coefficients.collect(),
            scale: rigid.scale,
            shift: rigid.shift,
        }
    }

    /// Constants at a place.
    pub(crate) fn at(&self, place: f64) -> RollingCurve {
        let u = self.scale * place + self.shift;
        let value = |of: fn(&RollingCurve) -> f64| {
            let coefficients = self.coefficients.iter().rev();
            coefficients.fold(0.0, |sum, c| sum * u + of(c))
        };
        RollingCurve {
            rigid: value(|curve| curve.rigid),
            elastic: value(|curve| curve.elastic),
            load: value(|curve| curve.load),
            heat: self.coefficients[0].heat,
        }
    }

    /// Largest relative error of the constants at a place.
    #[cfg(test)]
    pub(super) fn error(&self, place: f64, expected: &RollingCurve) -> f64 {
        let found = self.at(place);
        let error = |of: fn(&RollingCurve) -> f64| (of(&found) / of(expected) - 1.0).abs();
        [
            error(|curve| curve.rigid),
            error(|curve| curve.elastic),
            error(|curve| curve.load),
        ]
        .into_iter()
        .fold(0.0, f64::max)
    }
}
