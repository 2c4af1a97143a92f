//! Why the paper could not be reproduced.

use cageless::{Case, Housing};
use cageless_study::StudyError;

/// End of a computation that was interrupted.
pub(crate) fn not_computed<T>() -> Result<T, StudyError> {
    Err(StudyError::Interrupted)
}

/// The housing of the case of the experiment.
pub(crate) fn housing(case: &Case) -> Result<&Housing, StudyError> {
    let missing = || StudyError::Input("the case of the experiment needs a [housing]".to_owned());
    case.housing.as_ref().ok_or_else(missing)
}
