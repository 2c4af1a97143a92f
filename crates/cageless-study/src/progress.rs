//! Progress with the time left, and cancellation.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use cageless::simulation::Control;

use crate::interruption::break_if;
use crate::task::{Task, times_s};

/// Expected work of tasks: steps, and time, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Steps of all runs; bearings side by side count one by one.
    pub steps: f64,
    /// Time on the threads of the pool, s; `None` unless [`Progress::announces`].
    pub time_s: Option<f64>,
}

/// Receiver of the progress of long work, task by task.
pub trait Progress: Sync {
    /// Whether cancellation is requested.
    fn interrupted(&self) -> bool;

    /// Work of all tasks of one whole; `None` if nothing is shown.
    fn workload(&self) -> Option<&Mutex<Workload>> {
        None
    }

    /// Whether the time of the whole is wanted before it starts.
    fn announces(&self) -> bool {
        false
    }

    /// Takes what new tasks of the whole are expected to take, before they start.
    fn expects(&self, expected: Expected) {
        let _ = expected;
    }

    /// Shows the fraction of the whole that is done while `task` is under way.
    fn show(&self, task: &str, fraction: f64) {
        let _ = (task, fraction);
    }
}

impl dyn Progress + '_ {
    /// Announces the tasks of one whole in their order. A task may be begun more than once, or not at all. Tasks that
    /// are known already keep their estimate.
    pub fn whole(&self, tasks: &[Task]) {
        let new = tasks.iter().filter(|task| self.wants(&task.name));
        let tasks: Vec<Task> = new.cloned().collect();
        if tasks.is_empty() {
            return;
        }
        // Without anyone who wants to know, a step takes as long as another.
        let times_s = self
            .announces()
            .then(|| times_s(&tasks, &|| self.interrupted()));
        let weights = match &times_s {
            Some(times_s) => times_s.clone(),
            None => tasks.iter().map(Task::steps).collect(),
        };
        if let Some(mut workload) = self.locked() {
            workload.announce(&tasks, &weights);
        }
        self.expects(Expected {
            steps: tasks.iter().map(Task::steps).sum(),
            time_s: times_s.map(|times_s| times_s.iter().sum()),
        });
    }

    /// Whether anything is shown, and the task is not known.
    pub fn wants(&self, task: &str) -> bool {
        self.locked().is_some_and(|workload| !workload.knows(task))
    }

    /// Begins a task of so many steps.
    pub fn begin(&self, task: &str, steps: f64) -> Work<'_> {
        let begun = self.locked().map(|mut workload| {
            let begun = workload.begin(task, steps);
            (begun, workload.fraction())
        });
        if let Some((_, fraction)) = begun {
            self.show(task, fraction);
        }
        let (begun, _) = begun.unwrap_or_default();
        Work {
            progress: self,
            task: task.to_owned(),
            begun,
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
    begun: Begun,
}

impl Work<'_> {
    /// Reports further steps done and returns whether to continue.
    pub fn add(&self, steps: f64) -> Control {
        let fraction = self.progress.locked().map(|mut workload| {
            workload.done += steps * self.begun.weight_of_step;
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

    /// Control of one run of `duration_s` that has so many steps; a duration of 1 for work that
    /// reports its completed fraction.
    pub fn run_control<'s>(
        &'s self,
        duration_s: f64,
        steps: f64,
    ) -> Box<dyn FnMut(f64) -> Control + 's> {
        let mut reported = 0.0;
        Box::new(move |time_s| {
            let fraction = (time_s / duration_s).min(1.0);
            if fraction - reported < LEAST && !self.interrupted() {
                return Control::Continue(());
            }
            let more = (fraction - reported) * steps;
            reported = fraction;
            self.add(more)
        })
    }
}

impl Drop for Work<'_> {
    fn drop(&mut self) {
        if let Some(mut workload) = self.progress.locked() {
            workload.done = self.begun.end;
        }
    }
}

/// Smallest fraction of a run worth reporting.
const LEAST: f64 = 1e-4;

