//! A run and its results.

use std::cell::RefCell;
use std::sync::{Mutex, OnceLock};
use std::time::Instant;

use cageless::collision::CollisionDetector;
use cageless::passage::PassageRecorder;
use cageless::recorder::Recorder;
use cageless::simulation::{Ending, Observer, RunOutcome, run};
use cageless::summary::{SummaryRecorder, transient_s};
use cageless::vibration::VibrationRecorder;
use cageless_io::case_file::CaseFile;
use cageless_io::results::SummaryFile;
use cageless_report::figures::{history, vibration};
use cageless_report::run_report::run_data;
use cageless_report::{Figure, RunData, run_page};
use cageless_study::verification::VerificationRuns;
use cageless_study::{Histories, SAMPLING_HZ};
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
    summary: SummaryFile,
    material: Material,
    data: OnceLock<RunData>,
}

/// Data of the figures.
struct Material {
    file: CaseFile,
    outcome: RunOutcome,
    /// Gone into the data once a figure was asked for.
    histories: Mutex<Option<Histories>>,
    vibration: Option<VibrationRecorder>,
}

/// Runs a case with everything recorded, and verifies it where that is attended to.
pub fn simulate(py: Python<'_>, file: &CaseFile, verify: Option<Background>) -> PyResult<Run> {
    let signals = Signals::new();
    let mut verification = verify.as_ref().map(|_| VerificationRuns::new(file.case()));
    let watch = verification.as_mut().map(VerificationRuns::watch);
    let done = py.detach(|| record(file, &signals, watch));
    signals.raised()?;
    let (material, mut summary, recording) = done?;
    if let (Some(background), Some(verification)) = (verify, verification) {
        let (case, outcome) = (file.case(), &material.outcome);
        background.run(py, |progress| {
            verification.finish(case, outcome, &mut summary, progress);
        })?;
    }
    Ok(Run {
        arrays: recording.into_arrays(py)?.unbind(),
        summary,
        material,
        data: OnceLock::new(),
    })
}

fn record(
    file: &CaseFile,
    signals: &Signals,
    watch: Option<&mut (dyn Observer + Send)>,
) -> PyResult<(Material, SummaryFile, Recording)> {
    let case = file.case();
    let started = Instant::now();
    let mut summary = SummaryRecorder::new();
    let settled_s = transient_s(case);
    let mut vibration = (case.housing.as_ref())
        .map(|housing| VibrationRecorder::new(housing, SAMPLING_HZ, settled_s));
    let kept = RefCell::new((Recording::default(), Histories::new(case)));
    let outcome = {
        let mut recorder = Recorder::new(case.output.interval_s, |snapshot| {
            let (recording, histories) = &mut *kept.borrow_mut();
            recording.snapshot(&snapshot);
            histories.push(&snapshot);
            Ok(())
        });
        let mut collisions = CollisionDetector::new(|collision| {
            let (recording, histories) = &mut *kept.borrow_mut();
            histories.collide(&collision);
            recording.collide(collision);
            Ok(())
        });
        let mut passages = PassageRecorder::new(|passage| {
            if passage.enter_s > settled_s {
                kept.borrow_mut().1.pass(&passage);
            }
            Ok(())
        });
        let mut observers: Vec<&mut dyn Observer> =
            vec![&mut summary, &mut collisions, &mut recorder, &mut passages];
        if let Some(vibration) = &mut vibration {
            observers.push(vibration);
        }
        if let Some(watch) = watch {
            observers.push(watch);
        }
        let outcome = run(case, &mut observers, &mut |_| signals.control());
        let outcome = outcome.map_err(|error| of_start(&error))?;
        collisions.close(outcome.end_s).map_err(other)?;
        outcome
    };
    let wall_s = started.elapsed().as_secs_f64();
    let (recording, histories) = kept.into_inner();
    let summary = SummaryFile::new(file, &outcome, summary.summary(), wall_s);
    let material = Material {
        file: file.clone(),
        outcome,
        histories: Mutex::new(Some(histories)),
        vibration,
    };
    Ok((material, summary, recording))
}

impl Run {
    /// Reason of an empty figure, with advice.
    fn nothing_to_show(&self, name: &str) -> String {
        let case = self.material.file.case();
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
        self.data.get_or_init(|| {
            let m = &self.material;
            let histories = m.histories.lock().ok().and_then(|mut kept| kept.take());
            let histories = histories.unwrap_or_else(|| Histories::new(m.file.case()));
            let measured = (m.vibration.as_ref()).map(|recorder| &recorder.measurements()[1]);
            run_data(
                &m.file,
                &m.outcome,
                &self.summary,
                histories,
                measured.filter(|measured| measured.samples() > 0),
            )
        })
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
        self.summary.to_json().map_err(other)
    }

    /// Names of the numbers of the verification, in the order of tables; `None` without one.
    fn certified(&self) -> Option<Vec<String>> {
        let verification = self.summary.verification.as_ref()?;
        let names = verification.ranked().into_iter();
        Some(names.map(|(name, _)| name.to_owned()).collect())
    }

    /// Reason of an early stop: the message of the command.
    fn stopped(&self) -> Option<String> {
        match &self.material.outcome.ending {
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
