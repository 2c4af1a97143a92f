//! Values of keys.

use serde::Serialize;

use super::spanned_toml::{Node, Value};
use super::unit::decimal;

/// A value for a key, in the unit of the case file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum CaseValue {
    /// A number.
    Number(f64),
    /// A whole number.
    Integer(i64),
    /// A name.
    Text(String),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// Rows of two numbers.
    Table(Vec<[f64; 2]>),
}

impl CaseValue {
    /// `None` for what no variant can be given: tables, dates, mixed lists.
    pub(crate) fn from_toml(value: &Value) -> Option<Self> {
        Some(match value {
            Value::Integer(i) => Self::Integer(*i),
            Value::Number(f) => Self::Number(*f),
            Value::Text(text) => Self::Text(text.clone()),
            Value::List(items) => {
                let number = |node: &Node| match Self::from_toml(&node.value)? {
                    Self::Number(f) => Some(f),
                    Self::Integer(i) => Some(i as f64),
                    _ => None,
                };
                Self::Numbers(items.iter().map(number).collect::<Option<_>>()?)
            }
            Value::Section(_) | Value::Other => return None,
        })
    }

    /// As TOML.
    pub fn written(&self) -> String {
        match self {
            Self::Number(f) => decimal(*f),
            Self::Integer(i) => i.to_string(),
            Self::Text(text) => quoted(text),
            Self::Numbers(list) => {
                let list: Vec<_> = list.iter().map(|f| decimal(*f)).collect();
                format!("[{}]", list.join(", "))
            }
            Self::Table(rows) => {
                let row = |[t, v]: &[f64; 2]| format!("[{}, {}]", decimal(*t), decimal(*v));
                format!("[{}]", rows.iter().map(row).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

/// A text as TOML, on one line whatever is in it.
pub(crate) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out + "\""
}
