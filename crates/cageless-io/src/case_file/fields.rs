//! The types of value that keys have.

use cageless::contact::FrictionTable;
use cageless::{HoleClass, ShaftClass};

use super::declaration::{Field, field};
use super::error::CaseError;
use super::key::Kind;
use super::named::Named;
use super::reader::Reader;
use super::spanned_toml::{Node, Value};
use super::unit::Unit;

/// `start.gaps`: a name or a list.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum GivenGaps {
    /// All the same.
    Uniform,
    /// All balls in one group: no gap but the last, from ball N to ball 1.
    Bunched,
    /// Every division of the free angle equally likely, by `solver.seed`.
    Random,
    /// N gaps; gap k lies between ball k and ball k+1.
    List(Vec<f64>),
}

/// `solver.step_us`: a step, or `None` where it follows from the stiffest contact and the method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Step(pub Option<f64>);

/// A quantity of the operation: constant, or piecewise linear in time.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct OverTime {
    /// Value at the start.
    pub start: f64,
    /// Rows of time in s and value; constant before and after.
    pub rows: Option<Vec<[f64; 2]>>,
}

field!(f64, Kind::Number, |reader, name, node| reader
    .number(name, node));
field!(u64, Kind::Whole, |reader, name, node| reader
    .count(name, node));
field!(usize, Kind::Whole, |reader, name, node| {
    // More than an address space has is refused by the checks of the value as well.
    Ok(Self::try_from(reader.count(name, node)?).unwrap_or(Self::MAX))
});
field!(String, Kind::Text, |reader, name, node| match &node.value {
    Value::Text(text) => Ok(text.clone()),
    _ => Err(reader.refuse(name, node, "text in quotes")),
});
field!(ShaftClass, Kind::Text, |reader, name, node| {
    let refused = || reader.refuse(name, node, ShaftClass::ALLOWED);
    text(node)
        .and_then(ShaftClass::from_name)
        .ok_or_else(refused)
});
field!(HoleClass, Kind::Text, |reader, name, node| {
    let refused = || reader.refuse(name, node, HoleClass::ALLOWED);
    text(node)
        .and_then(HoleClass::from_name)
        .ok_or_else(refused)
});
field!(Vec<f64>, Kind::Numbers, |reader, name, node| reader
    .list(name, node));

impl<T: Named> Field for T {
    const KIND: Kind = Kind::Choice(|| T::NAMES.iter().map(|(name, _)| *name).collect());

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        T::of_node(node).ok_or_else(|| reader.refuse(name, node, &T::choices()))
    }
}

impl<T: Field> Field for Option<T> {
    const KIND: Kind = T::KIND;

    fn read(reader: &Reader<'_>, name: &str, node: &Node) -> Result<Self, CaseError> {
        T::read(reader, name, node).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

// The lowest and the highest.
field!([f64; 2], Kind::Range, |reader, name, node| {
    let numbers = match &node.value {
        Value::List(_) => reader.list(name, node)?,
        _ => vec![reader.number(name, node)?],
    };
    match *numbers {
        [one] => Ok([one, one]),
        [low, high] if low <= high => Ok([low, high]),
        _ => Err(reader.refuse(name, node, "a number, or [lowest, highest]")),
    }
});

field!(Step, Kind::NumberOr(&["auto"]), |reader, name, node| {
    match &node.value {
        Value::Text(text) if text == "auto" => Ok(Self(None)),
        Value::Integer(_) | Value::Number(_) => Ok(Self(Some(reader.number(name, node)?))),
        _ => Err(reader.refuse(
            name,
            node,
            "\"auto\" or a number in µs, without quotes and unit",
        )),
    }
});

const GAPS: Kind = Kind::NumbersOr(&["uniform", "bunched", "random"]);

field!(GivenGaps, GAPS, |reader, name, node| {
    let allowed = "\"uniform\", \"bunched\", \"random\" or a list of gaps in °";
    let text = match &node.value {
        Value::List(_) => return Ok(Self::List(reader.list(name, node)?)),
        Value::Text(text) => text.as_str(),
        _ => "",
    };
    match text {
        "uniform" => Ok(Self::Uniform),
        "bunched" => Ok(Self::Bunched),
        "random" => Ok(Self::Random),
        _ => Err(reader.refuse(name, node, allowed)),
    }
});

field!(OverTime, Kind::OverTime, |reader, name, node| {
    let Value::List(items) = &node.value else {
        let (start, rows) = (reader.number(name, node)?, None);
        return Ok(Self { start, rows });
    };
    let row = |item: &Node| match &item.value {
        Value::List(pair) => match pair.as_slice() {
            [time, value] => Ok([
                reader.plain_number(name, time)?,
                reader.number(name, value)?,
            ]),
            _ => Err(reader.refuse(name, item, "[time in s, value] in each row")),
        },
        _ => Err(reader.refuse(name, node, "a number, or rows of [time in s, value]")),
    };
    let rows = items.iter().map(row).collect::<Result<Vec<_>, _>>()?;
    let increasing = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
    if rows.is_empty() || !increasing || !(rows[0][0] >= 0.0 && rows[rows.len() - 1][0].is_finite())
    {
        let allowed = "rows of [time in s, value] with times that increase from 0 s or later; a step \
                       is a short ramp";
        return Err(reader.refuse(name, node, allowed));
    }
    let (start, rows) = (rows[0][1], Some(rows));
    Ok(Self { start, rows })
});

const FRICTION: &str = "[sliding speed in m/s, μ]";

field!(FrictionTable, Kind::Rows(FRICTION), |reader, name, node| {
    let rows = pairs(reader, name, node, FRICTION)?;
    Self::new(rows).map_err(|e| reader.refuse(name, node, &e.allowed.to_string()))
});

/// Rows of ψ and flank angle, rad.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FlankRows(pub Vec<[f64; 2]>);

const FLANK: &str = "[ψ in °, flank angle in °]";

field!(FlankRows, Kind::Rows(FLANK), |reader, name, node| {
    let rows = pairs(reader, name, node, FLANK)?.into_iter();
    let rows = rows.map(|row| row.map(|angle| Unit::Degree.to_si(angle)));
    Ok(Self(rows.collect()))
});

/// Rows of two plain numbers.
fn pairs(
    reader: &Reader<'_>,
    name: &str,
    node: &Node,
    row: &str,
) -> Result<Vec<[f64; 2]>, CaseError> {
    let refused = |item: &Node| reader.refuse(name, item, &format!("rows of {row}"));
    let Value::List(items) = &node.value else {
        return Err(refused(node));
    };
    let row = |item: &Node| match &item.value {
        Value::List(pair) if pair.len() == 2 => Ok([
            reader.plain_number(name, &pair[0])?,
            reader.plain_number(name, &pair[1])?,
        ]),
        _ => Err(refused(item)),
    };
    items.iter().map(row).collect()
}

/// The text of a value that is one.
fn text(node: &Node) -> Option<&str> {
    match &node.value {
        Value::Text(text) => Some(text),
        _ => None,
    }
}
