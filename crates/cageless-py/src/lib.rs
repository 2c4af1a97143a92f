//! The extension module `cageless._cageless`: what the Python package `cageless` computes
//! with. The package itself, with its documentation, is in `python/cageless`.

mod arrays;
mod background;
mod case_file;
mod command;
mod design;
mod drop;
mod errors;
mod export;
mod report;
mod rotor;
mod rotor_file;
mod run;
mod run_files;
mod signals;
mod sweep;
mod table;
mod tolerance;
mod values;

use pyo3::prelude::*;

#[pymodule]
fn _cageless(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", cageless_io::results::VERSION)?;
    module.add_class::<case_file::CaseFile>()?;
    module.add_class::<run::Run>()?;
    module.add_class::<drop::Drop>()?;
    module.add_class::<rotor::LinearRotor>()?;
    module.add_class::<rotor_file::RotorFile>()?;
    module.add_class::<design::Design>()?;
    module.add_class::<design::Search>()?;
    module.add_class::<tolerance::Tolerance>()?;
    module.add_class::<sweep::Sweep>()?;
    module.add_class::<sweep::Collection>()?;
    module.add_class::<report::Report>()?;
    module.add_function(wrap_pyfunction!(case_file::template, module)?)?;
    module.add_function(wrap_pyfunction!(case_file::designated, module)?)?;
    module.add_function(wrap_pyfunction!(case_file::instruction_set, module)?)?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_function(wrap_pyfunction!(values::to_toml, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::merge, module)?)?;
    module.add_function(wrap_pyfunction!(table::read_table, module)?)?;
    module.add_function(wrap_pyfunction!(run_files::run_units, module)?)?;
    module.add_function(wrap_pyfunction!(report::analyse, module)?)
}
