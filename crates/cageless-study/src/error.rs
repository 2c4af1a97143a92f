//! Errors of studies.

use std::io;
use std::path::{Path, PathBuf};

use cageless::InputError;
use cageless::equilibrium::EquilibriumError;
use cageless::simulation::{Ending, ObserverError, Stop};
use cageless_design::critical_gap::CriticalGapError;
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_io::journal::JournalError;
use cageless_io::results::ResultError;
use cageless_io::{OptionError, io_error_message};

/// Error of a study.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The case is wrong.
    #[error(transparent)]
    File(#[from] CaseError),
    /// The plan of a sweep is wrong.
    #[error(transparent)]
    Plan(CaseError),
    /// The case is impossible.
    #[error(transparent)]
    Case(#[from] InputError),
    /// The request is not possible.
    #[error("{0}")]
    Input(String),
    /// An option of the study is not possible.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// A run that everything rests on left the physical range, or did not converge.
    #[error(transparent)]
    Run(#[from] CriticalGapError),
    /// One of many runs that everything rests on left the physical range.
    #[error("{run}: {}", stop.by_key())]
    Stopped {
        /// Which run it was.
        run: String,
        /// Time and cause.
        stop: Stop,
    },
    /// Rows of a run could not be stored.
    #[error("{0}")]
    Rows(ObserverError),
    /// Ended by the progress.
    #[error("interrupted")]
    Interrupted,
    /// The threads could not be started.
    #[error("cannot start threads: {0}")]
    Threads(String),
    /// Files of results cannot be written or read.
    #[error(transparent)]
    Files(#[from] ResultError),
    /// The folder cannot be used.
    #[error("{}: {}", path.display(), io_error_message(source))]
    Folder {
        /// Folder or file in it.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
    /// The journal in the folder is another's, in use or damaged.
    #[error("{0}")]
    Foreign(String),
    /// Results cannot be stored, for example on a full disk.
    #[error("{}: {}", path.display(), io_error_message(source))]
    Journal {
        /// File.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
}

impl StudyError {
    /// Error of a run of a case, naming the key that is refused.
    pub(crate) fn of_run(file: &CaseFile, error: CriticalGapError) -> Self {
        match error {
            CriticalGapError::Case(EquilibriumError::Input(error)) => {
                match file.checked(|_| Err::<(), _>(error.clone())) {
                    Err(named) => named.into(),
                    Ok(()) => error.into(),
                }
            }
            error => error.into(),
        }
    }

    /// Refuses a run that has not come to its end.
    ///
    /// # Errors
    /// Why it ended.
    pub fn unless_complete(ending: &Ending) -> Result<(), Self> {
        match ending {
            Ending::Complete => Ok(()),
            Ending::Stopped(stop) => Err(CriticalGapError::Stopped(stop.clone()).into()),
            Ending::ObserverFailed(error) => Err(Self::Input(error.to_string())),
            Ending::Interrupted => Err(Self::Interrupted),
        }
    }

    /// Error of threads that did not start.
    pub fn threads(error: &dyn std::fmt::Display) -> Self {
        Self::Threads(error.to_string())
    }

    /// Names the run that stopped.
    pub(crate) fn in_run(self, run: impl FnOnce() -> String) -> Self {
        match self {
            Self::Run(CriticalGapError::Stopped(stop)) => Self::Stopped { run: run(), stop },
            other => other,
        }
    }

    /// Error of a file or folder of results in the making.
    pub(crate) fn out(path: &Path, source: io::Error) -> Self {
        Self::Files(ResultError::out(path, source))
    }

    pub(crate) fn folder(path: &Path, source: io::Error) -> Self {
        Self::Folder {
            path: path.to_owned(),
            source,
        }
    }
}

impl From<EquilibriumError> for StudyError {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Interrupted => Self::Interrupted,
            error => Self::Run(error.into()),
        }
    }
}

impl From<JournalError> for StudyError {
    fn from(error: JournalError) -> Self {
        match error {
            JournalError::Foreign { .. }
            | JournalError::Busy { .. }
            | JournalError::Damaged { .. } => Self::Foreign(error.to_string()),
            JournalError::Io { path, source } => Self::Folder { path, source },
        }
    }
}
