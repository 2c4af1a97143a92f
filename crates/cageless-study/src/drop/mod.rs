//! Drops of a rotor: one, the same with a conventional outer ring, and many whose conditions
//! scatter.

mod ensemble;
mod result;
mod study;
mod verification;

use std::cell::RefCell;

use cageless::Case;
use cageless::collision::{Collision, CollisionDetector};
use cageless::recorder::Recorder;
use cageless::simulation::{Observer, RunOutcome, run as simulate};
use cageless::snapshot::Snapshot;
use cageless::touchdown::DropRecorder;
use cageless_io::case_file::missing_rotor;

pub use ensemble::{
    DROPS_MAX, DropRow, EndStateCount, EnsembleResult, Quantiles, check_drops, ensemble,
};
pub use result::{DropResult, WindowRow};
pub use study::{DropRequest, DropStudy, study};
pub use verification::DropVerification;

use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};

/// One drop with its record.
pub struct DropRecord {
    /// How it ended.
    pub outcome: RunOutcome,
    /// Its results.
    pub result: DropResult,
    /// Snapshots at the output interval.
    pub snapshots: Vec<Snapshot>,
    /// Collisions between balls.
    pub collisions: Vec<Collision>,
}

/// Checks that a case has a rotor to drop.
///
/// # Errors
/// [`StudyError::Input`]; `name` is what the message calls the case.
pub fn check_rotor(case: &Case, name: &str) -> Result<(), StudyError> {
    if case.rotor.is_some() {
        return Ok(());
    }
    Err(StudyError::Input(format!(
        "{name}: {}; `cageless run` computes a bearing at speed",
        missing_rotor()
    )))
}

/// Drops the rotor of a case on the calling thread.
///
/// # Errors
/// The case cannot start, or the last rows could not be stored. Everything else is an
/// [`Ending`](cageless::simulation::Ending) of the outcome.
pub fn drop_rotor(
    case: &Case,
    rows: Option<&mut (dyn Rows + Send)>,
    progress: &dyn Progress,
) -> Result<DropRecord, RunError> {
    let kept = RefCell::new((rows, Vec::new(), Vec::new()));
    let mut drop = DropRecorder::new();
    let outcome = {
        let mut recorder = Recorder::new(case.output.interval_s, |snapshot: Snapshot| {
            let (rows, snapshots, _) = &mut *kept.borrow_mut();
            if let Some(rows) = rows {
                rows.snapshot(&snapshot)?;
            }
            snapshots.push(snapshot);
            Ok(())
        });
        let mut detector = CollisionDetector::new(|collision: Collision| {
            let (rows, _, collisions) = &mut *kept.borrow_mut();
            if let Some(rows) = rows {
                rows.collision(&collision)?;
            }
            collisions.push(collision);
            Ok(())
        });
        let work = progress.begin("drop", 1.0);
        let mut control = work.run_control(case.solver.duration_s, 1.0);
        let mut observers: [&mut dyn Observer; 3] = [&mut drop, &mut detector, &mut recorder];
        let outcome = simulate(case, &mut observers, &mut *control)?;
        detector.close(outcome.end_s).map_err(RunError::Rows)?;
        outcome
    };
    let (_, snapshots, collisions) = kept.into_inner();
    Ok(DropRecord {
        result: DropResult::new(&drop.summary(&outcome.state), &outcome),
        outcome,
        snapshots,
        collisions,
    })
}
