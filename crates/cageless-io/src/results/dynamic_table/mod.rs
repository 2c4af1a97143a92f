//! Tables whose columns are known when the program runs: a row per variant of a sweep.
//!
//! Columns may be null, except those of kind [`ColumnKind::Index`]. The footer has the
//! entries given and for each column with a unit `unit:<column>`.

mod reader;
mod writer;

use cageless_results::Cell;

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

/// A cell for each column.
pub type Row = Vec<Cell>;
