//! A case and what can be computed of it.

use std::collections::HashMap;
use std::path::PathBuf;

use cageless::dynamics::InstructionSet;
use cageless_io::cad::ExportOptions;
use cageless_io::case_file;
use cageless_study::tolerance::Request;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::background::Background;
use crate::compute;
use crate::errors::{input, of_file, of_values, other};
use crate::export;
use crate::result::Computed;
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

/// The case file of a bearing of ISO 15.
#[pyfunction]
pub fn designated(designation: &str, full_complement: bool) -> PyResult<String> {
    let found = cageless_io::designation::find(designation).map_err(input)?;
    Ok(found.case_file(full_complement))
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

    /// Document as JSON; with `as_run` derived values are included.
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
        numbers.set_item(
            "radial_internal_clearance_um",
            bearing.radial_internal_clearance_m() * 1e6,
        )?;
        numbers.set_item("epsilon_deg", bearing.ball_angle_rad().to_degrees())?;
        numbers.set_item("uniform_gap_deg", bearing.nominal_gap_rad().to_degrees())?;
        Ok(numbers)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.file.document() == other.file.document()
    }

    /// Runs the case.
    fn run(
        &self,
        py: Python<'_>,
        verify: bool,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Computed> {
        // Verification uses every core, a run alone needs one.
        let threads = if verify { threads } else { Some(1) };
        let background = Background::new(threads, progress)?;
        compute::run(py, &self.file, verify, background)
    }

    /// Drops the rotor of the case.
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
        compute::drop(py, &self.file, request, background)
    }

    /// Solves the static equilibrium.
    fn static_equilibrium(&self, py: Python<'_>) -> PyResult<Computed> {
        compute::static_equilibrium(py, &self.file)
    }

    /// Judges the raceways, and the exception if a run that the verdict rests on stopped.
    fn design(&self, py: Python<'_>) -> PyResult<(Computed, Option<PyErr>)> {
        compute::design(py, &self.file)
    }

    /// Searches for the best raceway.
    fn search(
        &self,
        py: Python<'_>,
        folder: Option<PathBuf>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Computed> {
        let background = Background::new(threads, progress)?;
        compute::search(py, &self.file, folder, background)
    }

    /// Compares the ring with that of another case, or with a conventional one.
    fn compare(
        &self,
        py: Python<'_>,
        reference: Option<Py<Self>>,
        starts: i64,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Computed> {
        let reference = match &reference {
            Some(other) => ("reference", other.get().file.clone()),
            None => {
                let conventional = self.file.with_conventional_ring();
                ("conventional", conventional.map_err(|e| of_file(&e))?)
            }
        };
        let rings = [reference, ("case", self.file.clone())];
        let starts = compute::whole("starts", starts)?;
        compute::compare(py, rings, starts, Background::new(threads, progress)?)
    }

    /// Judges the bearing within tolerances; `deviations` by name, those of the command.
    fn tolerance(
        &self,
        py: Python<'_>,
        samples: i64,
        ball_grade: i64,
        deviations: HashMap<String, f64>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Computed> {
        let of = |name: &str| deviations.get(name).copied().unwrap_or(0.0);
        let request = Request {
            samples: compute::whole("samples", samples)?,
            groove_depth_um: of("groove_depth_um"),
            axial_span_um: of("axial_span_um"),
            half_angle_deg: of("half_angle_deg"),
            ball_grade: compute::whole("ball_grade", ball_grade)?,
            friction: of("friction"),
            clearance_um: of("clearance_um"),
            speed_percent: of("speed_percent"),
            load_percent: of("load_percent"),
        };
        let background = Background::new(threads, progress)?;
        compute::tolerance(py, &self.file, &request, background)
    }

    /// Writes the outer ring; a list of the numbers of `export --json`.
    #[expect(clippy::too_many_arguments, reason = "the options of the command")]
    fn export(
        &self,
        py: Python<'_>,
        out: PathBuf,
        formats: Option<Vec<String>>,
        blend_mm: Option<f64>,
        tolerance_um: Option<f64>,
        chord_um: Option<f64>,
        spacing_mm: Option<f64>,
    ) -> PyResult<String> {
        let options = ExportOptions {
            blend_mm,
            tolerance_um,
            chord_um,
            spacing_mm,
        };
        export::write(py, &self.file, &out, formats, &options)
    }
}
