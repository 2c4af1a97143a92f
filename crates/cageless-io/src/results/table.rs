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

#[derive(Debug)]
enum Values {
    Numbers(Vec<f64>),
    Integers(Vec<i32>),
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Numbers(v) => v.len(),
            Self::Integers(v) => v.len(),
        }
    }
}

/// A Parquet file in the making.
#[derive(Debug)]
pub(super) struct Table {
    writer: SerializedFileWriter<PartialFile>,
    columns: Vec<Values>,
}

impl Table {
    /// Opens the table that will be at `path`.
    pub(super) fn create(
        path: &std::path::Path,
        columns: &[Column],
        footer: &[(&str, String)],
    ) -> Result<Self, ResultError> {
        let file = PartialFile::create(path)?;
        let writer = open(file, columns, footer).map_err(|source| ResultError::Table {
            path: path.to_owned(),
            source,
        })?;
        let values = |c: &Column| match c.integer {
            true => Values::Integers(Vec::new()),
            false => Values::Numbers(Vec::new()),
        };
        Ok(Self {
            writer,
            columns: columns.iter().map(values).collect(),
        })
    }

    /// Adds numbers to a column.
    pub(super) fn numbers(&mut self, column: usize, values: impl IntoIterator<Item = f64>) {
        match &mut self.columns[column] {
            Values::Numbers(all) => all.extend(values),
            Values::Integers(_) => debug_assert!(false, "column {column} holds integers"),
        }
    }

    /// Adds to a column of whole numbers.
    pub(super) fn whole_numbers(&mut self, column: usize, values: impl IntoIterator<Item = i32>) {
        match &mut self.columns[column] {
            Values::Integers(all) => all.extend(values),
            Values::Numbers(_) => debug_assert!(false, "column {column} holds numbers"),
        }
    }

    /// Completes a row; called when all columns have been appended to.
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
        let file = seal(&mut self.writer).map_err(|source| ResultError::Table { path, source })?;
        file.sync()?;
        Ok(file)
    }

    fn rows(&self) -> usize {
        self.columns.first().map_or(0, Values::len)
    }

    fn write_group(&mut self) -> Result<(), ResultError> {
        let written = write_group(&mut self.writer, &mut self.columns);
        written.map_err(|source| ResultError::Table {
            path: self.writer.inner().path().to_owned(),
            source,
        })
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
    columns: &mut [Values],
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for values in columns {
        let Some(mut column) = group.next_column()? else {
            break;
        };
        match values {
            Values::Numbers(v) => {
                column.typed::<DoubleType>().write_batch(v, None, None)?;
                v.clear();
            }
            Values::Integers(v) => {
                column.typed::<Int32Type>().write_batch(v, None, None)?;
                v.clear();
            }
        }
        column.close()?;
    }
    group.close()?;
    Ok(())
}
