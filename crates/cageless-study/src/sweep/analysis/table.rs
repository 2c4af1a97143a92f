//! The result as columns of a kind.

use cageless_io::results::{Column, ColumnKind, Row, TableReader};

use crate::StudyError;
use crate::sweep::evaluate::{INDEX, REASON};

/// The result of a sweep: its index, then inputs, the reason, then outputs.
pub(super) struct Table {
    pub reader: TableReader,
    pub reason: usize,
}

impl Table {
    pub(super) fn new(reader: TableReader) -> Result<Self, StudyError> {
        let columns = reader.columns();
        let reason = columns.iter().position(|c| c.name == REASON);
        let index = columns.first().is_some_and(|c| c.name == INDEX);
        match reason {
            Some(reason) if index => Ok(Self { reader, reason }),
            _ => Err(StudyError::Input(format!(
                "{} lacks the columns of a sweep",
                reader.path().display()
            ))),
        }
    }

    pub(super) fn column(&self, name: &str) -> Option<usize> {
        self.columns().iter().position(|c| c.name == name)
    }

    pub(super) fn columns(&self) -> &[Column] {
        self.reader.columns()
    }

    /// Inputs that are single values.
    pub(super) fn inputs(&self) -> Vec<usize> {
        self.single(1..self.reason)
    }

    /// Outputs that are single values.
    pub(super) fn outputs(&self) -> Vec<usize> {
        self.single(self.reason + 1..self.columns().len())
    }

    fn single(&self, mut columns: std::ops::Range<usize>) -> Vec<usize> {
        let single = |k: &usize| self.columns()[*k].kind != ColumnKind::Numbers;
        columns.by_ref().filter(single).collect()
    }

    /// Shows every row, of the columns `wanted` alone.
    pub(super) fn each(
        &self,
        wanted: &[usize],
        mut see: impl FnMut(&Row),
    ) -> Result<(), StudyError> {
        for row in self.reader.rows_of(wanted) {
            see(&row?);
        }
        Ok(())
    }
}
