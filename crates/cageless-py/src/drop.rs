//! The drop of a rotor.

use std::path::PathBuf;

use cageless::simulation::Ending;
use cageless_io::case_file::CaseFile;
use cageless_io::results::{Metadata, ROTOR, RunWriter, write_atomically};
use cageless_report::drop::drop_page;
use cageless_study::drop::{DropRecord, DropRequest, DropStudy, study};
use cageless_study::run::{Rows, RunError};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Recording, frozen};
use crate::background::Background;
use crate::errors::{of_results, of_start, of_study, other};

/// A drop with what was computed beside it.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Drop {
    file: CaseFile,
    study: DropStudy,
}

impl Drop {
    pub fn compute(
        py: Python<'_>,
        file: &CaseFile,
        request: DropRequest,
        background: Background,
    ) -> PyResult<Self> {
        request.check(file, "case").map_err(|e| of_study(&e))?;
        let done = background.run(py, |progress| study(file, request, None, progress))?;
        let study = done.map_err(|error| match error {
            RunError::Start(error) => of_start(&error),
            RunError::Rows(error) => other(error),
        })?;
        Ok(Self {
            file: file.clone(),
            study,
        })
    }

    /// One bearing of a drop into several.
    pub fn of_bearing(file: CaseFile, drop: DropRecord) -> Self {
        let study = DropStudy {
            drop,
            conventional: None,
            ensemble: None,
            verification: None,
            warnings: vec![],
            interrupted: false,
        };
        Self { file, study }
    }
}

#[pymethods]
impl Drop {
    /// `{"balls": …, "ring": …, "collisions": …, "rotor": …}`.
    fn arrays(&self, py: Python<'_>) -> PyResult<Py<PyDict>> {
        let record = &self.study.drop;
        let mut recording = Recording::default();
        for snapshot in &record.snapshots {
            recording.snapshot(snapshot).map_err(other)?;
        }
        for collision in &record.collisions {
            recording.collision(collision).map_err(other)?;
        }
        let tables = recording.into_arrays(py)?;
        let rows: Vec<_> = (record.snapshots.iter())
            .filter_map(|s| Some((s.time_s, s.rotor?.values())))
            .collect();
        let rotor = PyDict::new(py);
        for (k, column) in ROTOR.iter().enumerate() {
            let values = rows.iter().map(|(time_s, values)| match k {
                0 => *time_s,
                _ => values[k - 1],
            });
            let values: Vec<f64> = values.collect();
            rotor.set_item(column.name, frozen(values.into_pyarray(py)))?;
        }
        tables.set_item("rotor", rotor)?;
        Ok(tables.unbind())
    }

    /// `summary.json`.
    fn summary(&self) -> PyResult<String> {
        self.study.to_json(&self.file).map_err(other)
    }

    /// Reason of an early stop: the message of the command.
    fn stopped(&self) -> Option<String> {
        match &self.study.drop.outcome.ending {
            Ending::Stopped(stop) => Some(stop.to_string()),
            _ => None,
        }
    }

    /// Writes the folder of `cageless drop --out`.
    fn save(&self, py: Python<'_>, dir: PathBuf) -> PyResult<()> {
        let (summary, page) = (self.summary()?, self.page(py));
        self.save_tables(py, dir.clone())?;
        let write = || {
            write_atomically(&dir.join("summary.json"), summary.as_bytes())?;
            write_atomically(&dir.join("report.html"), page.as_bytes())
        };
        py.detach(write).map_err(|error| of_results(&error))
    }

    /// Writes the tables alone.
    fn save_tables(&self, py: Python<'_>, dir: PathBuf) -> PyResult<()> {
        let footer = serde_json::to_string(&self.file.document_as_run()).map_err(other)?;
        let record = &self.study.drop;
        let isa = record.outcome.instruction_set.name();
        let write = || {
            let metadata = Metadata { isa, case: &footer };
            let mut writer = RunWriter::create(&dir, &metadata)?;
            for snapshot in &record.snapshots {
                writer.snapshot(snapshot)?;
            }
            for collision in &record.collisions {
                writer.collision(collision)?;
            }
            writer.finish()
        };
        py.detach(write).map_err(|error| of_results(&error))
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> String {
        py.detach(|| drop_page(&self.file, &self.study))
    }
}
