//! Points that give no ring.

use crate::error::InputError;

/// Why points give no ring, or no raceway.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{error}")]
pub struct PointsError {
    /// Index of the raceway that they do not give; `None` of the ring.
    pub raceway: Option<usize>,
    /// Their number, and what is asked of them.
    pub error: InputError,
}

impl From<InputError> for PointsError {
    fn from(error: InputError) -> Self {
        Self {
            raceway: None,
            error,
        }
    }
}
