//! Progress with the time left, on stderr, and Ctrl-C.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use cageless_io::on_terminal;
use cageless_study::{KNOWN, Progress, Workload, time_left};
use indicatif::{FormattedDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Writes a line to stderr, without control sequences. Where nothing reads it, it is lost and the command
/// goes on.
pub fn message(text: &str) {
    let _ = writeln!(std::io::stderr(), "{}", on_terminal(text));
}

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
        message("\ninterrupted: finishing the files; once more to quit at once");
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
/// Work that takes less in all prints no lines where stderr is no terminal.
const SILENT_LINES: Duration = Duration::from_secs(10);
/// Positions of the bar.
const POSITIONS: f64 = 1e4;

/// One bar over all tasks of a command, with the time that is left of the whole.
pub struct Bars<'s> {
    stop: &'s StopFlag,
    bar: ProgressBar,
    started: Instant,
    visible: AtomicBool,
    /// Lines so far, where stderr is no terminal.
    lines: AtomicUsize,
    workload: Mutex<Workload>,
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
            lines: AtomicUsize::new(0),
            workload: Mutex::default(),
        }
    }
}

/// Number of lines that are due without a terminal: one as soon as the time left is known, then one
/// for each tenth.
fn lines_due(fraction: f64) -> usize {
    usize::from(fraction > KNOWN) + (10.0 * fraction) as usize
}

/// Time so far and time left of the whole.
fn times(elapsed: Duration, fraction: f64) -> String {
    let so_far = format!("{} elapsed", FormattedDuration(elapsed));
    match time_left(elapsed, fraction) {
        Some(left) => format!("{so_far}, {} left", FormattedDuration(left)),
        None => so_far,
    }
}

impl Progress for Bars<'_> {
    fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, task: &str, fraction: f64) {
        let elapsed = self.started.elapsed();
        if elapsed < SILENT || is_quiet() {
            return;
        }
        if !std::io::stderr().is_terminal() {
            let whole = elapsed + time_left(elapsed, fraction).unwrap_or_default();
            let due = lines_due(fraction);
            if whole >= SILENT_LINES && due > self.lines.fetch_max(due, Ordering::Relaxed) {
                let times = times(elapsed, fraction);
                message(&format!(
                    "progress: {task}: {:.0} %, {times}",
                    100.0 * fraction
                ));
            }
            return;
        }
        if !self.visible.swap(true, Ordering::Relaxed) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_message(task.to_owned());
        self.bar.set_prefix(times(elapsed, fraction));
        self.bar.set_position((fraction * POSITIONS) as u64);
    }
}

impl Drop for Bars<'_> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{lines_due, times};

    #[test]
    fn the_time_left_follows_from_the_fraction_that_is_done() {
        assert_eq!(
            times(Duration::from_secs(3), 0.05),
            "00:00:03 elapsed, 00:00:57 left"
        );
    }

    #[test]
    fn without_a_terminal_there_is_a_line_at_once_and_for_each_tenth() {
        let due = [0.0005, 0.02, 0.09, 0.1, 0.55, 1.0].map(lines_due);
        assert_eq!(due, [0, 1, 1, 2, 6, 11]);
    }
}
