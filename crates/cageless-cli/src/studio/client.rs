//! The page that waits for an answer.

use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use axum::body::Bytes;
use cageless_live::Control;
use cageless_study::{Progress, Workload, break_if};
use tokio::sync::mpsc;

use crate::interrupt::StopFlag;

/// Time between two reports of progress.
const PROGRESS_EVERY: Duration = Duration::from_millis(100);

/// Lines of an answer on their way to the page.
pub type Lines = mpsc::Sender<Result<Bytes, std::convert::Infallible>>;

/// A page that waits for an answer: it gets the progress, and its leaving ends the work.
pub struct Client<'s> {
    lines: &'s Lines,
    stop: &'s StopFlag,
    began: Instant,
    longest: Duration,
    reported: Mutex<Instant>,
    workload: Mutex<Workload>,
}

impl<'s> Client<'s> {
    /// A page whose request may be computed for `longest`.
    pub fn new(lines: &'s Lines, stop: &'s StopFlag, longest: Duration) -> Self {
        let began = Instant::now();
        Self {
            lines,
            stop,
            began,
            longest,
            reported: Mutex::new(began),
            workload: Mutex::default(),
        }
    }

    /// Whether the computation has taken too long.
    pub fn late(&self) -> bool {
        self.began.elapsed() > self.longest
    }

    /// Reports the fraction that is done, and ends the work once nobody waits for it, the server
    /// ends, or it has taken too long.
    pub fn control(&self, fraction: f64) -> Control {
        let mut reported = self.reported.lock().unwrap_or_else(PoisonError::into_inner);
        if reported.elapsed() > PROGRESS_EVERY {
            *reported = Instant::now();
            let line = format!("{{\"progress\":{fraction:.4}}}\n");
            // Of progress, what the page does not take in time is left out.
            let _ = self.lines.try_send(Ok(line.into()));
        }
        break_if(self.interrupted())
    }
}

impl Progress for Client<'_> {
    fn interrupted(&self) -> bool {
        self.late() || self.lines.is_closed() || self.stop.load(Ordering::Relaxed)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, _: &str, fraction: f64) {
        // The task asks by itself for an end of the work.
        let _ = self.control(fraction);
    }
}
