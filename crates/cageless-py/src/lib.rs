//! The extension module `cageless._cageless`: what the Python package `cageless` computes
//! with. The package itself, with its documentation, is in `python/cageless`.

mod background;
mod compute;
mod documents;
mod errors;
mod result;
mod rotor;
mod sweep;
mod table;
mod tables;

use std::ffi::OsString;

use pyo3::prelude::*;

/// Exit code of the command with these words, the first of which is its own name.
#[pyfunction]
fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| cageless_cli::command(words))
}

#[pymodule]
mod _cageless {
    use super::*;

    #[pymodule_export]
    use super::{
        command,
        compute::{
            analyse, compare, design, drop, export, run, sheet, static_equilibrium, tolerance,
        },
        documents::{File, designated, instruction_set, template},
        result::{Computed, figures, quantities, units, write, write_folder, write_result},
        rotor::LinearRotor,
        sweep::{Collection, Sweep, merge},
        table::read_table,
        tables::{read_tables, table_units},
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        cageless_io::case_file::on_former_name(errors::warn);
        module.add("THREADS_MAX", cageless_study::THREADS_MAX)?;
        module.add("__version__", cageless_io::results::VERSION)
    }
}
