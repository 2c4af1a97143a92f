//! Many drops whose conditions scatter.

use cageless::Case;
use cageless::numerics::proportion::wilson_interval;
use cageless::simulation::{Ending, Observer, batches, run_batch};
use cageless::touchdown::{Drawn, DropRecorder, EndState, Scatter};
use cageless_io::OptionError;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::DropResult;
use crate::StudyError;
use crate::progress::{Progress, Work};

/// Most drops of an ensemble.
pub const DROPS_MAX: u64 = 1_000_000;
/// Drops that one thread computes together.
const TOGETHER: usize = 8;

/// Drops whose conditions scatter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EnsembleResult {
    /// Seed of the draws.
    pub seed: u64,
    /// Drops that ran to their end.
    pub completed: usize,
    /// Drops that stopped early, with the reasons.
    pub stopped: Vec<String>,
    /// How often each state came out at the end.
    pub end_states: Vec<EndStateCount>,
    /// Fraction of the completed drops that end in backward whirl; `None` without any.
    pub backward_whirl_probability: Option<f64>,
    /// Its 95 % interval (Wilson 1927).
    pub backward_whirl_interval: Option<[f64; 2]>,
    /// Distributions over the completed drops.
    pub quantiles: Vec<Quantiles>,
    /// The drops, in the order of their indices.
    pub drops: Vec<DropRow>,
}

/// How often a state came out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EndStateCount {
    /// State.
    pub end_state: String,
    /// Drops.
    pub count: usize,
}

/// Distribution of one result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Quantiles {
    /// Result.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Least.
    pub least: f64,
    /// Median.
    pub median: f64,
    /// 95 % quantile.
    pub high: f64,
    /// Largest.
    pub most: f64,
}

/// One drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DropRow {
    /// Index of the draw.
    pub index: u64,
    /// Friction coefficient between rotor and inner ring.
    pub rotor_friction: f64,
    /// Friction coefficient of the balls.
    pub ball_friction: f64,
    /// Radial air gap, µm.
    pub air_gap_um: f64,
    /// Direction of the unbalance at the start, degrees.
    pub eccentricity_phase_deg: f64,
    /// Damping of the support, N·s/m; `None` without a support.
    pub support_damping_n_s_m: Option<f64>,
    /// Results.
    pub result: DropResult,
}

/// Checks the number of drops.
///
/// # Errors
/// [`StudyError::Option`].
pub fn check_drops(count: u64) -> Result<(), StudyError> {
    if (1..=DROPS_MAX).contains(&count) {
        return Ok(());
    }
    Err(StudyError::Option(OptionError {
        option: "samples",
        value: count.to_string(),
        problem: format!("is not possible: it must be from 1 to {DROPS_MAX}"),
    }))
}

/// Drops the rotor `count` times, on all threads; the result is the same on any number of them.
///
/// # Errors
/// The case is impossible, or the progress cancelled.
pub fn ensemble(
    case: &Case,
    count: u64,
    scatter: &Scatter,
    progress: &dyn Progress,
) -> Result<EnsembleResult, StudyError> {
    check_drops(count)?;
    case.check()?;
    let task = progress.begin("drops", count as f64);
    let indices: Vec<u64> = (0..count).collect();
    let rows: Result<Vec<Vec<DropRow>>, StudyError> = indices
        .par_chunks(TOGETHER)
        .map(|chunk| together(case, chunk, scatter, &*task))
        .collect();
    Ok(evaluate(case.seed, rows?.into_iter().flatten().collect()))
}

fn together(
    case: &Case,
    indices: &[u64],
    scatter: &Scatter,
    task: &dyn Work,
) -> Result<Vec<DropRow>, StudyError> {
    let (cases, drawn): (Vec<Case>, Vec<Drawn>) =
        indices.iter().map(|k| scatter.draw(case, *k)).unzip();
    let mut results: Vec<Option<DropResult>> = vec![None; cases.len()];
    for members in batches(&cases) {
        let mut recorders: Vec<_> = members.iter().map(|_| DropRecorder::new()).collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
            .map(|recorder| vec![recorder as &mut dyn Observer])
            .collect();
        let beside: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let mut control = task.run_control(case.solver.duration_s, members.len() as f64);
        let outcomes = run_batch(&beside, &mut observers, &mut *control);
        for ((k, outcome), recorder) in members.iter().zip(outcomes).zip(recorders) {
            let outcome = outcome.map_err(|error| StudyError::Input(error.to_string()))?;
            if matches!(outcome.ending, Ending::Interrupted) {
                return Err(StudyError::Interrupted);
            }
            results[*k] = Some(DropResult::new(&recorder.summary(&outcome.state), &outcome));
        }
    }
    let rows = indices.iter().zip(&drawn).zip(results);
    Ok(rows
        .filter_map(|((index, drawn), result)| Some(DropRow::new(*index, drawn, result?)))
        .collect())
}

impl DropRow {
    fn new(index: u64, drawn: &Drawn, result: DropResult) -> Self {
        Self {
            index,
            rotor_friction: drawn.rotor_friction,
            ball_friction: drawn.ball_friction,
            air_gap_um: 1e6 * drawn.air_gap_m,
            eccentricity_phase_deg: drawn.eccentricity_phase_rad.to_degrees(),
            support_damping_n_s_m: drawn.support_damping_n_s_m,
            result,
        }
    }
}

fn evaluate(seed: u64, drops: Vec<DropRow>) -> EnsembleResult {
    let stopped = drops
        .iter()
        .filter_map(|d| d.result.stopped.clone())
        .collect();
    let complete: Vec<&DropResult> = (drops.iter().map(|d| &d.result))
        .filter(|result| result.stopped.is_none())
        .collect();
    let count = |state: EndState| {
        let ended = |d: &&&DropResult| d.end_state == state.name();
        complete.iter().filter(ended).count()
    };
    let whirls = count(EndState::BackwardWhirl);
    let n = complete.len();
    EnsembleResult {
        seed,
        completed: n,
        stopped,
        end_states: (EndState::ALL.into_iter())
            .map(|state| EndStateCount {
                end_state: state.name().to_owned(),
                count: count(state),
            })
            .filter(|entry| entry.count > 0)
            .collect(),
        backward_whirl_probability: (n > 0).then(|| whirls as f64 / n as f64),
        backward_whirl_interval: (n > 0).then(|| wilson_interval(whirls, n)),
        quantiles: quantiles(&complete),
        drops,
    }
}

fn quantiles(complete: &[&DropResult]) -> Vec<Quantiles> {
    let tables: Vec<_> = complete.iter().map(|result| result.quantities()).collect();
    let Some(first) = tables.first() else {
        return vec![];
    };
    let of = |column: usize| {
        let (name, unit, _) = first[column];
        let mut values: Vec<f64> = tables.iter().filter_map(|table| table[column].2).collect();
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let quantile = |q: f64| values[(q * last as f64).round() as usize];
        Some(Quantiles {
            name: name.to_owned(),
            unit: unit.to_owned(),
            least: values[0],
            median: quantile(0.5),
            high: quantile(0.95),
            most: values[last],
        })
    };
    (0..first.len()).filter_map(of).collect()
}
