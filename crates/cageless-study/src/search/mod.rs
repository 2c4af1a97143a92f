//! The search for the best raceway: the library's search on all threads, with a journal.

mod data;
mod narrative;
mod task_runner;

use std::path::Path;
use std::time::{Duration, Instant};

use cageless::numerics::BATCH_WIDTH;
use cageless::raceway::RacewayDimensions;
use cageless_design::critical_gap::CriticalGapError;
use cageless_design::search::{
    Cause, Evaluation, ExpectedRuns, Found, OperatingPoint, RacewayLayout, Rejection, Request,
    SearchError, Stage, expected_runs, run_jobs, search,
};
use cageless_design::{RacewayVerdict, judge, verdict_steps};
use cageless_io::case_file::{CaseFile, SectionValues};
use rayon::prelude::*;

use crate::RacewayLabel;
use crate::benefit_search::{CANDIDATES, Candidate};
use crate::entered::{entered, entered_raceway, reshaped, turned, with_raceways};
use crate::error::StudyError;
use crate::interruption::break_if;
use crate::progress::Progress;
use crate::task::Task;
use crate::threads::{each, each_of};
use cageless_results::{Cell, FILM_VERDICT, Judged, Record, Results, Subject, VERDICT};
use narrative::why_none;
pub use narrative::{point_label, structure_label};
pub use task_runner::JOURNAL;
use task_runner::TaskRunner;

/// Name of the task of the verdicts on the recommended structure.
const VERDICT_TASK: &str = "search: verdict";

/// The tasks of [`run`], for `Progress::whole`; if they are `announced`, some candidates are looked at before.
///
/// # Errors
/// The case or the operating range is impossible.
pub fn tasks(file: &CaseFile, announced: bool) -> Result<Vec<Task>, StudyError> {
    let request = file.request_to_run()?;
    let expected = expected_runs(file.case(), request).map_err(|error| refused(file, error))?;
    let mut tasks: Vec<Task> = vec![];
    let empty = announced && nothing_is_acceptable(file, &expected);
    for runs in &expected {
        let name = task_runner::task_name(runs.stage);
        let at = tasks.iter().position(|task| task.name == name);
        let at = at.unwrap_or_else(|| {
            tasks.push(Task::new(&name));
            tasks.len() - 1
        });
        // One sample of a kind is timed for all stages.
        let kind = |r: &&ExpectedRuns| (r.shared, r.case.moves_in_space());
        let sample = expected.iter().find(|r| kind(r) == kind(&runs));
        let case = &sample.unwrap_or(runs).case;
        let most = if runs.shared { BATCH_WIDTH } else { 1 };
        let count = runs.jobs.len();
        // Nothing moves but what is judged in any case: the raceway of the case.
        let steps = match (empty && runs.shared, runs.stage) {
            (false, _) => runs.steps,
            (true, Stage::Confirm) if !file.case().raceways.is_empty() => 0.5 * runs.steps,
            (true, _) => 0.0,
        };
        let task = std::mem::replace(&mut tasks[at], Task::new(&name));
        tasks[at] = task.with_batch(case, most, steps, count.div_ceil(most));
    }
    let points = request.points.len();
    let verdict = Task::new(VERDICT_TASK);
    tasks.push(match expected.last() {
        Some(runs) => {
            let steps = points as f64 * verdict_steps(&runs.case);
            verdict.with(&runs.case, steps, points)
        }
        None => verdict,
    });
    Ok(tasks)
}

/// Candidates whose critical gaps are computed before the time of a search is announced, and the fewest that say
/// whether any is acceptable.
const PROBES: [usize; 2] = [36, 24];
/// Time for which they are computed.
const PROBED: Duration = Duration::from_millis(1500);

