//! Estimates over axial span and half angle of the first raceway of a case.

use cageless::design::{Eq11, Estimate, theoretical_gap_rad};
use cageless::equilibrium;
use cageless::simulation::Control;
use cageless_io::case_file::{CaseDocument, CaseFile, CaseValue, Change};
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::ranges::{Span, possible};
use crate::refusal::{Refusal, read};

/// Points of one map, at most.
const POINTS_MAX: usize = 20_000;

/// The values of lC and θ that span a map, increasing.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Grid {
    case: String,
    axial_span_mm: Vec<f64>,
    half_angle_deg: Vec<f64>,
}

/// Rows of equal θ: β0 of Eq. (11), the margin of every term of the estimate, `null` where the
/// case is impossible, and the ranges of lC within which it is possible.
pub(crate) fn map(grid: &Grid, control: &mut dyn FnMut(f64) -> Control) -> Result<Value, Refusal> {
    let (spans, angles) = (&grid.axial_span_mm, &grid.half_angle_deg);
    let (&[low, .., high], false) = (spans.as_slice(), angles.is_empty()) else {
        return Err(Refusal::new(
            "a map needs two values of axial_span_mm and one of half_angle_deg",
        ));
    };
    if spans.len().saturating_mul(angles.len()) > POINTS_MAX {
        let message = format!("a map has at most {POINTS_MAX} points");
        return Err(Refusal::new(message));
    }
    // Of several raceways the first changes.
    let raceway = match read(&grid.case)?.case().raceways.len() {
        0 | 1 => "raceway",
        _ => "raceway.1",
    };
    let [span_key, angle_key] =
        ["axial_span_mm", "half_angle_deg"].map(|k| format!("{raceway}.{k}"));
    let case = CaseDocument::parse(&grid.case, "case")?;
    let across = Span::of_key(&span_key, low, high)?;
    let (mut beta0, mut ranges) = (vec![], vec![]);
    let mut margins: Map<String, Value> = Map::new();
    for (j, &angle) in angles.iter().enumerate() {
        if control(j as f64 / angles.len() as f64).is_break() {
            return Err(Refusal::new("cancelled"));
        }
        let mut row = case.clone();
        let angle = CaseValue::Number(angle);
        row.change(&[Change::new(&angle_key, &angle, ("map", 1))])?;
        ranges.push(possible(&row, &across));
        let mut beta0_row = vec![Value::Null; spans.len()];
        for (k, &span) in spans.iter().enumerate() {
            let span = CaseValue::Number(span);
            let Ok(file) = row.with(&[Change::new(&span_key, &span, ("map", 1))]) else {
                continue;
            };
            beta0_row[k] = json!(beta0_deg(&file));
            let Ok(equilibrium) = equilibrium::solve(file.case()) else {
                continue;
            };
            for term in Estimate::new(file.case(), &equilibrium).terms() {
                let rows = margins
                    .entry(term.name)
                    .or_insert_with(|| json!(vec![vec![Value::Null; spans.len()]; angles.len()]));
                rows[j][k] = json!(term.margin());
            }
        }
        beta0.push(beta0_row);
    }
    Ok(json!({ "beta0_deg": beta0, "margins": margins, "possible_axial_span_mm": ranges }))
}

fn beta0_deg(file: &CaseFile) -> Option<f64> {
    let case = file.case();
    (case.raceways.first())
        .map(|r| theoretical_gap_rad(&case.bearing, r, Eq11::Published).to_degrees())
}
