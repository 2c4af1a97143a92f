//! The time that a sweep takes, from a few of its variants.

use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_design::verdict_steps;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::CaseFile;
use cageless_results::Computation;
use rayon::ThreadPool;

use super::evaluate::Sweep;
use crate::drop::{drop_task, worth_together};
use crate::task::{Task, times_s};

/// Variants that are looked at, spread over the plan.
const PROBES: u64 = 16;
/// Time for which variants without a motion are computed.
const TIMED: Duration = Duration::from_millis(200);
/// Name of the task of a sweep.
const TASK: &str = "sweep";

impl Sweep {
    /// Time that so many variants take on the threads of `pool`, s.
    pub(super) fn expected_s(&self, left: u64, pool: &ThreadPool) -> f64 {
        let task = self.task(left);
        if task.steps() > 0.0 {
            return pool.install(|| times_s(&[task], &|| false)).iter().sum();
        }
        // Nothing moves: some variants are computed.
        let began = Instant::now();
        let mut computed = 0.0;
        for index in self.probes() {
            let _ = self.evaluate(index..index + 1, &|| Control::Continue(()));
            computed += 1.0;
            if began.elapsed() > TIMED {
                break;
            }
        }
        let threads = pool.current_num_threads() as f64;
        began.elapsed().as_secs_f64() / computed * left as f64 / threads
    }

    /// Runs of so many variants, each as the mean of those that are looked at.
    pub fn task(&self, left: u64) -> Task {
        let probes = self.probes().count() as f64;
        let share = left as f64 / probes;
        let files: Vec<BearingArrangement> = self
            .probes()
            .filter_map(|index| self.file(index).ok())
            .collect();
        let cases = files.iter().filter_map(BearingArrangement::case);
        let cases: Vec<_> = cases.map(CaseFile::case).collect();
        let mut task = Task::new(TASK);
        let together = self.together().min(left.max(1)) as usize;
        let pieces = left.div_ceil(self.batch()) as usize;
        if let (Some(first), true) = (cases.first(), self.wants(Computation::Verdict)) {
            let steps: f64 = cases.iter().map(|case| verdict_steps(case)).sum();
            task = task.with(first, share * steps, pieces);
        }
        if let (Some(first), true) = (cases.first(), self.wants(Computation::Run)) {
            let steps: f64 = cases.iter().map(|case| case.solver.steps()).sum();
            task = task.with_batch(first, together, share * steps, pieces);
        }
        let drops: Vec<_> = files.iter().filter_map(BearingArrangement::drop).collect();
        if let (Some(first), true) = (drops.first(), self.wants(Computation::Drop)) {
            let steps = drops
                .iter()
                .map(|drop| crate::drop::steps(drop))
                .sum::<f64>();
            let together = worth_together(first).min(together);
            task = drop_task(task, first, together, share * steps, pieces);
        }
        task
    }

    /// Indices of the variants that are looked at.
    fn probes(&self) -> impl Iterator<Item = u64> {
        let (count, probes) = (self.variants(), self.variants().min(PROBES));
        let index = move |k: u64| (u128::from(k) * u128::from(count) / u128::from(probes)) as u64;
        (0..probes).map(index)
    }
}
