//! Values.

use serde_json::Value;

use crate::kind::Kind;

/// Value of a result, or of a column of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// None.
    Null,
    /// A double; one that is not finite is written as null.
    Number(f64),
    /// A 64-bit integer.
    Integer(i64),
    /// Text.
    Text(String),
    /// A list of doubles.
    Numbers(Vec<f64>),
    /// A list of values that are not all numbers, or of lists.
    List(Vec<Cell>),
}

impl Cell {
    /// The value as a number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Integer(value) => Some(*value as f64),
            _ => None,
        }
    }

    /// Items of a list.
    pub fn items(&self) -> &[Self] {
        match self {
            Self::List(items) => items,
            _ => &[],
        }
    }

    /// The text, if it is one.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value in JSON; integers are true or false in the result of a yes or no.
    pub(crate) fn json(&self, kind: Kind) -> Value {
        match (kind, self) {
            (_, Self::Null) => Value::Null,
            (Kind::Flag, Self::Integer(flag)) => (*flag == 1).into(),
            (_, Self::Integer(count)) => (*count).into(),
            (_, Self::Number(value)) => (*value).into(),
            (_, Self::Text(text)) => text.as_str().into(),
            (_, Self::Numbers(values)) => values.as_slice().into(),
            (_, Self::List(cells)) => cells.iter().map(|cell| cell.json(kind)).collect(),
        }
    }

    /// The value of this JSON in a result of this kind.
    pub(crate) fn read(kind: Kind, value: &Value) -> Self {
        let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
        match (kind, value) {
            (Kind::Numbers | Kind::Few | Kind::Range, Value::Array(items)) => {
                Self::Numbers(items.iter().map(number).collect())
            }
            (_, Value::Array(items)) => {
                Self::List(items.iter().map(|item| Self::read(kind, item)).collect())
            }
            (_, Value::Bool(flag)) => Self::Integer(i64::from(*flag)),
            (_, Value::String(text)) => Self::Text(text.clone()),
            (Kind::Integer, Value::Number(count)) => {
                count.as_i64().map_or(Self::Null, Self::Integer)
            }
            (_, Value::Number(_)) => Self::Number(number(value)),
            (_, Value::Null | Value::Object(_)) => Self::Null,
        }
    }
}

impl From<u64> for Cell {
    /// A number that is no 64-bit integer, as a seed may be, is a text of all its digits.
    fn from(value: u64) -> Self {
        i64::try_from(value).map_or_else(|_| Self::Text(value.to_string()), Self::Integer)
    }
}

impl From<Option<f64>> for Cell {
    fn from(value: Option<f64>) -> Self {
        value
            .filter(|v| v.is_finite())
            .map_or(Self::Null, Self::Number)
    }
}