/// A task that has begun.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Begun {
    /// Work that is done when the task ends.
    end: f64,
    /// Weight of a step of it.
    weight_of_step: f64,
}

/// A task that is announced.
#[derive(Debug, PartialEq)]
struct Announced {
    name: String,
    /// Weight of the work that has not begun: its time, or its steps.
    left: f64,
    weight_of_step: f64,
}

/// Work that is done, has been begun and is expected.
#[derive(Debug, Default)]
pub struct Workload {
    done: f64,
    begun: f64,
    /// Tasks in their order.
    expected: Vec<Announced>,
}

impl Workload {
    fn knows(&self, name: &str) -> bool {
        self.expected.iter().any(|task| task.name == name)
    }

    fn announce(&mut self, tasks: &[Task], weights: &[f64]) {
        for (task, weight) in tasks.iter().zip(weights) {
            let steps = task.steps();
            self.expected.push(Announced {
                name: task.name.clone(),
                left: *weight,
                weight_of_step: if steps > 0.0 { weight / steps } else { 0.0 },
            });
        }
    }

    /// Begins a task; those before it are over.
    fn begin(&mut self, name: &str, steps: f64) -> Begun {
        let at = self.expected.iter().position(|task| task.name == name);
        let weight_of_step = at.map_or(1.0, |at| self.expected[at].weight_of_step);
        let weight = steps * weight_of_step;
        // What an earlier task did less than its estimate is not left to do.
        self.begun = self.begun.min(self.done) + weight;
        if let Some(at) = at {
            for task in &mut self.expected[..at] {
                task.left = 0.0;
            }
            let left = &mut self.expected[at].left;
            *left = (*left - weight).max(0.0);
        }
        Begun {
            end: self.begun,
            weight_of_step,
        }
    }

    /// Fraction of the whole that is done.
    fn fraction(&self) -> f64 {
        let expected: f64 = self.expected.iter().map(|task| task.left).sum();
        let total = self.begun.max(self.done) + expected;
        if total > 0.0 { self.done / total } else { 0.0 }
    }
}

/// Fraction of the whole from which on the time left is known.
const KNOWN: f64 = 0.001;

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

    use cageless_io::case_file::{CaseFile, template};

    use super::{Task, Workload, time_left};

    /// Announces tasks of so many steps, each of this weight.
    fn announce(whole: &mut Workload, list: &[(&str, f64, f64)]) {
        let file = CaseFile::parse(&template(false), "case", &[]).unwrap();
        let task =
            |&(name, steps, _): &(&str, f64, f64)| Task::new(name).with(file.case(), steps, 1);
        let tasks: Vec<Task> = list.iter().map(task).collect();
        let weights: Vec<f64> = list
            .iter()
            .map(|(_, steps, weight)| steps * weight)
            .collect();
        whole.announce(&tasks, &weights);
    }

    #[test]
    fn the_time_left_is_that_of_all_tasks() {
        let mut whole = Workload::default();
        // Weights of 10, 70 and 20.
        let tasks = [
            ("map", 5.0, 2.0),
            ("motion", 140.0, 0.5),
            ("verdict", 20.0, 1.0),
        ];
        announce(&mut whole, &tasks);
        assert_eq!(whole.begin("map", 5.0).end, 10.0);
        whole.done += 5.0;
        assert_eq!(whole.fraction(), 0.05);
        whole.done = 10.0;
        // Less than was expected, in two parts; the rest may still come.
        let begun = whole.begin("motion", 80.0);
        assert_eq!((begun.end, begun.weight_of_step), (50.0, 0.5));
        whole.done = 50.0;
        assert_eq!(whole.fraction(), 0.5);
        assert_eq!(whole.begin("motion", 20.0).end, 60.0);
        whole.done = 60.0;
        // A later task tells that the ones before it are over.
        assert_eq!(whole.begin("verdict", 20.0).end, 80.0);
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
        announce(&mut whole, &[("run", 1.0, 1.0), ("verify", 3.0, 1.0)]);
        assert!(whole.fraction() < 0.1);
        assert!(whole.knows("run") && !whole.knows("map"));
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
