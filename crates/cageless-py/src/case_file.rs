//! A case and what can be computed of it.

use std::path::PathBuf;

use cageless::design::{judge, recommend};
use cageless::dynamics::InstructionSet;
use cageless::equilibrium::solve;
use cageless::spacing::CriticalGapError;
use cageless_io::case_file;
use cageless_report::{DesignResult, StaticResult};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{of_file, of_gap, of_start, of_values, other, stopped};
use crate::run::{Run, simulate};
use crate::signals::Signals;
use crate::values::to_toml;

/// A case that was read and checked.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct CaseFile {
    pub file: case_file::CaseFile,
}

/// A commented case file.
#[pyfunction]
pub fn template(conventional: bool) -> String {
    case_file::template(conventional)
}

/// Vector instructions that runs use on this machine.
#[pyfunction]
pub fn instruction_set() -> &'static str {
    InstructionSet::chosen().name()
}

#[pymethods]
impl CaseFile {
    /// Reads a file; `changes` are `section.key=value`.
    #[staticmethod]
    fn read(path: PathBuf, changes: Vec<String>) -> PyResult<Self> {
        let file = case_file::CaseFile::read(&path, &changes).map_err(|e| of_file(&e))?;
        Ok(Self { file })
    }

    /// Reads a text, which messages call `name`.
    #[staticmethod]
    fn parse(text: &str, name: &str, changes: Vec<String>) -> PyResult<Self> {
        let file = case_file::CaseFile::parse(text, name, &changes).map_err(|e| of_file(&e))?;
        Ok(Self { file })
    }

    /// Takes `{section: {key: value}}`.
    #[staticmethod]
    fn of_values(values: &Bound<'_, PyDict>) -> PyResult<Self> {
        let text = to_toml(values)?;
        let file = case_file::CaseFile::parse(&text, "case", &[]).map_err(|e| of_values(&e))?;
        Ok(Self { file })
    }

    /// The case with changes, each `section.key=value`.
    fn changed(&self, changes: Vec<String>) -> PyResult<Self> {
        let text = self.to_toml()?;
        let file =
            case_file::CaseFile::parse(&text, "case", &changes).map_err(|e| of_values(&e))?;
        Ok(Self { file })
    }

    /// The case as a case file, every default filled in.
    fn to_toml(&self) -> PyResult<String> {
        self.file.document().to_toml().map_err(|e| of_file(&e))
    }

    /// The same as JSON; `as_run` with what follows from the rest as well.
    fn document(&self, as_run: bool) -> PyResult<String> {
        let document = if as_run {
            self.file.document_as_run()
        } else {
            self.file.document().clone()
        };
        serde_json::to_string(&document).map_err(other)
    }

    /// Keys that took their default.
    fn defaults(&self) -> Vec<String> {
        self.file.defaults().to_vec()
    }

    /// Numbers that follow from the bearing alone.
    fn derived<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let bearing = &self.file.case().bearing;
        let numbers = PyDict::new(py);
        numbers.set_item("radial_clearance_um", bearing.radial_clearance_m() * 1e6)?;
        numbers.set_item("epsilon_deg", bearing.ball_angle_rad().to_degrees())?;
        numbers.set_item("uniform_gap_deg", bearing.uniform_gap_rad().to_degrees())?;
        Ok(numbers)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.file.document() == other.file.document()
    }

    /// Runs the case.
    fn run(&self, py: Python<'_>) -> PyResult<Run> {
        simulate(py, &self.file)
    }

    /// `static --json`.
    fn static_equilibrium(&self, py: Python<'_>) -> PyResult<String> {
        let solved = py.detach(|| solve(self.file.case()));
        let solved = solved.map_err(|error| of_start(&error))?;
        serde_json::to_string(&StaticResult::new(solved)).map_err(other)
    }

    /// `design --json`, and the exception if a run that it rests on stopped.
    fn design(&self, py: Python<'_>) -> PyResult<(String, Option<PyErr>)> {
        let case = self.file.case();
        let signals = Signals::new();
        let found = py.detach(|| {
            let judgement = judge(case, &mut |_| signals.control())?;
            if signals.stop() {
                return Err(CriticalGapError::Interrupted);
            }
            match recommend(case) {
                Err(CriticalGapError::Case(error)) => Err(CriticalGapError::Case(error)),
                // No run of a pair can be judged here; the verdict says why.
                recommendation => Ok((judgement, recommendation.ok().flatten())),
            }
        });
        signals.raised()?;
        let (judgement, recommendation) = found.map_err(|error| of_gap(&error))?;
        let stop = judgement.stopped.as_ref().map(stopped);
        let result = DesignResult::new(case, judgement, recommendation);
        let json = serde_json::to_string(&result).map_err(other)?;
        Ok((json, stop))
    }
}
