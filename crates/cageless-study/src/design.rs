//! What is known of a case's own raceways.

use cageless::Case;
use cageless::design::{Judgement, Recommendation, judge_watched, recommend, steady_case};
use cageless::recorder::Recorder;
use cageless::snapshot::Snapshot;
use cageless::spacing::CriticalGapError;
use cageless_report::design_report::PORTRAIT_ORBITS;

use crate::error::StudyError;
use crate::watcher::Watcher;

/// The verdict on a case's own raceways and what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The verdict.
    pub judgement: Judgement,
    /// A raceway in the middle of what is usable.
    pub recommendation: Option<Recommendation>,
    /// The end of the run that was judged.
    pub snapshots: Vec<Snapshot>,
}

/// Moments of the motion that are kept.
const SNAPSHOTS: f64 = 400.0;

/// Judges the raceways of a case.
///
/// # Errors
/// The case is impossible, a run did not converge, or the watcher ended the work.
pub fn judged(case: &Case, watcher: &dyn Watcher) -> Result<Judged, StudyError> {
    let steady = steady_case(case);
    let end_s = steady.solver.duration_s;
    let from_s = end_s * (1.0 - PORTRAIT_ORBITS / 32.0);
    // The run of all balls is most of the work; the recommendation takes about as long.
    let progress = watcher.begin("design", 2.0);
    let mut snapshots = vec![];
    let judgement = {
        let interval_s = (end_s - from_s) / SNAPSHOTS;
        let mut recorder = Recorder::new(interval_s, |snapshot: Snapshot| {
            if snapshot.time_s >= from_s {
                snapshots.push(snapshot);
            }
            Ok(())
        });
        judge_watched(
            case,
            &mut [&mut recorder],
            &mut progress.run_control(end_s, 1.0),
        )
    };
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let recommendation = match recommend(case) {
        Ok(found) => found,
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
