//! Values.

/// Value of a result, or of a column of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// None.
    Null,
    /// A double; one that is not finite is written as null.
    Number(f64),
    /// A 64-bit integer.
    Integer(i64),
    /// Text.
    Text(String),
    /// A list of doubles.
    Numbers(Vec<f64>),
}

impl Cell {
    /// The value as a number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Integer(value) => Some(*value as f64),
            _ => None,
        }
    }
}

impl From<Option<f64>> for Cell {
    fn from(value: Option<f64>) -> Self {
        value
            .filter(|v| v.is_finite())
            .map_or(Self::Null, Self::Number)
    }
}
