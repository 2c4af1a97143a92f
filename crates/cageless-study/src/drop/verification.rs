//! Verification of a drop: which of its results are converged.

use cageless::Case;
use cageless::simulation::Ending;
use cageless::touchdown::DropRecorder;
use cageless::verification::{
    LARGE_PERTURBATIONS, Perturbation, Replica, Role, judge, replicas, z_limit,
};
use rayon::prelude::*;

use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::together::run_together;
use cageless_results::{DropResult, Kind, Record, VerifiedDrop};

/// Name of the task.
pub(super) const TASK: &str = "verify";
/// Results that are no results of the drop.
const LEFT_OUT: [&str; 2] = ["energy_residual_relative", "simulated_s"];

/// Verifies the drop of `case` that gave `result` by drops from perturbed starts and at half the step.
///
/// # Errors
/// A replica stopped, or the progress cancelled.
pub(super) fn verify(
    case: &Case,
    result: &DropResult,
    progress: &dyn Progress,
) -> Result<Record, StudyError> {
    let all = replicas(case, LARGE_PERTURBATIONS);
    let task = progress.begin(TASK, all[1..].iter().map(|r| work(r.role)).sum());
    let (full, half): (Vec<&Replica>, Vec<&Replica>) =
        all[1..].iter().partition(|r| !r.role.half_step);
    let groups: Result<Vec<_>, StudyError> = [half, full]
        .into_par_iter()
        .map(|group| together(&group, &task))
        .collect();
    let mut drops = vec![(all[0].role, result.clone())];
    drops.extend(groups?.into_iter().flatten());
    Ok(judged(case.solver.step_s, &drops))
}

/// Judges the results of the drop at a step and of its replicas, in the order of the roles.
pub(super) fn judged(step_s: f64, drops: &[(Role, DropResult)]) -> Record {
    let quantities = drops[0].1.results.iter().map(|(quantity, _)| quantity);
    let judgements = quantities
        .filter(|q| matches!(q.kind, Kind::Number | Kind::Integer))
        .filter(|q| !LEFT_OUT.contains(&q.name))
        .filter_map(|quantity| {
            let values = drops.iter().map(|(role, drop)| {
                let value = drop.results.value(quantity.name)?;
                Some((*role, value))
            });
            let values: Vec<(Role, f64)> = values.collect::<Option<_>>()?;
            Some(judge(quantity.named(), &values, values[0].1.abs(), false))
        });
    let states = |half_step: bool| -> Vec<String> {
        let of_step = drops
            .iter()
            .filter(|(r, _)| r.half_step == half_step && r.perturbation != Perturbation::Small);
        of_step.map(|(_, d)| d.end_state().to_owned()).collect()
    };
    let replicas = LARGE_PERTURBATIONS + 1;
    let verified = VerifiedDrop {
        step_s,
        replicas,
        z_limit: z_limit(replicas),
        judgements: judgements.collect(),
        end_states: states(false),
        half_step_end_states: states(true),
    };
    verified.record()
}

/// Work of a replica, that of the drop being 1.
pub(super) fn work(role: Role) -> f64 {
    if role.half_step { 2.0 } else { 1.0 }
}

/// The reason why there is no verification where a replica stopped.
pub(super) fn replica_stopped(role: Role, reason: &str) -> StudyError {
    StudyError::Input(format!("{role} stopped {reason}"))
}

fn together(group: &[&Replica], task: &Work<'_>) -> Result<Vec<(Role, DropResult)>, StudyError> {
    let cases: Vec<Case> = group.iter().map(|replica| replica.case.clone()).collect();
    let units = work(group[0].role);
    let control = |runs: usize| task.run_control(cases[0].solver.duration_s, units * runs as f64);
    let runs = run_together(&cases, |_| DropRecorder::new(), control);
    let runs = group.iter().zip(runs.ok_or(StudyError::Interrupted)?);
    runs.map(|(replica, run)| {
        let (recorder, outcome) = run.map_err(|error| StudyError::Input(error.to_string()))?;
        if let Ending::Stopped(stop) = &outcome.ending {
            return Err(replica_stopped(replica.role, &stop.reason()));
        }
        let result = DropResult::new(&replica.case, &recorder.summary(&outcome.state), &outcome);
        Ok((replica.role, result))
    })
    .collect()
}