/// Whether sliding and pressure leave none of the candidates of a search, by some of them.
fn nothing_is_acceptable(file: &CaseFile, expected: &[ExpectedRuns]) -> bool {
    let (case, request) = (file.case(), file.search());
    let candidates = expected.iter().find(|runs| runs.stage == Stage::Candidates);
    let Some(jobs) = candidates.map(|runs| runs.jobs.as_slice()) else {
        return false;
    };
    let [most, least] = PROBES;
    let began = Instant::now();
    let count = jobs.len().min(most);
    let found: Vec<bool> = each_of(0..count)
        .with_max_len(1)
        .filter_map(|k| {
            let job = &jobs[k * jobs.len() / count];
            let mut control = |_| break_if(began.elapsed() > PROBED);
            let outcome = run_jobs(case, &[job], &mut control).pop()??;
            job.is_acceptable(case, request, &outcome)
        })
        .collect();
    found.len() >= least && !found.contains(&true)
}

/// Error of a search of a file.
fn refused(file: &CaseFile, error: SearchError) -> StudyError {
    match error {
        SearchError::Impossible(message) => {
            StudyError::Input(format!("no raceway can be recommended: {message}"))
        }
        SearchError::Case(error) => file.refused(&error).into(),
        SearchError::Interrupted(_) => StudyError::Interrupted,
    }
}

/// Searches for the best raceway of a case, as its section `[search]` asks; `paper` are the structures of
/// the paper for its bearing. With a folder,
/// what was computed is kept there until [`forget`], and a search that was ended or killed, or
/// whose result could not be stored, resumes.
///
/// # Errors
/// The case or the operating range is impossible, the folder cannot be used, or the progress
/// ended the search. That no raceway is acceptable is no error; see [`refusal`].
pub fn run(
    file: &CaseFile,
    folder: Option<&Path>,
    paper: &[RacewayLabel],
    progress: &dyn Progress,
) -> Result<(Found, Record), StudyError> {
    file.checked(cageless::Case::check_motion)?;
    let request = file.request_to_run()?;
    if progress.wants(VERDICT_TASK) {
        progress.whole(&tasks(file, progress.announces())?);
    }
    let mut runner = TaskRunner::new(file, folder, progress)?;
    let found = search(file.case(), request, &mut |stage, jobs| {
        runner.execute(stage, jobs)
    });
    runner.check()?;
    let mut found = found.map_err(|error| refused(file, error))?;
    let best = found.recommended.map(|k| &found.evaluations[k]);
    let mut verdicts = match best {
        Some(best) => verdicts(file, &found.request, best, progress)?,
        None => vec![],
    };
    let failing = verdicts.iter().position(|v| v.flag("passes") != Some(true));
    if let Some(point) = failing {
        found.reject_recommended(&Rejection {
            cause: Cause::Verdict(verdicts[point].text("headline").to_owned()),
            point: Some(point),
            bunched: false,
        });
        verdicts.clear();
    }
    let record = data::search_record(file, &found, verdicts, paper);
    Ok((found, record))
}

/// The record of a structure.
pub fn structure(evaluation: &Evaluation) -> Record {
    data::structure(evaluation, None)
}

/// The raceways of a structure as sections of a case file.
fn sections_of(file: &CaseFile, evaluation: &Evaluation) -> Vec<SectionValues> {
    let section_angle_deg = structure(evaluation).number("contact_angle_deg");
    sections(file, &evaluation.structure, section_angle_deg)
}

/// The raceways of a layout as sections of a case file, all of a contact angle in its unit.
fn sections(file: &CaseFile, of: &RacewayLayout, section_angle_deg: f64) -> Vec<SectionValues> {
    let raceways = of.centres_rad.iter().map(|&centre_angle_rad| {
        let dimensions = RacewayDimensions {
            axial_span_m: of.axial_span_m,
            half_angle_rad: of.half_angle_rad,
            centre_angle_rad,
        };
        let mut values = entered_raceway(&dimensions, 0.0);
        values.extend(reshaped(file, of.form.shape.name()));
        values.extend(turned(file, section_angle_deg));
        values
    });
    raceways.collect()
}

