//! Estimates over two keys of a case.

use std::cell::OnceCell;

use cageless::Case;
use cageless::design::{Eq11, Estimate, seats, theoretical_gap_rad};
use cageless::equilibrium;
use cageless::simulation::Control;
use cageless_io::case_file::{CaseDocument, CaseFile, CaseValue, Change};
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::ranges::{Span, possible};
use crate::refusal::{Refusal, read};

/// Points of one map, at most.
const POINTS_MAX: usize = 20_000;

/// Two keys and their values, increasing, that span a map.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Grid {
    case: String,
    across: Axis,
    up: Axis,
}

/// A key as `--set` takes it, with its values in the unit of the case file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Axis {
    key: String,
    values: Vec<f64>,
}

/// Rows of equal value of the key `up`: β0 of Eq. (11), the margin of every term of the estimate,
/// both `null` where the case is refused, the message there, and the ranges of the key `across`
/// within which the case is possible.
pub(crate) fn map(grid: &Grid, control: &mut dyn FnMut(f64) -> Control) -> Result<Value, Refusal> {
    let Grid { case, across, up } = grid;
    let (&[low, .., high], false) = (across.values.as_slice(), up.values.is_empty()) else {
        return Err(Refusal::new("a map needs two values across and one up"));
    };
    let count = across.values.len();
    if count.saturating_mul(up.values.len()) > POINTS_MAX {
        let message = format!("a map has at most {POINTS_MAX} points");
        return Err(Refusal::new(message));
    }
    let base = read(case)?;
    // No raceway moves the balls on a plain ring, which take long to settle in space.
    let of_raceway = [across, up]
        .iter()
        .all(|axis| axis.key.starts_with("raceway."));
    let rests = OnceCell::new();
    let rests = || rests.get_or_init(|| seats(base.case()).ok()).as_deref();
    let case = CaseDocument::parse(case, "case")?;
    let span = Span::of_key(&across.key, low, high)?;
    let (mut beta0, mut refused, mut ranges) = (vec![], vec![], vec![]);
    let mut margins: Map<String, Value> = Map::new();
    for (j, &value) in up.values.iter().enumerate() {
        if control(j as f64 / up.values.len() as f64).is_break() {
            return Err(Refusal::new("cancelled"));
        }
        let mut row = case.clone();
        let value = CaseValue::Number(value);
        row.change(&[Change::new(&up.key, &value, ("map", 1))])?;
        ranges.push(possible(&row, &span));
        let mut beta0_row = vec![Value::Null; count];
        let mut refused_row = vec![Value::Null; count];
        for (k, &value) in across.values.iter().enumerate() {
            let value = CaseValue::Number(value);
            let file = match row.with(&[Change::new(&across.key, &value, ("map", 1))]) {
                Ok(file) => file,
                Err(error) => {
                    refused_row[k] = json!(error.to_string());
                    continue;
                }
            };
            beta0_row[k] = json!(beta0_deg(&file));
            let Some(estimate) = estimate(file.case(), of_raceway.then_some(&rests)) else {
                continue;
            };
            for term in estimate.terms() {
                let rows = margins
                    .entry(term.name)
                    .or_insert_with(|| json!(vec![vec![Value::Null; count]; up.values.len()]));
                rows[j][k] = json!(term.margin());
            }
        }
        beta0.push(beta0_row);
        refused.push(refused_row);
    }
    Ok(json!({ "beta0_deg": beta0, "margins": margins, "refused": refused, "possible": ranges }))
}

/// Where the balls of all points of a map rest, if anywhere.
type Rests<'a> = &'a dyn Fn() -> Option<&'a [[f64; 2]]>;

/// The estimate of a point; in space without the contact stress, on elastic flanks from where the balls of all
/// points rest if that is the same for all.
fn estimate(case: &Case, rests: Option<Rests<'_>>) -> Option<Estimate> {
    let solved = match case.moves_in_space() {
        true => None,
        false => Some(equilibrium::solve(case).ok()?),
    };
    if !case.has_elastic_flanks() {
        return Some(Estimate::new(case, solved.as_ref()?));
    }
    Some(match rests {
        Some(rests) => Estimate::elastic(case, rests()?, solved.as_ref()),
        None => Estimate::elastic(case, &seats(case).ok()?, solved.as_ref()),
    })
}

fn beta0_deg(file: &CaseFile) -> Option<f64> {
    let case = file.case();
    (case.raceways.first())
        .map(|r| theoretical_gap_rad(&case.bearing, r, Eq11::Published).to_degrees())
}
