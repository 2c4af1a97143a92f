//! The file format described as data: what documentation and other languages are made of.

use super::key::{Key, Kind, Limit, Presence};
use super::sections::CASE_FILE;
use super::unit::{Side, round};
use super::value::CaseValue;
use cageless::limits::LIMITS;

/// A section of the case file.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionReference {
    /// Name; empty for the head of the file.
    pub name: &'static str,
    /// What the section holds.
    pub meaning: &'static str,
    /// Whether a case without the section has none of its values.
    pub optional: bool,
    /// Whether there may be several of the name.
    pub several: bool,
    /// Keys, in the order of the file format.
    pub keys: Vec<KeyReference>,
}

/// A key of the case file.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyReference {
    /// Name.
    pub name: &'static str,
    /// Name in files of earlier versions; empty if none.
    pub formerly: &'static str,
    /// Unit as it is printed; empty if none.
    pub unit: &'static str,
    /// What the value is.
    pub meaning: &'static str,
    /// Type of the value.
    pub value: ValueType,
    /// Lower and upper end of its numbers, in its unit.
    pub range: [Option<RangeEnd>; 2],
    /// What happens if the key is left out.
    pub left_out: LeftOut,
}

/// An end of the numbers of a key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeEnd {
    /// The end, in the unit of the key.
    pub at: f64,
    /// Whether it is allowed itself.
    pub included: bool,
}

/// Type of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum ValueType {
    /// A number.
    Number,
    /// A whole number.
    Whole,
    /// Text.
    Text,
    /// A list of numbers.
    Numbers,
    /// A number, or the lowest and the highest.
    Range,
    /// A number, or rows of time in s and value.
    OverTime,
    /// Rows of two numbers, named here.
    Rows(&'static str),
    /// One of these names.
    Choice(Vec<&'static str>),
    /// A number or one of these names.
    NumberOr(Vec<&'static str>),
    /// A list of numbers or one of these names.
    NumbersOr(Vec<&'static str>),
}

/// What happens if a key is left out.
#[derive(Debug, Clone, PartialEq)]
pub enum LeftOut {
    /// The case is refused.
    Refused,
    /// The key takes this value.
    Default(CaseValue),
    /// The value follows from the rest of the case.
    Derived,
    /// The key has no value.
    Nothing,
}

/// Every section of the file format with its keys.
pub fn reference() -> Vec<SectionReference> {
    let keys = |section: &str, keys: &'static [Key]| keys.iter().map(|k| key(section, k)).collect();
    let head = SectionReference {
        name: "",
        meaning: "head of the file",
        optional: false,
        several: false,
        keys: keys("", CASE_FILE.head),
    };
    let sections = CASE_FILE.sections.iter().map(|s| SectionReference {
        name: s.name,
        meaning: s.meaning,
        optional: s.optional,
        several: s.several,
        keys: keys(s.name, s.keys),
    });
    std::iter::once(head).chain(sections).collect()
}

/// Ends of the numbers of a key: those of its row, and the limits of [`cageless`] within them.
fn range(section: &str, key: &Key) -> [Option<RangeEnd>; 2] {
    let end = |at, included| Some(RangeEnd { at, included });
    let [mut low, mut high] = match key.limit {
        Limit::None => [None, None],
        Limit::Above(low) => [end(low, false), None],
        Limit::AtLeast(low) => [end(low, true), None],
        Limit::Inside(low, high) => [end(low, false), end(high, false)],
        Limit::Within(low, high) => [end(low, true), end(high, true)],
    };
    let of_section = format!("{section}_{}", key.field);
    let find = |field: &str| LIMITS.iter().find(|limit| limit.field == field);
    if let Some(limit) = find(&of_section).or_else(|| find(key.field)) {
        let in_unit = |si: f64, side| end(round(key.unit.of_si(si), side), true);
        if limit.least.is_finite() {
            low = in_unit(limit.least, Side::Lower);
        }
        high = in_unit(limit.most, Side::Upper);
    }
    [low, high]
}

fn key(section: &str, key: &Key) -> KeyReference {
    KeyReference {
        name: key.name,
        formerly: key.formerly,
        unit: key.unit.printed(),
        meaning: key.meaning,
        value: match key.kind {
            Kind::Number => ValueType::Number,
            Kind::Whole => ValueType::Whole,
            Kind::Text => ValueType::Text,
            Kind::Numbers => ValueType::Numbers,
            Kind::Range => ValueType::Range,
            Kind::OverTime => ValueType::OverTime,
            Kind::Rows(row) => ValueType::Rows(row),
            Kind::Choice(names) => ValueType::Choice(names()),
            Kind::NumberOr(names) => ValueType::NumberOr(names.to_vec()),
            Kind::NumbersOr(names) => ValueType::NumbersOr(names.to_vec()),
        },
        range: range(section, key),
        left_out: match (key.presence)() {
            Presence::Required => LeftOut::Refused,
            Presence::Default(value) => LeftOut::Default(value),
            Presence::Derived => LeftOut::Derived,
            Presence::Optional => LeftOut::Nothing,
        },
    }
}
