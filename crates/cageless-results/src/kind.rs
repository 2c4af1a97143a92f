//! The kind of a value.

/// Kind of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A count.
    Integer,
    /// True or false; 1 or 0 in the columns of sweeps.
    Flag,
    /// A name or a sentence.
    Text,
    /// A number for each ball, or for each of several things.
    Numbers,
    /// A number for each of a few things, in the order in which tables show them.
    Few,
    /// Both ends of a range, or several quantiles.
    Range,
}
