//! Tasks with their work in steps, and the time that they take on this machine: some steps of the very runs are
//! timed, and the runs are counted.

use std::time::{Duration, Instant};

use cageless::Case;
use cageless::numerics::BATCH_WIDTH;
use cageless::passage::PassageRecorder;
use cageless::simulation::{Control, Observer, RotorDrop, batches, run_batch, steps_of_thread};
use cageless::summary::SummaryRecorder;

use crate::interruption::break_if;
use crate::threads::{count, on_each};

/// A task of a study with its runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// Name.
    pub name: String,
    runs: Vec<Runs>,
}

/// Runs like one another.
#[derive(Debug, Clone, PartialEq)]
struct Runs {
    sample: Sample,
    /// Steps of all of them; bearings side by side count one by one.
    steps: f64,
    /// Pieces of equal size between which threads share them.
    pieces: usize,
}

/// Runs to be timed: cases side by side, or a drop.
#[derive(Debug, Clone, PartialEq)]
enum Sample {
    /// Cases side by side.
    Cases(Vec<Case>),
    /// A rotor in several bearings.
    Drop(Box<RotorDrop>),
}

impl Task {
    /// A task without runs.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            runs: vec![],
        }
    }

    /// Adds runs of cases like one, of so many steps in all, in so many pieces.
    pub fn with(self, case: &Case, steps: f64, pieces: usize) -> Self {
        self.with_together(vec![case.clone()], steps, pieces)
    }

    /// Adds runs of cases like these, side by side.
    pub fn with_together(self, cases: Vec<Case>, steps: f64, pieces: usize) -> Self {
        self.with_runs(Sample::Cases(cases), steps, pieces)
    }

    /// Adds runs of cases like one, so many side by side if they can be.
    pub(crate) fn with_batch(self, case: &Case, most: usize, steps: f64, pieces: usize) -> Self {
        let members = batches(&vec![case.clone(); most.clamp(1, BATCH_WIDTH)]);
        let together = members.first().map_or(1, Vec::len);
        self.with_together(vec![case.clone(); together], steps, pieces)
    }

    /// Adds drops like one, of so many steps of all bearings in all.
    pub fn with_drops(self, drop: &RotorDrop, steps: f64, pieces: usize) -> Self {
        self.with_runs(Sample::Drop(Box::new(drop.clone())), steps, pieces)
    }

    fn with_runs(mut self, sample: Sample, steps: f64, pieces: usize) -> Self {
        if steps > 0.0 && pieces > 0 {
            self.runs.push(Runs {
                sample,
                steps,
                pieces,
            });
        }
        self
    }

    /// Steps of all runs.
    pub fn steps(&self) -> f64 {
        self.runs.iter().map(|runs| runs.steps).sum()
    }

    /// Time that the task takes on `threads` threads, s, if a step of a sample takes what `pace` says.
    fn time_s(&self, threads: usize, pace: &mut dyn FnMut(&Sample, bool) -> f64) -> f64 {
        let time_s = |runs: &Runs| {
            let rounds = runs.pieces.div_ceil(threads) as f64 / runs.pieces as f64;
            rounds * runs.steps * pace(&runs.sample, runs.pieces > 1)
        };
        self.runs.iter().map(time_s).sum()
    }
}

/// Time for which the steps of a sample are timed.
const TIMED: Duration = Duration::from_millis(250);

/// Times that tasks take on the threads of this pool, s, in their order. What `stop` ends early is less well known.
pub(crate) fn times_s(tasks: &[Task], stop: &(dyn Fn() -> bool + Sync)) -> Vec<f64> {
    let mut known: Vec<(Sample, bool, f64)> = vec![];
    let mut pace = |sample: &Sample, parallel: bool| {
        if let Some((.., step_s)) = known.iter().find(|(s, p, _)| (s, *p) == (sample, parallel)) {
            return *step_s;
        }
        let step_s = match parallel {
            // All threads at once: they share memory and power.
            true => {
                let all = on_each(|| sample.step_s(stop));
                all.iter().sum::<f64>() / all.len() as f64
            }
            false => sample.step_s(stop),
        };
        known.push((sample.clone(), parallel, step_s));
        step_s
    };
    let threads = count();
    let times = tasks.iter();
    times.map(|task| task.time_s(threads, &mut pace)).collect()
}

