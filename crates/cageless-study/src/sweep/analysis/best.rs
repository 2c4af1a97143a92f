//! The best variants.

use std::collections::BTreeMap;

use super::result::{BestVariant, BestVariants};
use cageless_io::results::Row;
use cageless_results::number_text::short;
use cageless_results::{Aim, Cell, quantities as all};

use super::quantities::{Input, Output, Quantities};
use super::table::Table;
use crate::StudyError;

/// Requested direction of an output.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Goal {
    /// Column of the output.
    pub column: String,
    /// Better direction of a quantity.
    pub aim: Aim,
}

/// Variants that are named for each goal …
const NAMED: usize = 8;
/// … and for each goal at each combination of conditions,
const NAMED_PER_CONDITION: usize = 3;
/// of which there may be so many.
const CONDITIONS_MAX: usize = 6;

/// The best variants by one goal, of all and at each combination of conditions.
#[derive(Default)]
struct Ranking {
    all: Vec<BestVariant>,
    /// By the values of the conditions; `None` if there are too many.
    at: Option<BTreeMap<Vec<String>, Vec<BestVariant>>>,
}

/// The outputs to seek by, each with whether more is better.
pub(super) fn goals<'q>(
    table: &Table,
    quantities: &'q Quantities,
    wanted: &[Goal],
) -> Result<Vec<(&'q Output, Aim)>, StudyError> {
    let number = |name: &str| {
        let mut outputs = quantities.outputs.iter();
        outputs.find(|o| o.quantity.name == name && o.is_name.is_none())
    };
    if wanted.is_empty() {
        let known = all().filter(|q| q.in_sweeps);
        return Ok(known
            .filter_map(|q| Some((number(&q.column_name())?, q.aim?)))
            .collect());
    }
    let mut goals = Vec::new();
    for goal in wanted {
        let Some(output) = number(&goal.column) else {
            let numbers = quantities.outputs.iter().filter(|o| o.is_name.is_none());
            let names: Vec<_> = numbers.map(|o| o.quantity.name.as_str()).collect();
            return Err(StudyError::Input(format!(
                "{}: {} is not a number among the outputs that varies; these are {}",
                table.reader.path().display(),
                goal.column,
                names.join(", ")
            )));
        };
        if goals
            .iter()
            .any(|(other, _): &(&Output, Aim)| other.column == output.column)
        {
            return Err(StudyError::Input(format!(
                "{}: {} is named twice: of an output either less or more is better",
                table.reader.path().display(),
                goal.column
            )));
        }
        goals.push((output, goal.aim));
    }
    Ok(goals)
}

/// The best variants by each goal; of equal ones the first.
pub(super) fn find(
    table: &Table,
    quantities: &Quantities,
    goals: &[(&Output, Aim)],
) -> Result<Vec<BestVariants>, StudyError> {
    let inputs = &quantities.inputs;
    let mut wanted = vec![0];
    wanted.extend(inputs.iter().map(|i| i.column));
    wanted.extend(goals.iter().map(|(output, _)| output.column));
    let conditions: Vec<usize> = (inputs.iter().enumerate())
        .filter(|(_, input)| input.quantity.is_condition())
        .map(|(k, _)| k)
        .collect();
    let choices = conditions.len() < inputs.len();
    let new = || Ranking {
        at: (choices && !conditions.is_empty()).then(BTreeMap::new),
        ..Ranking::default()
    };
    let mut best: Vec<Ranking> = goals.iter().map(|_| new()).collect();
    table.each(&wanted, |row| {
        for (k, (output, aim)) in goals.iter().enumerate() {
            let Some(value) = output.value(&row[1 + inputs.len() + k]) else {
                continue;
            };
            enter(&mut best[k].all, NAMED, *aim, value, row, inputs);
            let Some(at) = &mut best[k].at else { continue };
            let here: Vec<String> = conditions.iter().map(|c| shown(&row[1 + c])).collect();
            let place = at.entry(here).or_default();
            enter(place, NAMED_PER_CONDITION, *aim, value, row, inputs);
            if at.len() > CONDITIONS_MAX {
                best[k].at = None;
            }
        }
    })?;
    let entry = |((output, aim), ranking): (&(&Output, Aim), Ranking)| {
        let per_condition = ranking.at.as_ref().is_some_and(|at| at.len() > 1);
        BestVariants {
            quantity: output.quantity.clone(),
            high: *aim == Aim::High,
            per_condition,
            variants: match ranking.at {
                Some(at) if per_condition => at.into_values().flatten().collect(),
                _ => ranking.all,
            },
        }
    };
    Ok(goals.iter().zip(best).map(entry).collect())
}

/// A value of an input as it is to be printed.
fn shown(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => text.clone(),
        cell => cell.number().map_or_else(String::new, short),
    }
}

fn enter(
    best: &mut Vec<BestVariant>,
    most: usize,
    aim: Aim,
    value: f64,
    row: &Row,
    inputs: &[Input],
) {
    let better = |other: &BestVariant| match aim {
        Aim::Low => value < other.value,
        Aim::High => value > other.value,
    };
    let place = best.iter().position(better).unwrap_or(best.len());
    if place >= most {
        return;
    }
    best.insert(
        place,
        BestVariant {
            variant: row[0].number().unwrap_or(0.0) as u64,
            value,
            inputs: row[1..=inputs.len()].iter().map(shown).collect(),
        },
    );
    best.truncate(most);
}
