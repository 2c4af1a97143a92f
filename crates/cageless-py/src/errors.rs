//! Errors of the library as exceptions of the package, with the messages of the command.

use std::ffi::CString;
use std::io;
use std::path::Path;

use cageless::critical_gap::CriticalGapError;
use cageless::equilibrium::EquilibriumError;
use cageless::simulation::{Ending, Stop};
use cageless_io::cad::ExportError;
use cageless_io::case_file::CaseError;
use cageless_io::results::{ResultError, is_unusable};
use cageless_study::StudyError;
use cageless_study::run::RunError;
use cageless_study::sweep::SweepError;
use pyo3::exceptions::{PyFutureWarning, PyKeyboardInterrupt};
use pyo3::prelude::*;

mod package {
    pyo3::import_exception!(cageless.errors, CagelessError);
    pyo3::import_exception!(cageless.errors, InputError);
    pyo3::import_exception!(cageless.errors, UnphysicalError);
}

use package::{CagelessError, InputError, UnphysicalError};

/// Shows a note as a `FutureWarning`.
pub fn warn(note: &str) {
    Python::attach(|py| {
        let category = py.get_type::<PyFutureWarning>();
        // A filter that makes exceptions of warnings has no call here that could raise one.
        let _ = PyErr::warn(py, &category, &CString::new(note).unwrap_or_default(), 1);
    });
}

pub fn input(message: impl ToString) -> PyErr {
    InputError::new_err(message.to_string())
}

pub fn other(message: impl ToString) -> PyErr {
    CagelessError::new_err(message.to_string())
}

/// An error of a text that the user has not written: the message without its place.
pub fn of_values(error: &CaseError) -> PyErr {
    InputError::new_err((
        error.message().to_owned(),
        error.key().map(str::to_owned),
        None::<usize>,
    ))
}

pub fn of_file(error: &CaseError) -> PyErr {
    InputError::new_err((
        error.to_string(),
        error.key().map(str::to_owned),
        error.line(),
    ))
}

pub fn stopped(stop: &Stop) -> PyErr {
    UnphysicalError::new_err(stop.to_string())
}

pub fn of_run(error: RunError) -> PyErr {
    match error {
        RunError::Start(error) => of_start(&error),
        RunError::Rows(error) => other(error),
    }
}

/// Reason of an early stop by the physics: the message of the command.
pub fn reason(ending: &Ending) -> Option<String> {
    match ending {
        Ending::Stopped(stop) => Some(stop.to_string()),
        _ => None,
    }
}

pub fn of_start(error: &EquilibriumError) -> PyErr {
    match error {
        EquilibriumError::Input(error) => input(error),
        _ => UnphysicalError::new_err(error.to_string()),
    }
}

pub fn of_gap(error: &CriticalGapError) -> PyErr {
    match error {
        CriticalGapError::Case(error) => of_start(error),
        CriticalGapError::Stopped(stop) => stopped(stop),
        CriticalGapError::Interrupted => PyKeyboardInterrupt::new_err(()),
        error => UnphysicalError::new_err(error.to_string()),
    }
}

pub fn of_sweep(error: &SweepError) -> PyErr {
    match error {
        SweepError::Plan(error) => of_file(error),
        error if error.is_input() => input(error),
        error => other(error),
    }
}

pub fn of_results(error: &ResultError) -> PyErr {
    if error.is_input() {
        input(error)
    } else {
        other(error)
    }
}

pub fn of_study(error: &StudyError) -> PyErr {
    match error {
        StudyError::File(error) => of_values(error),
        StudyError::Run(error) => of_gap(error),
        StudyError::Option(refused) => {
            InputError::new_err((error.to_string(), Some(refused.option), None::<usize>))
        }
        StudyError::Case(_)
        | StudyError::Input(_)
        | StudyError::Foreign(_)
        | StudyError::Folder { .. } => input(error),
        StudyError::Interrupted => PyKeyboardInterrupt::new_err(()),
        StudyError::Threads(_) | StudyError::Journal { .. } => other(error),
    }
}

pub fn of_export(error: &ExportError) -> PyErr {
    let option = |option: &'static str| {
        InputError::new_err((error.to_string(), Some(option), None::<usize>))
    };
    match error {
        ExportError::Case(error) => of_values(error),
        ExportError::Option(refused) => option(refused.option),
        ExportError::Format { option: name, .. } => option(name),
    }
}

/// A folder that cannot be made.
pub fn of_folder(path: &Path, error: io::Error) -> PyErr {
    let message = format!("{}: {error}", path.display());
    if is_unusable(&error) {
        input(message)
    } else {
        other(message)
    }
}
