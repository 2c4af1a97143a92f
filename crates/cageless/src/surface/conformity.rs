//! Whether a measured dimension keeps to its tolerance.

use super::measured_value::MeasuredValue;

/// Decision on a dimension with its expanded uncertainty (ISO 14253-1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Conformity {
    /// Within the tolerance by more than the uncertainty.
    Within,
    /// Out of it by more than the uncertainty.
    Out,
    /// The limit lies within the uncertainty.
    NotDecided,
}

impl Conformity {
    /// Conformity of an error under a tolerance to either side.
    pub fn of(error: MeasuredValue, tolerance: f64) -> Self {
        let (error, uncertainty) = (error.value.abs(), error.expanded());
        if error + uncertainty <= tolerance {
            Self::Within
        } else if error - uncertainty >= tolerance {
            Self::Out
        } else {
            Self::NotDecided
        }
    }

    /// Name of the conformity.
    pub fn name(self) -> &'static str {
        match self {
            Self::Within => "within",
            Self::Out => "out",
            Self::NotDecided => "not decided",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// U = 2 at a tolerance of 10: up to 8 within, from 12 out, between not decided.
    #[test]
    fn the_uncertainty_lies_on_neither_side() {
        let decision = |value: f64| {
            let error = MeasuredValue {
                value,
                standard_uncertainty: 1.0,
            };
            Conformity::of(error, 10.0).name()
        };
        for sign in [1.0, -1.0] {
            for (error, expected) in [
                (0.0, "within"),
                (8.0, "within"),
                (8.1, "not decided"),
                (10.0, "not decided"),
                (11.9, "not decided"),
                (12.0, "out"),
                (50.0, "out"),
            ] {
                assert_eq!(decision(sign * error), expected, "{error}");
            }
        }
    }
}
