//! A value that was measured, with its uncertainty.

/// Coverage factor of expanded uncertainties: about 95 % of a normal distribution (GUM, JCGM 100:2008, 6.2).
const COVERAGE_FACTOR: f64 = 2.0;

/// A value and its standard uncertainty, in the same unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeasuredValue {
    /// The value.
    pub value: f64,
    /// u, its standard uncertainty, from the scatter of the points.
    pub standard_uncertainty: f64,
}

impl MeasuredValue {
    /// U = 2 u, its expanded uncertainty.
    pub fn expanded(self) -> f64 {
        COVERAGE_FACTOR * self.standard_uncertainty
    }

    /// The value in another unit, this many of which are one.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self {
            value: factor * self.value,
            standard_uncertainty: factor * self.standard_uncertainty,
        }
    }

    /// The value counted from another zero.
    #[must_use]
    pub fn plus(self, by: f64) -> Self {
        Self {
            value: self.value + by,
            ..self
        }
    }
}
