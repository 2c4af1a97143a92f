//! The types of value that keys have.

use cageless::contact::FrictionTable;

use super::declaration::{Field, ToSi};
use super::error::CaseError;
use super::key::Kind;
use super::named::Named;
use super::reader::Reader;
use super::spanned_toml::{Node, Value};
use super::value::CaseValue;

/// `start.gaps`: a name or a list.
#[derive(Debug, Clone, PartialEq)]
pub enum GapsDocument {
    /// All the same.
    Uniform,
    /// All balls in one group: no gap but the last, from ball N to ball 1.
    Bunched,
    /// Every division of the free angle equally likely, by `solver.seed`.
    Random,
    /// N gaps in degrees; gap k lies between ball k and ball k+1.
    ListDeg(Vec<f64>),
}

/// `solver.step_us`: `"auto"` or a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepDocument {
    /// Step from the stiffest contact and the method.
    Auto,
    /// In microseconds.
    FixedUs(f64),
}

/// A quantity of the operation: constant, or piecewise linear in time.
#[derive(Debug, Clone, PartialEq)]
pub enum OverTime {
    /// One value for the whole run.
    Constant(f64),
    /// Rows of time in s and value; constant before and after.
    Table(Vec<[f64; 2]>),
}

/// A number, or the lowest and the highest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeDocument {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

impl Field for f64 {
    type Si = Self;
    const KIND: Kind = Kind::Number;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        reader.number(name, node)
    }

    fn written(&self) -> Option<CaseValue> {
        Some(CaseValue::Number(*self))
    }

    fn si(&self, si: ToSi<'_>) -> Result<Self, CaseError> {
        si(*self)
    }
}

impl Field for u64 {
    type Si = Self;
    const KIND: Kind = Kind::Whole;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        reader.count(name, node)
    }

    fn written(&self) -> Option<CaseValue> {
        // TOML has no larger integers; the conversion refuses such a value.
        let integer = i64::try_from(*self).map(CaseValue::Integer);
        Some(integer.unwrap_or(CaseValue::Number(*self as f64)))
    }

    fn si(&self, _: ToSi<'_>) -> Result<Self, CaseError> {
        Ok(*self)
    }
}

impl Field for usize {
    type Si = Self;
    const KIND: Kind = Kind::Whole;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        // More than an address space has is refused by the checks of the value as well.
        Ok(Self::try_from(reader.count(name, node)?).unwrap_or(Self::MAX))
    }

    fn written(&self) -> Option<CaseValue> {
        (*self as u64).written()
    }

    fn si(&self, _: ToSi<'_>) -> Result<Self, CaseError> {
        Ok(*self)
    }
}

impl Field for String {
    type Si = Self;
    const KIND: Kind = Kind::Text;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        match &node.value {
            Value::Text(text) => Ok(text.clone()),
            _ => Err(reader.refuse(name, node, "text in quotes")),
        }
    }

    fn written(&self) -> Option<CaseValue> {
        Some(CaseValue::Text(self.clone()))
    }

    fn si(&self, _: ToSi<'_>) -> Result<Self, CaseError> {
        Ok(self.clone())
    }
}

impl<T: Named> Field for T {
    type Si = T;
    const KIND: Kind = Kind::Choice(|| T::NAMES.iter().map(|(name, _)| *name).collect());

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        let choice = match &node.value {
            Value::Text(text) => T::from_name(text),
            _ => None,
        };
        choice.ok_or_else(|| reader.refuse(name, node, &T::choices()))
    }

    fn written(&self) -> Option<CaseValue> {
        Some(CaseValue::Text(self.name().to_owned()))
    }

    fn si(&self, _: ToSi<'_>) -> Result<T, CaseError> {
        Ok(*self)
    }
}

impl<T: Field> Field for Option<T> {
    type Si = Option<T::Si>;
    const KIND: Kind = T::KIND;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        T::read(reader, name, node).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }

    fn written(&self) -> Option<CaseValue> {
        self.as_ref()?.written()
    }

    fn si(&self, si: ToSi<'_>) -> Result<Self::Si, CaseError> {
        self.as_ref().map(|v| v.si(si)).transpose()
    }
}

impl Field for Vec<f64> {
    type Si = Self;
    const KIND: Kind = Kind::Numbers;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        reader.list(name, node)
    }

    fn written(&self) -> Option<CaseValue> {
        Some(CaseValue::Numbers(self.clone()))
    }

    fn si(&self, si: ToSi<'_>) -> Result<Self, CaseError> {
        self.iter().map(|v| si(*v)).collect()
    }
}

impl Field for RangeDocument {
    type Si = [f64; 2];
    const KIND: Kind = Kind::Range;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        let numbers = match &node.value {
            Value::List(_) => reader.list(name, node)?,
            _ => vec![reader.number(name, node)?],
        };
        match *numbers {
            [one] => Ok(Self {
                low: one,
                high: one,
            }),
            [low, high] if low <= high => Ok(Self { low, high }),
            _ => Err(reader.refuse(name, node, "a number, or [lowest, highest]")),
        }
    }

    fn written(&self) -> Option<CaseValue> {
        Some(if self.low == self.high {
            CaseValue::Number(self.low)
        } else {
            CaseValue::Numbers(vec![self.low, self.high])
        })
    }

    fn si(&self, si: ToSi<'_>) -> Result<[f64; 2], CaseError> {
        Ok([si(self.low)?, si(self.high)?])
    }
}

