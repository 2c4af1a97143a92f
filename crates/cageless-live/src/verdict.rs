//! The simulated verdict on the raceways of a case.

use cageless::Case;
use cageless::design::search::AXIAL_LAG_MIN_FRACTION;
use cageless::design::{Criterion, judge, kinematic_lag_rad, lag_in_space};
use cageless::simulation::Control;
use cageless_results::{Judged, PASSAGES, Results, Subject, VERDICT};
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// Judges the raceways of a case as `cageless design` does.
pub(crate) fn verdict(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    if case.moves_in_space() {
        return in_space(case, control);
    }
    let judgement = judge(case, control)?;
    let worst = judgement
        .raceways
        .iter()
        .find(|r| r.verdict == judgement.verdict);
    let criteria: Vec<Value> = worst
        .map_or(&[][..], |r| &r.criteria)
        .iter()
        .map(|c: &Criterion| {
            json!({
                "name": c.name(), "value": c.value(), "limit": c.limit(), "margin": c.margin(),
                "at_least": c.at_least(), "met": c.is_met(), "text": c.to_string(),
            })
        })
        .collect();
    let mut answer = json!({
        "label": judgement.verdict.label(),
        "reasons": judgement.reasons,
        "criteria": criteria,
        "passages": judgement.passages.map(|p| Results::of(PASSAGES, Subject::Passages(&p))),
        "stopped": judgement.stopped.as_ref().map(ToString::to_string),
    });
    let judged = Judged {
        case,
        judgement: &judgement,
    };
    let verdict = json!(Results::of(VERDICT, Subject::Verdict(&judged)));
    if let (Value::Object(answer), Value::Object(verdict)) = (&mut answer, verdict) {
        answer.extend(verdict);
    }
    Ok(answer)
}

/// Judges the raceways of a case in space by the lag that its load leaves of that of rolling without a
/// contact angle; criteria of passages hold in the plane.
fn in_space(case: &Case, control: &mut dyn FnMut(f64) -> Control) -> Result<Value, Refusal> {
    case.check_constant_operation("a verdict in space")?;
    if case.raceways.is_empty() {
        let why = "not judged: the outer ring has no discrete raceway";
        return Err(Refusal::new(why));
    }
    let rolling = case.raceways.iter();
    let rolling = rolling.map(|r| kinematic_lag_rad(&case.bearing, r, 0.0, 0.0));
    let rolling_rad = rolling.sum::<f64>() / case.raceways.len() as f64;
    let mut ended = false;
    let found = lag_in_space(case, &mut |done| {
        let next = control(done);
        ended |= next.is_break();
        next
    })?;
    if ended {
        return Err(Refusal::new("cancelled"));
    }
    let Some(found) = found else {
        let why =
            "not judged: the bearing does not bear its load in motion, or no ball passes a raceway";
        return Err(Refusal::new(why));
    };
    let (share, least) = (found.least_fraction, AXIAL_LAG_MIN_FRACTION);
    let passes = share >= least;
    let [lag, rolling] = [found.lag_rad, rolling_rad].map(f64::to_degrees);
    let text = format!(
        "balls lag by {lag:.2}° a pass in the mean, rolling without a contact angle by {rolling:.2}°; the worst \
         row and raceway keeps {:.0} % of that, and {:.0} % is the least",
        100.0 * share,
        100.0 * least
    );
    let word = if passes { "PASS" } else { "FAIL" };
    Ok(json!({
        "label": if passes { "keeps its lag" } else { "loses its lag" },
        "headline": format!("{word} in space: {text}"),
        "passes": passes,
        "reasons": [&text],
        "lag_per_pass_deg": lag,
        "criteria": [{
            "name": "lag", "value": share, "limit": least, "margin": (share - least) / least,
            "at_least": true, "met": passes, "text": text,
        }],
    }))
}
