//! File formats described as data: what documentation and other languages are made of.

use super::format::{Format, Heading, SectionTable};
use super::key::{Key, Limit};
use super::sections::CASE_FILE;
use super::unit::{Side, round};
use cageless::LIMITS;

/// An end of the numbers of a key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeEnd {
    /// The end, in the unit of the key.
    pub at: f64,
    /// Whether it is allowed itself.
    pub included: bool,
}

/// Every section of the case file with its keys; the head of the file first, without a name.
pub fn reference() -> impl Iterator<Item = SectionTable> {
    CASE_FILE.reference()
}

impl Format {
    /// Every section with its keys; the head of the file first, without a name.
    pub(crate) fn reference(&self) -> impl Iterator<Item = SectionTable> + use<> {
        let head = SectionTable {
            name: "",
            meaning: "head of the file",
            keys: self.head,
            optional: false,
            several: false,
            heading: Heading::Absent,
        };
        std::iter::once(head).chain(self.sections.iter().copied())
    }
}

impl SectionTable {
    /// Ends of the numbers of a key: those of its row, and the limits of [`cageless`] within them.
    pub fn range(&self, key: &Key) -> [Option<RangeEnd>; 2] {
        let end = |at, included| Some(RangeEnd { at, included });
        let [mut low, mut high] = match key.limit {
            Limit::None => [None, None],
            Limit::Above(low) => [end(low, false), None],
            Limit::AtLeast(low) => [end(low, true), None],
            Limit::Inside(low, high) => [end(low, false), end(high, false)],
            Limit::Within(low, high) => [end(low, true), end(high, true)],
        };
        let of_section = format!("{}_{}", self.name, key.field);
        let find = |field: &str| LIMITS.iter().find(|limit| limit.field == field);
        if let Some(limit) = find(&of_section).or_else(|| find(key.field)) {
            let in_unit = |si: f64, side| end(round(key.unit.of_si(si), side), true);
            if limit.least.is_finite() {
                low = in_unit(limit.least, Side::Lower);
            }
            if limit.most.is_finite() {
                high = in_unit(limit.most, Side::Upper);
            }
        }
        [low, high]
    }
}
