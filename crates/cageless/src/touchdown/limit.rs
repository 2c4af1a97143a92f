//! Limits of a user on what a drop may do.

/// A limit on one result of a drop. No standard gives numbers: a limit belongs to someone.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// Name of the result.
    pub result: String,
    /// The most that it may be in magnitude, of a temperature with its sign, in the unit of the result; the least where
    /// more is better.
    pub value: f64,
    /// Whose limit it is.
    pub source: String,
}
