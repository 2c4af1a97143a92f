//! The extension module `cageless._cageless`: what the Python package `cageless` computes
//! with. The package itself, with its documentation, is in `python/cageless`.

mod analysis;
mod background;
mod case_file;
mod command;
mod compute;
mod content;
mod errors;
mod export;
mod result;
mod rotor;
mod rotor_file;
mod signals;
mod sweep;
mod table;
mod tables;
mod values;

use pyo3::prelude::*;

#[pymodule]
fn _cageless(module: &Bound<'_, PyModule>) -> PyResult<()> {
    cageless_io::case_file::on_former_name(errors::warn);
    module.add("__version__", cageless_io::results::VERSION)?;
    module.add_class::<case_file::CaseFile>()?;
    module.add_class::<rotor::LinearRotor>()?;
    module.add_class::<rotor_file::RotorFile>()?;
    module.add_class::<result::Computed>()?;
    module.add_class::<sweep::Sweep>()?;
    module.add_class::<sweep::Collection>()?;
    module.add_function(wrap_pyfunction!(case_file::template, module)?)?;
    module.add_function(wrap_pyfunction!(case_file::designated, module)?)?;
    module.add_function(wrap_pyfunction!(case_file::instruction_set, module)?)?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_function(wrap_pyfunction!(values::to_toml, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::merge, module)?)?;
    module.add_function(wrap_pyfunction!(table::read_table, module)?)?;
    module.add_function(wrap_pyfunction!(tables::table_units, module)?)?;
    module.add_function(wrap_pyfunction!(result::quantities, module)?)?;
    module.add_function(wrap_pyfunction!(result::figures, module)?)?;
    module.add_function(wrap_pyfunction!(result::load, module)?)?;
    module.add_function(wrap_pyfunction!(result::write, module)?)?;
    module.add_function(wrap_pyfunction!(result::make_folder, module)?)?;
    module.add_function(wrap_pyfunction!(compute::analyse, module)?)
}
