//! Computations in the background: they run on their own threads while the calling thread handles
//! signals and progress.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::thread::Builder;
use std::time::{Duration, Instant};

use cageless_study::{Progress, StudyError, Workload, on_threads};
use pyo3::prelude::*;

use crate::errors::{Found, input};

/// Interval between checks for signals.
const EVERY: Duration = Duration::from_millis(20);
/// Interval between progress callbacks.
const REPORT_INTERVAL: Duration = Duration::from_millis(100);

/// Number of threads and progress callback, which gets the name of the task under way and the completed
/// fraction of the whole.
#[derive(FromPyObject)]
pub struct Background(pub Option<NonZeroUsize>, pub Option<Py<PyAny>>);

impl Background {
    /// One thread if `alone`, else the number of threads as given, with the same callback.
    pub fn on_one(self, alone: bool) -> Self {
        let Self(threads, callback) = self;
        Self(alone.then_some(NonZeroUsize::MIN).or(threads), callback)
    }

    /// Runs `work` with the interpreter unlocked, handling Ctrl-C and progress callbacks.
    pub fn run<T: Send>(
        self,
        py: Python<'_>,
        work: impl FnOnce(&dyn Progress) -> T + Send,
    ) -> Found<T> {
        let Self(threads, callback) = self;
        let relay = ProgressRelay::default();
        let mut failed: Option<PyErr> = None;
        let done = py.detach(|| {
            std::thread::scope(|scope| {
                let (sender, receiver) = sync_channel(1);
                let relay = &relay;
                let started = Builder::new().spawn_scoped(scope, move || {
                    // The receiver waits for nothing else.
                    let _ = sender.send(on_threads(threads, || work(relay)));
                });
                if let Err(error) = started {
                    return Some(Err(StudyError::threads(&error)));
                }
                let mut reported = Instant::now();
                loop {
                    let done = match receiver.recv_timeout(EVERY) {
                        Ok(done) => Some(done),
                        // The thread has panicked; joining it propagates the panic.
                        Err(RecvTimeoutError::Disconnected) => return None,
                        Err(RecvTimeoutError::Timeout) => None,
                    };
                    let due = done.is_some() || reported.elapsed() >= REPORT_INTERVAL;
                    if let (Some(callback), None, true) = (&callback, &failed, due) {
                        reported = Instant::now();
                        failed = relay.tell(callback).err();
                    }
                    // The interpreter answers the thread that called us, if it is its main thread.
                    if let Err(error) = Python::attach(|py| py.check_signals()) {
                        failed.get_or_insert(error);
                    }
                    relay.stop.store(failed.is_some(), Ordering::Relaxed);
                    if done.is_some() {
                        return done;
                    }
                }
            })
        });
        match (failed, done) {
            (Some(error), _) => Err(error.into()),
            (None, Some(done)) => Ok(done?),
            (None, None) => Err(input("the work has ended without a result")),
        }
    }
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
    fn tell(&self, callback: &Py<PyAny>) -> PyResult<()> {
        let now = self.now.lock();
        let Some(now) = now.unwrap_or_else(PoisonError::into_inner).clone() else {
            return Ok(());
        };
        Python::attach(|py| callback.call1(py, now)).map(|_| ())
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
