//! A run and its results.

use std::sync::OnceLock;

use cageless::simulation::Ending;
use cageless_io::case_file::CaseFile;
use cageless_report::figures::{history, vibration};
use cageless_report::run_report::run_data;
use cageless_report::{Figure, RunData, run_page};
use cageless_study::run::{Options, RunError, RunRecord, run};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::Recording;
use crate::background::Background;
use crate::errors::{input, of_start, other};
use crate::signals::Signals;

/// A run that completed or stopped early.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Run {
    arrays: Py<PyDict>,
    file: CaseFile,
    record: RunRecord,
    data: OnceLock<RunData>,
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
    let record = done.map_err(|error| match error {
        RunError::Start(error) => of_start(&error),
        RunError::Rows(error) => other(error),
    })?;
    Ok(Run {
        arrays: recording.into_arrays(py)?.unbind(),
        file: file.clone(),
        record,
        data: OnceLock::new(),
    })
}

impl Run {
    /// Reason of an empty figure, with advice.
    fn nothing_to_show(&self, name: &str) -> String {
        let case = self.file.case();
        let why = match name {
            "vibration" if case.housing.is_none() => {
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

    fn data(&self) -> &RunData {
        (self.data).get_or_init(|| run_data(&self.file, &self.record))
    }
}

/// A figure of a run, if there is anything to show.
type Make = fn(&RunData) -> Option<Figure>;

/// Figures of a run by name.
const FIGURES: [(&str, Make); 9] = [
    ("gaps", history::gaps),
    ("collisions", history::collisions),
    ("orbit_speed", history::orbit_speed),
    ("slip", history::slip),
    ("phase", history::phase),
    ("loads", history::loads),
    ("ring_orbit", history::ring_orbit),
    ("energy", history::energy),
    ("vibration", |data| {
        let measured = data.vibration.as_ref()?;
        Some(vibration::vibration("Vibration", measured))
    }),
];

#[pymethods]
impl Run {
    /// `{"balls": …, "ring": …, "collisions": …}`, the same arrays at every call.
    fn arrays(&self, py: Python<'_>) -> Py<PyDict> {
        self.arrays.clone_ref(py)
    }

    /// `summary.json`.
    fn summary(&self) -> PyResult<String> {
        self.record.summary.to_json().map_err(other)
    }

    /// Names of the numbers of the verification, in the order of tables; `None` without one.
    fn certified(&self) -> Option<Vec<String>> {
        let verification = self.record.summary.verification.as_ref()?;
        let names = verification.ranked().into_iter();
        Some(names.map(|(name, _)| name.to_owned()).collect())
    }

    /// Reason of an early stop: the message of the command.
    fn stopped(&self) -> Option<String> {
        match &self.record.outcome.ending {
            Ending::Stopped(stop) => Some(stop.to_string()),
            _ => None,
        }
    }

    /// A figure in the JSON of plotly.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        let Some((_, make)) = FIGURES.iter().find(|(n, _)| *n == name) else {
            return Err(input(format!("there is no figure {name:?}")));
        };
        let figure = py.detach(|| make(self.data()));
        match figure {
            Some(figure) => Ok(figure.json()),
            None => Err(input(self.nothing_to_show(name))),
        }
    }

    /// `report.html`.
    fn page(&self, py: Python<'_>) -> String {
        py.detach(|| run_page(self.data()))
    }
}
