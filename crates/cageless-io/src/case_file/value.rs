//! Values of keys.

use serde::Serialize;

use super::spanned_toml::{Node, Origin, Tree, Value, section_at};
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
                let number = |node: &Node| match node.value {
                    Value::Number(f) => Some(f),
                    Value::Integer(i) => Some(i as f64),
                    _ => None,
                };
                let row = |node: &Node| match &node.value {
                    Value::List(pair) if pair.len() == 2 => {
                        Some([number(&pair[0])?, number(&pair[1])?])
                    }
                    _ => None,
                };
                match items.iter().map(number).collect() {
                    Some(numbers) => Self::Numbers(numbers),
                    None => Self::Table(items.iter().map(row).collect::<Option<_>>()?),
                }
            }
            Value::Section(_) | Value::Other => return None,
        })
    }

    /// The value in a tree.
    pub(crate) fn node(&self, origin: &Origin) -> Node {
        let number = |f: &f64| Self::Number(*f).node(origin);
        let value = match self {
            Self::Number(f) => Value::Number(*f),
            Self::Integer(i) => Value::Integer(*i),
            Self::Text(text) => Value::Text(text.clone()),
            Self::Numbers(list) => Value::List(list.iter().map(number).collect()),
            Self::Table(rows) => {
                let row = |row: &[f64; 2]| Self::Numbers(row.to_vec()).node(origin);
                Value::List(rows.iter().map(row).collect())
            }
        };
        Node::new(value, origin.clone(), self.written())
    }

    /// Text of the value in TOML.
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

impl From<f64> for CaseValue {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<i64> for CaseValue {
    fn from(number: i64) -> Self {
        Self::Integer(number)
    }
}

impl From<&str> for CaseValue {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl Tree {
    /// Gives a dotted key a value, and leaves keys that say the same as they are; nothing happens
    /// where no section can have it.
    pub(crate) fn set(&mut self, key: &str, value: impl Into<CaseValue>) {
        let node = value.into().node(&Origin::Nowhere);
        let path: Vec<&str> = key.split('.').collect();
        if let Ok((section, key)) = section_at(&mut self.root, &path, &node.place) {
            section.insert(key.to_owned(), node);
        }
    }

    /// Gives a dotted key that is left out a value.
    pub(crate) fn set_missing(&mut self, key: &str, value: impl Into<CaseValue>) {
        if self.find(key).is_none() {
            self.set(key, value);
        }
    }

    /// The number of a dotted key; `None` if it is left out or no number.
    pub(crate) fn number(&self, key: &str) -> Option<f64> {
        match CaseValue::from_toml(&self.find(key)?.value)? {
            CaseValue::Number(number) => Some(number),
            CaseValue::Integer(number) => Some(number as f64),
            _ => None,
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
