//! `cageless drop`.

use cageless_report::drop::drop_page;
use cageless_results::{DropJudgement, DropResult};
use cageless_study::drop::{DropRequest, DropStudy, EnsembleResult, study};

use super::run::verified;
use crate::args::{DropArgs, Reference};
use crate::driver::{Answer, PAGE, Tables, read_case};
use crate::failure::Failure;
use crate::finished_run::SUMMARY;
use crate::format::{columns, judged, pairs, warnings};

/// Failure of a drop whose samples or verification were interrupted.
pub(super) const REST_INTERRUPTED: &str = "interrupted: the drop itself is complete.";

/// Drops the rotor of a case.
pub fn touchdown(args: &DropArgs) -> Result<(), Failure> {
    let file = read_case(&args.case)?;
    let request = requested(args);
    request.check(&file, &args.case.case.display().to_string())?;
    let output = &args.case.output;
    output.drive(&[SUMMARY, PAGE], |bars| {
        let out = output.out.as_deref();
        let mut tables = Tables::create(out, [(String::new(), &file)])?;
        let study = study(&file, request, tables.rows().remove(0), bars)?;
        tables.finish(output.csv)?;
        let (json, text) = (study.to_json(&file)?, text(&study));
        let files = output.files(|| Ok(vec![(PAGE, Some(drop_page(&file, &study)))]))?;
        let rest_interrupted = study.interrupted.then_some(REST_INTERRUPTED);
        Ok(Answer {
            files,
            ending: Failure::of_outcome(study.drop.outcome, rest_interrupted, out),
            ..Answer::new(SUMMARY, json, text)
        })
    })
}

/// What the options ask for beside the drop.
pub(super) fn requested(args: &DropArgs) -> DropRequest {
    DropRequest {
        compare: args.compare == Some(Reference::Conventional),
        samples: args.samples,
        verify: args.verify,
    }
}

fn text(study: &DropStudy) -> String {
    let mut drops = vec![("value".to_owned(), &study.drop.result)];
    let other = study.conventional.iter();
    drops.extend(other.map(|other| ("conventional".to_owned(), &other.result)));
    let mut text = verdict(&study.drop.result.judgement);
    text += &columns(&DropResult::side_by_side(&drops));
    if let Some(ensemble) = &study.ensemble {
        text += &ensemble_text(ensemble);
    }
    if let Some(verification) = &study.verification {
        let numbers = verification.parts("numbers").iter();
        text += &verified(verification, numbers, "verification");
    }
    text + &warnings(&study.warnings)
}

/// PASS or FAIL with its reasons.
pub(super) fn verdict(judgement: &DropJudgement) -> String {
    let headline = judged(judgement.passes, &judgement.headline());
    pairs(&[("verdict", headline)]) + "\n"
}

fn ensemble_text(many: &EnsembleResult) -> String {
    let ends = many.distribution.end_states_text();
    let mut lines = vec![("drops", format!("{} completed: {ends}", many.completed))];
    if let Some(percent) = many.distribution.backward_whirl.percent() {
        lines.push(("probability of backward whirl", percent));
    }
    for reason in &many.stopped {
        lines.push(("stopped", reason.clone()));
    }
    format!(
        "\n{}\n{}",
        pairs(&lines),
        columns(&many.distribution.rows())
    )
}
