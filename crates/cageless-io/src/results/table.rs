//! One table: typed columns in a Parquet file, written in groups of rows.
//!
//! Columns of runs have a number in every row. Those of sweeps, whose rows are of [`Cell`]s, may be
//! null, except an [`ColumnKind::Index`]. The footer has the entries given and for each column with a
//! unit `unit:<column>`.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use cageless_results::Cell;
use parquet::basic::{Compression, ConvertedType, LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type, TypePtr};

use super::atomic_file::PartialFile;
use super::checksum::seal;
use super::error::ResultError;

/// Version of Cageless that writes.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Prefix of the units in the footer.
pub(super) const UNIT: &str = "unit:";

/// Rows in a group of a sweep, whatever the size of the table: the bytes of a file follow from its
/// rows alone.
pub(super) const GROUP_ROWS: usize = 16_384;

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Name, with the unit at its end.
    pub name: Cow<'static, str>,
    /// Unit; empty if there is none.
    pub unit: Cow<'static, str>,
    /// Kind of the contents.
    pub kind: ColumnKind,
}

/// Kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// Doubles of a run, never null.
    Value,
    /// 32-bit integers of a run, never null.
    Ordinal,
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

/// A table in the making; without [`TableWriter::finish`] it leaves nothing behind.
#[derive(Debug)]
pub struct TableWriter {
    writer: SerializedFileWriter<PartialFile>,
    /// Contents of each column in the next group of rows.
    columns: Vec<Contents>,
    rows: usize,
    group_rows: usize,
}

impl TableWriter {
    /// Opens the table that will be at `path`.
    ///
    /// # Errors
    /// If the folder cannot be written to, or another process writes the same table.
    pub fn create(
        path: &Path,
        columns: &[Column],
        footer: &[(&str, String)],
    ) -> Result<Self, ResultError> {
        Self::in_groups(path, columns, footer, GROUP_ROWS)
    }

    /// Opens a table with groups of so many rows or more.
    pub(super) fn in_groups(
        path: &Path,
        columns: &[Column],
        footer: &[(&str, String)],
        group_rows: usize,
    ) -> Result<Self, ResultError> {
        let file = PartialFile::create(path)?;
        let writer = open(file, columns, footer).map_err(|e| ResultError::table(path, e))?;
        Ok(Self {
            writer,
            columns: columns.iter().map(|c| Contents::new(c.kind)).collect(),
            rows: 0,
            group_rows,
        })
    }

    /// Adds a row.
    ///
    /// # Errors
    /// If a cell does not fit its column, or writing fails.
    pub fn push(&mut self, row: Row) -> Result<(), ResultError> {
        let fit = |(column, cell): (&Contents, &Cell)| column.fits(cell);
        if row.len() != self.columns.len() || !self.columns.iter().zip(&row).all(fit) {
            let message = format!("a row does not fit the columns: {row:?}");
            let error = ParquetError::General(message);
            return Err(ResultError::table(self.path(), error));
        }
        for (column, cell) in self.columns.iter_mut().zip(row) {
            column.push(cell);
        }
        self.added(1)
    }

    /// Adds numbers to a column without nulls; [`TableWriter::added`] follows.
    pub(super) fn numbers(&mut self, column: usize, numbers: impl IntoIterator<Item = f64>) {
        match &mut self.columns[column].values {
            Values::Ordinals(values) => values.extend(numbers.into_iter().map(|v| v as i32)),
            Values::Doubles(values) => values.extend(numbers),
            Values::Integers(_) | Values::Texts(_) => {}
        }
    }

    /// Adds a row of numbers without nulls.
    pub(super) fn row(
        &mut self,
        numbers: impl IntoIterator<Item = f64>,
    ) -> Result<(), ResultError> {
        for (column, number) in numbers.into_iter().enumerate() {
            self.numbers(column, [number]);
        }
        self.added(1)
    }

    /// Completes rows, to all columns of which something was added.
    pub(super) fn added(&mut self, rows: usize) -> Result<(), ResultError> {
        self.rows += rows;
        if self.rows < self.group_rows {
            return Ok(());
        }
        self.write_group()
    }

    /// Writes what is left and gives the file its name.
    ///
    /// # Errors
    /// If writing fails.
    pub fn finish(self) -> Result<(), ResultError> {
        self.close()?.rename()
    }

    /// Writes what is left; the file lacks only its name then.
    pub(super) fn close(mut self) -> Result<PartialFile, ResultError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        let sealed = seal(&mut self.writer);
        let file = sealed.map_err(|e| ResultError::table(self.path(), e))?;
        file.sync()?;
        Ok(file)
    }

    fn path(&self) -> &Path {
        self.writer.inner().path()
    }

    fn write_group(&mut self) -> Result<(), ResultError> {
        self.rows = 0;
        let mut write = || {
            let mut group = self.writer.next_row_group()?;
            for column in &mut self.columns {
                if let Some(mut out) = group.next_column()? {
                    column.write(&mut out)?;
                    out.close()?;
                }
            }
            group.close()
        };
        match write() {
            Ok(_) => Ok(()),
            Err(error) => Err(ResultError::table(self.path(), error)),
        }
    }
}

