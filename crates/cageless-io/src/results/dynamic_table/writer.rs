//! Writing the tables of sweeps.

use std::path::Path;
use std::sync::Arc;

use cageless_results::Cell;
use parquet::basic::{Compression, ConvertedType, LogicalType, Repetition, Type as PhysicalType};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{PrimitiveTypeBuilder, Type, TypePtr};

use super::{ColumnKind, ColumnSpec, Row, UNIT};
use crate::results::VERSION;
use crate::results::atomic_file::PartialFile;
use crate::results::checksum::seal;
use crate::results::error::ResultError;

/// Rows in a group, whatever the size of the table: the bytes of a file follow from its
/// rows alone.
pub(super) const GROUP_ROWS: usize = 16_384;

/// A table in the making; without [`RowsWriter::finish`] it leaves nothing behind.
#[derive(Debug)]
pub struct RowsWriter {
    writer: SerializedFileWriter<PartialFile>,
    columns: Vec<ColumnSpec>,
    rows: Vec<Row>,
}

impl RowsWriter {
    /// Opens the table that will be at `path`.
    ///
    /// # Errors
    /// If the folder cannot be written to, or another process writes the same table.
    pub fn create(
        path: &Path,
        columns: &[ColumnSpec],
        footer: &[(String, String)],
    ) -> Result<Self, ResultError> {
        let file = PartialFile::create(path)?;
        let writer = open(file, columns, footer).map_err(|e| ResultError::table(path, e))?;
        Ok(Self {
            writer,
            columns: columns.to_vec(),
            rows: Vec::new(),
        })
    }

    /// Adds a row.
    ///
    /// # Errors
    /// If writing fails, or a cell does not fit its column.
    pub fn push(&mut self, row: Row) -> Result<(), ResultError> {
        self.rows.push(row);
        if self.rows.len() < GROUP_ROWS {
            return Ok(());
        }
        self.write_group()
    }

    /// Writes what is left and gives the file its name.
    ///
    /// # Errors
    /// If writing fails.
    pub fn finish(mut self) -> Result<(), ResultError> {
        if !self.rows.is_empty() {
            self.write_group()?;
        }
        let path = self.writer.inner().path().to_owned();
        let file = seal(&mut self.writer).map_err(|e| ResultError::table(&path, e))?;
        file.commit()
    }

    fn write_group(&mut self) -> Result<(), ResultError> {
        let rows = std::mem::take(&mut self.rows);
        write_group(&mut self.writer, &self.columns, &rows)
            .map_err(|e| ResultError::table(self.writer.inner().path(), e))
    }
}

fn open(
    file: PartialFile,
    columns: &[ColumnSpec],
    footer: &[(String, String)],
) -> Result<SerializedFileWriter<PartialFile>, ParquetError> {
    let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("cageless")
        .with_fields(fields)
        .build()?;
    let units = columns.iter().filter(|c| !c.unit.is_empty());
    let metadata: Vec<_> = footer
        .iter()
        .map(|(key, value)| KeyValue::new(key.clone(), value.clone()))
        .chain(units.map(|c| KeyValue::new(format!("{UNIT}{}", c.name), c.unit.clone())))
        .collect();
    let properties = WriterProperties::builder()
        .set_created_by(format!("cageless {VERSION}"))
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(metadata))
        .build();
    SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
}

fn primitive(
    name: &str,
    physical: PhysicalType,
    repetition: Repetition,
) -> PrimitiveTypeBuilder<'_> {
    Type::primitive_type_builder(name, physical).with_repetition(repetition)
}

fn field(column: &ColumnSpec) -> Result<TypePtr, ParquetError> {
    let name = column.name.as_str();
    let field = match column.kind {
        ColumnKind::Index => primitive(name, PhysicalType::INT64, Repetition::REQUIRED).build()?,
        ColumnKind::Integer => {
            primitive(name, PhysicalType::INT64, Repetition::OPTIONAL).build()?
        }
        ColumnKind::Number => {
            primitive(name, PhysicalType::DOUBLE, Repetition::OPTIONAL).build()?
        }
        ColumnKind::Text => primitive(name, PhysicalType::BYTE_ARRAY, Repetition::OPTIONAL)
            .with_converted_type(ConvertedType::UTF8)
            .with_logical_type(Some(LogicalType::String))
            .build()?,
        // Three levels, as the Parquet format lays down for lists.
        ColumnKind::Numbers => {
            let element = primitive("element", PhysicalType::DOUBLE, Repetition::REQUIRED);
            let list = Type::group_type_builder("list")
                .with_repetition(Repetition::REPEATED)
                .with_fields(vec![Arc::new(element.build()?)])
                .build()?;
            Type::group_type_builder(name)
                .with_repetition(Repetition::OPTIONAL)
                .with_converted_type(ConvertedType::LIST)
                .with_logical_type(Some(LogicalType::List))
                .with_fields(vec![Arc::new(list)])
                .build()?
        }
    };
    Ok(Arc::new(field))
}

