//! How a command fails, and the exit code that goes with it.

use std::fmt;
use std::process::ExitCode;

use cageless::equilibrium::EquilibriumError;
use cageless::simulation::Stop;
use cageless::spacing::CriticalGapError;
use cageless_io::case_file::CaseError;
use cageless_io::results::ResultError;
use cageless_sweep::SweepError;

/// A failed command.
#[derive(Debug)]
pub enum Failure {
    /// Bad input, exit code 2.
    Input(String),
    /// The run left the physical range or did not converge, exit code 3.
    Unphysical(String),
    /// Ended by the user, exit code 1.
    Interrupted(String),
    /// Anything else, exit code 1.
    Other(anyhow::Error),
}

impl Failure {
    /// Exit code of the contract.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Input(_) => 2,
            Self::Unphysical(_) => 3,
            Self::Interrupted(_) | Self::Other(_) => 1,
        })
    }

    /// A run that stopped.
    pub fn stopped(stop: &Stop, kept: &str) -> Self {
        Self::Unphysical(format!(
            "at t = {:.6} s {}. To change: {}.{kept}",
            stop.time_s,
            stop.cause,
            stop.advice()
        ))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(message) | Self::Unphysical(message) | Self::Interrupted(message) => {
                f.write_str(message)
            }
            Self::Other(error) => write!(f, "{error:#}"),
        }
    }
}

impl From<CaseError> for Failure {
    fn from(error: CaseError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<cageless::InputError> for Failure {
    fn from(error: cageless::InputError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<EquilibriumError> for Failure {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Input(error) => error.into(),
            error @ EquilibriumError::NotConverged { .. } => Self::Unphysical(error.to_string()),
        }
    }
}

impl From<CriticalGapError> for Failure {
    fn from(error: CriticalGapError) -> Self {
        match error {
            CriticalGapError::Case(error) => error.into(),
            CriticalGapError::Stopped(stop) => Self::stopped(&stop, ""),
            CriticalGapError::Interrupted => Self::Interrupted("interrupted".to_owned()),
            error => Self::Unphysical(error.to_string()),
        }
    }
}

/// A place that cannot be written to is bad input; a disk that is full is not.
fn is_unusable(error: &std::io::Error) -> bool {
    use std::io::ErrorKind::{
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

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Plan(error) => error.into(),
            SweepError::Input(message) => Self::Input(message),
            SweepError::Files(error) => error.into(),
            SweepError::Folder { ref source, .. } if is_unusable(source) => {
                Self::Input(error.to_string())
            }
            error => Self::Other(anyhow::Error::msg(error.to_string())),
        }
    }
}

impl From<ResultError> for Failure {
    fn from(error: ResultError) -> Self {
        match &error {
            ResultError::Busy { .. } | ResultError::Unreadable { .. } => {
                Self::Input(error.to_string())
            }
            ResultError::Out { source, .. } if is_unusable(source) => {
                Self::Input(error.to_string())
            }
            // The message has its cause in it.
            _ => Self::Other(anyhow::Error::msg(error.to_string())),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::Other(error.into())
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Other(error.into())
    }
}
