//! Progress with the time left, on stderr, and Ctrl-C.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_study::{Progress, Work};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Set once the user has asked to stop.
pub type StopFlag = Arc<AtomicBool>;

/// Lets Ctrl-C end the work in good order; a second one ends it at once.
pub fn catch_interrupt() -> StopFlag {
    let flag = StopFlag::default();
    let seen = Arc::clone(&flag);
    // Without a handler Ctrl-C ends the process as it always does.
    let _ = ctrlc::set_handler(move || {
        if seen.swap(true, Ordering::Relaxed) {
            std::process::exit(1);
        }
        eprintln!("\ninterrupted: finishing the files; once more to quit at once");
    });
    flag
}

/// Work shorter than this shows no bar.
const SILENT: Duration = Duration::from_secs(2);
/// Parts into which a unit of work is divided.
const PARTS: f64 = 1e4;

/// A bar over a known amount of work, in units that the caller chooses. Threads share it.
pub struct Bar {
    bar: ProgressBar,
    started: Instant,
    visible: AtomicBool,
    done: AtomicU64,
    stop: StopFlag,
}

impl Bar {
    /// `total` units of work to do.
    pub fn new(what: &str, total: f64, stop: &StopFlag) -> Self {
        let bar = ProgressBar::with_draw_target(
            Some((total * PARTS) as u64),
            ProgressDrawTarget::hidden(),
        );
        if let Ok(style) = ProgressStyle::with_template(
            "{msg} {wide_bar} {percent:>3} % {elapsed} elapsed, {eta} left",
        ) {
            bar.set_style(style);
        }
        bar.set_message(what.to_owned());
        Self {
            bar,
            started: Instant::now(),
            visible: AtomicBool::new(false),
            done: AtomicU64::new(0),
            stop: Arc::clone(stop),
        }
    }
}

impl Work for Bar {
    fn add(&self, units: f64) -> Control {
        let parts = (units * PARTS) as u64;
        let done = self.done.fetch_add(parts, Ordering::Relaxed) + parts;
        if self.started.elapsed() > SILENT {
            if !self.visible.swap(true, Ordering::Relaxed) {
                self.bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            self.bar.set_position(done);
        }
        self.control()
    }

    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// Shows each part of a study as a bar.
pub struct Bars<'s>(pub &'s StopFlag);

impl Progress for Bars<'_> {
    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_> {
        Box::new(Bar::new(what, units, self.0))
    }

    fn interrupted(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
