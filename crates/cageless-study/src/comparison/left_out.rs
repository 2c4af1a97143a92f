//! Rings that could not be compared.

use cageless::simulation::Stop;
use cageless_design::critical_gap::CriticalGapError;
use serde::Serialize;

use crate::error::StudyError;

/// A ring that could not be compared.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LeftOut {
    /// Name of the ring.
    pub name: String,
    /// Reason.
    pub why: String,
}

impl LeftOut {
    /// A ring that does not run, without advice on a case that the user did not give.
    ///
    /// # Errors
    /// The error itself, where it is not that of the ring.
    pub(super) fn of(name: &str, error: StudyError) -> Result<Self, StudyError> {
        match why_not(&error) {
            Some(why) => Ok(Self {
                name: name.to_owned(),
                why,
            }),
            None => Err(error),
        }
    }
}

/// Reason for which a ring does not run; `None` of other errors.
fn why_not(error: &StudyError) -> Option<String> {
    let reason = |stop: &Stop| format!("its run stopped: {}", stop.reason());
    match error {
        StudyError::Stopped { stop, .. } | StudyError::Run(CriticalGapError::Stopped(stop)) => {
            Some(reason(stop))
        }
        StudyError::Run(CriticalGapError::Case(error)) => Some(error.to_string()),
        _ => None,
    }
}
