//! Verdict and design results of the raceways of a case.

use cageless::Case;
use cageless::critical_gap::CriticalGapError;
use cageless::design::{Judgement, Recommendation, judge_watched, recommend, steady_case};
use cageless::raceway::RacewayDimensions;
use cageless::recorder::Recorder;
use cageless::snapshot::Snapshot;
use cageless_io::case_file::CaseFile;

use cageless_results::{Recommended, Record, design_record};
use serde::Serialize;

use crate::entered::{entered, entered_raceway};
use crate::error::StudyError;
use crate::progress::Progress;

/// Results of `design`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DesignResult {
    /// Closed forms, verdict and recommendation.
    #[serde(flatten)]
    pub record: Record,
    /// Result of a search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<Record>,
}

impl DesignResult {
    /// Results of the verdict on the raceways of `case`.
    pub fn new(case: &Case, judgement: &Judgement, near: Option<&Recommendation>) -> Self {
        Self {
            record: design_record(case, judgement, near),
            search: None,
        }
    }

    /// The raceway near the curve of Eq. (11), if there is one.
    pub fn recommendation(&self) -> Option<Recommended<'_>> {
        self.record.part("recommendation").map(Recommended)
    }
}

/// The verdict on a case's own raceways and what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The verdict.
    pub judgement: Judgement,
    /// A raceway that passes its verdict, or the starting point with the verdict that it fails.
    pub recommendation: Option<Recommendation>,
    /// The end of the run that was judged.
    pub snapshots: Vec<Snapshot>,
}

/// Orbits of the balls whose motion is kept.
pub const PORTRAIT_ORBITS: f64 = 3.0;
/// Moments of the motion that are kept.
const SNAPSHOTS: f64 = 400.0;

/// A recommendation takes as long as the verdict on the case's own raceway if the starting point
/// passes, and up to five times as long as a rule if it does not.
const RECOMMENDATION_WORK: f64 = 1.5;

/// Name of the task of [`judged`].
const TASK: &str = "design";

/// The task of [`judged`] with its work, for `Progress::whole`.
pub fn task() -> (String, f64) {
    (TASK.to_owned(), 1.0 + RECOMMENDATION_WORK)
}

/// Judges the raceways of a case, and finds one near the curve of Eq. (11) that passes.
///
/// # Errors
/// The case is impossible, a run did not converge, or the progress ended the work.
pub fn judged(file: &CaseFile, progress: &dyn Progress) -> Result<Judged, StudyError> {
    file.check_planar()?;
    let case = file.case();
    let steady = steady_case(case);
    let end_s = steady.solver.duration_s;
    let from_s = end_s * (1.0 - PORTRAIT_ORBITS / 32.0);
    let task = progress.begin(TASK, 1.0 + RECOMMENDATION_WORK);
    let mut snapshots = vec![];
    let judgement = {
        let interval_s = (end_s - from_s) / SNAPSHOTS;
        let mut recorder = Recorder::new(interval_s, |snapshot: Snapshot| {
            if snapshot.time_s >= from_s {
                snapshots.push(snapshot);
            }
            Ok(())
        });
        judge_watched(case, &mut [&mut recorder], &mut task.run_control(1.0, 1.0))
    };
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let entered = |dimensions: RacewayDimensions| {
        let depth_error_um = file.document().number("raceway.1.depth_error_um");
        let raceway = entered_raceway(&dimensions, depth_error_um.unwrap_or(0.0));
        entered(file, &[raceway], None)
    };
    let mut control = task.run_control(1.0, RECOMMENDATION_WORK);
    let recommendation = match recommend(case, &entered, &mut *control) {
        Ok(found) => found,
        Err(CriticalGapError::Interrupted) => return Err(StudyError::Interrupted),
        Err(CriticalGapError::Case(error)) => return Err(CriticalGapError::Case(error).into()),
        // No run of a pair can be judged here; the verdict says why.
        Err(_) => None,
    };
    Ok(Judged {
        judgement: judgement?,
        recommendation,
        snapshots,
    })
}
