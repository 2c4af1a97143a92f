//! Scalar results: one table ([`QUANTITIES`]) with the name, unit, label, better direction and
//! function of each. `summary.json`, the terminal, the tables of pages, the columns of sweeps,
//! comparisons of runs and the Python package are views of it.

mod across;
mod table;
#[cfg(test)]
mod tests;

use cageless::Case;
use cageless::design::{Judgement, RunVerdict};
use cageless::equilibrium::Equilibrium;
use cageless::passage::PassageTally;
use cageless::simulation::RunOutcome;
use cageless::summary::Summary;
use cageless::touchdown::DropSummary;
use cageless_io::plan_file::Computation;
use cageless_io::results::{Cell, ColumnKind, ColumnSpec};
use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::drop::{DropJudgement, RotorRun};
use crate::number_text;

pub use across::Across;
pub use table::QUANTITIES;

/// A scalar result.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Name with the unit at its end: the key in JSON.
    pub name: &'static str,
    /// Unit in ASCII; empty if there is none.
    pub unit: &'static str,
    /// Wording for readers.
    pub label: &'static str,
    /// Kind of the value.
    pub kind: Kind,
    /// Better direction, where there is one.
    pub aim: Option<Aim>,
    /// Its value for a rotor in several bearings, where there is one.
    pub across: Option<Across>,
    /// Whether the columns of sweeps have it.
    pub in_sweeps: bool,
    /// Whether tables for readers have it.
    pub in_tables: bool,
    of: Source,
}

/// Kind of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A count.
    Integer,
    /// True or false; 1 or 0 in the columns of sweeps.
    Flag,
    /// A name or a sentence.
    Text,
    /// A number for each ball.
    Numbers,
}

/// Better direction of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// The less the better.
    Low,
    /// The more the better.
    High,
}

/// A run that has ended.
pub struct Finished<'a> {
    /// The case.
    pub case: &'a Case,
    /// How it ended.
    pub outcome: &'a RunOutcome,
    /// Statistics after the transient, if it got so far.
    pub summary: Option<&'a Summary>,
    /// Passages after the transient.
    pub passages: &'a PassageTally,
    /// Verdict on these.
    pub verdict: &'a RunVerdict,
    /// Time that the computation took, s; NaN if unknown.
    pub wall_s: f64,
}

/// A drop that has ended.
pub struct FinishedDrop<'a> {
    /// The case.
    pub case: &'a Case,
    /// What was recorded.
    pub summary: &'a DropSummary,
    /// How it ended.
    pub outcome: &'a RunOutcome,
}

