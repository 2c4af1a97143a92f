//! Verification of a drop: which of its results are converged.

use cageless::Case;
use cageless::simulation::Ending;
use cageless::touchdown::DropRecorder;
use cageless::verification::{
    Convergence, Judgement, LARGE_PERTURBATIONS, Perturbation, Replica, Role, TOLERANCE, judge,
    replicas, z_limit,
};
use rayon::prelude::*;
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::together::run_together;
use cageless_results::DropResult;
use cageless_results::{Kind, Quantity};

/// Verification of a drop by drops from perturbed starts and at half the step.
#[derive(Debug, Clone, PartialEq)]
pub struct DropVerification {
    /// Step of the drop, s.
    pub step_s: f64,
    /// Drops at the step, and as many at half of it.
    pub replicas: usize,
    /// Judgements of the scalar results that every drop has.
    pub judgements: Vec<Judgement<&'static Quantity>>,
    /// State at the end of the drops at the step.
    pub end_states: Vec<String>,
    /// State at the end of the drops at half the step.
    pub half_step_end_states: Vec<String>,
}

/// Name of the task.
pub(super) const TASK: &str = "verify";
/// Results that are no results of the drop.
const LEFT_OUT: [&str; 2] = ["energy_residual_relative", "simulated_s"];

impl DropVerification {
    /// Verifies the drop of `case` that gave `result`.
    ///
    /// # Errors
    /// A replica stopped, or the progress cancelled.
    pub fn new(
        case: &Case,
        result: &DropResult,
        progress: &dyn Progress,
    ) -> Result<Self, StudyError> {
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
        Ok(Self::judge(case.solver.step_s, &drops))
    }

    /// Judges the results of the drop at a step and of its replicas, in the order of the roles.
    pub(super) fn judge(step_s: f64, drops: &[(Role, DropResult)]) -> Self {
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
                Some(judge(quantity, &values, values[0].1.abs(), false))
            });
        let states = |half_step: bool| -> Vec<String> {
            let of_step = drops
                .iter()
                .filter(|(r, _)| r.half_step == half_step && r.perturbation != Perturbation::Small);
            of_step.map(|(_, d)| d.end_state().to_owned()).collect()
        };
        Self {
            step_s,
            replicas: LARGE_PERTURBATIONS + 1,
            judgements: judgements.collect(),
            end_states: states(false),
            half_step_end_states: states(true),
        }
    }

    /// Results classified as `verdict`.
    pub fn count(&self, verdict: Convergence) -> usize {
        let of_verdict = self.judgements.iter().filter(|j| j.verdict == verdict);
        of_verdict.count()
    }
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

impl Serialize for DropVerification {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Row {
            name: &'static str,
            unit: &'static str,
            verdict: &'static str,
            value: f64,
            half_step_value: f64,
            mean: f64,
            half_step_mean: f64,
            spread: f64,
            standard_error: f64,
            z: f64,
        }
        let rows: Vec<Row> = (self.judgements.iter())
            .map(|j| Row {
                name: j.quantity.name,
                unit: j.quantity.unit,
                verdict: j.verdict.name(),
                value: j.value,
                half_step_value: j.half_step_value,
                mean: j.mean,
                half_step_mean: j.half_step_mean,
                spread: j.spread,
                standard_error: j.standard_error,
                z: j.z,
            })
            .collect();
        let mut map = serializer.serialize_struct("DropVerification", 7)?;
        map.serialize_field("step_s", &self.step_s)?;
        map.serialize_field("replicas", &self.replicas)?;
        map.serialize_field("tolerance", &TOLERANCE)?;
        map.serialize_field("z_limit", &z_limit(self.replicas))?;
        map.serialize_field("numbers", &rows)?;
        map.serialize_field("end_states", &self.end_states)?;
        map.serialize_field("half_step_end_states", &self.half_step_end_states)?;
        map.end()
    }
}
