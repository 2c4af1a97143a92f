//! Reading the tables of sweeps, and what every reader of tables checks.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};

use cageless_results::Cell;
use parquet::basic::{Repetition, Type as PhysicalType};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::metadata::ParquetMetaData;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::TypePtr;

use super::checksum::{CHECKSUM, Fault, digits, verify};
use super::error::ResultError;
use super::table::{Column, ColumnKind, GROUP_ROWS, Row, UNIT};
use crate::system::io_error_message;

/// A table that is there.
pub struct TableReader {
    path: PathBuf,
    reader: SerializedFileReader<File>,
    columns: Vec<Column>,
    footer: BTreeMap<String, String>,
}

impl TableReader {
    /// Opens a table.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is not a table of this kind.
    pub fn open(path: &Path) -> Result<Self, ResultError> {
        let reader = checked(opened(path)?, path, GROUP_ROWS)?;
        let metadata = reader.metadata().file_metadata();
        let footer: BTreeMap<_, _> = metadata
            .key_value_metadata()
            .into_iter()
            .flatten()
            .filter_map(|entry| Some((entry.key.clone(), entry.value.clone()?)))
            .collect();
        let columns = metadata
            .schema()
            .get_fields()
            .iter()
            .map(|field| column(field, &footer))
            .collect::<Option<_>>()
            .ok_or_else(|| ResultError::unreadable(path, "its columns are not those of a sweep"))?;
        Ok(Self {
            path: path.to_owned(),
            reader,
            columns,
            footer,
        })
    }

    /// Path of the table.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Columns of the table.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// An entry of the footer.
    pub fn footer(&self, key: &str) -> Option<&str> {
        self.footer.get(key).map(String::as_str)
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        u64::try_from(self.reader.metadata().file_metadata().num_rows()).unwrap_or(0)
    }

    fn groups(&self) -> usize {
        self.reader.num_row_groups()
    }

    /// Rows of the table, group by group.
    pub fn into_rows(self) -> impl Iterator<Item = Result<Row, ResultError>> {
        let all: Vec<usize> = (0..self.columns.len()).collect();
        (0..self.groups()).flat_map(move |group| self.rows_of_group(group, &all))
    }

    /// Rows of the table, group by group, with the columns `wanted` alone.
    pub fn rows_of(&self, wanted: &[usize]) -> impl Iterator<Item = Result<Row, ResultError>> {
        (0..self.groups()).flat_map(move |group| self.rows_of_group(group, wanted))
    }

    fn rows_of_group(&self, index: usize, wanted: &[usize]) -> Vec<Result<Row, ResultError>> {
        match self.read_group(index, wanted) {
            Ok(rows) => rows.into_iter().map(Ok).collect(),
            Err(e) => vec![Err(ResultError::damaged(
                &self.path,
                &e,
                "its data are damaged",
            ))],
        }
    }

    fn read_group(&self, index: usize, wanted: &[usize]) -> Result<Vec<Row>, ParquetError> {
        let group = self.reader.get_row_group(index)?;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        // Grows with what is there, whatever a damaged footer says about the count.
        let mut rows: Vec<Row> = Vec::new();
        for &column in wanted {
            let cells = read_column(group.get_column_reader(column)?, count)?;
            let cells = of_length(cells, count)?;
            rows.resize_with(count, || Row::with_capacity(wanted.len()));
            for (row, cell) in rows.iter_mut().zip(cells) {
                row.push(cell);
            }
        }
        Ok(rows)
    }
}

const NOT_PARQUET: &str = "it is not a Parquet file, or a damaged one";

fn of_fault(path: &Path, fault: Fault) -> ResultError {
    let why = match fault {
        Fault::System(error) => io_error_message(&error),
        Fault::NotParquet => NOT_PARQUET.to_owned(),
        Fault::NoChecksum => format!(
            "its footer lacks `{CHECKSUM}`, the checksum of the whole file: it is not a table of \
             Cageless, or one of an earlier version, which must be computed again"
        ),
        Fault::Damaged => "it is damaged: its bytes are not those that were written".to_owned(),
    };
    ResultError::unreadable(path, why)
}

/// Test that the groups of rows lie within the file and are of the size that is written: Parquet
/// panics at negative offsets and allocates for any number of rows that a file states.
fn is_readable(metadata: &ParquetMetaData, bytes: u64, rows_max: usize) -> bool {
    let within = |start: i64, length: i64| {
        let (start, length) = (u64::try_from(start), u64::try_from(length));
        let end = start
            .ok()
            .zip(length.ok())
            .and_then(|(s, l)| s.checked_add(l));
        end.is_some_and(|end| end <= bytes)
    };
    let mut rows = 0_i64;
    for group in metadata.row_groups() {
        let count = group.num_rows();
        let columns = group.columns().iter().all(|column| {
            let data = column.data_page_offset();
            let start = column.dictionary_page_offset().unwrap_or(data);
            start <= data && within(start, column.compressed_size()) && within(data, 0)
        });
        if !columns || !(0..=rows_max as i64).contains(&count) {
            return false;
        }
        rows = rows.saturating_add(count);
    }
    rows == metadata.file_metadata().num_rows()
}

