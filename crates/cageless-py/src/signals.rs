//! Ctrl-C while the library computes.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// The interpreter is asked this often.
const EVERY: Duration = Duration::from_millis(50);

/// Asks the interpreter for signals now and then, from the thread that called us: it
/// answers its main thread only.
pub struct Signals {
    state: Mutex<(Instant, Option<PyErr>)>,
}

impl Signals {
    pub fn new() -> Self {
        Self {
            state: Mutex::new((Instant::now(), None)),
        }
    }

    /// Whether to give up.
    pub fn stop(&self) -> bool {
        let Ok(mut state) = self.state.lock() else {
            return true;
        };
        if state.1.is_none() && state.0.elapsed() >= EVERY {
            state.0 = Instant::now();
            state.1 = Python::attach(|py| py.check_signals()).err();
        }
        state.1.is_some()
    }

    /// The exception that a signal has raised.
    pub fn raised(self) -> PyResult<()> {
        match self.state.into_inner() {
            Ok((_, Some(error))) => Err(error),
            _ => Ok(()),
        }
    }
}
