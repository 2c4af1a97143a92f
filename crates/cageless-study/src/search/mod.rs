//! The search for the best raceway: the library's search on all threads, with a journal.

mod data;
mod narrative;
mod result;
mod task_runner;

use std::path::Path;

use cageless::critical_gap::CriticalGapError;
use cageless::design::search::{Found, SearchError, search};
use cageless::design::{RacewayVerdict, judge};
use cageless::raceway::RacewayDimensions;
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

use crate::entered::{entered, raceway_document};
use crate::error::StudyError;
use crate::progress::Progress;
pub use result::{
    MapData, MotionNumbers, PlacementData, PointData, PointNumbers, PointVerdict, RejectionCount,
    SearchData, StructureData,
};

use narrative::why_none;
use task_runner::TaskRunner;

/// Searches for the best raceway of a case, as its section `[search]` asks. With a folder,
/// what was computed is kept there until [`forget`], and a search that was ended or killed, or
/// whose result could not be stored, resumes.
///
/// # Errors
/// The case or the operating range is impossible, the folder cannot be used, or the progress
/// ended the search. That no raceway is acceptable is no error; see [`refusal`].
pub fn run(
    file: &CaseFile,
    folder: Option<&Path>,
    progress: &dyn Progress,
) -> Result<(Found, SearchData), StudyError> {
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
        Err(SearchError::Case(error)) => return Err(error.into()),
        Err(SearchError::Interrupted(_)) => return Err(StudyError::Interrupted),
    };
    let verdicts = verdicts(file, &found, progress)?;
    let data = data::search_data(file, &found, verdicts)?;
    Ok((found, data))
}

/// Verdict on the recommended structure at every operating point, as it is when the structure is
/// entered as the case's own.
fn verdicts(
    file: &CaseFile,
    found: &Found,
    progress: &dyn Progress,
) -> Result<Vec<PointVerdict>, StudyError> {
    let Some(best) = found.recommended.map(|k| &found.evaluations[k].structure) else {
        return Ok(vec![]);
    };
    let raceways: Vec<_> = best
        .centres_rad
        .iter()
        .map(|&centre_angle_rad| {
            raceway_document(&RacewayDimensions {
                axial_span_m: best.axial_span_m,
                half_angle_rad: best.half_angle_rad,
                centre_angle_rad,
            })
        })
        .collect();
    let points = &found.request.points;
    let task = progress.begin("search: verdict", points.len() as f64);
    points
        .par_iter()
        .map(|point| {
            let Some(case) = entered(file, raceways.clone(), Some(point)) else {
                return Ok(PointVerdict {
                    verdict: RacewayVerdict::Infeasible.name().to_owned(),
                    passes: Some(false),
                    headline: "FAIL: no solution; the case cannot have this raceway".to_owned(),
                });
            };
            match judge(&case, &mut task.run_control(1.0, 1.0)) {
                Ok(judgement) => Ok(PointVerdict {
                    verdict: judgement.verdict.name().to_owned(),
                    passes: judgement.passes(),
                    headline: judgement.headline(),
                }),
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
    let _ = std::fs::remove_file(folder.join(task_runner::JOURNAL));
}
