//! Errors of writing results.

use std::io;
use std::path::{Path, PathBuf};

use parquet::errors::ParquetError;

use crate::system::io_error_message;

/// Error of writing or reading results.
#[derive(Debug, thiserror::Error)]
pub enum ResultError {
    /// The folder of `--out` cannot be used.
    #[error("--out {}: cannot be written to: {}", path.display(), io_error_message(.source))]
    Out {
        /// The folder, or the file in it.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
    /// Another process is writing to the same place.
    #[error("--out {}: another process is writing a result there; wait for it or choose another folder", path.display())]
    Busy {
        /// The folder, or the file in it.
        path: PathBuf,
    },
    /// The hidden file that is to grow into a result cannot be used.
    #[error("--out {}: {} {source}", path.display(), partial.display())]
    Occupied {
        /// The file of the result.
        path: PathBuf,
        /// The hidden file.
        partial: PathBuf,
        /// Kind of the existing entry.
        source: io::Error,
    },
    /// A table cannot be read.
    #[error("{}: cannot be read: {message}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Description of the error.
        message: String,
    },
    /// A table does not belong to the summary beside it.
    #[error(
        "{}: is of another computation than {}, {why}: run the case again with --out to an empty folder",
        path.display(),
        summary.display()
    )]
    Foreign {
        /// The table.
        path: PathBuf,
        /// The summary.
        summary: PathBuf,
        /// Difference.
        why: String,
    },
    /// Rows could not be written.
    #[error("cannot write {}: {}", path.display(), of_parquet(.source))]
    Table {
        /// The file.
        path: PathBuf,
        /// Error of Parquet.
        source: ParquetError,
    },
    /// The files of a result could not all be written; and what is there now.
    #[error("{}; {left}", joined(.errors))]
    Run {
        /// One for each file.
        errors: Vec<Self>,
        /// Contents of the folder.
        left: String,
    },
    /// The arrays of a snapshot are not of one length.
    #[error("the snapshot at {time_s} s has arrays of different lengths")]
    Ragged {
        /// Time of the snapshot.
        time_s: f64,
    },
}

/// Whether this is about a place that cannot be written to, which is for the user to
/// change, unlike a disk that is full.
pub fn is_unusable(error: &io::Error) -> bool {
    use io::ErrorKind::{
        AlreadyExists, IsADirectory, NotADirectory, NotFound, PermissionDenied, ReadOnlyFilesystem,
    };
    matches!(
        error.kind(),
        AlreadyExists
            | IsADirectory
            | NotADirectory
            | NotFound
            | PermissionDenied
            | ReadOnlyFilesystem
    )
}

impl ResultError {
    /// Whether what was asked for is at fault, not the machine.
    pub fn is_input(&self) -> bool {
        match self {
            Self::Busy { .. }
            | Self::Occupied { .. }
            | Self::Unreadable { .. }
            | Self::Foreign { .. } => true,
            Self::Out { source, .. } => is_unusable(source),
            Self::Run { errors, .. } => errors.iter().all(Self::is_input),
            Self::Table { .. } | Self::Ragged { .. } => false,
        }
    }

    /// Error of a file or folder under `--out`.
    pub fn out(path: &Path, source: io::Error) -> Self {
        Self::Out {
            path: path.to_owned(),
            source,
        }
    }

    pub(super) fn unreadable(path: &Path, why: impl Into<String>) -> Self {
        Self::Unreadable {
            path: path.to_owned(),
            message: why.into(),
        }
    }

    /// A table that Parquet cannot read: what the system says, or else `why`.
    pub(super) fn damaged(path: &Path, error: &ParquetError, why: &str) -> Self {
        match system_error(error) {
            Some(error) if error.kind() != io::ErrorKind::UnexpectedEof => {
                Self::unreadable(path, io_error_message(error))
            }
            _ => Self::unreadable(path, why),
        }
    }

    pub(super) fn table(path: &Path, source: ParquetError) -> Self {
        Self::Table {
            path: path.to_owned(),
            source,
        }
    }
}

fn joined(errors: &[ResultError]) -> String {
    let errors: Vec<_> = errors.iter().map(ToString::to_string).collect();
    errors.join("; ")
}

fn system_error(error: &ParquetError) -> Option<&io::Error> {
    match error {
        ParquetError::External(source) => source.downcast_ref(),
        _ => None,
    }
}

/// Message of Parquet without its internal error names.
fn of_parquet(error: &ParquetError) -> String {
    match (system_error(error), error) {
        (Some(error), _) => io_error_message(error),
        (None, ParquetError::General(text) | ParquetError::EOF(text)) => text.clone(),
        (None, error) => error.to_string(),
    }
}
