//! A run and its results.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use cageless_io::case_file::CaseFile;
use cageless_io::results::write_atomically;
use cageless_report::figures::{
    ball, collisions, energy, gap_map, history, polar, ring, vibration,
};
use cageless_report::run_report::run_data;
use cageless_report::{Figure, RunData, run_from_json, run_json, run_page};
use cageless_study::run::{Options, RunRecord, run};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::Recording;
use crate::background::Background;
use crate::errors::{input, of_results, of_run, other, reason};
use crate::run_files::{self, Arrays};
use crate::signals::Signals;

/// A run that completed or stopped early.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Run {
    arrays: Py<PyDict>,
    /// `summary.json`.
    summary: String,
    /// Message of an early stop.
    stopped: Option<String>,
    source: Source,
    data: OnceLock<RunData>,
}

/// What the data of the page come from.
enum Source {
    Computed(Box<(CaseFile, RunRecord)>),
    /// `report.json`.
    Saved(String),
}

/// Runs a case with everything recorded, and verifies it where a background is given.
pub fn simulate(py: Python<'_>, file: &CaseFile, verify: Option<Background>) -> PyResult<Run> {
    let signals = Signals::new();
    let mut recording = Recording::default();
    let options = Options {
        rows: Some(&mut recording),
        verify: verify.is_some(),
    };
    let mut done = py.detach(|| run(file, options, &signals));
    signals.raised()?;
    if let (Some(background), Ok(record)) = (verify, &mut done) {
        background.run(py, |progress| record.verify(file, progress))?;
    }
    let record = done.map_err(of_run)?;
    Ok(Run {
        arrays: recording.into_arrays(py)?.unbind(),
        summary: record.summary.to_json().map_err(other)?,
        stopped: reason(&record.outcome.ending),
        source: Source::Computed(Box::new((file.clone(), record))),
        data: OnceLock::new(),
    })
}

impl Run {
    /// Reason of an empty figure, with advice.
    fn nothing_to_show(&self, name: &str, data: &RunData) -> String {
        let why = match name {
            "vibration" if data.vibration.is_none() => {
                "the case has no [housing], whose acceleration it shows: add \
                 Housing(mass_kg=…, stiffness_n_m=…, damping_n_s_m=…)"
            }
            "collisions" => "no balls touched",
            _ => {
                "the run is too short after its transient: lengthen solver.duration_s or shorten \
                 output.interval_us"
            }
        };
        format!("{name} has nothing to show: {why}")
    }

    fn data(&self) -> PyResult<&RunData> {
        if let Some(data) = self.data.get() {
            return Ok(data);
        }
        let data = match &self.source {
            Source::Computed(run) => run_data(&run.0, &run.1),
            Source::Saved(text) => {
                let read = run_from_json(text, &self.summary);
                read.map_err(|e| input(format!("report.json of a saved run: {e}")))?
            }
        };
        Ok(self.data.get_or_init(|| data))
    }

    /// Data for figures of some balls, counted from 1, and of a part of the time.
    fn selected(
        &self,
        py: Python<'_>,
        balls: Option<Vec<usize>>,
        time_s: Option<(f64, f64)>,
    ) -> PyResult<RunData> {
        let data = self.data()?;
        let arrays = Arrays::read(self.arrays.bind(py))?;
        let mut found = match time_s {
            Some((from, to)) => data.within(&arrays.snapshots(from, to)?),
            None => data.clone(),
        };
        if let Some(balls) = balls {
            let count = data.balls.len();
            if let Some(ball) = balls.iter().find(|ball| !(1..=count).contains(*ball)) {
                return Err(input(format!(
                    "balls = {ball} is not possible: it must be 1 to {count}"
                )));
            }
            let balls: Vec<usize> = balls.iter().map(|ball| ball - 1).collect();
            found = found.of_balls(&balls);
        }
        Ok(found)
    }
}

/// A figure of a run, if there is anything to show.
type Make = fn(&RunData) -> Option<Figure>;