impl Field for StepDocument {
    /// Step in seconds; `None` if it is chosen once the case is known.
    type Si = Option<f64>;
    const KIND: Kind = Kind::NumberOr(&["auto"]);

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        match &node.value {
            Value::Text(text) if text == "auto" => Ok(Self::Auto),
            Value::Text(_) => Err(reader.refuse(name, node, "\"auto\" or a number of us")),
            _ => Ok(Self::FixedUs(reader.number(name, node)?)),
        }
    }

    fn written(&self) -> Option<CaseValue> {
        Some(match self {
            Self::Auto => CaseValue::Text("auto".to_owned()),
            Self::FixedUs(step) => CaseValue::Number(*step),
        })
    }

    fn si(&self, si: ToSi<'_>) -> Result<Option<f64>, CaseError> {
        match self {
            Self::Auto => Ok(None),
            Self::FixedUs(step) => si(*step).map(Some),
        }
    }
}

impl Field for GapsDocument {
    /// Gaps in radians; `None` if they follow from the bearing.
    type Si = Option<Vec<f64>>;
    const KIND: Kind = Kind::NumbersOr(&["uniform", "bunched", "random"]);

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        let allowed = "\"uniform\", \"bunched\", \"random\" or a list of gaps in deg";
        match &node.value {
            Value::Text(text) => match text.as_str() {
                "uniform" => Ok(Self::Uniform),
                "bunched" => Ok(Self::Bunched),
                "random" => Ok(Self::Random),
                _ => Err(reader.refuse(name, node, allowed)),
            },
            Value::List(_) => Ok(Self::ListDeg(reader.list(name, node)?)),
            _ => Err(reader.refuse(name, node, allowed)),
        }
    }

    fn written(&self) -> Option<CaseValue> {
        Some(match self {
            Self::Uniform => CaseValue::Text("uniform".to_owned()),
            Self::Bunched => CaseValue::Text("bunched".to_owned()),
            Self::Random => CaseValue::Text("random".to_owned()),
            Self::ListDeg(gaps) => CaseValue::Numbers(gaps.clone()),
        })
    }

    fn si(&self, si: ToSi<'_>) -> Result<Self::Si, CaseError> {
        match self {
            Self::ListDeg(gaps) => gaps.si(si).map(Some),
            _ => Ok(None),
        }
    }
}

impl Field for OverTime {
    type Si = ();
    const KIND: Kind = Kind::OverTime;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        let Value::List(items) = &node.value else {
            return Ok(Self::Constant(reader.number(name, node)?));
        };
        let row = |item: &Node| match &item.value {
            Value::List(pair) => match pair.as_slice() {
                [time, value] => Ok([reader.number(name, time)?, reader.number(name, value)?]),
                _ => Err(reader.refuse(name, item, "[time in s, value] in each row")),
            },
            _ => Err(reader.refuse(name, item, "a number, or rows of [time in s, value]")),
        };
        let rows = items.iter().map(row).collect::<Result<Vec<_>, _>>()?;
        let increasing = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        if rows.is_empty()
            || !increasing
            || !(rows[0][0] >= 0.0 && rows[rows.len() - 1][0].is_finite())
        {
            let allowed = "rows of [time in s, value] with times that increase from 0 s or later; \
                           a step is a short ramp";
            return Err(reader.refuse(name, node, allowed));
        }
        Ok(Self::Table(rows))
    }

    fn written(&self) -> Option<CaseValue> {
        Some(match self {
            Self::Constant(value) => CaseValue::Number(*value),
            Self::Table(rows) => CaseValue::Table(rows.clone()),
        })
    }

    fn si(&self, _: ToSi<'_>) -> Result<(), CaseError> {
        Ok(())
    }
}

impl Field for FrictionTable {
    type Si = Self;
    const KIND: Kind = Kind::Rows("[sliding speed in m/s, μ]");

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        let refused = |item: &Node| {
            let allowed = "rows of [sliding speed in m/s, μ]";
            Err(reader.refuse(name, item, allowed))
        };
        let Value::List(items) = &node.value else {
            return refused(node);
        };
        let mut rows = vec![];
        for item in items {
            match &item.value {
                Value::List(pair) if pair.len() == 2 => {
                    rows.push([
                        reader.number(name, &pair[0])?,
                        reader.number(name, &pair[1])?,
                    ]);
                }
                _ => return refused(item),
            }
        }
        Self::new(rows).map_err(|e| reader.refuse(name, node, &e.allowed.to_string()))
    }

    fn written(&self) -> Option<CaseValue> {
        Some(CaseValue::Table(self.points().to_vec()))
    }

    fn si(&self, _: ToSi<'_>) -> Result<Self, CaseError> {
        Ok(self.clone())
    }
}
