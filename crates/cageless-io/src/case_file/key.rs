//! A key of the case file: type, unit, field in [`cageless`], meaning, what happens if it is left
//! out, and its line in the template.

use super::unit::Unit;
use super::value::CaseValue;

/// What happens if a key is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Presence<T> {
    /// The case is refused.
    Required,
    /// The key takes this value.
    Default(T),
    /// The key takes a value that follows from the rest of the case, and counts as a default.
    Derived,
    /// The key has no value.
    Optional,
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
pub(crate) enum Kind {
    Number,
    Whole,
    Text,
    /// One of these names.
    Choice(fn() -> Vec<&'static str>),
    Numbers,
    /// A number, or the lowest and the highest.
    Range,
    /// A number, or rows of time and value.
    OverTime,
    /// Rows of two numbers.
    Rows(&'static str),
    /// One of these names or a number.
    NumberOr(&'static [&'static str]),
    /// One of these names or a list of numbers.
    NumbersOr(&'static [&'static str]),
}

/// One key.
#[derive(Debug)]
pub(crate) struct Key {
    pub name: &'static str,
    /// Name in files of earlier versions, which is read as well; empty if none.
    pub formerly: &'static str,
    pub unit: Unit,
    /// Field of [`cageless::InputError`]; empty if none.
    pub field: &'static str,
    pub meaning: &'static str,
    pub kind: Kind,
    pub presence: fn() -> Presence<Option<CaseValue>>,
    pub line: Line,
}

/// The keys of one section with their values.
pub(crate) type Values = Vec<(&'static str, CaseValue)>;

impl Key {
    /// Meaning of the key, with its unit.
    pub(super) fn describe(&self) -> String {
        match self.unit.symbol() {
            "" => self.meaning.to_owned(),
            unit => format!("{}, in {unit}", self.meaning),
        }
    }
}
