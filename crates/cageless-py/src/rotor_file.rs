//! A rotor above several touchdown bearings with their cases, and its drop.

use std::path::PathBuf;

use cageless_io::{case_file, rotor_file};
use pyo3::prelude::*;

use crate::background::Background;
use crate::case_file::CaseFile;
use crate::compute;
use crate::errors::{of_file, of_values, other};
use crate::result::Computed;
use crate::rotor::{LinearRotor, refused};

/// A rotor file that was read and checked.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct RotorFile {
    pub file: rotor_file::RotorFile,
}

#[pymethods]
impl RotorFile {
    /// Reads a file; `changes` are `section.key=value`.
    #[staticmethod]
    fn read(path: PathBuf, changes: Vec<String>) -> PyResult<Self> {
        let file = rotor_file::RotorFile::read(&path, &changes).map_err(|e| of_file(&e))?;
        Ok(Self { file })
    }

    /// Reads a text, which messages call `name`; paths in it are relative to `folder`.
    #[staticmethod]
    fn parse(text: &str, name: &str, folder: PathBuf, changes: Vec<String>) -> PyResult<Self> {
        let file = rotor_file::RotorFile::parse(text, name, &folder, &changes);
        let file = file.map_err(|e| of_file(&e))?;
        Ok(Self { file })
    }

    /// A rotor above the bearings of `cases`.
    #[staticmethod]
    fn of(
        rotor: &LinearRotor,
        cases: Vec<PyRef<'_, CaseFile>>,
        title: &str,
        speed_rpm: f64,
        drive_torque_n_m: f64,
    ) -> PyResult<Self> {
        let cases: Vec<_> = cases.iter().map(|case| case.file.clone()).collect();
        let rotor = &rotor.description;
        let file = rotor_file::RotorFile::new(title, rotor, speed_rpm, drive_torque_n_m, &cases);
        let file = file.map_err(|error| refused(&error))?;
        Ok(Self { file })
    }

    /// The rotor with changes, each `section.key=value`.
    fn changed(&self, changes: Vec<String>) -> PyResult<Self> {
        let file = self.file.changed(&changes).map_err(|e| of_values(&e))?;
        Ok(Self { file })
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.file.document() == other.file.document()
    }

    #[getter]
    fn title(&self) -> &str {
        self.file.title()
    }

    #[getter]
    fn speed_rpm(&self) -> f64 {
        self.file.document().speed_rpm
    }

    #[getter]
    fn drive_torque_n_m(&self) -> f64 {
        self.file.document().drive_torque_n_m
    }

    /// The rotor.
    fn rotor(&self) -> PyResult<LinearRotor> {
        LinearRotor::new(self.file.document().rotor.clone())
    }

    /// The case of each bearing.
    fn cases(&self) -> PyResult<Vec<CaseFile>> {
        let cases = self.file.document().cases.iter().enumerate();
        let case = |(k, document): (usize, &case_file::CaseDocument)| {
            let name = format!("bearing {}", k + 1);
            let file = case_file::CaseFile::from_document(document.clone(), &name);
            let file = file.map_err(|error| of_values(&error))?;
            Ok(CaseFile { file })
        };
        cases.map(case).collect()
    }

    /// The rotor as a rotor file with its cases, every default filled in.
    fn to_toml(&self) -> PyResult<String> {
        self.file.document().to_toml().map_err(|e| of_file(&e))
    }

    /// Document as JSON.
    fn document(&self) -> PyResult<String> {
        let value = self.file.document().to_value().map_err(|e| of_values(&e))?;
        serde_json::to_string(&value).map_err(other)
    }

    /// Drops the rotor.
    fn drop(
        &self,
        py: Python<'_>,
        compare: bool,
        samples: Option<i64>,
        verify: bool,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Computed> {
        let request = compute::requested(compare, samples, verify)?;
        let background = Background::new(threads, progress)?;
        compute::drop_rotor(py, &self.file, request, background)
    }
}
