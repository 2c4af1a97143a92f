//! Why the paper could not be reproduced.

use cageless::InputError;
use cageless::critical_gap::CriticalGapError;
use cageless::equilibrium::EquilibriumError;
use cageless::simulation::Stop;
use cageless_io::case_file::CaseError;

/// Error of a computation of the paper.
#[derive(Debug, thiserror::Error)]
pub enum PaperError {
    /// A case file is wrong.
    #[error(transparent)]
    File(#[from] CaseError),
    /// A case is impossible.
    #[error(transparent)]
    Case(#[from] InputError),
    /// A critical gap could not be computed.
    #[error(transparent)]
    CriticalGap(#[from] CriticalGapError),
    /// There is no static equilibrium.
    #[error(transparent)]
    Equilibrium(#[from] EquilibriumError),
    /// A run left the physical range.
    #[error("{0}")]
    Stopped(Stop),
    /// A computation ended without a number.
    #[error("{0}")]
    NoResult(String),
    /// Interrupted by the caller.
    #[error("interrupted: no report was written")]
    Interrupted,
}

/// End of a computation that was interrupted.
pub(crate) fn not_computed<T>() -> Result<T, PaperError> {
    Err(PaperError::Interrupted)
}