/// Figures of a run by name.
const FIGURES: [(&str, Make); 11] = [
    ("gaps", history::gaps),
    ("gap_map", gap_map::gap_map),
    ("load_profile", polar::loads),
    ("collisions", collisions::collisions),
    ("orbit_speed", history::orbit_speed),
    ("slip", history::slip),
    ("phase", ball::phase),
    ("loads", ball::loads),
    ("ring_orbit", ring::ring_orbit),
    ("energy", energy::energy),
    ("vibration", |data| {
        let measured = data.vibration.as_ref()?;
        Some(vibration::vibration("Vibration", measured))
    }),
];

#[pymethods]
impl Run {
    /// A run from what [`Run::report`] and its siblings return.
    #[staticmethod]
    fn restored(
        arrays: Py<PyDict>,
        summary: String,
        report: String,
        stopped: Option<String>,
    ) -> Self {
        Self {
            arrays,
            summary,
            stopped,
            source: Source::Saved(report),
            data: OnceLock::new(),
        }
    }

    /// Reads the folder of `cageless run --out`.
    #[staticmethod]
    fn load(py: Python<'_>, dir: PathBuf) -> PyResult<Self> {
        let (arrays, [summary, report]) =
            run_files::read(py, &dir, ["summary.json", "report.json"])?;
        Ok(Self {
            arrays: arrays.unbind(),
            stopped: run_files::stopped(&summary),
            summary,
            source: Source::Saved(report),
            data: OnceLock::new(),
        })
    }

    /// Writes the folder of `cageless run --out`; `case` is the case as run, JSON.
    fn save(&self, py: Python<'_>, dir: PathBuf, isa: &str, case: &str) -> PyResult<()> {
        let report = self.report()?;
        let arrays = Arrays::read(self.arrays.bind(py))?;
        let page = self.page(py)?;
        arrays.write(&dir, isa, case)?;
        let write = |name: &str, text: &str| {
            let path: &Path = &dir.join(name);
            write_atomically(path, text.as_bytes()).map_err(|e| of_results(&e))
        };
        write("summary.json", &self.summary)?;
        write("report.html", &page)?;
        write("report.json", &report)
    }

    /// `{"balls": …, "ring": …, "collisions": …}`, the same arrays at every call.
    fn arrays(&self, py: Python<'_>) -> Py<PyDict> {
        self.arrays.clone_ref(py)
    }

    /// `summary.json`.
    fn summary(&self) -> &str {
        &self.summary
    }

    /// `report.json`.
    fn report(&self) -> PyResult<String> {
        match &self.source {
            Source::Computed(_) => run_json(self.data()?, &self.summary).map_err(other),
            Source::Saved(text) => Ok(text.clone()),
        }
    }

    /// Names of the numbers of the verification, in the order of tables; `None` without one.
    fn certified(&self) -> PyResult<Option<Vec<String>>> {
        let table = self.data()?.verification.as_ref();
        Ok(table.map(|table| table.rows.iter().map(|row| row.name.clone()).collect()))
    }

    /// Reason of an early stop: the message of the command.
    fn stopped(&self) -> Option<String> {
        self.stopped.clone()
    }

    /// A figure in the JSON of plotly, of all balls and all times or of some.
    #[pyo3(signature = (name, balls=None, time_s=None))]
    fn figure(
        &self,
        py: Python<'_>,
        name: &str,
        balls: Option<Vec<usize>>,
        time_s: Option<(f64, f64)>,
    ) -> PyResult<String> {
        let Some((_, make)) = FIGURES.iter().find(|(n, _)| *n == name) else {
            return Err(input(format!("there is no figure {name:?}")));
        };
        let selected;
        let data = if balls.is_none() && time_s.is_none() {
            self.data()?
        } else {
            selected = self.selected(py, balls, time_s)?;
            &selected
        };
        match py.detach(|| make(data)) {
            Some(figure) => Ok(figure.json()),
            None => Err(input(self.nothing_to_show(name, data))),
        }
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        let data = self.data()?;
        Ok(py.detach(|| run_page(data)))
    }
}
