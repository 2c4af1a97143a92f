//! Errors of input values, in SI units.
//!
//! ```
//! use cageless::reference;
//! use cageless::Material;
//! use cageless::{Bearing, BearingDimensions};
//!
//! let dimensions = BearingDimensions { balls: 0, ..reference::DIMENSIONS };
//! let error = Bearing::new(dimensions, Material::STEEL).unwrap_err();
//! assert_eq!(error.field, "balls");
//! ```

/// A value that no bearing, raceway or run can have.
///
/// `field` is the name of the offending public field (`"axial_span_m"`); its
/// suffix is the unit of `value` and of the numbers in `allowed`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", self.message())]
pub struct InputError {
    /// Name of the field, with its unit as suffix.
    pub field: &'static str,
    /// The value given.
    pub value: f64,
    /// Allowed values.
    pub allowed: Allowed,
}

/// The values that a field may take.
#[derive(Debug, Clone, PartialEq)]
pub enum Allowed {
    /// More than this.
    Above(f64, &'static str),
    /// This or more.
    AtLeast(f64, &'static str),
    /// Less than this.
    Below(f64, &'static str),
    /// This or less.
    AtMost(f64, &'static str),
    /// Between the two, bounds excluded.
    Between(f64, f64, &'static str),
    /// Such that what `.0` names, now `.1`, is at most `.2`.
    Reaching(&'static str, f64, f64),
    /// A condition in words.
    Rule(String),
    /// None: the field, a section of the case, must be left out for this reason.
    LeftOut(String),
}

impl std::fmt::Display for Allowed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (bound, why) = match self {
            Self::Above(low, why) => (format!("more than {low}"), why),
            Self::AtLeast(low, why) => (format!("at least {low}"), why),
            Self::Below(high, why) => (format!("less than {high}"), why),
            Self::AtMost(high, why) => (format!("at most {high}"), why),
            Self::Between(low, high, why) => (format!("between {low} and {high}"), why),
            Self::Reaching(what, now, most) => {
                return write!(f, "such that {what} is at most {most}, and it is {now}");
            }
            Self::Rule(rule) => return f.write_str(rule),
            Self::LeftOut(why) => return write!(f, "left out: {why}"),
        };
        match *why {
            "" => f.write_str(&bound),
            why => write!(f, "{bound} ({why})"),
        }
    }
}

impl Allowed {
    /// Passes the value of a field that keeps to the bound; none keeps to words.
    pub(crate) fn check(self, field: &'static str, value: f64) -> Result<(), InputError> {
        let kept = match self {
            Self::Above(low, _) => value > low,
            Self::AtLeast(low, _) => value >= low,
            Self::Below(high, _) => value < high,
            Self::AtMost(high, _) => value <= high,
            Self::Between(low, high, _) => value > low && value < high,
            Self::Reaching(_, now, most) => now <= most,
            Self::Rule(_) | Self::LeftOut(_) => false,
        };
        match kept {
            true => Ok(()),
            false => Err(InputError::new(field, value, self)),
        }
    }
}

impl InputError {
    pub(crate) fn new(field: &'static str, value: f64, allowed: Allowed) -> Self {
        Self {
            field,
            value,
            allowed,
        }
    }

    /// A rotor where there can be none; `why` completes "must be left out:".
    pub(crate) fn rotor_left_out(why: impl Into<String>) -> Self {
        Self::new("rotor", 1.0, Allowed::LeftOut(why.into()))
    }

    fn message(&self) -> String {
        match &self.allowed {
            Allowed::LeftOut(_) => format!("[{}] must be {}", self.field, self.allowed),
            // Nothing was given.
            Allowed::Rule(rule) if self.value.is_nan() => {
                format!("{} must be {rule}", self.field)
            }
            allowed => format!(
                "{} = {} is not possible: it must be {allowed}",
                self.field, self.value
            ),
        }
    }

    /// Error of a field whose value breaks a rule, such as "left out: …".
    pub fn rule(field: &'static str, value: f64, rule: impl Into<String>) -> Self {
        Self::new(field, value, Allowed::Rule(rule.into()))
    }
}

/// An angle for a message, degrees.
pub(crate) fn degrees(angle_rad: f64) -> f64 {
    angle_rad.to_degrees()
}
