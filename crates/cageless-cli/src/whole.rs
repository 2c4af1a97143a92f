//! Progress over all tasks of one piece of work.

use std::sync::{Mutex, PoisonError};

use cageless::simulation::Control;
use cageless_study::{Progress, Work};

/// A progress that shows the fraction of the whole that is done.
pub trait Display: Progress {
    /// Its tasks.
    fn tasks(&self) -> &Mutex<Whole>;

    /// Shows the fraction while the task `what` is under way.
    fn show(&self, what: &str, fraction: f64);
}

/// Work that is done, has been begun and is expected, in the units of its tasks.
#[derive(Debug, Default)]
pub struct Whole {
    done: f64,
    begun: f64,
    /// Tasks in their order, each with its work that has not been begun.
    expected: Vec<(String, f64)>,
}

impl Whole {
    /// Takes tasks with their estimated work, in their order.
    pub fn announce(&mut self, tasks: &[(String, f64)]) {
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

/// A task under way. Threads share it.
pub struct Task<'d, D: Display> {
    display: &'d D,
    what: String,
    /// Work that is done when the task ends.
    end: f64,
}

impl<'d, D: Display> Task<'d, D> {
    /// Begins the task `what` of `units`.
    pub fn begin(display: &'d D, what: &str, units: f64) -> Self {
        let tasks = display.tasks().lock();
        let end = tasks
            .unwrap_or_else(PoisonError::into_inner)
            .begin(what, units);
        Self {
            display,
            what: what.to_owned(),
            end,
        }
    }
}

impl<D: Display> Work for Task<'_, D> {
    fn add(&self, units: f64) -> Control {
        let fraction = {
            let tasks = self.display.tasks().lock();
            let mut whole = tasks.unwrap_or_else(PoisonError::into_inner);
            whole.done += units;
            whole.fraction()
        };
        self.display.show(&self.what, fraction);
        self.control()
    }

    fn interrupted(&self) -> bool {
        self.display.interrupted()
    }
}

impl<D: Display> Drop for Task<'_, D> {
    fn drop(&mut self) {
        let tasks = self.display.tasks().lock();
        let mut whole = tasks.unwrap_or_else(PoisonError::into_inner);
        whole.done = self.end;
    }
}

#[cfg(test)]
mod tests {
    use super::Whole;

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
