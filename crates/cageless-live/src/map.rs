//! Estimates over two keys of a case.

use cageless::Case;
use cageless::closed_forms::{Eq11, seats, theoretical_gap_rad};
use cageless::equilibrium::{EquilibriumError, settle_controlled};
use cageless::film::FilmAtRest;
use cageless::simulation::Control;
use cageless_design::Estimate;
use cageless_io::case_file::{CaseDocument, CaseFile, CaseValue, Change};
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::plain_film::plain_film;
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
    let of_raceway = [across, up]
        .iter()
        .all(|axis| axis.key.starts_with("raceway."));
    let mut estimates = Estimates {
        common: of_raceway.then(|| base.case()),
        rests: None,
        film: None,
    };
    let case = CaseDocument::parse(case, "case")?;
    let span = Span::of_key(&across.key, low, high)?;
    let (mut beta0, mut refused, mut ranges) = (vec![], vec![], vec![]);
    let mut margins: Map<String, Value> = Map::new();
    for (j, &value) in up.values.iter().enumerate() {
        let mut row = case.clone();
        let value = CaseValue::Number(value);
        row.change(&[Change::new(&up.key, &value, ("map", 1))])?;
        ranges.push(possible(&row, &span));
        let mut beta0_row = vec![Value::Null; count];
        let mut refused_row = vec![Value::Null; count];
        for (k, &value) in across.values.iter().enumerate() {
            let done = (j * count + k) as f64 / (count * up.values.len()) as f64;
            if control(done).is_break() {
                return Err(Refusal::new("cancelled"));
            }
            let value = CaseValue::Number(value);
            let file = match row.with(&[Change::new(&across.key, &value, ("map", 1))]) {
                Ok(file) => file,
                Err(error) => {
                    refused_row[k] = json!(error.to_string());
                    continue;
                }
            };
            beta0_row[k] = json!(beta0_deg(&file));
            let Some(estimate) = estimates.of(file.case(), &mut || control(done))? else {
                continue;
            };
            for term in estimate.terms {
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

/// Estimates of the points of a map; in space without the contact stress.
struct Estimates<'a> {
    /// The case of which all points have the plain ring, where the keys are those of raceways alone: no raceway
    /// moves the balls on it, which take long to settle in space.
    common: Option<&'a Case>,
    /// Where its balls rest, if anywhere; `None` before the first point.
    rests: Option<Option<Vec<[f64; 2]>>>,
    /// Film on it, if it has one; `None` before the first point.
    film: Option<Option<FilmAtRest>>,
}

impl Estimates<'_> {
    /// The estimate of a point, in oil where the case has a film; `None` without equilibrium.
    ///
    /// # Errors
    /// `control` ended the search.
    fn of(
        &mut self,
        case: &Case,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Option<Estimate>, EquilibriumError> {
        let Some(estimate) = self.dry(case, control)? else {
            return Ok(None);
        };
        if self.common.is_none() || self.film.is_none() {
            self.film = Some(plain_film(case, control)?);
        }
        let film = self.film.as_ref().and_then(Option::as_ref);
        Ok(Some(match film {
            Some(film) => estimate.in_oil(case, film),
            None => estimate,
        }))
    }

    /// The estimate of a point without the lag of a film; `None` without equilibrium.
    ///
    /// # Errors
    /// `control` ended the search.
    fn dry(
        &mut self,
        case: &Case,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Option<Estimate>, EquilibriumError> {
        let solved = match case.moves_in_space() {
            true => None,
            false => match found(settle_controlled(case, control))? {
                None => return Ok(None),
                Some(solved) => Some(solved.rest),
            },
        };
        let solved = solved.as_ref();
        if !case.has_elastic_flanks() {
            return Ok(solved.map(|rest| Estimate::new(case, rest)));
        }
        let Some(common) = self.common else {
            let seats = found(seats(case, control))?;
            return Ok(seats.map(|seats| Estimate::elastic(case, &seats, solved)));
        };
        if self.rests.is_none() {
            self.rests = Some(found(seats(common, control))?);
        }
        let rests = self.rests.as_ref().and_then(Option::as_ref);
        Ok(rests.map(|rests| Estimate::elastic(case, rests, solved)))
    }
}

/// A result, `None` where there is no equilibrium.
///
/// # Errors
/// The search was ended.
fn found<T>(result: Result<T, EquilibriumError>) -> Result<Option<T>, EquilibriumError> {
    match result {
        Err(EquilibriumError::Interrupted) => Err(EquilibriumError::Interrupted),
        other => Ok(other.ok()),
    }
}

fn beta0_deg(file: &CaseFile) -> Option<f64> {
    let case = file.case();
    (case.raceways.first())
        .map(|r| theoretical_gap_rad(&case.bearing, r, Eq11::Published).to_degrees())
}
