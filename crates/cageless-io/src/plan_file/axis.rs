//! One key that varies.

use super::key::unit;
use crate::case_file::CaseValue;
use crate::case_file::named::named;

/// A key and its values.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// `section.key`; `raceway.2.key` for the second of several raceways, and with several bearings
    /// `bearing.2.section.key` for the case of the second.
    pub key: String,
    /// Values of the axis.
    pub values: AxisValues,
    /// Line of the plan.
    pub line: usize,
}

/// Values of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisValues {
    /// These: all numbers or all names, at least one.
    List(Vec<CaseValue>),
    /// A range.
    Range(Range),
}

/// Numbers from one end to the other, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// First.
    pub from: f64,
    /// Last.
    pub to: f64,
    /// Number of values, 2 or more; `None` for the continuous axes of samples.
    pub count: Option<u64>,
    /// Spacing of the values.
    pub scale: Scale,
}

cageless::named_enum! {
    /// Spacing of a range.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Scale {
        /// Equal differences.
        Linear = "linear",
        /// Equal ratios; both ends are then above 0.
        Log = "log",
    }
}

named!(Scale);

impl Range {
    /// The value at `fraction` of the way, 0 to 1, to twelve digits: 5.1 stays 5.1, and the
    /// last bits of exp and ln, which differ between systems, do not matter.
    pub fn at(&self, fraction: f64) -> f64 {
        let value = match self.scale {
            _ if fraction <= 0.0 => return self.from,
            _ if fraction >= 1.0 => return self.to,
            Scale::Linear => self.from + (self.to - self.from) * fraction,
            Scale::Log => (self.from.ln() + (self.to / self.from).ln() * fraction).exp(),
        };
        twelve_digits(value)
    }
}

/// Rounds to twelve significant digits.
pub fn twelve_digits(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

impl Axis {
    /// Number of values; `None` if it takes any value of a range.
    pub fn len(&self) -> Option<u64> {
        match &self.values {
            AxisValues::List(list) => Some(list.len() as u64),
            AxisValues::Range(range) => range.count,
        }
    }

    /// No values: never, an axis has one at least.
    pub fn is_empty(&self) -> bool {
        self.len() == Some(0)
    }

    /// Value number `index`, counted from 0.
    pub fn value(&self, index: u64) -> CaseValue {
        match &self.values {
            AxisValues::List(list) => list[index as usize % list.len()].clone(),
            AxisValues::Range(range) => {
                let last = range.count.unwrap_or(2).max(2) - 1;
                CaseValue::Number(range.at(index as f64 / last as f64))
            }
        }
    }

    /// The value at `fraction` of the axis, 0 to below 1.
    pub fn value_at(&self, fraction: f64) -> CaseValue {
        match &self.values {
            AxisValues::List(list) => {
                let index = (fraction * list.len() as f64) as usize;
                list[index.min(list.len() - 1)].clone()
            }
            AxisValues::Range(range) => CaseValue::Number(range.at(fraction)),
        }
    }

    /// Unit of the values; empty if none.
    pub fn unit(&self) -> &'static str {
        unit(&self.key)
    }

    /// Whether the values are names, lists or tables, which are told apart by how they are written.
    pub fn is_text(&self) -> bool {
        let numbers =
            |value: &CaseValue| matches!(value, CaseValue::Integer(_) | CaseValue::Number(_));
        matches!(&self.values, AxisValues::List(list) if !list.iter().all(numbers))
    }
}
