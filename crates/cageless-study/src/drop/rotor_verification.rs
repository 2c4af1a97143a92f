//! Verification of a drop of a rotor into several bearings.

use cageless::simulation::RotorDrop;
use cageless::verification::{LARGE_PERTURBATIONS, Role};
use cageless_results::{Part, ROTOR_VERIFICATION, Record, Results, Subject};
use rayon::prelude::*;

use super::SeveralBearings;
use super::several::run_rotor;
use super::verification::{TASK, judged, replica_stopped, work};
use crate::StudyError;
use crate::progress::Progress;

/// Verifies the drop that gave `done` by drops from perturbed starts and at half the step, judged for
/// each of its `bearings`; the balls of all bearings are turned by one angle.
///
/// # Errors
/// A replica stopped, or the progress cancelled.
pub(super) fn verify(
    drop: &RotorDrop,
    done: &SeveralBearings,
    progress: &dyn Progress,
) -> Result<Record, StudyError> {
    let case = &drop.cases()[0];
    let roles = Role::all(case.seed, LARGE_PERTURBATIONS);
    let task = progress.begin(TASK, roles[1..].iter().map(|role| work(*role)).sum());
    let replicas: Result<Vec<_>, StudyError> = (roles[1..].par_iter())
        .map(|role| {
            let mut control = task.run_control(case.solver.duration_s, work(*role));
            let replica = run_rotor(&drop.replica(*role), &mut *control)?;
            match &replica.stopped {
                Some(reason) => Err(replica_stopped(*role, reason)),
                None => Ok((*role, replica)),
            }
        })
        .collect();
    let replicas = replicas?;
    let of_bearing = |(k, record): (usize, &super::DropRecord)| {
        let first = (roles[0], record.result.clone());
        let others = replicas
            .iter()
            .map(|(role, r)| (*role, r.bearings[k].clone()));
        let drops: Vec<_> = std::iter::once(first).chain(others).collect();
        judged(case.solver.step_s, &drops)
    };
    let bearings = done.bearings.iter().enumerate().map(of_bearing);
    let halved = replicas.iter().find(|(role, _)| role.half_step);
    let residuals = [
        done.rotor_energy_residual_relative,
        halved.map_or(f64::NAN, |(_, r)| r.rotor_energy_residual_relative),
    ];
    let residuals = Results::of(ROTOR_VERIFICATION, Subject::RotorVerified(&residuals));
    Ok(Record::from(residuals).with_part("bearings", Part::Many(bearings.collect())))
}
