//! The declaration of a result.

use crate::Cell;
use crate::across::Across;
use crate::computation::Computation;
use crate::group::Group;
use crate::judged::Named;
use crate::kind::Kind;
use crate::number_text::significant;
use crate::source::{Source, Subject};
use crate::unit::{printed, with_unit};

/// A scalar result.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Name with the unit at its end: the key in JSON.
    pub name: &'static str,
    /// Unit in ASCII; empty if there is none.
    pub unit: &'static str,
    /// Wording for readers.
    pub label: &'static str,
    /// Definition, where the label is none: a sentence without its full stop; empty otherwise.
    pub meaning: &'static str,
    /// Symbol at the head of a column of values of every ball; empty where tables have none.
    pub symbol: &'static str,
    /// Kind of the value.
    pub kind: Kind,
    /// Better direction, where there is one.
    pub aim: Option<Aim>,
    /// Rule for the value of a rotor in several bearings, where there is one.
    pub across: Option<Across>,
    /// Whether it is a time from the start that has no value where its event has not come by the end.
    pub awaited: bool,
    /// Whether it has no value where what it is of does not occur, which keeps a limit from above.
    pub occurs: bool,
    /// Whether the columns of sweeps have it.
    pub in_sweeps: bool,
    /// Whether only cases with an oil film have it.
    pub in_oil: bool,
    /// Whether tables for readers have it.
    pub in_tables: bool,
    /// Heading under which tables have it.
    pub group: Group,
    /// Whether tables have it where it is zero.
    pub shows_zero: bool,
    pub(crate) of: Source,
}

/// Better direction of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// The less the better.
    Low,
    /// The more the better.
    High,
}

/// The bearing, from 0, and what follows it in the name of a column of one of several bearings:
/// `bearing_2_contact_damping`.
pub fn bearing_in_column(name: &str) -> Option<(usize, &str)> {
    let (number, rest) = name.strip_prefix("bearing_")?.split_once('_')?;
    let k = number.parse::<usize>().ok()?.checked_sub(1)?;
    Some((k, rest))
}

impl Quantity {
    /// Whether a limit is the most of the magnitude: the sign of a speed or a force is its sense. A temperature counts
    /// with its sign, and of what is better higher a limit is the least.
    pub fn is_limited_in_magnitude(&self) -> bool {
        self.aim != Some(Aim::High) && self.unit != "C"
    }

    /// The computation of a sweep that it is part of, or that rests on it.
    pub fn computation(&self) -> Computation {
        match self.of {
            Source::Static(_) => Computation::Static,
            Source::Design(_) | Source::ContactAngle(_) | Source::Axial(_) | Source::Curve(_) => {
                Computation::Design
            }
            Source::Run(_) | Source::Steady(_) | Source::Vibration(_) => Computation::Run,
            Source::Drop(_) | Source::RotorDrop(_) | Source::Plane(_) => Computation::Drop,
            _ => Computation::Verdict,
        }
    }

    /// Name of the column in sweeps: that of the computation, then its own.
    pub fn column_name(&self) -> String {
        format!("{}_{}", self.computation().name(), self.name)
    }

    /// Name of the column in sweeps of a rotor in several bearings, for bearing `k` from 0.
    pub fn column_name_in_bearing(&self, k: usize) -> String {
        format!(
            "{}_bearing_{}_{}",
            self.computation().name(),
            k + 1,
            self.name
        )
    }

    /// Value for a subject; `None` where it is computed from something else.
    pub fn of(&self, subject: Subject<'_>) -> Option<Cell> {
        self.of.value(subject)
    }

    /// Whether one bearing has it.
    pub fn is_of_bearing(&self) -> bool {
        !matches!(self.of, Source::RotorDrop(_))
    }

    /// Whether a rotor in several bearings has it.
    pub fn is_of_rotor(&self) -> bool {
        !self.is_of_bearing() || self.across.is_some()
    }

    /// Factor and unit of values in tables for readers; fractions are percentages there.
    pub fn printed(&self) -> (f64, String) {
        let is_share = ["_fraction", "_share"].map(|end| self.name.ends_with(end));
        match self.unit.is_empty() && is_share.contains(&true) {
            true => (100.0, "%".to_owned()),
            false => printed(&self.unit_text()),
        }
    }

    /// A number for readers, in [`Quantity::printed_unit`].
    pub fn number_text(&self, value: f64) -> String {
        // Below this a force, a length, an angle or a stiffness is the rounding of a zero.
        let zero = match self.unit {
            "um" | "mm" | "deg" | "mrad" => 1e-9,
            "N" => 1e-6,
            "N/m" => 1e-3,
            _ => 0.0,
        };
        let rounded = if value.abs() < zero { 0.0 } else { value };
        // An angle differs from another in its fourth digit; what a bearing carries, loses or lasts does not.
        let digits = if self.unit == "deg" { 5 } else { 4 };
        significant(self.printed().0 * rounded, digits)
    }

    /// A number for readers with its unit.
    pub fn with_unit(&self, value: f64) -> String {
        with_unit(&self.number_text(value), &self.printed_unit())
    }

    /// Unit of [`value_text`](crate::value_text).
    pub fn printed_unit(&self) -> String {
        self.printed().1
    }

    /// The unit with its symbols.
    pub fn unit_text(&self) -> String {
        self.named().unit_text()
    }

    /// Name, label and unit of the quantity.
    pub fn named(&self) -> Named {
        Named {
            name: self.name,
            label: self.label,
            unit: self.unit,
        }
    }
}

impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.label) == (other.name, other.label)
    }
}
