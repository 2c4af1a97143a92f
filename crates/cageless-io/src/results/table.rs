//! One table: columns of numbers, written in groups of rows.

use std::sync::Arc;

use parquet::basic::{Compression, Repetition, Type as PhysicalType};
use parquet::data_type::{DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type};

use super::atomic_file::PartialFile;
use super::checksum::seal;
use super::error::ResultError;

/// Version of Cageless that writes.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A column of a table.
#[derive(Debug)]
pub struct Column {
    /// Name, with the unit at its end.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// 32-bit integers instead of doubles.
    pub integer: bool,
}

/// Rows that are kept in memory, at most a snapshot more: 12 MB of `balls.parquet`.
pub(super) const GROUP_ROWS: usize = 100_000;

/// A Parquet file in the making.
#[derive(Debug)]
pub(super) struct Table {
    writer: SerializedFileWriter<PartialFile>,
    /// Whether a column has whole numbers, and its values.
    columns: Vec<(bool, Vec<f64>)>,
}

impl Table {
    /// Opens the table that will be at `path`.
    pub(super) fn create(
        path: &std::path::Path,
        columns: &[Column],
        footer: &[(&str, String)],
    ) -> Result<Self, ResultError> {
        let file = PartialFile::create(path)?;
        let writer = open(file, columns, footer).map_err(|e| ResultError::table(path, e))?;
        Ok(Self {
            writer,
            columns: columns.iter().map(|c| (c.integer, vec![])).collect(),
        })
    }

    /// Adds numbers to a column.
    pub(super) fn numbers(&mut self, column: usize, values: impl IntoIterator<Item = f64>) {
        self.columns[column].1.extend(values);
    }

    /// Adds a row.
    pub(super) fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), ResultError> {
        for ((_, column), value) in self.columns.iter_mut().zip(values) {
            column.push(value);
        }
        self.rows_added()
    }

    /// Completes rows; called when all columns have been appended to.
    pub(super) fn rows_added(&mut self) -> Result<(), ResultError> {
        if self.rows() < GROUP_ROWS {
            Ok(())
        } else {
            self.write_group()
        }
    }

    /// Writes what is left; the file lacks only its name then.
    pub(super) fn close(mut self) -> Result<PartialFile, ResultError> {
        if self.rows() > 0 {
            self.write_group()?;
        }
        let path = self.writer.inner().path().to_owned();
        let file = seal(&mut self.writer).map_err(|e| ResultError::table(&path, e))?;
        file.sync()?;
        Ok(file)
    }

    fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, values)| values.len())
    }

    fn write_group(&mut self) -> Result<(), ResultError> {
        write_group(&mut self.writer, &mut self.columns)
            .map_err(|e| ResultError::table(self.writer.inner().path(), e))
    }
}

fn open(
    file: PartialFile,
    columns: &[Column],
    footer: &[(&str, String)],
) -> Result<SerializedFileWriter<PartialFile>, ParquetError> {
    let mut fields = Vec::new();
    let mut metadata: Vec<_> = footer
        .iter()
        .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()))
        .collect();
    let mut properties = WriterProperties::builder()
        .set_created_by(format!("cageless {VERSION}"))
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false);
    for column in columns {
        let physical = if column.integer {
            PhysicalType::INT32
        } else {
            PhysicalType::DOUBLE
        };
        let field = Type::primitive_type_builder(column.name, physical)
            .with_repetition(Repetition::REQUIRED)
            .build()?;
        fields.push(Arc::new(field));
        metadata.push(KeyValue::new(
            format!("unit:{}", column.name),
            column.unit.to_owned(),
        ));
        // These repeat; in the other columns hardly two values are the same.
        if column.integer || column.name == "time_s" {
            let path = ColumnPath::from(column.name);
            properties = properties.set_column_dictionary_enabled(path, true);
        }
    }
    let schema = Type::group_type_builder("cageless")
        .with_fields(fields)
        .build()?;
    let properties = properties.set_key_value_metadata(Some(metadata)).build();
    SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
}

/// Writes the rows as one group and empties the columns.
fn write_group(
    writer: &mut SerializedFileWriter<PartialFile>,
    columns: &mut [(bool, Vec<f64>)],
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for (whole, values) in columns {
        let Some(mut column) = group.next_column()? else {
            break;
        };
        if *whole {
            let values: Vec<i32> = values.iter().map(|value| *value as i32).collect();
            column
                .typed::<Int32Type>()
                .write_batch(&values, None, None)?;
        } else {
            column
                .typed::<DoubleType>()
                .write_batch(values, None, None)?;
        }
        values.clear();
        column.close()?;
    }
    group.close()?;
    Ok(())
}