/// Raceways that meet every requirement of a search, for [`search_benefit`]: the recommended one first, then others
/// with their critical gaps spread over the range. Their indices among the evaluations stand beside them.
///
/// # Errors
/// A case cannot have such a raceway.
///
/// [`search_benefit`]: crate::benefit_search::search_benefit
pub fn candidates(file: &CaseFile, found: &Found) -> Result<Vec<(usize, Candidate)>, StudyError> {
    let gap = |k: &usize| found.evaluations[*k].spacing[0].map_or(0.0, |s| s.critical_gap_rad);
    let accepted = |k: &usize| found.evaluations[*k].objectives.is_some();
    let mut others: Vec<usize> = (0..found.evaluations.len())
        .filter(|k| accepted(k) && Some(*k) != found.recommended)
        .collect();
    others.sort_by(|a, b| gap(a).total_cmp(&gap(b)));
    let first: Vec<usize> = found.recommended.into_iter().collect();
    let count = others.len().min(CANDIDATES - first.len());
    let spread = (0..count).map(|k| match count {
        1 => others[0],
        _ => others[k * (others.len() - 1) / (count - 1)],
    });
    let chosen = first.into_iter().chain(spread);
    let candidate = |k: usize| {
        let document = with_raceways(file, &sections_of(file, &found.evaluations[k]));
        let name = structure_label(&structure(&found.evaluations[k]));
        let file = CaseFile::from_document(document, "case")?;
        Ok((k, Candidate { name, file }))
    };
    chosen.map(candidate).collect()
}

/// Whether a structure passes its verdict at every operating point.
///
/// # Errors
/// A run did not converge, or the progress ended the work.
pub fn works(
    file: &CaseFile,
    found: &Found,
    structure: usize,
    progress: &dyn Progress,
) -> Result<bool, StudyError> {
    let evaluation = &found.evaluations[structure];
    let verdicts = verdicts(file, &found.request, evaluation, progress)?;
    Ok(verdicts.iter().all(|v| v.flag("passes") == Some(true)))
}

/// Verdict on a structure at every operating point, as it is when the structure is entered as the case's own.
fn verdicts(
    file: &CaseFile,
    request: &Request,
    evaluation: &Evaluation,
    progress: &dyn Progress,
) -> Result<Vec<Record>, StudyError> {
    let raceways = sections_of(file, evaluation);
    let points = &request.points;
    let steps = |point: &OperatingPoint| match entered(file, &raceways, Some(point)) {
        Some(case) => verdict_steps(&case),
        None => 0.0,
    };
    let task = progress.begin(VERDICT_TASK, points.iter().map(steps).sum());
    each(points)
        .map(|point| {
            let Some(case) = entered(file, &raceways, Some(point)) else {
                let text = |text: &str| Cell::Text(text.to_owned());
                let values = [
                    ("verdict", text(RacewayVerdict::Infeasible.name())),
                    ("passes", Cell::Integer(0)),
                    (
                        "headline",
                        text("does not work: no solution; the case cannot have this raceway"),
                    ),
                    ("criterion", Cell::Null),
                    ("margin", Cell::Null),
                    ("critical_gap_deg", Cell::Null),
                    ("judged_steady_gap_deg", Cell::Null),
                    ("gap_reserve_deg", Cell::Null),
                ];
                return Ok(Results::only(VERDICT, &values).into());
            };
            match judge(&case, &mut task.run_control(1.0, verdict_steps(&case))) {
                Ok(judgement) => {
                    let judged = Judged {
                        case: &case,
                        judgement: &judgement,
                    };
                    let verdict = Results::of(VERDICT, Subject::Verdict(&judged));
                    Ok(match judgement.dry {
                        Some(_) => {
                            verdict.and(Results::of(FILM_VERDICT, Subject::Verdict(&judged)))
                        }
                        None => verdict,
                    }
                    .into())
                }
                Err(CriticalGapError::Interrupted) => Err(StudyError::Interrupted),
                Err(error) => Err(error.into()),
            }
        })
        .collect()
}

/// Reason without a recommendation; `None` with one.
pub fn refusal(file: &CaseFile, found: &Found) -> Option<String> {
    if found.recommended.is_some() {
        return None;
    }
    let message = why_none(found);
    Some(match file.particulars().title.as_str() {
        "" => message,
        title => format!("{title}: {message}"),
    })
}

/// Removes what [`run`] kept in the folder: the result is where it belongs.
pub fn forget(folder: &Path) {
    // A journal that stays only makes the next search short.
    let _ = std::fs::remove_file(folder.join(JOURNAL));
}
