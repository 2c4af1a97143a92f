//! Columns of results.

use cageless_io::case_file::CaseError;
use cageless_io::plan_file::PlanFile;
use cageless_io::results::{Column, ColumnKind};

use cageless_results::{Cell, DropRun, Kind, Quantity, SPACE, quantities};

/// A column of results.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Output {
    /// The result.
    pub quantity: &'static Quantity,
    /// The bearing that has it, from 0, of a rotor in several; `None` for the drop as a whole, and of
    /// an only bearing.
    bearing: Option<usize>,
}

impl Output {
    fn name(&self) -> String {
        match self.bearing {
            Some(k) => self.quantity.column_name_in_bearing(k),
            None => self.quantity.column_name(),
        }
    }

    pub(crate) fn column(&self) -> Column {
        Column {
            name: self.name().into(),
            unit: self.quantity.unit.into(),
            kind: match self.quantity.kind {
                Kind::Number => ColumnKind::Number,
                Kind::Integer | Kind::Flag => ColumnKind::Integer,
                Kind::Text => ColumnKind::Text,
                Kind::Numbers | Kind::Few | Kind::Range => ColumnKind::Numbers,
            },
        }
    }

    /// Value in a drop.
    pub(crate) fn of_drop(&self, run: &DropRun) -> Cell {
        match self.bearing {
            None => run.value(self.quantity),
            Some(k) => {
                let results = run.bearings.get(k).map(|bearing| &bearing.results);
                let found = results.and_then(|results| results.get(self.quantity.name));
                found.cloned().unwrap_or(Cell::Null)
            }
        }
    }
}

/// Cases that a plan varies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Varied {
    /// Whether some are in space.
    pub in_space: bool,
    /// Whether some have an oil film.
    pub in_oil: bool,
}

/// The columns of results that a plan keeps; those of statics in space only of one in space, those of a film only of
/// one with a film.
///
/// # Errors
/// `keep` names a column that is not computed.
pub(crate) fn outputs(plan: &PlanFile, varied: Varied) -> Result<Vec<Output>, CaseError> {
    let of_plane = |output: &Output| {
        varied.in_space
            || !SPACE
                .iter()
                .any(|q| q.column_name() == output.quantity.column_name())
    };
    let dry = |output: &Output| varied.in_oil || !output.quantity.in_oil;
    let computed: Vec<Output> = (all(plan).filter(of_plane).filter(dry))
        .filter(|output| plan.compute.contains(&output.quantity.computation()))
        .collect();
    let Some(keep) = &plan.keep else {
        return Ok(computed);
    };
    for kept in keep {
        if computed.iter().any(|output| output.name() == kept.name) {
            continue;
        }
        let why = match all(plan).find(|output| output.name() == kept.name) {
            Some(Output { quantity, .. }) => {
                format!("compute leaves out \"{}\"", quantity.computation().name())
            }
            None => {
                let names: Vec<_> = computed.iter().map(Output::name).collect();
                format!("there are {}", names.join(", "))
            }
        };
        let message = format!("keep has \"{}\", which is not computed: {why}", kept.name);
        return Err(plan.error(kept.line, "keep", message));
    }
    let wanted = |output: &Output| keep.iter().any(|kept| kept.name == output.name());
    Ok(computed.into_iter().filter(wanted).collect())
}

/// Every column that the base of a plan can have: those of the drop as a whole, then those of each of
/// several bearings.
fn all(plan: &PlanFile) -> impl Iterator<Item = Output> {
    let base = &plan.base_file;
    let bearings = match base.cases().len() {
        1 => 0,
        several => several,
    };
    let of_rotor = base.rotor_file().is_some();
    let in_sweeps = || quantities().filter(|quantity| quantity.in_sweeps);
    let whole = in_sweeps().filter(move |quantity| {
        let of_only = bearings == 0 && quantity.is_of_bearing();
        of_only || of_rotor && quantity.is_of_rotor()
    });
    let of_bearing = move |k: usize| {
        let own = in_sweeps().filter(|q| q.is_of_bearing());
        own.map(move |quantity| (quantity, Some(k)))
    };
    whole
        .map(|quantity| (quantity, None))
        .chain((0..bearings).flat_map(of_bearing))
        .map(|(quantity, bearing)| Output { quantity, bearing })
}