/// Origin of a quantity.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Source {
    Static(fn(&Equilibrium) -> Cell),
    Design(fn(&Case) -> Cell),
    Verdict(fn(&Judgement) -> Cell),
    Run(fn(&Finished<'_>) -> Cell),
    Drop(fn(&FinishedDrop<'_>) -> Cell),
    RotorDrop(fn(&RotorRun) -> Cell),
}

/// The bearing, from 0, and what follows it in the name of a column of one of several bearings:
/// `bearing_2_contact_damping`.
pub fn bearing_in_column(name: &str) -> Option<(usize, &str)> {
    let (number, rest) = name.strip_prefix("bearing_")?.split_once('_')?;
    let k = number.parse::<usize>().ok()?.checked_sub(1)?;
    Some((k, rest))
}

impl Quantity {
    /// The computation that it is part of.
    pub fn computation(&self) -> Computation {
        match self.of {
            Source::Static(_) => Computation::Static,
            Source::Design(_) => Computation::Design,
            Source::Verdict(_) => Computation::Verdict,
            Source::Run(_) => Computation::Run,
            Source::Drop(_) | Source::RotorDrop(_) => Computation::Drop,
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

    /// The result of a column of sweeps, and the bearing from 0 if it is that of one of several.
    pub fn of_column(name: &str) -> Option<(&'static Self, Option<usize>)> {
        let drop = Computation::Drop.name();
        let in_bearing = || {
            let rest = name.strip_prefix(drop)?.strip_prefix('_')?;
            let (k, rest) = bearing_in_column(rest)?;
            Some((format!("{drop}_{rest}"), Some(k)))
        };
        let (name, bearing) = in_bearing().unwrap_or_else(|| (name.to_owned(), None));
        let quantity = QUANTITIES.iter().find(|q| q.column_name() == name)?;
        Some((quantity, bearing))
    }

    /// Whether one bearing has it.
    pub(crate) fn is_of_bearing(&self) -> bool {
        !matches!(self.of, Source::RotorDrop(_))
    }

    /// Whether a rotor in several bearings has it.
    pub(crate) fn is_of_rotor(&self) -> bool {
        !self.is_of_bearing() || self.across.is_some()
    }

    pub(crate) fn column(&self) -> ColumnSpec {
        ColumnSpec {
            name: self.column_name(),
            unit: self.unit.to_owned(),
            kind: match self.kind {
                Kind::Number => ColumnKind::Number,
                Kind::Integer | Kind::Flag => ColumnKind::Integer,
                Kind::Text => ColumnKind::Text,
                Kind::Numbers => ColumnKind::Numbers,
            },
        }
    }

    pub(crate) fn of_equilibrium(&self, equilibrium: &Equilibrium) -> Option<Cell> {
        match self.of {
            Source::Static(of) => Some(of(equilibrium)),
            _ => None,
        }
    }

    pub(crate) fn of_case(&self, case: &Case) -> Option<Cell> {
        match self.of {
            Source::Design(of) => Some(of(case)),
            _ => None,
        }
    }

    pub(crate) fn of_judgement(&self, judgement: &Judgement) -> Option<Cell> {
        match self.of {
            Source::Verdict(of) => Some(of(judgement)),
            _ => None,
        }
    }

    pub(crate) fn of_run(&self, run: &Finished<'_>) -> Option<Cell> {
        match self.of {
            Source::Run(of) => Some(of(run)),
            _ => None,
        }
    }

    pub(crate) fn of_drop(&self, drop: &FinishedDrop<'_>) -> Option<Cell> {
        match self.of {
            Source::Drop(of) => Some(of(drop)),
            _ => None,
        }
    }

    /// Its value in a drop of a rotor into several bearings.
    pub(crate) fn of_rotor_drop(&self, drop: &RotorRun) -> Cell {
        let of_bearings = || {
            drop.bearings
                .iter()
                .map(|bearing| bearing.results.get(self.name))
        };
        match (self.of, self.across) {
            (Source::RotorDrop(of), _) => of(drop),
            (_, Some(Across::Verdict)) => verdict(self.kind, &drop.judgement()),
            (_, Some(across)) => across.of(of_bearings().map(|c| c.unwrap_or(&Cell::Null))),
            (_, None) => Cell::Null,
        }
    }

    /// Factor and unit of values in tables for readers: one unit for pressures, one for torques.
    fn printed(&self) -> (f64, String) {
        match self.unit {
            "GPa" => (1e3, "MPa".to_owned()),
            "N m" => (1e3, "N·mm".to_owned()),
            _ => (1.0, self.unit_text()),
        }
    }

    /// Unit of [`value_text`].
    pub fn printed_unit(&self) -> String {
        self.printed().1
    }

    /// The unit with its symbols.
    pub fn unit_text(&self) -> String {
        match self.unit {
            "deg" => "°".to_owned(),
            "um" => "µm".to_owned(),
            unit => unit.replace(' ', "·"),
        }
    }
}

/// The verdict on a drop: whether it passes, or its name.
fn verdict(kind: Kind, judgement: &DropJudgement) -> Cell {
    match kind {
        Kind::Flag => judgement
            .passes
            .map_or(Cell::Null, |passes| Cell::Integer(passes.into())),
        _ => Cell::Text(judgement.name().to_owned()),
    }
}

/// Scalar results with their quantities, in the order of the table. Serialised as a map from
/// name to value.
#[derive(Debug, Clone, PartialEq)]
pub struct Results(Vec<(&'static Quantity, Cell)>);

impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.column_name() == other.column_name()
    }
}

impl Results {
    /// Results of a run.
    pub fn of_run(run: &Finished<'_>) -> Self {
        Self::by(|quantity| quantity.of_run(run))
    }

    /// These results, by name.
    #[cfg(test)]
    pub(crate) fn only(values: &[(&str, Cell)]) -> Self {
        Self::by(|quantity| {
            let mut all = values.iter();
            let found = all.find(|(name, _)| quantity.name == *name);
            found.map(|(_, cell)| cell.clone())
        })
    }

    /// Results of a drop.
    pub fn of_drop(drop: &FinishedDrop<'_>) -> Self {
        Self::by(|quantity| quantity.of_drop(drop))
    }

    fn by(value: impl Fn(&Quantity) -> Option<Cell>) -> Self {
        let all = QUANTITIES.iter();
        Self(all.filter_map(|q| Some((q, value(q)?))).collect())
    }

    /// Every quantity with its value.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Quantity, &Cell)> {
        self.0.iter().map(|(quantity, cell)| (*quantity, cell))
    }

    /// Value of a quantity.
    pub fn get(&self, name: &str) -> Option<&Cell> {
        let mut all = self.iter();
        all.find(|(q, _)| q.name == name).map(|(_, cell)| cell)
    }

    /// Value of a numeric quantity; NaN if there is none.
    pub fn number(&self, name: &str) -> f64 {
        self.get(name).and_then(Cell::number).unwrap_or(f64::NAN)
    }

    /// Quantities for readers that have a value: label, value, unit.
    pub fn rows(&self) -> impl Iterator<Item = (&'static str, String, String)> {
        self.iter()
            .filter(|(q, _)| q.in_tables)
            .filter_map(|(q, cell)| Some((q.label, value_text(q, cell)?, q.printed_unit())))
    }

    /// Label, value and unit of one quantity, if it has a value.
    pub fn row(&self, name: &str) -> Option<(&'static str, String, String)> {
        let mut all = self.iter();
        let (q, cell) = all.find(|(q, _)| q.name == name)?;
        Some((q.label, value_text(q, cell)?, q.printed_unit()))
    }
}

/// A value for readers, in [`Quantity::printed_unit`]; `None` if there is none.
pub fn value_text(quantity: &Quantity, cell: &Cell) -> Option<String> {
    match (quantity.kind, cell) {
        (Kind::Flag, Cell::Integer(flag)) => Some(if *flag == 1 { "yes" } else { "no" }.into()),
        (_, Cell::Integer(count)) => Some(count.to_string()),
        (_, Cell::Number(value)) => {
            let (factor, _) = quantity.printed();
            Some(number_text::significant(factor * value, 5))
        }
        (_, Cell::Text(text)) => Some(text.clone()),
        (_, Cell::Null | Cell::Numbers(_)) => None,
    }
}

impl Serialize for Results {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (quantity, cell) in self.iter() {
            match (quantity.kind, cell) {
                (_, Cell::Null) => map.serialize_entry(quantity.name, &())?,
                (Kind::Flag, Cell::Integer(flag)) => {
                    map.serialize_entry(quantity.name, &(*flag == 1))?;
                }
                (_, Cell::Integer(count)) => map.serialize_entry(quantity.name, count)?,
                (_, Cell::Number(value)) => map.serialize_entry(quantity.name, value)?,
                (_, Cell::Text(text)) => map.serialize_entry(quantity.name, text)?,
                (_, Cell::Numbers(values)) => map.serialize_entry(quantity.name, values)?,
            }
        }
        map.end()
    }
}
