//! Reading the tables of runs, which are written in groups of rows.

use std::path::Path;

use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::reader::FileReader;

use super::columns::run_columns;
use super::error::ResultError;
use super::reader::checked;
use super::table::Column;

/// Rows that are kept in memory, at most a snapshot more: 12 MB of `balls.parquet`.
pub(super) const GROUP_ROWS: usize = 100_000;
/// Rows that a snapshot may add to a full group.
const SNAPSHOT_ROWS: usize = 10_000;

/// Those of `columns` that a table has: without those of space in the plane.
pub(super) fn columns_of<'c>(
    path: &Path,
    columns: &'c [Column],
) -> Result<&'c [Column], ResultError> {
    let reader = checked(path, GROUP_ROWS + SNAPSHOT_ROWS)?;
    let count = reader
        .metadata()
        .file_metadata()
        .schema()
        .get_fields()
        .len();
    let mut tables = run_columns(true).into_iter().zip(run_columns(false));
    let planar = tables.find(|(all, few)| *all == columns && few.len() == count);
    Ok(&columns[..planar.map_or(columns.len(), |(_, few)| few.len())])
}

/// A table of a run: for each of `columns` its numbers, bit by bit those that were written; those
/// of space are left out in the plane.
///
/// # Errors
/// The file cannot be read, is damaged or has other columns.
pub fn read_run_table(path: &Path, columns: &[Column]) -> Result<Vec<Vec<f64>>, ResultError> {
    let columns = columns_of(path, columns)?;
    let mut found = vec![Vec::new(); columns.len()];
    for_each_group(path, columns, |group| {
        for (values, more) in found.iter_mut().zip(group) {
            values.extend(more);
        }
        Ok(())
    })?;
    Ok(found)
}

/// Calls `take` with the numbers of each group of rows, column by column.
pub(super) fn for_each_group(
    path: &Path,
    columns: &[Column],
    mut take: impl FnMut(Vec<Vec<f64>>) -> Result<(), ResultError>,
) -> Result<(), ResultError> {
    let reader = checked(path, GROUP_ROWS + SNAPSHOT_ROWS)?;
    let schema = reader.metadata().file_metadata().schema();
    let names = schema.get_fields().iter().map(|field| field.name());
    if !names.eq(columns.iter().map(|column| &*column.name)) {
        let message = "its columns are not those of a run";
        return Err(ResultError::unreadable(path, message));
    }
    for group in 0..reader.num_row_groups() {
        let damaged = |e: ParquetError| ResultError::damaged(path, &e, "its data are damaged");
        let group = reader.get_row_group(group).map_err(damaged)?;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let mut found = vec![Vec::new(); columns.len()];
        for (k, values) in found.iter_mut().enumerate() {
            let column = group.get_column_reader(k).map_err(damaged)?;
            read(column, count, values).map_err(damaged)?;
        }
        take(found)?;
    }
    Ok(())
}

fn read(column: ColumnReader, count: usize, into: &mut Vec<f64>) -> Result<(), ParquetError> {
    let before = into.len();
    match column {
        ColumnReader::DoubleColumnReader(mut reader) => {
            reader.read_records(count, None, None, into)?;
        }
        ColumnReader::Int32ColumnReader(mut reader) => {
            let mut whole = Vec::new();
            reader.read_records(count, None, None, &mut whole)?;
            into.extend(whole.into_iter().map(f64::from));
        }
        _ => return Err(ParquetError::General("unknown type of column".to_owned())),
    }
    if into.len() - before == count {
        Ok(())
    } else {
        let message = "its columns are not of one length".to_owned();
        Err(ParquetError::General(message))
    }
}
