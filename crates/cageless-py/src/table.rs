//! The table of a sweep as columns.

use std::path::PathBuf;

use cageless_io::results::{ColumnKind, ResultError, TableReader};
use cageless_results::Cell;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};

use crate::errors::Found;

/// Columns, their units, and the entries of the footer.
type Contents<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>, Bound<'py, PyDict>);

/// Entries of the footer of a sweep.
const FOOTER: [&str; 7] = [
    "schema", "version", "isa", "seed", "variants", "plan", "shard",
];

/// Reads a table: numbers as arrays (NaN for none), the rest as lists.
#[pyfunction]
pub fn read_table(py: Python<'_>, path: PathBuf) -> Found<Contents<'_>> {
    let (table, cells) = py.detach(|| {
        let table = TableReader::open(&path)?;
        let mut columns: Vec<Vec<Cell>> = table.columns().iter().map(|_| Vec::new()).collect();
        let all: Vec<usize> = (0..columns.len()).collect();
        for row in table.rows_of(&all) {
            for (column, cell) in columns.iter_mut().zip(row?) {
                column.push(cell);
            }
        }
        Ok::<_, ResultError>((table, columns))
    })?;
    let (columns, units, footer) = (PyDict::new(py), PyDict::new(py), PyDict::new(py));
    for (spec, cells) in table.columns().iter().zip(cells) {
        columns.set_item(&spec.name, column(py, spec.kind, cells)?)?;
        units.set_item(&spec.name, &spec.unit)?;
    }
    for key in FOOTER {
        if let Some(value) = table.footer(key) {
            footer.set_item(key, value)?;
        }
    }
    Ok((columns, units, footer))
}

fn column(py: Python<'_>, kind: ColumnKind, cells: Vec<Cell>) -> Found<Bound<'_, PyAny>> {
    let whole = |cell: &Cell| match cell {
        Cell::Integer(value) => Some(*value),
        _ => None,
    };
    if matches!(kind, ColumnKind::Index | ColumnKind::Integer) {
        // With gaps in it, it cannot be one of integers.
        let values: Option<Vec<i64>> = cells.iter().map(whole).collect();
        if let Some(values) = values {
            return Ok(values.into_pyarray(py).into_any());
        }
    }
    if matches!(kind, ColumnKind::Text | ColumnKind::Numbers) {
        let items = cells.into_iter().map(|cell| match cell {
            Cell::Text(text) => Ok(PyString::new(py, &text).into_any()),
            Cell::Numbers(list) => Ok(list.into_pyarray(py).into_any()),
            _ => Ok(py.None().into_bound(py)),
        });
        let items = items.collect::<Found<Vec<_>>>()?;
        return Ok(PyList::new(py, items)?.into_any());
    }
    let values: Vec<f64> = cells
        .iter()
        .map(|c| c.number().unwrap_or(f64::NAN))
        .collect();
    Ok(values.into_pyarray(py).into_any())
}
