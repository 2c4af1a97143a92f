//! The command `cageless`, installed with the Python package.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Exit code of the command with these words, the first of which is its own name.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| cageless_cli::command(words))
}