/// Opens a file that may be a table.
pub(super) fn opened(path: &Path) -> Result<File, ResultError> {
    let unreadable = |e: std::io::Error| ResultError::unreadable(path, io_error_message(&e));
    // A pipe would be waited for.
    let kind = std::fs::metadata(path).map_err(unreadable)?;
    if kind.is_dir() {
        return Err(unreadable(std::io::ErrorKind::IsADirectory.into()));
    }
    if !kind.is_file() {
        return Err(ResultError::unreadable(path, "it is not a file"));
    }
    File::open(path).map_err(unreadable)
}

/// Checksum of a table as its footer has it.
pub(super) fn checksum(path: &Path) -> Result<String, ResultError> {
    let digits = digits(&mut opened(path)?).map_err(|fault| of_fault(path, fault))?;
    Ok(String::from_utf8_lossy(&digits).into_owned())
}

/// A Parquet file of ours, with at most `rows` in a group, once its checksum is right.
pub(super) fn checked(
    mut file: File,
    path: &Path,
    rows: usize,
) -> Result<SerializedFileReader<File>, ResultError> {
    let unreadable = |e: std::io::Error| ResultError::unreadable(path, io_error_message(&e));
    let bytes = file.metadata().map_err(unreadable)?.len();
    // First, since Parquet panics at some damage and believes other.
    verify(&mut file).map_err(|fault| of_fault(path, fault))?;
    let reader =
        SerializedFileReader::new(file).map_err(|e| ResultError::damaged(path, &e, NOT_PARQUET))?;
    if !is_readable(reader.metadata(), bytes, rows) {
        return Err(ResultError::unreadable(
            path,
            "its groups of rows are impossible",
        ));
    }
    Ok(reader)
}

/// The contents of a column if it has so many rows.
pub(super) fn of_length<T>(values: Vec<T>, count: usize) -> Result<Vec<T>, ParquetError> {
    if values.len() == count {
        Ok(values)
    } else {
        let message = "its columns are not of one length".to_owned();
        Err(ParquetError::General(message))
    }
}

/// The column of a field; `None` if it is none of ours.
fn column(field: &TypePtr, footer: &BTreeMap<String, String>) -> Option<Column> {
    let optional = field.get_basic_info().repetition() == Repetition::OPTIONAL;
    let kind = if field.is_group() {
        ColumnKind::Numbers
    } else {
        match (field.get_physical_type(), optional) {
            (PhysicalType::INT64, false) => ColumnKind::Index,
            (PhysicalType::INT64, true) => ColumnKind::Integer,
            (PhysicalType::DOUBLE, true) => ColumnKind::Number,
            (PhysicalType::BYTE_ARRAY, true) => ColumnKind::Text,
            _ => return None,
        }
    };
    let name = field.name().to_owned();
    let unit = footer.get(&format!("{UNIT}{name}")).cloned();
    Some(Column {
        unit: unit.unwrap_or_default().into(),
        name: name.into(),
        kind,
    })
}

fn read_column(reader: ColumnReader, count: usize) -> Result<Vec<Cell>, ParquetError> {
    match reader {
        ColumnReader::Int64ColumnReader(reader) => {
            let (values, levels, _) = read_all(reader, count)?;
            Ok(cells(values, levels, Cell::Integer))
        }
        ColumnReader::DoubleColumnReader(reader) => {
            let (values, levels, repetition) = read_all(reader, count)?;
            if repetition.is_empty() {
                return Ok(cells(values, levels, Cell::Number));
            }
            Ok(lists(values, &levels, &repetition))
        }
        ColumnReader::ByteArrayColumnReader(reader) => {
            let (values, levels, _) = read_all(reader, count)?;
            let texts = values
                .iter()
                .map(|bytes| bytes.as_utf8().map(str::to_owned))
                .collect::<Result<Vec<_>, _>>()?;
            Ok(cells(texts, levels, Cell::Text))
        }
        _ => Err(ParquetError::General("unknown type of column".to_owned())),
    }
}

/// Values, definition and repetition levels of a whole column.
type Levels<T> = (Vec<T>, Vec<i16>, Vec<i16>);

fn read_all<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    count: usize,
) -> Result<Levels<T::T>, ParquetError> {
    let (mut values, mut definition, mut repetition) = (Vec::new(), Vec::new(), Vec::new());
    reader.read_records(
        count,
        Some(&mut definition),
        Some(&mut repetition),
        &mut values,
    )?;
    Ok((values, definition, repetition))
}

fn cells<T>(values: Vec<T>, levels: Vec<i16>, cell: fn(T) -> Cell) -> Vec<Cell> {
    // A column that is never null has no levels.
    if levels.is_empty() {
        return values.into_iter().map(cell).collect();
    }
    let mut values = values.into_iter();
    levels
        .into_iter()
        .map(|level| match level {
            0 => Cell::Null,
            _ => values.next().map_or(Cell::Null, cell),
        })
        .collect()
}

fn lists(values: Vec<f64>, definition: &[i16], repetition: &[i16]) -> Vec<Cell> {
    let mut values = values.into_iter();
    let mut cells: Vec<Cell> = Vec::new();
    for (definition, repetition) in definition.iter().zip(repetition) {
        let item = if *definition == 2 {
            values.next()
        } else {
            None
        };
        match (cells.last_mut(), repetition) {
            (Some(Cell::Numbers(list)), 1) => list.extend(item),
            _ if *definition == 0 => cells.push(Cell::Null),
            _ => cells.push(Cell::Numbers(item.into_iter().collect())),
        }
    }
    cells
}
