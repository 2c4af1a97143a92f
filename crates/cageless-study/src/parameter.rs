//! Names and values as tables list them.

use cageless_io::case_file::{CaseFile, unit};
use serde::{Deserialize, Serialize};

/// A line of a parameter or result table.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Parameter {
    /// Name of the quantity.
    pub name: String,
    /// Symbol in the paper; may be empty.
    pub symbol: String,
    /// Value as it is to be printed.
    pub value: String,
    /// Unit; may be empty.
    pub unit: String,
    /// Source: `Table 1`, `not in the paper: …`; may be empty.
    pub source: String,
}

/// A line of a table.
pub fn parameter(name: &str, value: String, unit: &str) -> Parameter {
    Parameter {
        name: name.to_owned(),
        value,
        unit: unit.to_owned(),
        ..Parameter::default()
    }
}

/// A line for each result: label, value, unit.
pub fn lines<'r>(rows: impl IntoIterator<Item = (&'r str, String, String)>) -> Vec<Parameter> {
    let rows = rows.into_iter();
    rows.map(|(label, value, unit)| parameter(label, value, &unit))
        .collect()
}

/// One line per key of the case.
pub fn parameters(file: &CaseFile) -> Vec<Parameter> {
    let mut lines = vec![];
    let document = serde_json::to_value(file.document_as_run()).unwrap_or_default();
    flatten("", &document, &mut |key, value| {
        lines.push(Parameter {
            source: file.source(key).name().to_owned(),
            ..parameter(key, value, &unit(key))
        });
    });
    lines
}

/// Calls `add` with every dotted key and its value; items of a list of sections are counted
/// from 1.
fn flatten(prefix: &str, value: &serde_json::Value, add: &mut impl FnMut(&str, String)) {
    match value {
        serde_json::Value::Array(items) if items.iter().all(serde_json::Value::is_object) => {
            for (k, item) in items.iter().enumerate() {
                flatten(&format!("{prefix}.{}", k + 1), item, add);
            }
        }
        serde_json::Value::Object(map) => {
            for (key, value) in map {
                let name = if prefix.is_empty() {
                    key.clone()
                } else {
                    format!("{prefix}.{key}")
                };
                flatten(&name, value, add);
            }
        }
        serde_json::Value::String(text) => add(prefix, text.clone()),
        other => add(prefix, other.to_string()),
    }
}
