//! The drop of a rotor.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use cageless_io::case_file::CaseFile;
use cageless_io::results::{ROTOR, write_atomically};
use cageless_report::drop::drop_page;
use cageless_study::drop::{DropRecord, DropRequest, DropStudy, study};
use cageless_study::run::Rows;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Recording, frozen};
use crate::background::Background;
use crate::errors::{of_results, of_run, of_study, other, reason};
use crate::run_files::{self, Arrays};

/// A drop with what was computed beside it.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Drop {
    arrays: Py<PyDict>,
    summary: String,
    stopped: Option<String>,
    /// What the page is made of; nothing where it was read.
    computed: Option<Box<(CaseFile, DropStudy)>>,
    page: OnceLock<String>,
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
        let study = done.map_err(of_run)?;
        Self::new(py, file.clone(), study)
    }

    /// One bearing of a drop into several.
    pub fn of_bearing(py: Python<'_>, file: CaseFile, drop: DropRecord) -> PyResult<Self> {
        let study = DropStudy::of_bearing(file.case(), drop);
        Self::new(py, file, study)
    }

    fn new(py: Python<'_>, file: CaseFile, study: DropStudy) -> PyResult<Self> {
        let stopped = reason(&study.drop.outcome.ending);
        Ok(Self {
            arrays: arrays(py, &study.drop)?.unbind(),
            summary: study.to_json(&file).map_err(other)?,
            stopped,
            computed: Some(Box::new((file, study))),
            page: OnceLock::new(),
        })
    }
}

/// `{"balls": …, "ring": …, "collisions": …, "rotor": …}`.
fn arrays<'py>(py: Python<'py>, record: &DropRecord) -> PyResult<Bound<'py, PyDict>> {
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
    Ok(tables)
}

#[pymethods]
impl Drop {
    /// A drop from what its methods return.
    #[staticmethod]
    fn restored(
        arrays: Py<PyDict>,
        summary: String,
        page: String,
        stopped: Option<String>,
    ) -> Self {
        Self {
            arrays,
            summary,
            stopped,
            computed: None,
            page: OnceLock::from(page),
        }
    }

    /// Reads the folder of `cageless drop --out`.
    #[staticmethod]
    fn load(py: Python<'_>, dir: PathBuf) -> PyResult<Self> {
        let (arrays, [summary, page]) = run_files::read(py, &dir, ["summary.json", "report.html"])?;
        run_files::read_rotor(py, &dir, &arrays)?;
        let stopped = run_files::reason(&summary);
        Ok(Self::restored(arrays.unbind(), summary, page, stopped))
    }

    /// `{"balls": …, "ring": …, "collisions": …, "rotor": …}`, the same arrays at every call.
    fn arrays(&self, py: Python<'_>) -> Py<PyDict> {
        self.arrays.clone_ref(py)
    }

    /// `summary.json`.
    fn summary(&self) -> &str {
        &self.summary
    }

    /// Reason of an early stop: the message of the command.
    fn stopped(&self) -> Option<&str> {
        self.stopped.as_deref()
    }

    /// Writes the folder of `cageless drop --out`; `case` is the case as run, JSON.
    fn save(&self, py: Python<'_>, dir: PathBuf, isa: &str, case: &str) -> PyResult<()> {
        let page = self.page(py).to_owned();
        self.save_tables(py, dir.clone(), isa, case)?;
        let write = |name: &str, text: &str| {
            let path: &Path = &dir.join(name);
            write_atomically(path, text.as_bytes()).map_err(|e| of_results(&e))
        };
        write("summary.json", &self.summary)?;
        write("report.html", &page)
    }

    /// Writes the tables alone.
    fn save_tables(&self, py: Python<'_>, dir: PathBuf, isa: &str, case: &str) -> PyResult<()> {
        Arrays::read(self.arrays.bind(py))?.write(&dir, isa, case)
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> &str {
        let make = || match &self.computed {
            Some(computed) => py.detach(|| drop_page(&computed.0, &computed.1)),
            None => String::new(),
        };
        self.page.get_or_init(make)
    }
}
