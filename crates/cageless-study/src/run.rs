//! One run with its record: tables as they grow, summary, histories, vibration, verification.

use std::cell::RefCell;
use std::time::Instant;

use crate::StudyError;
use cageless::collision::{Collision, CollisionDetector};
use cageless::recorder::Recorder;
use cageless::simulation::{Observer, ObserverError, RunOutcome, run as simulate};
use cageless::summary::{SummaryRecorder, transient_s};
use cageless::vibration::{Measurement, VibrationRecorder};
use cageless::{Case, Snapshot};
use cageless_io::case_file::CaseFile;
use cageless_io::results::RunWriter;

use crate::histories::{Histories, SAMPLING_HZ};
use crate::passages::Passages;
use crate::progress::Progress;
use crate::ring_path::{RingPathRecorder, RingPosition};
use crate::summary::RunSummary;
use crate::task::Task;
use crate::verification::VerificationRuns;
use cageless_results::Finished;

/// Receiver of the rows of a run.
pub trait Rows {
    /// Takes a snapshot.
    ///
    /// # Errors
    /// The snapshot cannot be stored; the run ends.
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError>;

    /// Takes a collision.
    ///
    /// # Errors
    /// The collision cannot be stored; the run ends.
    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError>;
}

impl Rows for RunWriter {
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError> {
        Ok(self.snapshot(snapshot)?)
    }

    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
        Ok(self.collision(collision)?)
    }
}

/// Rows of which only histories and vibration are wanted.
impl Rows for () {
    fn snapshot(&mut self, _: &Snapshot) -> Result<(), ObserverError> {
        Ok(())
    }

    fn collision(&mut self, _: &Collision) -> Result<(), ObserverError> {
        Ok(())
    }
}

/// Options of the record of a run beside its summary.
pub struct Options<'r> {
    /// Receiver of snapshots and collisions; without one, neither histories nor vibration are
    /// recorded.
    pub rows: Option<&'r mut (dyn Rows + Send)>,
    /// Whether [`RunRecord::verify`] is to follow.
    pub verify: bool,
}

/// A run that has ended.
pub struct RunRecord {
    /// How it ended.
    pub outcome: RunOutcome,
    /// The content of `summary.json`.
    pub summary: RunSummary,
    /// Histories for figures.
    pub histories: Histories,
    /// Passages through the discrete raceways after the transient.
    pub passages: Passages,
    /// The end of the path of the inner ring's centre; empty without [`Options::rows`].
    pub ring_path: Vec<RingPosition>,
    vibration: Option<VibrationRecorder>,
    verification: Option<VerificationRuns>,
}

impl RunRecord {
    /// Acceleration of the outer ring after the transient; `None` without a housing or samples.
    pub fn vibration(&self) -> Option<&Measurement> {
        let measured = &self.vibration.as_ref()?.measurements()[1];
        (measured.samples() > 0).then_some(measured)
    }

    /// Runs the replicas of a verification and adds its result to the summary, if
    /// [`Options::verify`] asked for it.
    pub fn verify(&mut self, file: &CaseFile, progress: &dyn Progress) {
        if let Some(verification) = self.verification.take() {
            verification.finish(file.case(), &self.outcome, &mut self.summary, progress);
        }
    }
}

/// Rows and histories of a run.
struct Kept<'r> {
    rows: Option<&'r mut (dyn Rows + Send)>,
    histories: Histories,
}

impl Kept<'_> {
    fn snapshot(&mut self, snapshot: &Snapshot) -> Result<(), ObserverError> {
        if let Some(rows) = &mut self.rows {
            rows.snapshot(snapshot)?;
        }
        self.histories.push(snapshot);
        Ok(())
    }

    fn collision(&mut self, collision: &Collision) -> Result<(), ObserverError> {
        if let Some(rows) = &mut self.rows {
            rows.collision(collision)?;
        }
        self.histories.collide(collision);
        Ok(())
    }
}

/// Name of the task of a run.
const TASK: &str = "run";

/// Announces a run with its verification, if there is one.
fn announce(case: &Case, verification: Option<&VerificationRuns>, progress: &dyn Progress) {
    if let Some(verification) = verification {
        let own = Task::new(TASK).with(case, case.solver.steps(), 1);
        progress.whole(&[own, verification.task(case)]);
    }
}

/// Runs a case and records it on the calling thread.
///
/// # Errors
/// The case cannot start, or the last rows could not be stored. Everything else is an
/// [`Ending`](cageless::simulation::Ending) of the outcome.
pub fn run(
    file: &CaseFile,
    options: Options<'_>,
    progress: &dyn Progress,
) -> Result<RunRecord, StudyError> {
    file.checked(Case::check_run)?;
    let (case, particulars) = (file.case(), file.particulars());
    let recorded = options.rows.is_some();
    let mut summary = SummaryRecorder::new();
    let mut ring_path = RingPathRecorder::new();
    let mut passages = Passages::new(case);
    let mut verification = options
        .verify
        .then(|| VerificationRuns::new(case, particulars.seed));
    let mut vibration = (case.housing.as_ref())
        .map(|housing| VibrationRecorder::new(housing, SAMPLING_HZ, transient_s(case)));
    let kept = RefCell::new(Kept {
        rows: options.rows,
        histories: Histories::new(case, particulars.interval_s),
    });
    let started = Instant::now();
    let outcome = {
        let mut recorder = Recorder::new(particulars.interval_s, |snapshot| {
            kept.borrow_mut().snapshot(&snapshot)
        });
        let mut collisions =
            CollisionDetector::new(|collision| kept.borrow_mut().collision(&collision));
        let mut passing = passages.recorder(case);
        announce(case, verification.as_ref(), progress);
        let work = progress.begin(TASK, case.solver.steps());
        let mut observers: Vec<&mut dyn Observer> = vec![&mut summary, &mut collisions];
        if !case.raceways.is_empty() {
            observers.push(&mut passing);
        }
        if recorded {
            observers.push(&mut recorder);
            observers.push(&mut ring_path);
            if let Some(vibration) = &mut vibration {
                observers.push(vibration);
            }
        }
        if let Some(verification) = &mut verification {
            observers.push(verification.observer());
        }
        let mut control = work.run_control(case.solver.duration_s, case.solver.steps());
        let outcome = simulate(case, &mut observers, &mut *control)?;
        collisions.close(outcome.end_s).map_err(StudyError::Rows)?;
        outcome
    };
    let wall_s = started.elapsed().as_secs_f64();
    let statistics = summary.summary();
    let run = Finished {
        case,
        outcome: &outcome,
        summary: statistics.as_ref(),
        passages: &passages.all,
        verdict: &passages.verdict(case, &outcome, statistics.as_ref()),
        wall_s,
    };
    Ok(RunRecord {
        summary: RunSummary::new(file, &run),
        outcome,
        histories: kept.into_inner().histories,
        passages,
        ring_path: ring_path.into_path(),
        vibration,
        verification,
    })
}
