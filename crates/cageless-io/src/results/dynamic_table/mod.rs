//! Tables whose columns are known when the program runs: a row per variant of a sweep.
//!
//! Columns may be null, except those of kind [`ColumnKind::Index`]. The footer has the
//! entries given and for each column with a unit `unit:<column>`.

mod reader;
mod writer;

pub use reader::RowsReader;
pub(super) use reader::checked;
pub use writer::RowsWriter;

/// Prefix of the units in the footer.
const UNIT: &str = "unit:";

/// A column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnSpec {
    /// Name, with the unit at its end.
    pub name: String,
    /// Unit; empty if there is none.
    pub unit: String,
    /// Kind of the contents.
    pub kind: ColumnKind,
}

/// Kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// 64-bit integers, never null.
    Index,
    /// Doubles.
    Number,
    /// 64-bit integers.
    Integer,
    /// UTF-8.
    Text,
    /// Lists of doubles.
    Numbers,
}

/// A value of a row.
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

/// A cell for each column.
pub type Row = Vec<Cell>;

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
