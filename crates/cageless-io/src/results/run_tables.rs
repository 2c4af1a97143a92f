//! Reading the tables of runs, which are written in groups of rows.

use std::fs::File;
use std::path::Path;

use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};

use super::columns::run_columns;
use super::error::ResultError;
use super::reader::{checked, of_length, opened};
use super::table::Column;

/// Rows that are kept in memory, at most a snapshot more: 12 MB of `balls.parquet`.
pub(super) const GROUP_ROWS: usize = 100_000;
/// Rows that a snapshot may add to a full group.
const SNAPSHOT_ROWS: usize = 10_000;

/// A table of a run.
pub(super) struct RunTable<'c> {
    path: &'c Path,
    reader: SerializedFileReader<File>,
    /// Columns of the table; in the plane, without those of space.
    pub columns: &'c [Column],
}

impl<'c> RunTable<'c> {
    /// Opens the table, which has `columns`, or in the plane the first of them.
    pub fn open(path: &'c Path, columns: &'c [Column]) -> Result<Self, ResultError> {
        Self::of(opened(path)?, path, columns)
    }

    /// The table in an open file.
    pub fn of(file: File, path: &'c Path, columns: &'c [Column]) -> Result<Self, ResultError> {
        let reader = checked(file, path, GROUP_ROWS + SNAPSHOT_ROWS)?;
        let fields = reader.metadata().file_metadata().schema().get_fields();
        let has = |some: &&[Column]| {
            let names = some.iter().map(|column| &*column.name);
            columns.starts_with(some) && names.eq(fields.iter().map(|field| field.name()))
        };
        let found = run_columns(false).into_iter().chain([columns]).find(has);
        let other = || ResultError::unreadable(path, "its columns are not those of a run");
        let columns = found.ok_or_else(other)?;
        Ok(Self {
            path,
            reader,
            columns,
        })
    }

    /// The numbers of each group of rows, column by column.
    pub fn groups(&self) -> impl Iterator<Item = Result<Vec<Vec<f64>>, ResultError>> {
        (0..self.reader.num_row_groups()).map(|group| {
            let damaged = |e| ResultError::damaged(self.path, &e, "its data are damaged");
            self.group(group).map_err(damaged)
        })
    }

    fn group(&self, index: usize) -> Result<Vec<Vec<f64>>, ParquetError> {
        let group = self.reader.get_row_group(index)?;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let columns = 0..self.columns.len();
        columns
            .map(|k| read(group.get_column_reader(k)?, count))
            .collect()
    }
}

/// A table of a run: for each of `columns` its numbers, bit by bit those that were written; those
/// of space are left out in the plane.
///
/// # Errors
/// The file cannot be read, is damaged or has other columns.
pub fn read_run_table(path: &Path, columns: &[Column]) -> Result<Vec<Vec<f64>>, ResultError> {
    let table = RunTable::open(path, columns)?;
    let mut found = vec![Vec::new(); table.columns.len()];
    for group in table.groups() {
        for (values, more) in found.iter_mut().zip(group?) {
            values.extend(more);
        }
    }
    Ok(found)
}

fn read(column: ColumnReader, count: usize) -> Result<Vec<f64>, ParquetError> {
    let mut values = Vec::new();
    match column {
        ColumnReader::DoubleColumnReader(mut reader) => {
            reader.read_records(count, None, None, &mut values)?;
        }
        ColumnReader::Int32ColumnReader(mut reader) => {
            let mut whole = Vec::new();
            reader.read_records(count, None, None, &mut whole)?;
            values.extend(whole.into_iter().map(f64::from));
        }
        _ => return Err(ParquetError::General("unknown type of column".to_owned())),
    }
    of_length(values, count)
}
