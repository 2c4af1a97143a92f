//! Many drops of a rotor into several bearings whose conditions scatter.

use cageless::simulation::RotorDrop;
use cageless::touchdown::Scatter;
use rayon::prelude::*;
use serde::Serialize;

use super::distribution::whirls_backward;
use super::several::run_rotor;
use cageless_results::{DropResult, RotorRun};

use super::{BearingRow, Distribution, WhirlProbability, check_drops};
use crate::StudyError;
use crate::progress::{Progress, Work};

/// Drops of a rotor into several bearings whose conditions scatter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RotorEnsemble {
    /// Seed of the draws: that of the case of the first bearing.
    pub seed: u64,
    /// Drops that ran to their end.
    pub completed: usize,
    /// Drops that stopped early, with bearing and reason.
    pub stopped: Vec<String>,
    /// Probability that the rotor ends in backward whirl in any of its bearings.
    #[serde(flatten)]
    pub backward_whirl: WhirlProbability,
    /// What each bearing went through in the completed drops.
    pub bearings: Vec<Distribution>,
    /// The drops, in the order of their indices.
    pub drops: Vec<RotorDropRow>,
}

/// One drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RotorDropRow {
    /// Index of the draw.
    pub index: u64,
    /// Angle by which all unbalances are turned at the start, degrees.
    pub unbalance_turn_deg: f64,
    /// What the energy ledger of the rotor alone lacks, over the sum of its absolute terms.
    pub rotor_energy_residual_relative: f64,
    /// Bearing and reason, where the drop stopped early.
    pub stopped: Option<String>,
    /// The bearings.
    pub bearings: Vec<BearingRow>,
}

/// Drops the rotor `count` times, on all threads; the result is the same on any number of them.
///
/// # Errors
/// A case is impossible, or the progress cancelled.
pub fn rotor_ensemble(
    drop: &RotorDrop,
    count: u64,
    scatter: &Scatter,
    progress: &dyn Progress,
) -> Result<RotorEnsemble, StudyError> {
    check_drops(count)?;
    let task = progress.begin("drops", count as f64);
    let rows: Result<Vec<RotorDropRow>, StudyError> = (0..count)
        .into_par_iter()
        .map(|index| RotorDropRow::compute(drop, index, scatter, &task))
        .collect();
    let cases = drop.cases();
    Ok(evaluate(cases[0].seed, cases.len(), rows?))
}

impl RotorDropRow {
    fn compute(
        drop: &RotorDrop,
        index: u64,
        scatter: &Scatter,
        task: &Work<'_>,
    ) -> Result<Self, StudyError> {
        let (scattered, drawn) = scatter.draw_rotor(drop, index);
        let mut control = task.run_control(drop.cases()[0].solver.duration_s, 1.0);
        let RotorRun {
            bearings,
            stopped,
            rotor_energy_residual_relative,
            ..
        } = run_rotor(&scattered, &mut *control)?;
        Ok(Self {
            index,
            unbalance_turn_deg: drawn.unbalance_turn_rad.to_degrees(),
            rotor_energy_residual_relative,
            stopped,
            bearings: (drawn.bearings.iter().zip(bearings))
                .map(|(drawn, result)| BearingRow::new(drawn, result))
                .collect(),
        })
    }

    /// Whether the rotor ends in backward whirl in any of its bearings.
    pub fn whirls_backward(&self) -> bool {
        let mut results = self.bearings.iter().map(|bearing| &bearing.result);
        results.any(whirls_backward)
    }
}

fn evaluate(seed: u64, bearings: usize, drops: Vec<RotorDropRow>) -> RotorEnsemble {
    let complete: Vec<&RotorDropRow> = drops.iter().filter(|d| d.stopped.is_none()).collect();
    let whirls = complete.iter().filter(|d| d.whirls_backward()).count();
    let of_bearing = |k: usize| {
        let results: Vec<&DropResult> = complete.iter().map(|d| &d.bearings[k].result).collect();
        Distribution::new(&results)
    };
    RotorEnsemble {
        seed,
        completed: complete.len(),
        stopped: drops.iter().filter_map(|d| d.stopped.clone()).collect(),
        backward_whirl: WhirlProbability::new(whirls, complete.len()),
        bearings: (0..bearings).map(of_bearing).collect(),
        drops,
    }
}

#[cfg(test)]
mod tests {
    use cageless_results::Cell;

    use super::*;
    use cageless_results::DropJudgement;
    use cageless_results::{DROP, Results};

    fn bearing(state: &str, force: f64) -> BearingRow {
        let results = [
            ("end_state", Cell::Text(state.to_owned())),
            ("rotor_force_max_n", Cell::Number(force)),
        ];
        BearingRow {
            rotor_friction: 0.1,
            ball_friction: 0.1,
            radial_clearance_um: 200.0,
            support_damping_n_s_m: None,
            result: DropResult {
                results: Results::only(DROP, &results),
                judgement: DropJudgement::default(),
                stopped: None,
                windows: vec![],
            },
        }
    }

    fn row(bearings: Vec<BearingRow>, stopped: Option<&str>) -> RotorDropRow {
        RotorDropRow {
            index: 0,
            unbalance_turn_deg: 0.0,
            rotor_energy_residual_relative: 0.0,
            stopped: stopped.map(str::to_owned),
            bearings,
        }
    }

    #[test]
    fn a_whirl_in_any_bearing_counts_once_and_a_drop_that_stopped_not_at_all() {
        let (whirl, bounce) = ("backward-whirl", "bouncing");
        let drops = vec![
            row(vec![bearing(whirl, 1.0), bearing(whirl, 5.0)], None),
            row(vec![bearing(bounce, 3.0), bearing(whirl, 4.0)], None),
            row(vec![bearing(bounce, 2.0), bearing(bounce, 6.0)], None),
            row(vec![bearing(bounce, 2.5), bearing(bounce, 7.0)], None),
            row(
                vec![bearing(whirl, 9.0), bearing(whirl, 9.0)],
                Some("in bearing 1 at t = 0.1 s"),
            ),
        ];
        let many = evaluate(3, 2, drops);
        assert_eq!((many.seed, many.completed), (3, 4));
        assert_eq!(many.stopped, ["in bearing 1 at t = 0.1 s"]);
        assert_eq!(many.backward_whirl.fraction, Some(0.5));
        let fractions = [0, 1].map(|k: usize| many.bearings[k].backward_whirl.fraction);
        assert_eq!(fractions, [Some(0.25), Some(0.5)]);
        let most = |k: usize| many.bearings[k].quantiles[0].most;
        assert_eq!([most(0), most(1)], [3.0, 7.0]);
        // Wilson 1927: 2 of 4.
        let [low, high] = many.backward_whirl.interval.unwrap();
        assert!((low - 0.150).abs() < 1e-3 && (high - 0.850).abs() < 1e-3);
    }
}
