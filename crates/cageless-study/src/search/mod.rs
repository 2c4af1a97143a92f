//! The search for the best raceway: the library's search on all threads, with a journal.

mod data;
mod narrative;
mod task_runner;

use std::path::Path;

use cageless::critical_gap::CriticalGapError;
use cageless::design::search::{Found, SearchError, Stage, map_fraction, search};
use cageless::design::{RacewayVerdict, judge};
use cageless::raceway::RacewayDimensions;
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

use crate::RacewayLabel;
use crate::entered::{entered, entered_raceway, reshaped, turned};
use crate::error::StudyError;
use crate::progress::Progress;
use cageless_results::{Cell, Judged, Record, Results, Subject, VERDICT};
use narrative::why_none;
pub use narrative::{point_label, structure_label};
pub use task_runner::JOURNAL;
use task_runner::TaskRunner;

/// Name of the task of the verdicts on the recommended structure.
const VERDICT_TASK: &str = "search: verdict";
/// Work of such a verdict over that of a run of all balls.
const VERDICT_WORK: f64 = 2.0;
/// Work of the map of one speed, as a rule.
const MAP_WORK: f64 = 30.0;
/// Work of the critical gaps of the candidates of one placement and shape at one operating point, as a rule.
const CANDIDATES_WORK: f64 = 5.0;
/// Fraction of the structures allowed that the optimiser tries, as a rule.
const OPTIMISED: f64 = 0.6;

/// The tasks of [`run`] with estimates of their work in runs of all balls, for
/// `Progress::whole`.
pub fn tasks(file: &CaseFile) -> Vec<(String, f64)> {
    let request = file.search();
    let points = request.points.len() as f64;
    let maps = points + request.map_speeds_rad_s.len() as f64;
    let starts = request.starts as f64;
    let of_structure = points * starts;
    let confirmed = request.confirming_starts() as f64;
    let structures = 1.0 + f64::from(u8::from(!file.case().raceways.is_empty()));
    let stages = [
        (Stage::Map, maps * MAP_WORK * map_fraction(request)),
        (
            Stage::Candidates,
            points
                * (request.placements.len() * request.sections().count()) as f64
                * CANDIDATES_WORK,
        ),
        (
            Stage::Motion,
            request.front_structures() as f64 * of_structure,
        ),
        (
            Stage::Polish,
            OPTIMISED * request.optimised_structures() as f64 * of_structure,
        ),
        (Stage::Confirm, structures * points * confirmed),
    ];
    let stages = stages.map(|(stage, work)| (task_runner::task_name(stage), work));
    let verdict = (VERDICT_TASK.to_owned(), points * VERDICT_WORK);
    stages.into_iter().chain([verdict]).collect()
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
    progress.whole(&tasks(file));
    let mut runner = TaskRunner::new(file, folder, progress)?;
    let found = search(file.case(), file.search(), &mut |stage, jobs| {
        runner.execute(stage, jobs)
    });
    runner.check()?;
    let found = match found {
        Ok(found) => found,
        Err(SearchError::Impossible(message)) => {
            return Err(StudyError::Input(format!(
                "no raceway can be recommended: {message}"
            )));
        }
        Err(SearchError::Case(error)) => return Err(file.refused(&error).into()),
        Err(SearchError::Interrupted(_)) => return Err(StudyError::Interrupted),
    };
    let verdicts = verdicts(file, &found, progress)?;
    let record = data::search_record(file, &found, verdicts, paper);
    Ok((found, record))
}

/// Verdict on the recommended structure at every operating point, as it is when the structure is
/// entered as the case's own.
fn verdicts(
    file: &CaseFile,
    found: &Found,
    progress: &dyn Progress,
) -> Result<Vec<Record>, StudyError> {
    let Some(recommended) = found.recommended.map(|k| &found.evaluations[k]) else {
        return Ok(vec![]);
    };
    let best = &recommended.structure;
    let section_angle_deg = data::structure(recommended, None).number("contact_angle_deg");
    let raceways: Vec<_> = best
        .centres_rad
        .iter()
        .map(|&centre_angle_rad| {
            let dimensions = RacewayDimensions {
                axial_span_m: best.axial_span_m,
                half_angle_rad: best.half_angle_rad,
                centre_angle_rad,
            };
            let mut values = entered_raceway(&dimensions, 0.0);
            values.extend(reshaped(file, best.form.shape.name()));
            values.extend(turned(file, section_angle_deg));
            values
        })
        .collect();
    let points = &found.request.points;
    let task = progress.begin(VERDICT_TASK, points.len() as f64 * VERDICT_WORK);
    points
        .par_iter()
        .map(|point| {
            let Some(case) = entered(file, &raceways, Some(point)) else {
                let text = |text: &str| Cell::Text(text.to_owned());
                let values = [
                    ("verdict", text(RacewayVerdict::Infeasible.name())),
                    ("passes", Cell::Integer(0)),
                    (
                        "headline",
                        text("FAIL: no solution; the case cannot have this raceway"),
                    ),
                    ("criterion", Cell::Null),
                    ("margin", Cell::Null),
                    ("critical_gap_deg", Cell::Null),
                    ("gap_reserve_deg", Cell::Null),
                ];
                return Ok(Results::only(VERDICT, &values).into());
            };
            match judge(&case, &mut task.run_control(1.0, VERDICT_WORK)) {
                Ok(judgement) => {
                    let judged = Judged {
                        case: &case,
                        judgement: &judgement,
                    };
                    Ok(Results::of(VERDICT, Subject::Verdict(&judged)).into())
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
    Some(match file.case().title.as_str() {
        "" => message,
        title => format!("{title}: {message}"),
    })
}

/// Removes what [`run`] kept in the folder: the result is where it belongs.
pub fn forget(folder: &Path) {
    // A journal that stays only makes the next search short.
    let _ = std::fs::remove_file(folder.join(JOURNAL));
}
