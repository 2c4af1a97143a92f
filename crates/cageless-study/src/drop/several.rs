//! The drop of a rotor into several touchdown bearings.

use cageless::simulation::{Control, Ending, Observer, PlaneDisplacement, RotorDrop, RunOutcome};
use cageless::touchdown::DropRecorder;

use cageless_results::{DropJudgement, DropResult, RotorRun};

use super::{DropRecord, Ended, watched};
use crate::StudyError;
use crate::progress::Progress;
use crate::run::{Rows, RunError};

/// A drop into several bearings with its record.
pub struct SeveralBearings {
    /// What each bearing went through.
    pub bearings: Vec<DropRecord>,
    /// What the energy ledger of the rotor alone lacks, over the sum of its absolute terms.
    pub rotor_energy_residual_relative: f64,
    /// Planes of the rotor with a clearance to the stator.
    pub planes: Vec<PlaneDisplacement>,
}

/// Recorders of the bearings of a drop.
fn recorders(drop: &RotorDrop) -> Vec<DropRecorder> {
    let carried = drop.carried_n().into_iter();
    carried.map(DropRecorder::of_bearing).collect()
}

/// Drops a rotor into its bearings on the calling thread; `rows` has a store for each bearing, or
/// none.
///
/// # Errors
/// A bearing cannot start, or the last rows could not be stored. Everything else is an
/// [`Ending`] of the outcomes.
pub(super) fn drop_into_bearings<'r>(
    drop: &RotorDrop,
    rows: Vec<Option<&'r mut (dyn Rows + Send + 'r)>>,
    progress: &dyn Progress,
) -> Result<SeveralBearings, RunError> {
    let cases: Vec<_> = drop.cases().iter().collect();
    let work = progress.begin("drop", 1.0);
    let mut control = work.run_control(cases[0].solver.duration_s, 1.0);
    let mut rotor_energy_residual_relative = 0.0;
    let mut planes = vec![];
    let bearings = watched(&cases, recorders(drop), rows, |observers| {
        let outcome = drop.run(observers, &mut *control)?;
        planes = outcome.planes;
        rotor_energy_residual_relative = outcome.rotor_energy_residual_relative;
        Ok(outcome.bearings)
    })?;
    Ok(SeveralBearings {
        bearings,
        rotor_energy_residual_relative,
        planes,
    })
}

impl SeveralBearings {
    /// The verdict on all bearings and the planes of the rotor.
    pub fn judgement(&self) -> DropJudgement {
        let records = self.bearings.iter();
        let bearings: Vec<_> = records.map(|record| &record.result.judgement).collect();
        DropJudgement::of_rotor(&bearings, &self.planes, self.rotor_energy_residual_relative)
    }

    /// Names and results of the bearings; `note` follows each name.
    pub(super) fn columns(&self, note: &str) -> impl Iterator<Item = (String, &DropResult)> {
        let records = self.bearings.iter().enumerate();
        records.map(move |(k, r)| (format!("bearing {}{note}", k + 1), &r.result))
    }

    /// The record of the bearing at which the drop ended: the one that stopped, or else the first.
    pub fn last(&self) -> &DropRecord {
        &self.bearings[self.last_index()]
    }

    /// [`Self::last`], taken out.
    pub fn into_last(mut self) -> DropRecord {
        self.bearings.swap_remove(self.last_index())
    }

    /// Index of [`Self::last`].
    pub fn last_index(&self) -> usize {
        stopped_bearing(self.bearings.iter().map(|bearing| &bearing.outcome)).unwrap_or(0)
    }
}

impl Ended for SeveralBearings {
    fn ending(&self) -> &Ending {
        &self.last().outcome.ending
    }
}

/// The bearing that ended the drop of all, if one did: it stopped, or could not be recorded.
fn stopped_bearing<'a>(mut outcomes: impl Iterator<Item = &'a RunOutcome>) -> Option<usize> {
    outcomes.position(|outcome| {
        matches!(
            outcome.ending,
            Ending::Stopped(_) | Ending::ObserverFailed(_)
        )
    })
}

/// Drops a rotor into its bearings and keeps the results alone.
///
/// # Errors
/// A bearing cannot start, or `control` cancelled.
pub(crate) fn run_rotor(
    drop: &RotorDrop,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RotorRun, StudyError> {
    // A short drop ends before it asks for the first time.
    if control(0.0).is_break() {
        return Err(StudyError::Interrupted);
    }
    let mut recorders = recorders(drop);
    let outcome = {
        let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
            .map(|recorder| vec![recorder as &mut dyn Observer])
            .collect();
        drop.run(&mut observers, control)
            .map_err(|error| StudyError::Input(error.to_string()))?
    };
    let results = drop.cases().iter().zip(recorders).zip(&outcome.bearings);
    let bearings: Vec<DropResult> = results
        .map(|((case, recorder), outcome)| {
            DropResult::new(case, &recorder.summary(&outcome.state), outcome)
        })
        .collect();
    let stopped = stopped_bearing(outcome.bearings.iter()).map(|k| {
        let reason = bearings[k].stopped.as_deref().unwrap_or_default();
        format!("in bearing {} {reason}", k + 1)
    });
    let interrupted = |outcome: &RunOutcome| matches!(outcome.ending, Ending::Interrupted);
    if stopped.is_none() && outcome.bearings.iter().any(interrupted) {
        return Err(StudyError::Interrupted);
    }
    Ok(RotorRun {
        bearings,
        stopped,
        rotor_energy_residual_relative: outcome.rotor_energy_residual_relative,
        planes: outcome.planes,
    })
}
