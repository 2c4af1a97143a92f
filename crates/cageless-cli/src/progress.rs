//! Progress with the time left, on stderr.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use cageless_io::on_terminal;
use cageless_study::{Expected, Progress, Workload, about, threads, time_left};
use indicatif::{FormattedDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::interrupt::Interrupt;

/// Writes a line to stderr, without control sequences. Where nothing reads it, it is lost and the command
/// goes on.
pub fn message(text: &str) {
    let _ = writeln!(std::io::stderr(), "{}", on_terminal(text));
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
/// Work that takes less in all announces no time, and prints no lines where stderr is no terminal.
const SILENT_LINES: Duration = Duration::from_secs(10);
/// Positions of the bar.
const POSITIONS: f64 = 1e4;
/// Time between two looks of the heartbeat.
const HEARTBEAT: Duration = Duration::from_millis(500);

/// One bar over all tasks of a command, with the time that is left of the whole; where stderr is no terminal, a line
/// now and then.
pub struct Bars<'s> {
    stop: &'s Interrupt,
    shared: Arc<Shared>,
    workload: Mutex<Workload>,
}

/// Text that the heartbeat repeats, so that a task that asks seldom is not silent.
struct Shared {
    bar: ProgressBar,
    started: Instant,
    visible: AtomicBool,
    ended: AtomicBool,
    now: Mutex<Now>,
}

/// Progress so far.
#[derive(Default)]
struct Now {
    task: String,
    fraction: f64,
    /// Time and fraction of the last line.
    told: Option<(Duration, f64)>,
}

impl<'s> Bars<'s> {
    /// A bar that appears once the work has taken a while.
    pub fn new(stop: &'s Interrupt) -> Self {
        let hidden = ProgressDrawTarget::hidden();
        let bar = ProgressBar::with_draw_target(Some(POSITIONS as u64), hidden);
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent:>3} % {prefix}")
        {
            bar.set_style(style);
        }
        let shared = Arc::new(Shared {
            bar,
            started: Instant::now(),
            visible: AtomicBool::new(false),
            ended: AtomicBool::new(false),
            now: Mutex::default(),
        });
        let beating = Arc::clone(&shared);
        let heartbeat = move || {
            while !beating.ended.load(Ordering::Relaxed) {
                std::thread::park_timeout(HEARTBEAT);
                beating.tell();
            }
        };
        // Where no thread can start, tasks are shown when they ask.
        if !is_quiet() {
            let _ = std::thread::Builder::new().spawn(heartbeat);
        }
        Self {
            stop,
            shared,
            workload: Mutex::default(),
        }
    }
}

/// Whether a line is due without a terminal, `since` the last and so much `further`, of work that takes `whole`: one
/// for each tenth, and one every ten seconds, of long work every hundredth or minute.
fn is_due(since: Duration, further: f64, whole: Duration) -> bool {
    let seldom = (whole / 100).clamp(Duration::from_secs(10), Duration::from_secs(60));
    further >= 0.1 || since >= seldom
}

/// Time so far and time left of the whole.
fn times(elapsed: Duration, fraction: f64) -> String {
    let so_far = format!("{} elapsed", FormattedDuration(elapsed));
    match time_left(elapsed, fraction) {
        Some(left) => format!("{so_far}, {} left", FormattedDuration(left)),
        None => so_far,
    }
}

impl Shared {
    fn now(&self) -> MutexGuard<'_, Now> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Shows the progress so far, if it is due.
    fn tell(&self) {
        let elapsed = self.started.elapsed();
        if elapsed < SILENT || is_quiet() || self.ended.load(Ordering::Relaxed) {
            return;
        }
        let mut now = self.now();
        if now.task.is_empty() {
            return;
        }
        if std::io::stderr().is_terminal() {
            if !self.visible.swap(true, Ordering::Relaxed) {
                self.bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            self.bar.set_message(now.task.clone());
            self.bar.set_prefix(times(elapsed, now.fraction));
            self.bar.set_position((now.fraction * POSITIONS) as u64);
            return;
        }
        let whole = elapsed + time_left(elapsed, now.fraction).unwrap_or_default();
        let (last, before) = now.told.unwrap_or_default();
        if whole >= SILENT_LINES && is_due(elapsed - last, now.fraction - before, whole) {
            now.told = Some((elapsed, now.fraction));
            let (task, percent) = (&now.task, 100.0 * now.fraction);
            let times = times(elapsed, now.fraction);
            message(&format!("progress: {task}: {percent:.0} %, {times}"));
        }
    }
}

impl Progress for Bars<'_> {
    fn interrupted(&self) -> bool {
        let asked = self.stop.asked();
        if asked && self.stop.is_new() {
            message("\ninterrupted: finishing the files; once more to quit at once");
        }
        asked
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn announces(&self) -> bool {
        !is_quiet()
    }

    fn expects(&self, expected: Expected) {
        if let Some(time_s) = expected.time_s {
            announce_long(time_s, threads::count());
        }
    }

    fn show(&self, task: &str, fraction: f64) {
        let mut now = self.shared.now();
        if now.task != task {
            task.clone_into(&mut now.task);
        }
        now.fraction = fraction;
        drop(now);
        self.shared.tell();
    }
}

/// Says how long work on so many threads will take, unless it is soon done.
pub fn announce_long(time_s: f64, threads: usize) {
    if time_s < SILENT_LINES.as_secs_f64() {
        return;
    }
    let on = match threads {
        1 => "1 thread".to_owned(),
        threads => format!("{threads} threads"),
    };
    message(&format!("takes {} on {on}", about(time_s)));
}

impl Drop for Bars<'_> {
    fn drop(&mut self) {
        self.shared.ended.store(true, Ordering::Relaxed);
        // A line that is being written ends first.
        drop(self.shared.now());
        self.shared.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{is_due, times};

    #[test]
    fn the_time_left_follows_from_the_fraction_that_is_done() {
        assert_eq!(
            times(Duration::from_secs(3), 0.05),
            "00:00:03 elapsed, 00:00:57 left"
        );
    }

    /// Announcements of a minute, 80 minutes and two days.
    #[test]
    fn without_a_terminal_there_is_a_line_for_each_tenth_and_now_and_then() {
        for (whole_s, seldom_s) in [(60, 10), (4800, 48), (172_800, 60)] {
            let due = |since_s, further| {
                let whole = Duration::from_secs(whole_s);
                is_due(Duration::from_secs(since_s), further, whole)
            };
            assert!(due(0, 0.1) && !due(0, 0.099));
            assert!(due(seldom_s, 0.0) && !due(seldom_s - 1, 0.05));
        }
    }
}
