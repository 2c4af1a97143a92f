//! Progress with the time left, and cancellation.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cageless::simulation::Control;

/// `Break(())` if `interrupted`, else `Continue(())`.
pub fn break_if(interrupted: bool) -> Control {
    if interrupted {
        Control::Break(())
    } else {
        Control::Continue(())
    }
}

/// Receiver of the progress of long work, task by task.
pub trait Progress: Sync {
    /// Whether cancellation is requested.
    fn interrupted(&self) -> bool;

    /// Work of all tasks of one whole; `None` if nothing is shown.
    fn workload(&self) -> Option<&Mutex<Workload>> {
        None
    }

    /// Shows the fraction of the whole that is done while `task` is under way.
    fn show(&self, task: &str, fraction: f64) {
        let _ = (task, fraction);
    }
}

impl dyn Progress + '_ {
    /// Announces the tasks of one whole in their order, each with an estimate of its work. A task
    /// may be begun more than once, or not at all. Tasks that are known already keep their
    /// estimate.
    pub fn whole(&self, tasks: &[(String, f64)]) {
        if let Some(mut workload) = self.locked() {
            workload.announce(tasks);
        }
    }

    /// Begins a task of `units`, a dimensionless estimate of its work.
    pub fn begin(&self, task: &str, units: f64) -> Work<'_> {
        let begun = self.locked().map(|mut workload| {
            let end = workload.begin(task, units);
            (end, workload.fraction())
        });
        if let Some((_, fraction)) = begun {
            self.show(task, fraction);
        }
        Work {
            progress: self,
            task: task.to_owned(),
            end: begun.map_or(0.0, |(end, _)| end),
        }
    }

    fn locked(&self) -> Option<MutexGuard<'_, Workload>> {
        let lock = self.workload()?.lock();
        Some(lock.unwrap_or_else(PoisonError::into_inner))
    }
}

/// Task in progress until dropped; shared between threads.
pub struct Work<'p> {
    progress: &'p dyn Progress,
    task: String,
    /// Units of the whole that are done when the task ends.
    end: f64,
}

impl Work<'_> {
    /// Reports `units` of further work done and returns whether to continue.
    pub fn add(&self, units: f64) -> Control {
        let fraction = self.progress.locked().map(|mut workload| {
            workload.done += units;
            workload.fraction()
        });
        if let Some(fraction) = fraction {
            self.progress.show(&self.task, fraction);
        }
        self.control()
    }

    /// Whether cancellation is requested.
    pub fn interrupted(&self) -> bool {
        self.progress.interrupted()
    }

    /// `Break(())` once cancellation is requested.
    pub fn control(&self) -> Control {
        break_if(self.interrupted())
    }

    /// Control of one run of `duration_s` that counts as `units`; a duration of 1 for work that
    /// reports its completed fraction.
    pub fn run_control<'s>(
        &'s self,
        duration_s: f64,
        units: f64,
    ) -> Box<dyn FnMut(f64) -> Control + 's> {
        let mut reported = 0.0;
        Box::new(move |time_s| {
            let fraction = (time_s / duration_s).min(1.0);
            let more = (fraction - reported) * units;
            if more < LEAST && !self.interrupted() {
                return Control::Continue(());
            }
            reported = fraction;
            self.add(more)
        })
    }
}

impl Drop for Work<'_> {
    fn drop(&mut self) {
        if let Some(mut workload) = self.progress.locked() {
            workload.done = self.end;
        }
    }
}

/// Smallest increment worth reporting.
const LEAST: f64 = 1e-4;

/// Work that is done, has been begun and is expected, in the units of its tasks.
#[derive(Debug, Default)]
pub struct Workload {
    done: f64,
    begun: f64,
    /// Tasks in their order, each with its work that has not been begun.
    expected: Vec<(String, f64)>,
}

impl Workload {
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

/// Fraction of the whole from which on the time left is known.
pub const KNOWN: f64 = 0.001;

/// Time left of a whole of which a fraction is done; `None` while too little is.
pub fn time_left(elapsed: Duration, fraction: f64) -> Option<Duration> {
    let left_s = elapsed.as_secs_f64() * (1.0 / fraction - 1.0);
    (fraction > KNOWN)
        .then(|| Duration::try_from_secs_f64(left_s).ok())
        .flatten()
}

/// Shows nothing and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {
    fn interrupted(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{Workload, time_left};

    fn tasks(list: &[(&str, f64)]) -> Vec<(String, f64)> {
        let owned = |&(name, units): &(&str, f64)| (name.to_owned(), units);
        list.iter().map(owned).collect()
    }

    #[test]
    fn the_time_left_is_that_of_all_tasks() {
        let mut whole = Workload::default();
        whole.announce(&tasks(&[
            ("map", 10.0),
            ("motion", 70.0),
            ("verdict", 20.0),
        ]));
        assert_eq!(whole.begin("map", 10.0), 10.0);
        whole.done += 5.0;
        assert_eq!(whole.fraction(), 0.05);
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
    fn a_task_that_was_not_announced_is_a_part_of_the_whole() {
        let mut whole = Workload::default();
        assert_eq!(whole.fraction(), 0.0);
        whole.begin("run", 1.0);
        whole.done = 0.25;
        assert_eq!(whole.fraction(), 0.25);
        whole.announce(&tasks(&[("run", 1.0), ("verify", 3.0)]));
        assert!(whole.fraction() < 0.1);
    }

    #[test]
    fn the_time_left_follows_from_the_fraction_that_is_done() {
        let left = |fraction| time_left(Duration::from_secs(3), fraction);
        let rounded = |fraction| left(fraction).map(|left| left.as_secs_f64().round());
        assert_eq!(rounded(0.05), Some(57.0));
        assert_eq!(rounded(1.0), Some(0.0));
        assert_eq!([left(0.001), left(f64::NAN)], [None, None]);
    }
}
