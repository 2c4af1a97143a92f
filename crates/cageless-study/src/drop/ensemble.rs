//! Many drops whose conditions scatter.

use cageless::Case;
use cageless::numerics::proportion::wilson_interval;
use cageless::simulation::Observer;
use cageless::touchdown::{Drawn, DropRecorder, EndState, Scatter};
use cageless_io::OptionError;
use cageless_io::plan_file::Computation;
use rayon::prelude::*;
use serde::{Serialize, Serializer};

use super::DropResult;
use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::quantities::{Kind, QUANTITIES, Quantity};
use crate::together::{Record, run_together};

/// Most drops of an ensemble.
pub const DROPS_MAX: u64 = 1_000_000;
/// Drops that one thread computes together.
const TOGETHER: usize = 8;

/// Drops whose conditions scatter.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EndStateCount {
    /// State.
    pub end_state: String,
    /// Drops.
    pub count: usize,
}

/// Distribution of one result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantiles {
    /// The result; its name in files.
    #[serde(rename = "name", serialize_with = "name")]
    pub quantity: &'static Quantity,
    /// Least.
    pub least: f64,
    /// Median.
    pub median: f64,
    /// 95 % quantile.
    pub high: f64,
    /// Largest.
    pub most: f64,
}

fn name<S: Serializer>(quantity: &&Quantity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(quantity.name)
}

/// One drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    let control = |runs: usize| task.run_control(case.solver.duration_s, runs as f64);
    let runs = run_together(&cases, |_| DropRecorder::new(), control);
    let runs = runs.ok_or(StudyError::Interrupted)?;
    let rows = indices.iter().zip(&drawn).zip(runs);
    rows.map(|((index, drawn), run)| {
        let (recorder, outcome) = run.map_err(|error| StudyError::Input(error.to_string()))?;
        let result = DropResult::new(&recorder.summary(&outcome.state), &outcome);
        Ok(DropRow::new(*index, drawn, result))
    })
    .collect()
}

impl Record for DropRecorder {
    fn observers<'s>(&'s mut self, _: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        vec![Box::new(self)]
    }
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
        let ended = |d: &&&DropResult| d.end_state() == state.name();
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
    let numbers = QUANTITIES.iter().filter(|q| {
        q.computation() == Computation::Drop && matches!(q.kind, Kind::Number | Kind::Integer)
    });
    let of = |quantity: &'static Quantity| {
        let mut values: Vec<f64> = (complete.iter())
            .filter_map(|result| result.value(quantity.name))
            .collect();
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let quantile = |q: f64| values[(q * last as f64).round() as usize];
        Some(Quantiles {
            quantity,
            least: values[0],
            median: quantile(0.5),
            high: quantile(0.95),
            most: values[last],
        })
    };
    numbers.filter_map(of).collect()
}
