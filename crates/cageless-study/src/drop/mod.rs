//! Drops of a rotor onto one bearing or into several: one drop, the same with conventional outer
//! rings, many whose conditions scatter, and its verification.

mod distribution;
mod ensemble;
mod rotor_ensemble;
mod rotor_study;
mod rotor_verification;
mod several;
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
use cageless_results::DropResult;

pub use distribution::{
    BearingRow, DROPS_MAX, Distribution, EndStateCount, Quantiles, WhirlProbability, check_drops,
};
pub use ensemble::{DropRow, EnsembleResult, ensemble};
pub use rotor_ensemble::{RotorDropRow, RotorEnsemble, rotor_ensemble};
pub use rotor_study::{RotorStudy, rotor_study, unloaded};
pub use several::SeveralBearings;
pub(crate) use several::run_rotor;
pub use study::{DropRequest, DropStudy, Ended, Study, study};

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
    let work = progress.begin("drop", 1.0);
    let mut control = work.run_control(case.solver.duration_s, 1.0);
    let recorders = vec![DropRecorder::new()];
    let mut records = watched(&[case], recorders, vec![rows], |observers| {
        Ok(vec![simulate(case, &mut observers[0], &mut *control)?])
    })?;
    Ok(records.remove(0))
}

/// The rows of a drop on their way to a store, and all of them so far.
struct Kept<'r> {
    rows: Option<&'r mut (dyn Rows + Send)>,
    snapshots: Vec<Snapshot>,
    collisions: Vec<Collision>,
}

/// Computes drops of which each of `cases` is watched; rows go to the store of its bearing, if
/// there is one.
fn watched<'r>(
    cases: &[&Case],
    mut drops: Vec<DropRecorder>,
    rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
    simulate: impl FnOnce(&mut [Vec<&mut dyn Observer>]) -> Result<Vec<RunOutcome>, RunError>,
) -> Result<Vec<DropRecord>, RunError> {
    let kept: Vec<RefCell<Kept<'r>>> = (rows.into_iter())
        .map(|rows| {
            RefCell::new(Kept {
                rows,
                snapshots: vec![],
                collisions: vec![],
            })
        })
        .collect();
    let outcomes = {
        let mut recorders: Vec<_> = (cases.iter().zip(&kept))
            .map(|(case, kept)| {
                Recorder::new(case.output.interval_s, |snapshot: Snapshot| {
                    let kept = &mut *kept.borrow_mut();
                    if let Some(rows) = &mut kept.rows {
                        rows.snapshot(&snapshot)?;
                    }
                    kept.snapshots.push(snapshot);
                    Ok(())
                })
            })
            .collect();
        let mut detectors: Vec<_> = (kept.iter())
            .map(|kept| {
                CollisionDetector::new(|collision: Collision| {
                    let kept = &mut *kept.borrow_mut();
                    if let Some(rows) = &mut kept.rows {
                        rows.collision(&collision)?;
                    }
                    kept.collisions.push(collision);
                    Ok(())
                })
            })
            .collect();
        let watching = drops.iter_mut().zip(&mut detectors).zip(&mut recorders);
        let mut observers: Vec<Vec<&mut dyn Observer>> = watching
            .map(|((drop, detector), recorder)| vec![drop as &mut dyn Observer, detector, recorder])
            .collect();
        let outcomes = simulate(&mut observers)?;
        for (detector, outcome) in detectors.iter_mut().zip(&outcomes) {
            detector.close(outcome.end_s).map_err(RunError::Rows)?;
        }
        outcomes
    };
    let records = cases.iter().zip(drops).zip(outcomes).zip(kept);
    Ok(records
        .map(|(((case, drop), outcome), kept)| {
            let kept = kept.into_inner();
            DropRecord {
                result: DropResult::new(case, &drop.summary(&outcome.state), &outcome),
                outcome,
                snapshots: kept.snapshots,
                collisions: kept.collisions,
            }
        })
        .collect())
}
