//! Errors of a sweep.

use crate::StudyError;
use cageless_io::case_file::CaseError;
use cageless_io::io_error_message;
use cageless_io::results::{ResultError, is_unusable};

/// Error of a sweep as a whole. A variant that fails is a row.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The plan is wrong.
    #[error(transparent)]
    Plan(#[from] CaseError),
    /// The request is not possible.
    #[error("{0}")]
    Input(String),
    /// Files cannot be written or read.
    #[error(transparent)]
    Files(#[from] ResultError),
    /// Files of the sweep in progress cannot be handled.
    #[error("{}: {}", path.display(), io_error_message(.source))]
    Folder {
        /// File or folder.
        path: std::path::PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// There are too many threads, or they could not be started.
    #[error(transparent)]
    Threads(#[from] StudyError),
}

impl SweepError {
    /// Whether what was asked for is at fault, not the machine.
    pub fn is_input(&self) -> bool {
        match self {
            Self::Plan(_) | Self::Input(_) => true,
            Self::Files(error) => error.is_input(),
            Self::Folder { source, .. } => is_unusable(source),
            Self::Threads(error) => matches!(error, StudyError::Input(_)),
        }
    }

    pub(crate) fn folder(path: &std::path::Path, source: std::io::Error) -> Self {
        Self::Folder {
            path: path.to_owned(),
            source,
        }
    }
}
