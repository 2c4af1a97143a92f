//! Sweeps.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Mutex;

use cageless_io::plan_file::PlanFile;
use cageless_study::sweep::{Job, Shard, write_part};
use cageless_study::{StudyError, break_if};
use pyo3::prelude::*;

use crate::background::Background;
use crate::documents::File;
use crate::errors::{Error, Found, input, of_values, other};

/// A plan that can be computed.
#[pyclass(frozen, module = "cageless._cageless")]
pub struct Sweep {
    sweep: cageless_study::sweep::Sweep,
}

#[pymethods]
impl Sweep {
    /// Reads a plan.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> Found<Self> {
        let plan = PlanFile::read(&path)?;
        Self::checked(py, plan)
    }

    /// Reads the text of a plan, which messages call `name`, without one they have no place; paths in it
    /// count from `folder`.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str, name: &str, folder: PathBuf) -> Found<Self> {
        let plan = PlanFile::parse(text, name, &folder)?;
        Self::checked(py, plan)
    }

    /// Number of variants.
    fn variants(&self) -> u64 {
        self.sweep.variants()
    }

    /// The plan with its case and every default, which is a plan again.
    fn to_toml(&self) -> String {
        self.sweep.normal().to_owned()
    }

    /// Number of variants worth computing together.
    fn together(&self) -> u64 {
        self.sweep.together()
    }

    /// The case of a variant, or its rotor above several bearings.
    fn file(&self, index: u64) -> Found<File> {
        self.sweep.file(index).map(File).map_err(of_values)
    }

    /// Computes what is missing of a result; `progress` gets the variants done and their total as a text.
    fn run(
        &self,
        py: Python<'_>,
        result: PathBuf,
        shard: Option<(u64, u64)>,
        threads: Option<NonZeroUsize>,
        progress: Option<Py<PyAny>>,
    ) -> Found<()> {
        let job = Job {
            result,
            shard: shard.map(|(number, of)| share(number, of)).transpose()?,
            threads,
        };
        Background(Some(NonZeroUsize::MIN), progress).run(py, |progress| {
            cageless_study::sweep::run(&self.sweep, &job, |now| {
                progress.show(&format!("{} {}", now.done, now.total), now.fraction());
                break_if(progress.interrupted())
            })
        })??;
        Ok(())
    }

    /// Opens a result for others to compute.
    fn collect(&self, py: Python<'_>, result: PathBuf) -> Found<Collection> {
        let opened =
            py.detach(|| cageless_study::sweep::Collection::open(&self.sweep, &result, None));
        Ok(Collection {
            open: Mutex::new(Some(opened?)),
        })
    }

    /// Computes a range of variants into a file.
    fn write_part(&self, py: Python<'_>, start: u64, end: u64, path: PathBuf) -> Found<()> {
        let range = start..end.min(self.sweep.variants());
        Background(Some(NonZeroUsize::MIN), None).run(py, |progress| {
            let stop = || break_if(progress.interrupted());
            write_part(&self.sweep, range, &path, &stop)
        })??;
        Ok(())
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
    fn missing(&self, py: Python<'_>) -> Found<Vec<(u64, u64)>> {
        let missing = self.with(py, cageless_study::sweep::Collection::missing)?;
        Ok(missing.into_iter().map(|r| (r.start, r.end)).collect())
    }

    /// File for the range from `first`.
    fn part(&self, py: Python<'_>, first: u64) -> Found<PathBuf> {
        self.with(py, |open| Ok(open.part(first)))
    }

    /// Takes a part that was written elsewhere.
    fn add(&self, py: Python<'_>, first: u64, part: &[u8]) -> Found<()> {
        self.with(py, |open| open.add(first, part))
    }

    /// Makes the result if nothing is missing; says whether it did.
    fn finish(&self, py: Python<'_>) -> Found<bool> {
        let open = self.open.lock().map_err(other)?.take();
        let open = open.ok_or_else(closed)?;
        Ok(py.detach(|| open.finish())?)
    }

    /// Lets go of the result; what is there stays.
    fn close(&self) -> Found<()> {
        *self.open.lock().map_err(other)? = None;
        Ok(())
    }
}

impl Collection {
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&cageless_study::sweep::Collection) -> Result<T, StudyError> + Send,
    ) -> Found<T> {
        py.detach(|| {
            let open = self.open.lock().map_err(other)?;
            Ok(work(open.as_ref().ok_or_else(closed)?)?)
        })
    }
}

fn closed() -> Error {
    other("this result is closed")
}

impl Sweep {
    fn checked(py: Python<'_>, plan: PlanFile) -> Found<Self> {
        let sweep = py.detach(|| cageless_study::sweep::Sweep::new(plan))?;
        Ok(Self { sweep })
    }
}

fn share(number: u64, of: u64) -> Found<Shard> {
    let problem = "is not possible: it must be (I, N) with 1 ≤ I ≤ N";
    let refused = || input(format!("shard = ({number}, {of}) {problem}"));
    Shard::new(number, of).ok_or_else(refused)
}

/// Joins shards; says how many variants the result has.
#[pyfunction]
pub fn merge(py: Python<'_>, shards: Vec<PathBuf>, result: PathBuf) -> Found<u64> {
    Ok(py.detach(|| cageless_study::sweep::merge(&shards, &result))?)
}
