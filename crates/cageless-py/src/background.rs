//! Studies in the background: they run on their own threads while the calling thread handles signals
//! and progress.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use cageless_study::{Progress, THREADS_MAX, Workload, on_threads};
use pyo3::prelude::*;

use crate::errors::{input, of_study};
use crate::signals::Signals;

/// Interval between checks for signals.
const EVERY: Duration = Duration::from_millis(20);
/// Interval between progress callbacks.
const REPORT_INTERVAL: Duration = Duration::from_millis(100);

/// Threads and progress callback of a study.
pub struct Background {
    pub threads: Option<NonZeroUsize>,
    /// Called with the name of the task under way and the completed fraction of the whole.
    pub progress: Option<Py<PyAny>>,
}

impl Background {
    pub fn new(threads: Option<i64>, progress: Option<Py<PyAny>>) -> PyResult<Self> {
        let threads = threads.map(count).transpose()?;
        Ok(Self { threads, progress })
    }

    /// Runs `work` with the interpreter unlocked, handling Ctrl-C and progress callbacks.
    pub fn run<T: Send>(
        self,
        py: Python<'_>,
        work: impl FnOnce(&dyn Progress) -> T + Send,
    ) -> PyResult<T> {
        let (signals, relay) = (Signals::new(), ProgressRelay::default());
        let mut failed: Option<PyErr> = None;
        let done = py.detach(|| {
            std::thread::scope(|scope| {
                let (sender, receiver) = sync_channel(1);
                let relay = &relay;
                scope.spawn(move || {
                    // The receiver waits for nothing else.
                    let _ = sender.send(on_threads(self.threads, || work(relay)));
                });
                let mut reported = Instant::now();
                loop {
                    match receiver.recv_timeout(EVERY) {
                        Ok(done) => return Some(done),
                        // The thread has panicked; joining it propagates the panic.
                        Err(RecvTimeoutError::Disconnected) => return None,
                        Err(RecvTimeoutError::Timeout) => {}
                    }
                    if let Some(progress) = &self.progress
                        && failed.is_none()
                        && reported.elapsed() >= REPORT_INTERVAL
                    {
                        reported = Instant::now();
                        failed = relay.tell(progress).err();
                    }
                    if failed.is_some() || signals.stop() {
                        relay.stop.store(true, Ordering::Relaxed);
                    }
                }
            })
        });
        signals.raised()?;
        match (failed, done) {
            (Some(error), _) => Err(error),
            (None, Some(done)) => done.map_err(|error| of_study(&error)),
            (None, None) => Err(input("the work has ended without a result")),
        }
    }
}

/// A number of threads.
pub fn count(threads: i64) -> PyResult<NonZeroUsize> {
    let count = usize::try_from(threads).ok().and_then(NonZeroUsize::new);
    count.ok_or_else(|| {
        input(format!(
            "threads = {threads} is not possible: 1 to {THREADS_MAX} are"
        ))
    })
}

/// Progress of the worker threads and the request to cancel them.
#[derive(Default)]
struct ProgressRelay {
    stop: AtomicBool,
    workload: Mutex<Workload>,
    /// Task under way and completed fraction of the whole.
    now: Mutex<Option<(String, f64)>>,
}

impl ProgressRelay {
    fn tell(&self, progress: &Py<PyAny>) -> PyResult<()> {
        let now = self.now.lock();
        let Some(now) = now.unwrap_or_else(PoisonError::into_inner).clone() else {
            return Ok(());
        };
        Python::attach(|py| progress.call1(py, now)).map(|_| ())
    }
}

impl Progress for ProgressRelay {
    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, task: &str, fraction: f64) {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        *now = Some((task.to_owned(), fraction));
    }
}
