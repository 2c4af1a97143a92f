//! Verification of a drop: which of its results are converged.

use cageless::simulation::{RotorDrop, RotorOutcome};
use cageless::verification::{LARGE_PERTURBATIONS, Perturbation, Role, judge, z_limit};
use cageless_results::{
    DropResult, DropRun, Kind, Part, ROTOR_VERIFICATION, Record, Results, Subject, VerifiedDrop,
};
use rayon::prelude::*;

use super::DropRecord;
use super::FiledDrop;
use super::record::steps;
use super::side_by_side::{drop_task, run_drops, worth_together};
use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::task::Task;
use crate::threads::groups_of;

/// Results that are no results of the drop.
const LEFT_OUT: [&str; 2] = ["energy_residual_relative", "simulated_s"];

/// Verifies the drop that gave `done` by drops from perturbed starts and at half the step, judged for
/// each bearing; the balls of all bearings are turned by one angle.
///
/// # Errors
/// A replica stopped, or the progress cancelled.
pub(super) fn verify(
    filed: &FiledDrop<'_>,
    done: &DropRecord,
    progress: &dyn Progress,
) -> Result<Record, StudyError> {
    let (drop, case) = (&filed.drop, &filed.drop.cases()[0]);
    let roles = Role::all(filed.seed(), LARGE_PERTURBATIONS);
    let task = progress.begin(TASK, replica_steps(drop, &roles[1..]));
    let (full, half): (Vec<Role>, Vec<Role>) = roles[1..].iter().partition(|r| !r.half_step);
    let together = worth_together(drop);
    let groups: Result<Vec<_>, StudyError> = groups_of(&half, together)
        .chain(groups_of(&full, together))
        .map(|group| replicas(filed, group, &task))
        .collect();
    let replicas: Vec<(Role, DropRun)> = groups?.into_iter().flatten().collect();
    let of_bearing = |k: usize| {
        let first = (roles[0], &done.bearings[k].result);
        let others = replicas.iter().map(|(role, r)| (*role, &r.bearings[k]));
        let drops: Vec<_> = std::iter::once(first).chain(others).collect();
        judged(case.solver.step_s, &drops)
    };
    let halved = replicas.iter().find(|(role, _)| role.half_step);
    let of_rotor = Record::from(of_rotor(done, halved.map(|(_, run)| run)));
    let bearings = (0..done.bearings.len()).map(of_bearing).collect();
    Ok(of_rotor.with_part("bearings", Part::Many(bearings)))
}

/// Results of the rotor alone, of the drop and of one at half the step.
fn of_rotor(done: &DropRecord, halved: Option<&DropRun>) -> Results {
    let residual = |rotor: &RotorOutcome| rotor.energy_residual_relative;
    let residuals = [
        residual(&done.rotor),
        halved.map_or(f64::NAN, |run| residual(&run.rotor)),
    ];
    Results::of(ROTOR_VERIFICATION, Subject::RotorVerified(&residuals))
}

/// Judges the results of a bearing in the drop and in its replicas.
fn judged(step_s: f64, drops: &[(Role, &DropResult)]) -> Record {
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

/// Name of the task of a verification.
const TASK: &str = "verify";

/// The task of [`verify`].
pub(super) fn task(filed: &FiledDrop<'_>) -> Task {
    let drop = &filed.drop;
    let roles = Role::all(filed.seed(), LARGE_PERTURBATIONS);
    let replicas = &roles[1..];
    // Those at either step go side by side.
    let pieces = match drop.rotor() {
        None => 2,
        Some(_) => replicas.len(),
    };
    let steps = replica_steps(drop, replicas);
    drop_task(Task::new(TASK), drop, replicas.len() / 2, steps, pieces)
}

/// Steps of replicas of a drop.
fn replica_steps(drop: &RotorDrop, roles: &[Role]) -> f64 {
    let work = |role: &Role| if role.half_step { 2.0 } else { 1.0 };
    steps(drop) * roles.iter().map(work).sum::<f64>()
}

/// Replicas of a drop at one step.
fn replicas(
    filed: &FiledDrop<'_>,
    roles: &[Role],
    task: &Work<'_>,
) -> Result<Vec<(Role, DropRun)>, StudyError> {
    let drop = &filed.drop;
    let replica = |role: &Role| filed.like(role.drop(drop));
    let drops: Vec<FiledDrop<'_>> = roles.iter().map(replica).collect();
    let (steps, duration_s) = (
        replica_steps(drop, &roles[..1]),
        drop.cases()[0].solver.duration_s,
    );
    let control = |runs: usize| task.run_control(duration_s, steps * runs as f64);
    let runs = run_drops(&drops, control).ok_or(StudyError::Interrupted)?;
    let replicas = roles.iter().zip(runs).map(|(role, run)| {
        let run = run.map_err(|error| StudyError::Input(error.to_string()))?;
        match &run.stopped {
            Some(reason) => Err(StudyError::Input(format!("{role} stopped {reason}"))),
            None => Ok((*role, run)),
        }
    });
    replicas.collect()
}