/// Values of one column with Dremel's levels.
#[derive(Default)]
struct Levels<T> {
    values: Vec<T>,
    definition: Vec<i16>,
    repetition: Vec<i16>,
}

fn levels<'r, T: Default>(
    rows: &'r [Row],
    column: usize,
    of: impl Fn(&'r Cell) -> Option<T>,
) -> Levels<T> {
    let mut levels = Levels::default();
    for row in rows {
        let value = row.get(column).and_then(&of);
        levels.definition.push(i16::from(value.is_some()));
        levels.values.extend(value);
    }
    levels
}

/// 0: null; 1: an empty list; 2: an item.
fn list_levels(rows: &[Row], column: usize) -> Levels<f64> {
    let mut levels = Levels::default();
    for row in rows {
        match row.get(column) {
            Some(Cell::Numbers(list)) if !list.is_empty() => {
                levels.values.extend(list);
                levels.definition.extend(list.iter().map(|_| 2));
                let first = std::iter::once(0);
                levels
                    .repetition
                    .extend(first.chain(list.iter().skip(1).map(|_| 1)));
            }
            other => {
                let empty = matches!(other, Some(Cell::Numbers(_)));
                levels.definition.push(i16::from(empty));
                levels.repetition.push(0);
            }
        }
    }
    levels
}

fn write_group(
    writer: &mut SerializedFileWriter<PartialFile>,
    columns: &[ColumnSpec],
    rows: &[Row],
) -> Result<(), ParquetError> {
    let misfit = |row: &&Row| {
        row.len() != columns.len() || !row.iter().zip(columns).all(|(cell, c)| fits(cell, c.kind))
    };
    if let Some(row) = rows.iter().find(misfit) {
        return Err(ParquetError::General(format!(
            "a row does not fit the columns: {row:?}"
        )));
    }
    let mut group = writer.next_row_group()?;
    for (k, column) in columns.iter().enumerate() {
        let Some(mut out) = group.next_column()? else {
            break;
        };
        match out.untyped() {
            ColumnWriter::Int64ColumnWriter(out) => {
                let found = levels(rows, k, |cell| match cell {
                    Cell::Integer(value) => Some(*value),
                    _ => None,
                });
                let optional = column.kind != ColumnKind::Index;
                let definition = optional.then_some(found.definition.as_slice());
                out.write_batch(&found.values, definition, None)?;
            }
            ColumnWriter::DoubleColumnWriter(out) if column.kind == ColumnKind::Numbers => {
                let found = list_levels(rows, k);
                let (definition, repetition) = (&found.definition, &found.repetition);
                out.write_batch(&found.values, Some(definition), Some(repetition))?;
            }
            ColumnWriter::DoubleColumnWriter(out) => {
                let found = levels(rows, k, |cell| match cell {
                    Cell::Number(value) if value.is_finite() => Some(*value),
                    _ => None,
                });
                out.write_batch(&found.values, Some(&found.definition), None)?;
            }
            ColumnWriter::ByteArrayColumnWriter(out) => {
                let found = levels(rows, k, |cell| match cell {
                    Cell::Text(text) => Some(ByteArray::from(text.as_str())),
                    _ => None,
                });
                out.write_batch(&found.values, Some(&found.definition), None)?;
            }
            _ => return Err(ParquetError::General("unknown type of column".to_owned())),
        }
        out.close()?;
    }
    group.close()?;
    Ok(())
}

fn fits(cell: &Cell, kind: ColumnKind) -> bool {
    match cell {
        Cell::Null => kind != ColumnKind::Index,
        Cell::Number(_) => kind == ColumnKind::Number,
        Cell::Integer(_) => matches!(kind, ColumnKind::Integer | ColumnKind::Index),
        Cell::Text(_) => kind == ColumnKind::Text,
        Cell::Numbers(_) => kind == ColumnKind::Numbers,
        Cell::List(_) => false,
    }
}