fn open(
    file: PartialFile,
    columns: &[Column],
    footer: &[(&str, String)],
) -> Result<SerializedFileWriter<PartialFile>, ParquetError> {
    let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("cageless")
        .with_fields(fields)
        .build()?;
    let units = columns.iter().filter(|c| !c.unit.is_empty());
    let metadata: Vec<_> = footer
        .iter()
        .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()))
        .chain(units.map(|c| KeyValue::new(format!("{UNIT}{}", c.name), c.unit.to_string())))
        .collect();
    let mut properties = WriterProperties::builder()
        .set_created_by(format!("cageless {VERSION}"))
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(metadata));
    // Times repeat, ball by ball; of the other numbers of a run hardly two are the same.
    let unique = |c: &&Column| c.kind == ColumnKind::Value && c.name != "time_s";
    for column in columns.iter().filter(unique) {
        let path = ColumnPath::from(&*column.name);
        properties = properties.set_column_dictionary_enabled(path, false);
    }
    SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties.build()))
}

fn field(column: &Column) -> Result<TypePtr, ParquetError> {
    use ColumnKind::{Index, Integer, Number, Numbers, Ordinal, Text, Value};
    let name = &*column.name;
    let physical = match column.kind {
        Value | Number | Numbers => PhysicalType::DOUBLE,
        Ordinal => PhysicalType::INT32,
        Index | Integer => PhysicalType::INT64,
        Text => PhysicalType::BYTE_ARRAY,
    };
    let primitive =
        |name, repetition| Type::primitive_type_builder(name, physical).with_repetition(repetition);
    Ok(Arc::new(match column.kind {
        Value | Ordinal | Index => primitive(name, Repetition::REQUIRED).build()?,
        Number | Integer => primitive(name, Repetition::OPTIONAL).build()?,
        Text => primitive(name, Repetition::OPTIONAL)
            .with_converted_type(ConvertedType::UTF8)
            .with_logical_type(Some(LogicalType::String))
            .build()?,
        // Three levels, as the Parquet format lays down for lists.
        Numbers => {
            let element = primitive("element", Repetition::REQUIRED);
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
    }))
}

/// Contents of one column with Dremel's levels.
#[derive(Debug)]
struct Contents {
    kind: ColumnKind,
    values: Values,
    /// 0: null; 1: a value, or an empty list; 2: an item of a list.
    definition: Vec<i16>,
    /// 1: a further item of a list.
    repetition: Vec<i16>,
}

/// Values as Parquet has them.
#[derive(Debug)]
enum Values {
    Ordinals(Vec<i32>),
    Integers(Vec<i64>),
    Doubles(Vec<f64>),
    Texts(Vec<ByteArray>),
}

impl Contents {
    fn new(kind: ColumnKind) -> Self {
        let values = match kind {
            ColumnKind::Ordinal => Values::Ordinals(vec![]),
            ColumnKind::Index | ColumnKind::Integer => Values::Integers(vec![]),
            ColumnKind::Value | ColumnKind::Number | ColumnKind::Numbers => Values::Doubles(vec![]),
            ColumnKind::Text => Values::Texts(vec![]),
        };
        let (definition, repetition) = (vec![], vec![]);
        Self {
            kind,
            values,
            definition,
            repetition,
        }
    }

    fn fits(&self, cell: &Cell) -> bool {
        use ColumnKind::{Index, Integer, Number, Numbers, Text};
        match cell {
            Cell::Null => matches!(self.kind, Number | Integer | Text | Numbers),
            Cell::Number(_) => self.kind == Number,
            Cell::Integer(_) => matches!(self.kind, Integer | Index),
            Cell::Text(_) => self.kind == Text,
            Cell::Numbers(_) => self.kind == Numbers,
            Cell::List(_) => false,
        }
    }

    /// Adds a cell that fits.
    fn push(&mut self, cell: Cell) {
        let level = match (&mut self.values, cell) {
            (Values::Doubles(values), Cell::Numbers(list)) if !list.is_empty() => {
                self.definition.extend(list.iter().map(|_| 2));
                let further = (0..list.len()).map(|k| i16::from(k > 0));
                self.repetition.extend(further);
                values.extend(list);
                return;
            }
            (Values::Doubles(values), Cell::Number(value)) if value.is_finite() => {
                values.push(value);
                1
            }
            (Values::Integers(values), Cell::Integer(value)) => {
                values.push(value);
                1
            }
            (Values::Texts(values), Cell::Text(text)) => {
                values.push(ByteArray::from(text.into_bytes()));
                1
            }
            (_, Cell::Numbers(_)) => 1,
            _ => 0,
        };
        self.definition.push(level);
        self.repetition.push(0);
    }

    /// Writes the column of a group and empties it.
    fn write(&mut self, out: &mut SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        let nullable = self.fits(&Cell::Null).then_some(&*self.definition);
        let repetition = (self.kind == ColumnKind::Numbers).then_some(&*self.repetition);
        match &self.values {
            Values::Ordinals(values) => out.typed::<Int32Type>().write_batch(values, None, None),
            Values::Integers(values) => {
                out.typed::<Int64Type>().write_batch(values, nullable, None)
            }
            Values::Doubles(values) => {
                let out = out.typed::<DoubleType>();
                out.write_batch(values, nullable, repetition)
            }
            Values::Texts(values) => {
                let out = out.typed::<ByteArrayType>();
                out.write_batch(values, nullable, None)
            }
        }?;
        *self = Self::new(self.kind);
        Ok(())
    }
}
