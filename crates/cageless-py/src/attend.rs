//! Studies: they work on threads of their own, and the thread that called us listens.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_study::{THREADS_MAX, Watcher, Work, on_threads};
use pyo3::prelude::*;

use crate::errors::{input, of_study};
use crate::signals::Signals;

/// How often signals are looked for.
const EVERY: Duration = Duration::from_millis(20);
/// How often a caller hears of the progress.
const TELL_EVERY: Duration = Duration::from_millis(100);
/// Parts into which a unit of work is divided.
const PARTS: f64 = 1e6;

/// Where and how a study is done.
pub struct Attendance {
    pub threads: Option<NonZeroUsize>,
    /// Called with what is being done and its share that is done.
    pub progress: Option<Py<PyAny>>,
}

impl Attendance {
    pub fn new(threads: Option<i64>, progress: Option<Py<PyAny>>) -> PyResult<Self> {
        let threads = threads.map(count).transpose()?;
        Ok(Self { threads, progress })
    }

    /// Does `work` while the interpreter goes on, hears Ctrl-C and tells of the progress.
    pub fn attend<T: Send>(
        self,
        py: Python<'_>,
        work: impl FnOnce(&dyn Watcher) -> T + Send,
    ) -> PyResult<T> {
        let (signals, ear) = (Signals::new(), Ear::default());
        let mut failed: Option<PyErr> = None;
        let done = py.detach(|| {
            std::thread::scope(|scope| {
                let (sender, receiver) = sync_channel(1);
                let ear = &ear;
                scope.spawn(move || {
                    // The receiver waits for nothing else.
                    let _ = sender.send(on_threads(self.threads, || work(ear)));
                });
                let mut told = Instant::now();
                loop {
                    match receiver.recv_timeout(EVERY) {
                        Ok(done) => return Some(done),
                        // The thread has panicked, which goes on when it is joined.
                        Err(RecvTimeoutError::Disconnected) => return None,
                        Err(RecvTimeoutError::Timeout) => {}
                    }
                    if let Some(progress) = &self.progress
                        && failed.is_none()
                        && told.elapsed() >= TELL_EVERY
                    {
                        told = Instant::now();
                        failed = ear.tell(progress).err();
                    }
                    if failed.is_some() || signals.stop() {
                        ear.stop.store(true, Ordering::Relaxed);
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

/// What the threads say, and whether they are to end.
#[derive(Default)]
struct Ear {
    stop: AtomicBool,
    /// What is being done, and its units.
    now: Mutex<Option<(String, f64)>>,
    done: AtomicU64,
}

impl Ear {
    fn tell(&self, progress: &Py<PyAny>) -> PyResult<()> {
        let now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        let Some((what, units)) = now.clone() else {
            return Ok(());
        };
        drop(now);
        let done = self.done.load(Ordering::Relaxed) as f64 / PARTS;
        let share = (done / units).clamp(0.0, 1.0);
        Python::attach(|py| progress.call1(py, (what, share))).map(|_| ())
    }
}

impl Watcher for Ear {
    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_> {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        self.done.store(0, Ordering::Relaxed);
        *now = Some((what.to_owned(), units));
        Box::new(Part(self))
    }

    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

struct Part<'e>(&'e Ear);

impl Work for Part<'_> {
    fn add(&self, units: f64) -> Control {
        let parts = (units * PARTS) as u64;
        self.0.done.fetch_add(parts, Ordering::Relaxed);
        if self.interrupted() {
            Control::Interrupt
        } else {
            Control::Continue
        }
    }

    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}
