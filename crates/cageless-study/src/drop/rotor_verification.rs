//! Verification of a drop of a rotor into several bearings.

use cageless::simulation::RotorDrop;
use cageless::verification::{LARGE_PERTURBATIONS, Role};
use rayon::prelude::*;
use serde::Serialize;

use super::several::run_rotor;
use super::verification::{TASK, replica_stopped, work};
use super::{DropVerification, SeveralBearings};
use crate::StudyError;
use crate::progress::Progress;

/// Verification of a drop into several bearings by drops from perturbed starts and at half the
/// step; the balls of all bearings are turned by one angle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RotorVerification {
    /// What the energy ledger of the rotor alone lacks, over the sum of its absolute terms: at the
    /// step, and at half of it.
    pub rotor_energy_residual_relative: [f64; 2],
    /// Judgements of the results of each bearing.
    pub bearings: Vec<DropVerification>,
}

impl RotorVerification {
    /// Verifies the drop that gave `done`.
    ///
    /// # Errors
    /// A replica stopped, or the progress cancelled.
    pub fn new(
        drop: &RotorDrop,
        done: &SeveralBearings,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
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
            DropVerification::judge(case.solver.step_s, &drops)
        };
        let halved = replicas.iter().find(|(role, _)| role.half_step);
        Ok(Self {
            rotor_energy_residual_relative: [
                done.rotor_energy_residual_relative,
                halved.map_or(f64::NAN, |(_, r)| r.rotor_energy_residual_relative),
            ],
            bearings: done.bearings.iter().enumerate().map(of_bearing).collect(),
        })
    }
}
