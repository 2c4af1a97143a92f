//! Errors of the library as exceptions of the package, with the messages of the command.

use std::ffi::CString;

use cageless::equilibrium::EquilibriumError;
use cageless::linear_rotor::RotorError;
use cageless_cli::Failure;
use cageless_io::cad::ExportError;
use cageless_io::case_file::CaseError;
use cageless_io::results::ResultError;
use cageless_study::StudyError;
use pyo3::exceptions::{PyFutureWarning, PyKeyboardInterrupt};
use pyo3::prelude::*;

mod package {
    pyo3::import_exception!(cageless.errors, CagelessError);
    pyo3::import_exception!(cageless.errors, InputError);
    pyo3::import_exception!(cageless.errors, UnphysicalError);
}

use package::{CagelessError, InputError, UnphysicalError};

/// An exception.
pub struct Error(pub PyErr);

/// A value, or the exception that is raised in its place.
pub type Found<T> = Result<T, Error>;

/// Shows a note as a `FutureWarning`.
pub fn warn(note: &str) {
    Python::attach(|py| {
        let category = py.get_type::<PyFutureWarning>();
        // A filter that makes exceptions of warnings has no call here that could raise one.
        let _ = PyErr::warn(py, &category, &CString::new(note).unwrap_or_default(), 1);
    });
}

pub fn input(message: impl ToString) -> Error {
    Error(InputError::new_err(message.to_string()))
}

pub fn other(message: impl ToString) -> Error {
    Error(CagelessError::new_err(message.to_string()))
}

/// A refused value of a key or an option.
fn refused(message: String, key: Option<&str>, line: Option<usize>) -> Error {
    Error(InputError::new_err((message, key.map(str::to_owned), line)))
}

/// An error of a text that the user has not written: the message without its place.
pub fn of_values(error: CaseError) -> Error {
    refused(error.message().to_owned(), error.key(), None)
}

impl From<Error> for PyErr {
    fn from(error: Error) -> Self {
        error.0
    }
}

impl From<PyErr> for Error {
    fn from(error: PyErr) -> Self {
        Self(error)
    }
}

impl From<Failure> for Error {
    fn from(failure: Failure) -> Self {
        let message = failure.to_string();
        match failure {
            Failure::Input(_) => input(message),
            Failure::Unphysical(_) => Self(UnphysicalError::new_err(message)),
            Failure::Interrupted(_) => Self(PyKeyboardInterrupt::new_err(())),
            Failure::Other(_) => other(message),
        }
    }
}

/// Errors that are classed as the command classes them.
macro_rules! as_of_the_command {
    ($($error:ty),+) => {
        $(impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Failure::from(error).into()
            }
        })+
    };
}

as_of_the_command!(EquilibriumError, ResultError, serde_json::Error);

impl From<RotorError> for Error {
    fn from(error: RotorError) -> Self {
        input(error)
    }
}

impl From<CaseError> for Error {
    fn from(error: CaseError) -> Self {
        refused(error.to_string(), error.key(), error.line())
    }
}

impl From<StudyError> for Error {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::File(error) => of_values(error),
            StudyError::Plan(error) => error.into(),
            StudyError::Option(ref of) => refused(error.to_string(), Some(of.option), None),
            StudyError::Folder { .. } => input(error),
            error => Failure::from(error).into(),
        }
    }
}

impl From<ExportError> for Error {
    fn from(error: ExportError) -> Self {
        let key = match error {
            ExportError::Case(error) => return of_values(error),
            ExportError::Option(ref of) => of.option,
            ExportError::Format { option, .. } => option,
            ExportError::Date(error) => return refused(error.to_string(), None, None),
        };
        refused(error.to_string(), Some(key), None)
    }
}
