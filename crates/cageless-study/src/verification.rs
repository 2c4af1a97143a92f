//! Verification of a run: its replicas, run on all threads.

use cageless::Case;
use cageless::simulation::{Ending, Observer, RunOutcome};
use cageless::verification::{
    LARGE_PERTURBATIONS, Replica, ReplicaError, ReplicaObserver, Verification, replicas,
};
use cageless_results::{step_warning, verification_record};
use rayon::prelude::*;

use crate::progress::Progress;
use crate::summary::RunSummary;
use crate::task::Task;
use crate::threads::each;

/// Replicas of a verification; the first is the run itself.
pub struct VerificationRuns {
    replicas: Vec<Replica>,
    observer: ReplicaObserver,
}

/// Name of the task of a verification.
const TASK: &str = "verify";

/// Steps of replicas.
fn steps(replicas: &[Replica]) -> f64 {
    let steps = replicas.iter().map(|replica| replica.case.solver.steps());
    steps.sum()
}

impl VerificationRuns {
    /// Replicas of the run of `case`.
    pub fn new(case: &Case, seed: u64) -> Self {
        let replicas = replicas(case, seed, LARGE_PERTURBATIONS);
        let observer = replicas[0].observer();
        Self { replicas, observer }
    }

    /// The task of [`VerificationRuns::finish`] for a run of `case`.
    pub fn task(&self, case: &Case) -> Task {
        let others = &self.replicas[1..];
        Task::new(TASK).with(case, steps(others), others.len())
    }

    /// Observer of the run itself.
    pub fn observer(&mut self) -> &mut (dyn Observer + Send) {
        &mut self.observer
    }

    /// Runs the other replicas and adds the verification to the summary, or a warning that it
    /// failed. The failure of a replica does not affect the results of the run.
    pub fn finish(
        self,
        case: &Case,
        outcome: &RunOutcome,
        summary: &mut RunSummary,
        progress: &dyn Progress,
    ) {
        if !matches!(outcome.ending, Ending::Complete) {
            summary
                .warnings
                .push("not verified: the run did not complete".to_owned());
            return;
        }
        match self.certify(case, outcome, progress) {
            Ok(verification) => {
                let verification = verification_record(&verification);
                summary.warnings.extend(step_warning(&verification));
                summary.verification = Some(verification);
            }
            Err(error) => summary.warnings.push(format!("not verified: {error}")),
        }
    }

    fn certify(
        self,
        case: &Case,
        outcome: &RunOutcome,
        progress: &dyn Progress,
    ) -> Result<Verification, ReplicaError> {
        let first = self.observer.record(outcome)?;
        let others = &self.replicas[1..];
        let task = progress.begin(TASK, steps(others));
        // Computed in any order, collected in order.
        let records: Result<Vec<_>, ReplicaError> = each(others)
            .with_max_len(1)
            .map(|replica| {
                let steps = replica.case.solver.steps();
                replica.run(&mut task.run_control(case.solver.duration_s, steps))
            })
            .collect();
        let mut all = vec![first];
        all.extend(records?);
        Verification::new(case, &all).map_err(|error| ReplicaError::Case(error.into()))
    }
}
