//! The result of a tolerance analysis in display units.

use serde::{Deserialize, Serialize};

use crate::Provenance;

/// One influence on its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InfluenceRow {
    /// Parameter that deviates.
    pub name: String,
    /// Lowest and highest deviation, in `unit`.
    pub low: f64,
    /// Upper end of the range, in `unit`.
    pub high: f64,
    /// Unit of the deviation; empty for a pure number.
    pub unit: String,
    /// Bearings judged.
    pub trials: usize,
    /// Bearings that pass.
    pub passed: usize,
    /// Verdicts that came out.
    pub verdicts: Vec<String>,
    /// Smallest and largest critical gap, degrees.
    pub critical_gap_deg: Option<[f64; 2]>,
    /// Smallest and largest share of passages hit by both neighbours.
    pub double_collision_fraction: Option<[f64; 2]>,
    /// Smallest and largest mean slip per passage, m/s.
    pub sliding_mean_m_s: Option<[f64; 2]>,
}

/// Number of bearings with a verdict.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VerdictCount {
    /// Its name.
    pub verdict: String,
    /// Whether a bearing with it passes.
    pub passes: Option<bool>,
    /// Number of occurrences.
    pub count: usize,
    /// Critical gaps of these bearings, degrees.
    pub critical_gap_deg: Vec<f64>,
}

/// Bearings in which everything deviates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SampleData {
    /// Number of samples or passages.
    pub count: usize,
    /// Seed that they come from.
    pub seed: u64,
    /// Bearings that pass.
    pub passed: usize,
    /// Probability of passing.
    pub pass_probability: f64,
    /// 95 % interval of the probability of passing.
    pub pass_probability_interval: [f64; 2],
    /// Samples by verdict.
    pub verdicts: Vec<VerdictCount>,
    /// 5 %, 50 % and 95 % quantile of the critical gap, degrees.
    pub critical_gap_quantiles_deg: Option<[f64; 3]>,
    /// Reason of the first infeasible one.
    pub first_impossible: Option<String>,
}

/// Fewest bearings of which the 5 % and 95 % quantiles are no extremes.
const QUANTILES_FROM: usize = 20;

impl SampleData {
    /// The quantiles of the critical gap in a sentence, by what they are; `None` without any.
    pub fn quantiles_text(&self) -> Option<String> {
        let [low, middle, high] = self.critical_gap_quantiles_deg?;
        let gaps: usize = self.verdicts.iter().map(|v| v.critical_gap_deg.len()).sum();
        let names = if gaps < QUANTILES_FROM {
            "smallest, median, largest"
        } else {
            "5 %, 50 %, 95 %"
        };
        Some(format!(
            "Critical gap of {gaps} bearings, {names}: {low:.4}°, {middle:.4}°, {high:.4}°"
        ))
    }
}

/// Data of the tolerance page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ToleranceData {
    /// Heading.
    pub title: String,
    /// Program and instruction set.
    pub software: String,
    /// Provenance of the numbers.
    pub provenance: Provenance,
    /// Grade of the balls, 0 for equal ones.
    pub ball_grade: u32,
    /// Whether the tolerances pass: the bearing as drawn, and enough of those that deviate.
    pub passes: bool,
    /// PASS or FAIL with the probability of passing and the reason.
    pub headline: String,
    /// Whether the bearing as drawn passes.
    pub nominal_passes: bool,
    /// Verdict as drawn.
    pub nominal_verdict: String,
    /// Critical gap as drawn, degrees.
    pub nominal_critical_gap_deg: Option<f64>,
    /// Share of passages hit by both neighbours, as drawn.
    pub nominal_double_collision_fraction: Option<f64>,
    /// Mean slip per passage, as drawn, m/s.
    pub nominal_sliding_m_s: Option<f64>,
    /// Gap of evenly spaced balls, degrees.
    pub uniform_gap_deg: f64,
    /// One influence at a time.
    pub influences: Vec<InfluenceRow>,
    /// All at once.
    pub samples: Option<SampleData>,
}
