//! The best variants.

use super::result::{BestVariant, BestVariants};
use crate::number_text::short;
use cageless_io::results::{Cell, Row};

use super::Goal;
use super::quantities::{Input, Output, Quantities};
use super::table::Table;
use crate::sweep::error::SweepError;
use crate::sweep::quantities::{Aim, QUANTITIES};

/// Variants that are named for each goal.
const NAMED: usize = 8;

/// The outputs to seek by, each with whether more is better.
pub(super) fn goals<'q>(
    table: &Table,
    quantities: &'q Quantities,
    wanted: &[Goal],
) -> Result<Vec<(&'q Output, Aim)>, SweepError> {
    let number = |name: &str| {
        let mut outputs = quantities.outputs.iter();
        outputs.find(|o| o.name == name && o.is_name.is_none())
    };
    if wanted.is_empty() {
        let known = QUANTITIES.iter().filter_map(|f| Some((f.name, f.aim?)));
        return Ok(known
            .filter_map(|(name, aim)| Some((number(name)?, aim)))
            .collect());
    }
    let mut goals = Vec::new();
    for goal in wanted {
        let Some(output) = number(&goal.column) else {
            let numbers = quantities.outputs.iter().filter(|o| o.is_name.is_none());
            let names: Vec<_> = numbers.map(|o| o.name.as_str()).collect();
            return Err(SweepError::Input(format!(
                "{}: {} is not an output that varies; these are {}",
                table.path().display(),
                goal.column,
                names.join(", ")
            )));
        };
        goals.push((output, goal.aim));
    }
    Ok(goals)
}

/// The best variants by each goal; of equal ones the first.
pub(super) fn find(
    table: &Table,
    quantities: &Quantities,
    goals: &[(&Output, Aim)],
) -> Result<Vec<BestVariants>, SweepError> {
    let inputs = &quantities.inputs;
    let mut wanted = vec![0];
    wanted.extend(inputs.iter().map(|i| i.column));
    wanted.extend(goals.iter().map(|(output, _)| output.column));
    let mut best: Vec<Vec<BestVariant>> = goals.iter().map(|_| Vec::new()).collect();
    table.each(&wanted, |row| {
        for (k, (output, aim)) in goals.iter().enumerate() {
            let value = output.value(&row[1 + inputs.len() + k]);
            if let Some(value) = value {
                enter(&mut best[k], *aim, value, row, inputs);
            }
        }
    })?;
    let entry = |((output, aim), variants): (&(&Output, Aim), Vec<BestVariant>)| BestVariants {
        quantity: output.quantity(),
        high: *aim == Aim::High,
        variants,
    };
    Ok(goals.iter().zip(best).map(entry).collect())
}

fn enter(best: &mut Vec<BestVariant>, aim: Aim, value: f64, row: &Row, inputs: &[Input]) {
    let better = |other: &BestVariant| match aim {
        Aim::Low => value < other.value,
        Aim::High => value > other.value,
    };
    let place = best.iter().position(better).unwrap_or(best.len());
    if place >= NAMED {
        return;
    }
    let shown = |cell: &Cell| match cell {
        Cell::Text(text) => text.clone(),
        cell => cell.number().map_or_else(String::new, short),
    };
    best.insert(
        place,
        BestVariant {
            variant: row[0].number().unwrap_or(0.0) as u64,
            value,
            inputs: row[1..=inputs.len()].iter().map(shown).collect(),
        },
    );
    best.truncate(NAMED);
}
