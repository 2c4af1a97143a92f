//! The record of one drop.

use std::cell::RefCell;

use cageless::Snapshot;
use cageless::collision::{Collision, CollisionDetector};
use cageless::recorder::Recorder;
use cageless::simulation::{Ending, Observer, RotorDrop, RotorOutcome, RunOutcome};
use cageless_results::{DropJudgement, DropResult, DropRun};

use super::FiledDrop;
use super::side_by_side::recorders;
use crate::StudyError;
use crate::progress::Progress;
use crate::run::Rows;

/// One drop with its record.
pub struct DropRecord {
    /// Records of the bearings.
    pub bearings: Vec<BearingRecord>,
    /// Outcome of a linear rotor.
    pub rotor: RotorOutcome,
}

/// Record of one bearing in a drop.
pub struct BearingRecord {
    /// How it ended.
    pub outcome: RunOutcome,
    /// Results of the bearing.
    pub result: DropResult,
    /// Snapshots at the output interval.
    pub snapshots: Vec<Snapshot>,
    /// Collisions between balls.
    pub collisions: Vec<Collision>,
}

/// The rows of a bearing on their way to a store, and all of them so far.
struct Kept<'r> {
    rows: Option<&'r mut (dyn Rows + Send)>,
    snapshots: Vec<Snapshot>,
    collisions: Vec<Collision>,
}

/// Name of the task of a drop.
pub(super) const TASK: &str = "drop";

/// Steps of all bearings of a drop.
pub(crate) fn steps(drop: &RotorDrop) -> f64 {
    drop.cases().iter().map(|case| case.solver.steps()).sum()
}

impl DropRecord {
    /// Drops a rotor on the calling thread; `rows` has a store for each bearing, or none.
    ///
    /// # Errors
    /// A bearing cannot start, or the last rows could not be stored. Everything else is an
    /// [`Ending`] of the outcomes.
    pub fn of<'r>(
        filed: &FiledDrop<'_>,
        rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
        let (drop, cases) = (&filed.drop, filed.drop.cases());
        let work = progress.begin(TASK, steps(drop));
        let mut control = work.run_control(cases[0].solver.duration_s, steps(drop));
        let mut drops = recorders(drop);
        let kept: Vec<RefCell<Kept<'r>>> = (rows.into_iter())
            .map(|rows| {
                RefCell::new(Kept {
                    rows,
                    snapshots: vec![],
                    collisions: vec![],
                })
            })
            .collect();
        let outcome = {
            let mut recorders: Vec<_> = (filed.particulars().zip(&kept))
                .map(|(particulars, kept)| {
                    Recorder::new(particulars.interval_s, |snapshot: Snapshot| {
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
                .map(|((drop, detector), recorder)| {
                    vec![drop as &mut dyn Observer, detector, recorder]
                })
                .collect();
            let outcome = drop.run(&mut observers, &mut *control)?;
            for (detector, outcome) in detectors.iter_mut().zip(&outcome.bearings) {
                detector.close(outcome.end_s).map_err(StudyError::Rows)?;
            }
            outcome
        };
        let results = DropRun::new(drop, filed.particulars(), drops, &outcome).bearings;
        let records = results.into_iter().zip(outcome.bearings).zip(kept);
        let bearings = records.map(|((result, outcome), kept)| {
            let kept = kept.into_inner();
            BearingRecord {
                result,
                outcome,
                snapshots: kept.snapshots,
                collisions: kept.collisions,
            }
        });
        Ok(Self {
            bearings: bearings.collect(),
            rotor: outcome.rotor,
        })
    }

    /// The verdict on all bearings and the planes of the rotor.
    pub fn judgement(&self) -> DropJudgement {
        let bearings: Vec<_> = self.bearings.iter().map(|b| &b.result.judgement).collect();
        DropJudgement::of_bearings(&bearings, &self.rotor)
    }

    /// Index of the bearing at which the drop ended: the one that stopped, or else the first.
    pub fn last_index(&self) -> usize {
        let mut bearings = self.bearings.iter();
        bearings.position(|b| b.outcome.has_failed()).unwrap_or(0)
    }

    /// How the drop ended.
    pub fn ending(&self) -> &Ending {
        &self.bearings[self.last_index()].outcome.ending
    }

    /// Outcome of the bearing at which the drop ended.
    pub fn into_last_outcome(mut self) -> RunOutcome {
        self.bearings.swap_remove(self.last_index()).outcome
    }
}
