//! Many drops onto one bearing whose conditions scatter.

use cageless::Case;
use cageless::simulation::Observer;
use cageless::touchdown::{Drawn, DropRecorder, Scatter};
use rayon::prelude::*;
use serde::Serialize;

use cageless_results::DropResult;

use super::{BearingRow, Distribution, check_drops};
use crate::StudyError;
use crate::progress::{Progress, Work};
use crate::together::{Record, run_together};

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
    /// What came out of the completed drops.
    #[serde(flatten)]
    pub distribution: Distribution,
    /// The drops, in the order of their indices.
    pub drops: Vec<DropRow>,
}

/// One drop of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DropRow {
    /// Index of the draw.
    pub index: u64,
    /// Direction of the unbalance at the start, degrees.
    pub eccentricity_phase_deg: f64,
    /// Bearing.
    #[serde(flatten)]
    pub bearing: BearingRow,
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
    cageless::step_limits::check(case)?;
    let task = progress.begin("drops", count as f64);
    let indices: Vec<u64> = (0..count).collect();
    let rows: Result<Vec<Vec<DropRow>>, StudyError> = indices
        .par_chunks(TOGETHER)
        .map(|chunk| together(case, chunk, scatter, &task))
        .collect();
    Ok(evaluate(case.seed, rows?.into_iter().flatten().collect()))
}

fn together(
    case: &Case,
    indices: &[u64],
    scatter: &Scatter,
    task: &Work<'_>,
) -> Result<Vec<DropRow>, StudyError> {
    // Short drops end before they ask for the first time.
    if task.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let (cases, drawn): (Vec<Case>, Vec<Drawn>) =
        indices.iter().map(|k| scatter.draw(case, *k)).unzip();
    let control = |runs: usize| task.run_control(case.solver.duration_s, runs as f64);
    let runs = run_together(&cases, |_| DropRecorder::new(), control);
    let runs = runs.ok_or(StudyError::Interrupted)?;
    let rows = indices.iter().zip(&cases).zip(&drawn).zip(runs);
    rows.map(|(((index, case), drawn), run)| {
        let (recorder, outcome) = run.map_err(|error| StudyError::Input(error.to_string()))?;
        let result = DropResult::new(case, &recorder.summary(&outcome.state), &outcome);
        Ok(DropRow {
            index: *index,
            eccentricity_phase_deg: drawn.eccentricity_phase_rad.to_degrees(),
            bearing: BearingRow::new(&drawn.bearing, result),
        })
    })
    .collect()
}

impl Record for DropRecorder {
    fn observers<'s>(&'s mut self, _: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        vec![Box::new(self)]
    }
}

fn evaluate(seed: u64, drops: Vec<DropRow>) -> EnsembleResult {
    let results = || drops.iter().map(|drop| &drop.bearing.result);
    let complete: Vec<&DropResult> = results().filter(|r| r.stopped.is_none()).collect();
    EnsembleResult {
        seed,
        completed: complete.len(),
        stopped: results().filter_map(|r| r.stopped.clone()).collect(),
        distribution: Distribution::new(&complete),
        drops,
    }
}
