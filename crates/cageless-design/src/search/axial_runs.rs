//! Runs of the structures of a search under its largest axial load.

use super::evaluation::{Batch, Evaluation, fail};
use super::job::{Interrupted, Job, Numbers, Outcome, Task};
use super::rejection::Cause;
use super::request::Stage;

impl Batch<'_, '_> {
    /// Lags of some structures in space without and under the largest axial load, and what they reject.
    pub(super) fn axial_lags(&mut self, of: &mut [&mut Evaluation]) -> Result<(), Interrupted> {
        let loads_n = [0.0, self.request.axial_load_max_n];
        let mut jobs = vec![];
        for e in of.iter().filter(|e| !e.axial.is_empty()) {
            for &point in &self.request.points {
                jobs.extend(loads_n.map(|axial_load_n| Job {
                    structure: e.structure.clone(),
                    point,
                    task: Task::AxialLag(axial_load_n),
                }));
            }
        }
        let outcomes = self.execute(Stage::Axial, &jobs)?;
        let mut pairs = outcomes.chunks(2);
        for e in of {
            for p in 0..e.axial.len() {
                let lags: Result<Vec<f64>, _> = pairs
                    .next()
                    .unwrap_or_default()
                    .iter()
                    .map(lag_of)
                    .collect();
                match lags {
                    Ok(lags) => e.axial[p].lags_rad = lags.try_into().ok(),
                    Err(reason) => fail(e, reason, p),
                }
            }
            e.reject(|e, point| Cause::of_axial(e.axial.get(point)?));
            if e.rejection.is_some() {
                e.objectives = None;
            }
        }
        Ok(())
    }
}

fn lag_of(outcome: &Outcome) -> Result<f64, String> {
    match outcome {
        Ok(Numbers::AxialLag(lag_rad)) => Ok(*lag_rad),
        Ok(_) => unreachable!("outcome of another task"),
        Err(reason) => Err(reason.clone()),
    }
}
