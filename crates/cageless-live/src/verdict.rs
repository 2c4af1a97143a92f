//! The simulated verdict on the raceways of a case.

use cageless::simulation::{Control, Stop};
use cageless_design::{Criterion, judge};
use cageless_io::case_file::CaseFile;
use cageless_results::{Judged, PASSAGES, Results, Subject, VERDICT};
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// Judges the raceways of a case as `cageless design` does.
pub(crate) fn verdict(
    file: &CaseFile,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    file.checked(|case| case.check_constant_operation("a verdict"))?;
    file.checked(cageless::Case::check_run)?;
    let case = file.case();
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
                "name": c.name(), "value": c.value, "limit": c.limit(), "margin": c.margin(),
                "at_least": c.at_least(), "met": c.is_met(), "text": c.to_string(),
            })
        })
        .collect();
    let mut answer = json!({
        "label": judgement.verdict.label(),
        "reasons": judgement.reasons,
        "criteria": criteria,
        "passages": judgement.passages.map(|p| Results::of(PASSAGES, Subject::Passages(&p))),
        "stopped": judgement.stopped.as_ref().map(Stop::by_key),
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
