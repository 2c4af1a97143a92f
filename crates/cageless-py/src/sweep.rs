//! Sweeps.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use cageless_io::plan_file::{PlanFile, VariantFile};
use cageless_study::break_if;
use cageless_study::sweep::{Job, Shard, SweepError, write_part};
use pyo3::prelude::*;

use crate::background::count;
use crate::case_file::CaseFile;
use crate::errors::{input, of_file, of_sweep, of_values, other};
use crate::rotor_file::RotorFile;
use crate::signals::Signals;

/// A plan that can be computed.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Sweep {
    sweep: cageless_study::sweep::Sweep,
}

/// Interval between progress callbacks.
const REPORT_INTERVAL: Duration = Duration::from_millis(100);

#[pymethods]
impl Sweep {
    /// Reads a plan.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let plan = PlanFile::read(&path).map_err(|e| of_file(&e))?;
        Self::checked(py, plan)
    }

    /// Reads the text of a plan, which messages call `name`; paths in it count from
    /// `folder`.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str, name: &str, folder: PathBuf) -> PyResult<Self> {
        let plan = PlanFile::parse(text, name, &folder).map_err(|e| of_file(&e))?;
        Self::checked(py, plan)
    }

    /// Takes the text of a plan made of values, of whose lines its user knows nothing.
    #[staticmethod]
    fn of_values(py: Python<'_>, text: &str) -> PyResult<Self> {
        // Without a name, messages have no place.
        let plan = PlanFile::parse(text, "", Path::new(".")).map_err(|e| of_file(&e))?;
        Self::checked(py, plan)
    }

    /// Number of variants.
    fn variants(&self) -> u64 {
        self.sweep.variants()
    }

    /// The plan with its case and every default, which is a plan again.
    fn normal(&self) -> String {
        self.sweep.normal().to_owned()
    }

    /// Number of variants worth computing together.
    fn together(&self) -> u64 {
        self.sweep.together()
    }

    /// The case of a variant, or its rotor above several bearings.
    fn file<'py>(&self, py: Python<'py>, index: u64) -> PyResult<Bound<'py, PyAny>> {
        if index >= self.sweep.variants() {
            let last = self.sweep.variants() - 1;
            return Err(input(format!(
                "variant = {index} is not possible: it must be 0 to {last}"
            )));
        }
        Ok(match self.sweep.file(index).map_err(|e| of_values(&e))? {
            VariantFile::Case(file) => Bound::new(py, CaseFile { file: *file })?.into_any(),
            VariantFile::Rotor(file) => Bound::new(py, RotorFile { file: *file })?.into_any(),
        })
    }

    /// Computes what is missing of a result; `progress` is called with the variants done
    /// and their total.
    fn run(
        &self,
        py: Python<'_>,
        result: PathBuf,
        shard: Option<(u64, u64)>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<()> {
        let job = Job {
            result,
            shard: shard.map(share).transpose()?,
            threads: threads.map(count).transpose()?,
        };
        let signals = Signals::new();
        let (mut reported, mut failed) = (Instant::now(), None);
        let done = py.detach(|| {
            cageless_study::sweep::run(&self.sweep, &job, |now| {
                let due = reported.elapsed() >= REPORT_INTERVAL || now.done == now.total;
                if let Some(progress) = progress.as_ref().filter(|_| due) {
                    reported = Instant::now();
                    let reported = Python::attach(|py| progress.call1(py, (now.done, now.total)));
                    failed = failed.take().or(reported.err());
                }
                break_if(failed.is_some() || signals.stop())
            })
        });
        signals.raised()?;
        if let Some(error) = failed {
            return Err(error);
        }
        done.map_err(|e| of_sweep(&e)).map(|_| ())
    }

    /// Opens a result for others to compute.
    fn collect(&self, py: Python<'_>, result: PathBuf) -> PyResult<Collection> {
        let opened =
            py.detach(|| cageless_study::sweep::Collection::open(&self.sweep, &result, None));
        let opened = opened.map_err(|e| of_sweep(&e))?;
        Ok(Collection {
            open: Mutex::new(Some(opened)),
        })
    }

    /// Computes a range of variants into a file.
    fn write_part(&self, py: Python<'_>, start: u64, end: u64, path: PathBuf) -> PyResult<()> {
        let signals = Signals::new();
        let range = start..end.min(self.sweep.variants());
        let done =
            py.detach(|| write_part(&self.sweep, range, &path, &|| break_if(signals.stop())));
        signals.raised()?;
        done.map_err(|e| of_sweep(&e)).map(|_| ())
    }
}

/// A result in the making, locked against others.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Collection {
    open: Mutex<Option<cageless_study::sweep::Collection>>,
}

#[pymethods]
impl Collection {
    /// Ranges of variants that nobody has computed.
    fn missing(&self, py: Python<'_>) -> PyResult<Vec<(u64, u64)>> {
        let missing = self.with(py, cageless_study::sweep::Collection::missing)?;
        Ok(missing.into_iter().map(|r| (r.start, r.end)).collect())
    }

    /// Number of variants of the result.
    fn total(&self, py: Python<'_>) -> PyResult<u64> {
        self.with(py, |open| Ok(open.total()))
    }

    /// File for the range from `first`.
    fn part(&self, py: Python<'_>, first: u64) -> PyResult<PathBuf> {
        self.with(py, |open| Ok(open.part(first)))
    }

    /// Takes a part that was written elsewhere.
    fn add(&self, py: Python<'_>, first: u64, part: &[u8]) -> PyResult<()> {
        self.with(py, |open| open.add(first, part))
    }

    /// Makes the result if nothing is missing; says whether it did.
    fn finish(&self, py: Python<'_>) -> PyResult<bool> {
        let open = self.open.lock().map_err(other)?.take();
        let open = open.ok_or_else(closed)?;
        py.detach(|| open.finish()).map_err(|e| of_sweep(&e))
    }

    /// Lets go of the result; what is there stays.
    fn close(&self) -> PyResult<()> {
        *self.open.lock().map_err(other)? = None;
        Ok(())
    }
}

impl Collection {
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&cageless_study::sweep::Collection) -> Result<T, SweepError> + Send,
    ) -> PyResult<T> {
        py.detach(|| {
            let open = self.open.lock().map_err(other)?;
            work(open.as_ref().ok_or_else(closed)?).map_err(|e| of_sweep(&e))
        })
    }
}

fn closed() -> PyErr {
    other("this result is closed")
}

impl Sweep {
    fn checked(py: Python<'_>, plan: PlanFile) -> PyResult<Self> {
        let sweep = py.detach(|| cageless_study::sweep::Sweep::new(plan));
        let sweep = sweep.map_err(|e| of_sweep(&e))?;
        Ok(Self { sweep })
    }
}

fn share((number, of): (u64, u64)) -> PyResult<Shard> {
    let refused = || {
        input(format!(
            "shard = ({number}, {of}) is not possible: it must be (I, N) with 1 ≤ I ≤ N"
        ))
    };
    Shard::new(number, of).ok_or_else(refused)
}

/// Joins shards; says how many variants the result has.
#[pyfunction]
pub fn merge(py: Python<'_>, shards: Vec<PathBuf>, result: PathBuf) -> PyResult<u64> {
    let merged = py.detach(|| cageless_study::sweep::merge(&shards, &result));
    merged.map_err(|e| of_sweep(&e))
}
