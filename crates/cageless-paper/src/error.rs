//! Why the paper could not be reproduced.

use cageless::critical_gap::CriticalGapError;
use cageless::simulation::{Ending, RunOutcome};
use cageless::{Case, Housing};
use cageless_study::StudyError;

/// End of a computation that was interrupted.
pub(crate) fn not_computed<T>() -> Result<T, StudyError> {
    Err(StudyError::Interrupted)
}

/// Refuses a run that left the physical range.
pub(crate) fn not_stopped(outcome: &RunOutcome) -> Result<(), StudyError> {
    match &outcome.ending {
        Ending::Stopped(stop) => Err(CriticalGapError::Stopped(stop.clone()).into()),
        _ => Ok(()),
    }
}

/// The housing of the case of the experiment.
pub(crate) fn housing(case: &Case) -> Result<&Housing, StudyError> {
    let missing = || StudyError::Input("the case of the experiment needs a [housing]".to_owned());
    case.housing.as_ref().ok_or_else(missing)
}
