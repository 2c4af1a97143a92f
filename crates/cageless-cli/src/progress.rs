//! Progress with the time left, on stderr, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_study::{Progress, Work};
use indicatif::{FormattedDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

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

/// Whether the user wants neither progress nor results as text.
static QUIET: AtomicBool = AtomicBool::new(false);

/// From here on progress and results as text are left out.
pub fn be_quiet() {
    QUIET.store(true, Ordering::Relaxed);
}

/// Whether progress and results as text are left out.
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Work shorter than this shows no bar.
const SILENT: Duration = Duration::from_secs(2);
/// Positions of the bar.
const POSITIONS: f64 = 1e4;

/// One bar over all tasks of a command, with the time that is left of the whole.
pub struct Bars<'s> {
    stop: &'s StopFlag,
    bar: ProgressBar,
    started: Instant,
    visible: AtomicBool,
    whole: Mutex<Whole>,
}

impl<'s> Bars<'s> {
    /// A bar that appears once the work has taken a while.
    pub fn new(stop: &'s StopFlag) -> Self {
        let hidden = ProgressDrawTarget::hidden();
        let bar = ProgressBar::with_draw_target(Some(POSITIONS as u64), hidden);
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent:>3} % {prefix}")
        {
            bar.set_style(style);
        }
        Self {
            stop,
            bar,
            started: Instant::now(),
            visible: AtomicBool::new(false),
            whole: Mutex::default(),
        }
    }

    fn add(&self, what: &str, units: f64) {
        let fraction = {
            let mut whole = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
            whole.done += units;
            whole.fraction()
        };
        let elapsed = self.started.elapsed();
        if elapsed < SILENT || is_quiet() {
            return;
        }
        if !self.visible.swap(true, Ordering::Relaxed) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_message(what.to_owned());
        self.bar.set_prefix(times(elapsed, fraction));
        self.bar.set_position((fraction * POSITIONS) as u64);
    }
}

/// Time so far and time left of the whole.
fn times(elapsed: Duration, fraction: f64) -> String {
    let left = elapsed.as_secs_f64() * (1.0 / fraction - 1.0);
    match Duration::try_from_secs_f64(left) {
        Ok(left) if fraction > 0.01 => format!(
            "{} elapsed, {} left",
            FormattedDuration(elapsed),
            FormattedDuration(left)
        ),
        _ => format!("{} elapsed", FormattedDuration(elapsed)),
    }
}

impl Progress for Bars<'_> {
    fn whole(&self, tasks: &[(String, f64)]) {
        let mut whole = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
        whole.announce(tasks);
    }

    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_> {
        let mut whole = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
        let end = whole.begin(what, units);
        Box::new(Task {
            bars: self,
            what: what.to_owned(),
            end,
        })
    }

    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

impl Drop for Bars<'_> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Work that is done, has been begun and is expected, in the units of its tasks.
#[derive(Debug, Default)]
struct Whole {
    done: f64,
    begun: f64,
    /// Tasks in their order, each with its work that has not been begun.
    expected: Vec<(String, f64)>,
}

impl Whole {
    /// Takes tasks with their estimated work, in their order.
    fn announce(&mut self, tasks: &[(String, f64)]) {
        for (what, units) in tasks {
            if !self.expected.iter().any(|(name, _)| name == what) {
                self.expected.push((what.clone(), *units));
            }
        }
    }

    /// Begins a task; those before it are over. Returns the work that is done when it ends.
    fn begin(&mut self, what: &str, units: f64) -> f64 {
        // What an earlier task did less than its estimate is not left to do.
        self.begun = self.begun.min(self.done) + units;
        if let Some(at) = self.expected.iter().position(|(name, _)| name == what) {
            for (_, left) in &mut self.expected[..at] {
                *left = 0.0;
            }
            let left = &mut self.expected[at].1;
            *left = (*left - units).max(0.0);
        }
        self.begun
    }

    /// Fraction of the whole that is done.
    fn fraction(&self) -> f64 {
        let expected: f64 = self.expected.iter().map(|(_, units)| units).sum();
        let total = self.begun.max(self.done) + expected;
        if total > 0.0 { self.done / total } else { 0.0 }
    }
}

/// A task of a command. Threads share it.
struct Task<'b, 's> {
    bars: &'b Bars<'s>,
    what: String,
    /// Work that is done when the task ends.
    end: f64,
}

impl Work for Task<'_, '_> {
    fn add(&self, units: f64) -> Control {
        self.bars.add(&self.what, units);
        self.control()
    }

    fn interrupted(&self) -> bool {
        self.bars.interrupted()
    }
}

impl Drop for Task<'_, '_> {
    fn drop(&mut self) {
        let whole = self.bars.whole.lock();
        let mut whole = whole.unwrap_or_else(PoisonError::into_inner);
        whole.done = self.end;
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{Whole, times};

    fn tasks(list: &[(&str, f64)]) -> Vec<(String, f64)> {
        let owned = |&(name, units): &(&str, f64)| (name.to_owned(), units);
        list.iter().map(owned).collect()
    }

    #[test]
    fn the_time_left_is_that_of_all_tasks() {
        let mut whole = Whole::default();
        whole.announce(&tasks(&[
            ("map", 10.0),
            ("motion", 70.0),
            ("verdict", 20.0),
        ]));
        assert_eq!(whole.begin("map", 10.0), 10.0);
        whole.done += 5.0;
        assert_eq!(whole.fraction(), 0.05);
        assert_eq!(
            times(Duration::from_secs(3), whole.fraction()),
            "00:00:03 elapsed, 00:00:57 left"
        );
        whole.done = 10.0;
        // Less than was expected, in two parts; the rest may still come.
        assert_eq!(whole.begin("motion", 40.0), 50.0);
        whole.done = 50.0;
        assert_eq!(whole.fraction(), 0.5);
        assert_eq!(whole.begin("motion", 10.0), 60.0);
        whole.done = 60.0;
        // A later task tells that the ones before it are over.
        assert_eq!(whole.begin("verdict", 20.0), 80.0);
        assert_eq!(whole.fraction(), 0.75);
        whole.done = 80.0;
        assert_eq!(whole.fraction(), 1.0);
    }

    #[test]
    fn a_task_that_was_not_announced_counts_as_well() {
        let mut whole = Whole::default();
        assert_eq!(whole.fraction(), 0.0);
        whole.begin("run", 1.0);
        whole.done = 0.25;
        assert_eq!(whole.fraction(), 0.25);
        whole.announce(&tasks(&[("run", 1.0), ("verify", 3.0)]));
        assert!(whole.fraction() < 0.1);
    }
}
