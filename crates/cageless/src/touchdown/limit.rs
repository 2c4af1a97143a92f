//! Limits of a user on results.

use crate::named_enum;

named_enum! {
    /// Side of a limit.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum LimitSide {
        /// The value is the most.
        AtMost = "at-most",
        /// The value is the least.
        AtLeast = "at-least",
    }
}

/// A limit on one result. No standard gives numbers: a limit belongs to someone.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// Name of the result.
    pub result: String,
    /// The most that it may be in magnitude, of a temperature with its sign, in the unit of the result; the least where
    /// more is better.
    pub value: f64,
    /// Side of the value, with its sign; as above unless given.
    pub side: Option<LimitSide>,
    /// Whose limit it is.
    pub source: String,
}
