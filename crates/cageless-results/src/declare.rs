//! Declarations of results, and the values that they share.

use crate::across::Across;
use crate::cell::Cell;
use crate::group::Group;
use crate::kind::Kind;
use crate::quantity::{Aim, Quantity};
use crate::source::Source;

type Text = &'static str;

pub(crate) const fn quantity(name: Text, unit: Text, label: Text, of: Source) -> Quantity {
    Quantity {
        name,
        unit,
        label,
        meaning: "",
        symbol: "",
        kind: Kind::Number,
        aim: None,
        across: None,
        awaited: false,
        occurs: false,
        in_sweeps: true,
        in_oil: false,
        in_tables: true,
        group: Group::Other,
        shows_zero: true,
        of,
    }
}

pub(crate) const fn list(name: Text, unit: Text, label: Text, of: Source) -> Quantity {
    kind(Kind::Numbers, quantity(name, unit, label, of))
}

/// A number for each of a few things, which tables show.
pub(crate) const fn few(name: Text, unit: Text, label: Text, of: Source) -> Quantity {
    kind(Kind::Few, quantity(name, unit, label, of))
}

/// Two ends or several quantiles.
pub(crate) const fn range(name: Text, unit: Text, label: Text, of: Source) -> Quantity {
    kind(Kind::Range, quantity(name, unit, label, of))
}

pub(crate) const fn integer(name: Text, label: Text, of: Source) -> Quantity {
    kind(Kind::Integer, quantity(name, "", label, of))
}

pub(crate) const fn flag(name: Text, label: Text, of: Source) -> Quantity {
    not_in_tables(kind(Kind::Flag, quantity(name, "", label, of)))
}

pub(crate) const fn text(name: Text, label: Text, of: Source) -> Quantity {
    not_in_tables(kind(Kind::Text, quantity(name, "", label, of)))
}

pub(crate) const fn kind(kind: Kind, mut quantity: Quantity) -> Quantity {
    quantity.kind = kind;
    quantity
}

/// A result that neither columns of sweeps nor tables have: a sentence, or a time that differs from
/// run to run.
pub(crate) const fn file_only(quantity: Quantity) -> Quantity {
    part(not_in_tables(quantity))
}

/// A list that tables for readers have, under a symbol.
pub(crate) const fn column(symbol: Text, mut quantity: Quantity) -> Quantity {
    quantity.symbol = symbol;
    quantity
}

/// A result of a part of a computation, which columns of sweeps do not have.
pub(crate) const fn part(mut quantity: Quantity) -> Quantity {
    quantity.in_sweeps = false;
    quantity
}

/// A result of a case with an oil film.
pub(crate) const fn in_oil(mut quantity: Quantity) -> Quantity {
    quantity.in_oil = true;
    quantity
}

/// A result under the heading of a group.
pub(crate) const fn group(group: Group, mut quantity: Quantity) -> Quantity {
    quantity.group = group;
    quantity
}

/// A result that tables for readers leave out where it is zero, as by symmetry.
pub(crate) const fn unless_zero(mut quantity: Quantity) -> Quantity {
    quantity.shows_zero = false;
    quantity
}

/// A text that tables for readers have.
pub(crate) const fn in_tables(mut quantity: Quantity) -> Quantity {
    quantity.in_tables = true;
    quantity
}

/// A result in files alone.
pub(crate) const fn not_in_tables(mut quantity: Quantity) -> Quantity {
    quantity.in_tables = false;
    quantity
}

/// A result of a drop with the rule for a rotor in several bearings.
pub(crate) const fn across(across: Across, mut quantity: Quantity) -> Quantity {
    quantity.across = Some(across);
    quantity
}

/// A result whose label does not define it, with its definition.
pub(crate) const fn means(meaning: Text, mut quantity: Quantity) -> Quantity {
    quantity.meaning = meaning;
    quantity
}

/// A time from the start that has no value where its event has not come by the end.
pub(crate) const fn awaited(mut quantity: Quantity) -> Quantity {
    quantity.awaited = true;
    quantity
}

/// A result of something that has no value where it does not occur.
pub(crate) const fn occurs(mut quantity: Quantity) -> Quantity {
    quantity.occurs = true;
    quantity
}

pub(crate) const fn low(mut quantity: Quantity) -> Quantity {
    quantity.aim = Some(Aim::Low);
    quantity
}

pub(crate) const fn high(mut quantity: Quantity) -> Quantity {
    quantity.aim = Some(Aim::High);
    quantity
}

pub(crate) fn flagged(value: Option<bool>) -> Cell {
    value.map_or(Cell::Null, |value| Cell::Integer(i64::from(value)))
}

pub(crate) fn some(value: f64) -> Cell {
    Some(value).into()
}

pub(crate) fn degrees(angle_rad: f64) -> Cell {
    some(angle_rad.to_degrees())
}

pub(crate) fn count(value: usize) -> Cell {
    Cell::Integer(value as i64)
}

pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}