impl Sample {
    /// Time of a step of one bearing on the calling thread, s; 0 if it cannot start.
    fn step_s(&self, stop: &dyn Fn() -> bool) -> f64 {
        let (bearings, step_s) = match self {
            Self::Cases(cases) => (cases.len(), cases[0].solver.step_s),
            Self::Drop(drop) => (drop.cases().len(), drop.cases()[0].solver.step_s),
        };
        let began = Instant::now();
        let mut asked: Option<[(Instant, f64); 2]> = None;
        let mut control = |time_s: f64| {
            let now = (Instant::now(), time_s);
            let [first, _] = *asked.get_or_insert([now; 2]);
            asked = Some([first, now]);
            break_if(stop() || now.0 - first.0 > TIMED)
        };
        let before = steps_of_thread();
        self.run(&mut control);
        let steps = steps_of_thread() - before;
        let timed = asked.filter(|[first, last]| last.1 > first.1);
        let (elapsed, steps) = match timed {
            Some([first, last]) => (
                last.0 - first.0,
                bearings as f64 * (last.1 - first.1) / step_s,
            ),
            // It was over before it asked twice.
            None => (began.elapsed(), steps as f64),
        };
        if steps > 0.0 {
            elapsed.as_secs_f64() / steps
        } else {
            0.0
        }
    }

    /// Runs the sample until `control` ends it; one that cannot start makes no step.
    fn run(&self, control: &mut dyn FnMut(f64) -> Control) {
        match self {
            Self::Cases(cases) => {
                let cases: Vec<&Case> = cases.iter().collect();
                let mut summaries: Vec<_> = cases.iter().map(|_| SummaryRecorder::new()).collect();
                let mut passages: Vec<_> = cases
                    .iter()
                    .map(|_| PassageRecorder::new(|_| Ok(())))
                    .collect();
                let mut observers: Vec<Vec<&mut dyn Observer>> = summaries
                    .iter_mut()
                    .zip(&mut passages)
                    .map(|(summary, passages)| vec![summary as &mut dyn Observer, passages])
                    .collect();
                run_batch(&cases, &mut observers, control);
            }
            Self::Drop(drop) => {
                let mut observers: Vec<Vec<&mut dyn Observer>> =
                    drop.cases().iter().map(|_| vec![]).collect();
                let _ = drop.run(&mut observers, control);
            }
        }
    }
}

/// A time in words: `about 5 min`.
pub fn about(time_s: f64) -> String {
    let rounded = |unit: f64| (time_s / unit).round();
    match time_s {
        s if s < 57.5 => format!("about {:.0} s", 5.0 * rounded(5.0).max(1.0)),
        s if s < 5700.0 => format!("about {:.0} min", rounded(60.0)),
        s if s < 36.0 * 3600.0 => format!("about {:.0} h", rounded(3600.0)),
        _ => format!("about {:.0} days", rounded(86_400.0)),
    }
}

#[cfg(test)]
mod tests {
    use cageless_io::case_file::{CaseFile, template};

    use super::*;

    fn case() -> Case {
        let file = CaseFile::parse(&template(false), "case", &[]).unwrap();
        file.case().clone()
    }

    #[test]
    fn the_time_of_a_task_is_that_of_its_steps_on_its_threads() {
        let case = case();
        // 1e6 steps in 5 pieces on 2 threads are three rounds of five.
        let task = Task::new("task")
            .with(&case, 1e6, 5)
            .with_together(vec![case.clone(); 8], 4e6, 1)
            .with(&case, 0.0, 3);
        assert_eq!(task.steps(), 5e6);
        let mut pace = |sample: &Sample, _| match sample {
            Sample::Cases(cases) if cases.len() == 1 => 3e-6,
            _ => 1e-6,
        };
        assert!((task.time_s(2, &mut pace) - (0.6 * 3.0 + 4.0)).abs() < 1e-9);
        assert!((task.time_s(1, &mut pace) - (3.0 + 4.0)).abs() < 1e-9);
        assert_eq!(Task::new("none").time_s(2, &mut pace), 0.0);
    }

    /// Every sample is timed, however short, and ends on interruption.
    #[test]
    fn steps_of_samples_are_timed() {
        let mut short = case();
        short.solver.duration_s = 20.0 * short.solver.step_s;
        let mut together = case();
        together.set_method(cageless::integrator::IntegrationMethod::VelocityVerlet);
        let tasks = [
            Task::new("short").with(&short, 1e9, 1),
            Task::new("alone").with(&case(), 1e9, 4),
            Task::new("together").with_together(vec![together; 8], 1e9, 4),
        ];
        let began = Instant::now();
        for time_s in times_s(&tasks, &|| false) {
            assert!(time_s > 0.0 && time_s.is_finite(), "{time_s}");
        }
        assert!(began.elapsed() < Duration::from_secs(60));
        assert!(times_s(&tasks, &|| true).iter().all(|t| t.is_finite()));
    }

    #[test]
    fn times_are_told_in_words() {
        let rows = [
            (12.0, "about 10 s"),
            (1.0, "about 5 s"),
            (57.0, "about 55 s"),
            (58.0, "about 1 min"),
            (680.0, "about 11 min"),
            (7200.0, "about 2 h"),
            (400_000.0, "about 5 days"),
        ];
        for (time_s, text) in rows {
            assert_eq!(about(time_s), text);
        }
    }
}
