//! A key of a file: type, unit, limits, field in [`cageless`], meaning, what happens if it is left
//! out, and its line in the template.

use super::spanned_toml::Value;
use super::unit::Unit;
use super::value::CaseValue;

/// Consequence of leaving a key out.
#[derive(Debug, Clone, PartialEq)]
pub enum Presence {
    /// The file is refused.
    Required,
    /// The key takes this value.
    Default(CaseValue),
    /// The key takes a value that follows from the rest of the case, and counts as a default.
    Derived,
    /// The key has no value.
    Optional,
}

/// A key that takes this value if it is left out.
pub(crate) fn default(value: impl Into<CaseValue>) -> Presence {
    Presence::Default(value.into())
}

/// Line of a key in the template: its value and a comment.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Line {
    /// In force.
    Shown(&'static str, &'static str),
    /// Commented out.
    Commented(&'static str, &'static str),
    /// Not in the template.
    Absent,
}

/// Type of a value as a reader of the documentation meets it.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// Text.
    Text,
    /// One of these names.
    Choice(fn() -> Vec<&'static str>),
    /// A list of numbers.
    Numbers,
    /// A number, or the lowest and the highest.
    Range,
    /// A number, or rows of time and value.
    OverTime,
    /// Rows of two numbers, named here.
    Rows(&'static str),
    /// One of these names or a number.
    NumberOr(&'static [&'static str]),
    /// One of these names or a list of numbers.
    NumbersOr(&'static [&'static str]),
}

impl Kind {
    /// The value of a key of this type, however it is written.
    pub(crate) fn value(self, value: &Value) -> Option<CaseValue> {
        Some(match (self, CaseValue::from_toml(value)?) {
            (Self::Whole, CaseValue::Number(f)) => CaseValue::Integer(f as i64),
            (Self::Whole, whole) => whole,
            (_, CaseValue::Integer(i)) => CaseValue::Number(i as f64),
            // -0.0 is 0: friction would have no direction otherwise.
            (_, CaseValue::Number(f)) => CaseValue::Number(f + 0.0),
            (Self::Range, CaseValue::Numbers(ends)) if ends.iter().all(|end| *end == ends[0]) => {
                CaseValue::Number(*ends.first()?)
            }
            (Self::OverTime | Self::Rows(_), CaseValue::Numbers(none)) if none.is_empty() => {
                CaseValue::Table(vec![])
            }
            (_, value) => value,
        })
    }
}

/// Allowed numbers of a key, in its unit. [`cageless`] has further limits, which depend on other
/// values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Limit {
    /// Any.
    None,
    /// More than this.
    Above(f64),
    /// This or more.
    AtLeast(f64),
    /// More than the first and less than the second.
    Inside(f64, f64),
    /// From the first to the second.
    Within(f64, f64),
}

impl Limit {
    /// Whether a number is allowed.
    pub(super) fn has(self, value: f64) -> bool {
        match self {
            Self::None => true,
            Self::Above(low) => value > low,
            Self::AtLeast(low) => value >= low,
            Self::Inside(low, high) => value > low && value < high,
            Self::Within(low, high) => (low..=high).contains(&value),
        }
    }

    /// Allowed numbers as a phrase.
    pub(super) fn allowed(self, unit: Unit) -> String {
        let with = |value| unit.with(value);
        match self {
            Self::None => "a number".to_owned(),
            Self::Above(low) => format!("more than {}", with(low)),
            Self::AtLeast(low) => format!("at least {}", with(low)),
            Self::Inside(low, high) => {
                format!("more than {} and less than {}", with(low), with(high))
            }
            Self::Within(low, high) => format!("between {low} and {}", with(high)),
        }
    }

    /// Allowed whole numbers as a phrase.
    pub(super) fn whole_numbers(self) -> String {
        match self {
            Self::Within(low, high) => format!("a whole number from {low} to {high}"),
            Self::AtLeast(low) => format!("a whole number, {low} or more"),
            _ => "a whole number, 0 or more and below 2^63".to_owned(),
        }
    }
}

/// A key of a file.
#[derive(Debug)]
pub struct Key {
    /// Name.
    pub name: &'static str,
    /// Name in files of earlier versions, which is read as well; empty if none.
    pub formerly: &'static str,
    pub(crate) unit: Unit,
    pub(crate) limit: Limit,
    /// Field of [`cageless::InputError`], in SI units; empty if none.
    pub(crate) field: &'static str,
    /// Meaning of the value.
    pub meaning: &'static str,
    /// Type of the value.
    pub kind: Kind,
    /// Consequence of leaving the key out.
    pub presence: fn() -> Presence,
    pub(crate) line: Line,
}

impl Key {
    /// Unit as it is printed; empty if there is none.
    pub fn unit(&self) -> String {
        self.unit.printed()
    }

    /// Meaning of the key, with its unit.
    pub(crate) fn describe(&self) -> String {
        match self.unit().as_str() {
            "" => self.meaning.to_owned(),
            unit => format!("{}, in {unit}", self.meaning),
        }
    }

    /// Whether the file is refused if the key is left out.
    pub fn is_required(&self) -> bool {
        matches!((self.presence)(), Presence::Required)
    }
}
