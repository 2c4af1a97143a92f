//! Python values as TOML.

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyString};
use toml::{Table, Value};

use crate::errors::input;

/// A dictionary of dictionaries, lists, numbers and texts as TOML.
#[pyfunction]
pub fn to_toml(values: &Bound<'_, PyDict>) -> PyResult<String> {
    toml::to_string(&table(values)?).map_err(input)
}

fn table(values: &Bound<'_, PyDict>) -> PyResult<Table> {
    values
        .iter()
        .map(|(key, item)| {
            let key: String = key.extract()?;
            let section = item.is_instance_of::<PyDict>();
            let item = value(&item).map_err(|error| match section {
                true => error,
                false => input(format!(
                    "{key} = {} is not possible: it must be a number, a text, a list or a \
                     dictionary",
                    item.repr()
                        .map_or_else(|_| "?".to_owned(), |r| r.to_string())
                )),
            })?;
            Ok((key, item))
        })
        .collect()
}

fn value(item: &Bound<'_, PyAny>) -> PyResult<Value> {
    if item.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(item.extract()?));
    }
    if item.is_instance_of::<PyInt>() {
        return Ok(Value::Integer(item.extract()?));
    }
    if item.is_instance_of::<PyFloat>() {
        return Ok(Value::Float(item.extract()?));
    }
    if item.is_instance_of::<PyString>() {
        return Ok(Value::String(item.extract()?));
    }
    if let Ok(values) = item.cast::<PyDict>() {
        return Ok(Value::Table(table(values)?));
    }
    // Arrays and numbers of numpy.
    if let Ok(plain) = item.call_method0("tolist") {
        return value(&plain);
    }
    let items: PyResult<Vec<_>> = item.try_iter()?.map(|each| value(&each?)).collect();
    items.map(Value::Array)
}
