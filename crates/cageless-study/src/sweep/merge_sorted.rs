//! One table from several, in the order of the variants. Memory holds a group of rows of
//! each table that is open, and few are: each spans a short stretch of the sweep.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::vec::IntoIter;

use cageless_io::results::{Column, Row, TableReader, TableWriter};

use super::checkpoint::index;
use super::error::SweepError;

/// Writes `result` from `tables` (each with its first index, in order), which together
/// hold every variant of `range` once.
pub(crate) fn merge_sorted(
    result: &Path,
    columns: &[Column],
    footer: &[(&str, String)],
    tables: &[(u64, PathBuf)],
    range: Range<u64>,
) -> Result<(), SweepError> {
    let mut out = TableWriter::create(result, columns, footer)?;
    let mut waiting = tables.iter().peekable();
    let mut open: Vec<Option<Cursor>> = Vec::new();
    let mut heads: BinaryHeap<Reverse<(u64, usize)>> = BinaryHeap::new();
    for expected in range {
        while let Some((_, path)) = waiting.next_if(|(first, _)| *first <= expected) {
            let mut cursor = Cursor::open(path, columns)?;
            if let Some(head) = cursor.head()? {
                heads.push(Reverse((head, open.len())));
                open.push(Some(cursor));
            }
        }
        let found = heads.pop();
        let cursor = match found {
            Some(Reverse((head, k))) if head == expected => open[k].as_mut().map(|c| (c, k)),
            _ => None,
        };
        let Some((cursor, k)) = cursor else {
            return Err(SweepError::Input(format!(
                "{}: variant {expected} is missing, or one is there twice",
                result.display()
            )));
        };
        if let Some(row) = cursor.rows.next() {
            out.push(row)?;
        }
        match cursor.head()? {
            Some(head) => heads.push(Reverse((head, k))),
            None => open[k] = None,
        }
    }
    Ok(out.finish()?)
}

/// A table that is being read.
struct Cursor {
    table: TableReader,
    next_group: usize,
    rows: IntoIter<Row>,
}

impl Cursor {
    fn open(path: &Path, columns: &[Column]) -> Result<Self, SweepError> {
        let table = TableReader::open(path)?;
        if table.columns() != columns {
            return Err(SweepError::Input(format!(
                "{}: its columns are not those of the sweep",
                path.display()
            )));
        }
        Ok(Self {
            table,
            next_group: 0,
            rows: Vec::new().into_iter(),
        })
    }

    /// Index of the next row; `None` at the end.
    fn head(&mut self) -> Result<Option<u64>, SweepError> {
        while self.rows.len() == 0 {
            if self.next_group == self.table.groups() {
                return Ok(None);
            }
            self.rows = self.table.group(self.next_group)?.into_iter();
            self.next_group += 1;
        }
        Ok(self.rows.as_slice().first().map(index))
    }
}
