//! Tolerance table and probability of passing from judged trials.

use super::deviation::{Influence, Trial};
use crate::design::{Judgement, PassageStatistics, RacewayVerdict};
use crate::numerics::proportion::wilson_interval;
use crate::numerics::quantile::quantile;

/// Result of one trial.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The verdict.
    pub verdict: RacewayVerdict,
    /// Critical gap, if there is one.
    pub critical_gap_rad: Option<f64>,
    /// Passages of the most critical raceway; `None` without any.
    pub passages: Option<PassageStatistics>,
    /// Reason if infeasible.
    pub reason: Option<String>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
}

impl Outcome {
    /// Whether the bearing passes.
    pub fn passes(&self) -> bool {
        self.verdict.passes() == Some(true)
    }

    /// Outcome of a bearing that was judged.
    pub fn judged(judgement: &Judgement) -> Self {
        Self {
            verdict: judgement.verdict,
            critical_gap_rad: judgement.critical_gap_rad,
            passages: judgement.passages,
            reason: (judgement.verdict == RacewayVerdict::Infeasible)
                .then(|| judgement.reasons.join("; ")),
            headline: judgement.headline(),
        }
    }

    /// Outcome of a bearing that cannot be built.
    pub fn impossible(reason: String) -> Self {
        Self {
            verdict: RacewayVerdict::Infeasible,
            critical_gap_rad: None,
            passages: None,
            headline: format!("FAIL: {}; {reason}", RacewayVerdict::Infeasible.label()),
            reason: Some(reason),
        }
    }
}

/// Lowest and highest value; `None` without any.
pub type Interval = Option<[f64; 2]>;

fn interval(values: impl Iterator<Item = f64>) -> Interval {
    values.fold(None, |range: Interval, v| {
        let [low, high] = range.unwrap_or([v, v]);
        Some([low.min(v), high.max(v)])
    })
}

/// One row of the tolerance table.
#[derive(Debug, Clone, PartialEq)]
pub struct InfluenceResult {
    /// The only influence that deviates.
    pub influence: Influence,
    /// Trials.
    pub trials: usize,
    /// Trials that pass.
    pub passed: usize,
    /// Verdicts that came out, worst last.
    pub verdicts: Vec<RacewayVerdict>,
    /// Critical gaps, this and the numbers below with those of the nominal bearing.
    pub critical_gap_rad: Interval,
    /// Shares of the lag.
    pub lag_fraction: Interval,
    /// Shares of passages hit by both neighbours.
    pub double_collision_fraction: Interval,
    /// Slip per passage.
    pub sliding_mean_m_s: Interval,
}

/// The bearings in which everything deviates.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// Number of samples or passages.
    pub count: usize,
    /// Those that pass.
    pub passed: usize,
    /// Number of each verdict.
    pub verdicts: [(RacewayVerdict, usize); 6],
    /// Probability of passing.
    pub pass_probability: f64,
    /// 95 % interval of the probability (Wilson 1927).
    pub pass_probability_interval: [f64; 2],
    /// 5 %, 50 % and 95 % quantile of the critical gap of those that have one.
    pub critical_gap_quantiles_rad: Option<[f64; 3]>,
    /// Every outcome.
    pub outcomes: Vec<Outcome>,
}

/// Fraction of the bearings that have to pass for the tolerances to pass.
pub const PASS_FRACTION: f64 = 0.95;

/// The tolerance table and the probability.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The nominal bearing.
    pub nominal: Outcome,
    /// One influence at a time; those without a tolerance are left out.
    pub influences: Vec<InfluenceResult>,
    /// All at once; `None` without samples.
    pub samples: Option<Samples>,
}

impl Assessment {
    /// Whether the tolerances pass: the nominal bearing does, and `PASS_FRACTION` of those in which
    /// everything deviates, if there are any.
    pub fn passes(&self) -> bool {
        let samples = self.samples.as_ref();
        self.nominal.passes() && samples.is_none_or(|s| s.pass_probability >= PASS_FRACTION)
    }

    /// PASS or FAIL with the probability of passing and the verdict on the nominal bearing.
    pub fn headline(&self) -> String {
        let word = if self.passes() { "PASS" } else { "FAIL" };
        let nominal = &self.nominal.headline;
        match &self.samples {
            None => format!("{word}; nominal design {nominal}"),
            Some(s) => {
                let [low, high] = s.pass_probability_interval.map(|p| 100.0 * p);
                format!(
                    "{word}: {} of {} bearings pass, probability of passing {:.1} % (95 % interval \
                     {low:.1} to {high:.1} %, {:.0} % needed); nominal design {nominal}",
                    s.passed,
                    s.count,
                    100.0 * s.pass_probability,
                    100.0 * PASS_FRACTION
                )
            }
        }
    }
}

/// Puts together what became of [`super::trials`], in their order.
///
/// # Panics
/// If there is not one outcome per trial, the first that of the nominal bearing.
pub fn assess(trials: &[Trial], outcomes: &[Outcome]) -> Assessment {
    assert!(!trials.is_empty() && trials.len() == outcomes.len());
    let nominal = outcomes[0].clone();
    let judged = || trials.iter().zip(outcomes).skip(1);
    let influences = Influence::ALL
        .into_iter()
        .filter_map(|influence| {
            let of: Vec<&Outcome> = judged()
                .filter(|(trial, _)| trial.influence == Some(influence))
                .map(|(_, outcome)| outcome)
                .collect();
            (!of.is_empty()).then(|| row(influence, &nominal, &of))
        })
        .collect();
    let sampled: Vec<Outcome> = judged()
        .filter(|(trial, _)| trial.influence.is_none())
        .map(|(_, outcome)| outcome.clone())
        .collect();
    Assessment {
        influences,
        samples: (!sampled.is_empty()).then(|| samples(sampled)),
        nominal,
    }
}

fn row(influence: Influence, nominal: &Outcome, of: &[&Outcome]) -> InfluenceResult {
    let mut verdicts: Vec<RacewayVerdict> = of.iter().map(|o| o.verdict).collect();
    verdicts.sort();
    verdicts.dedup();
    let all = || of.iter().copied().chain([nominal]);
    let over = |of: fn(&PassageStatistics) -> f64| {
        interval(all().filter_map(|o| o.passages.as_ref().map(of)))
    };
    InfluenceResult {
        influence,
        trials: of.len(),
        passed: of.iter().filter(|o| o.passes()).count(),
        verdicts,
        critical_gap_rad: interval(all().filter_map(|o| o.critical_gap_rad)),
        lag_fraction: over(|p| p.lag_fraction),
        double_collision_fraction: over(|p| p.double_collision_fraction),
        sliding_mean_m_s: over(|p| p.sliding_mean_m_s),
    }
}

fn samples(outcomes: Vec<Outcome>) -> Samples {
    let count = outcomes.len();
    let number = |verdict| outcomes.iter().filter(|o| o.verdict == verdict).count();
    let passed = outcomes.iter().filter(|o| o.passes()).count();
    let mut gaps: Vec<f64> = outcomes.iter().filter_map(|o| o.critical_gap_rad).collect();
    gaps.sort_by(f64::total_cmp);
    Samples {
        count,
        passed,
        verdicts: [
            RacewayVerdict::Smooth,
            RacewayVerdict::DoubleCollision,
            RacewayVerdict::Slips,
            RacewayVerdict::LosesLag,
            RacewayVerdict::Overloaded,
            RacewayVerdict::Infeasible,
        ]
        .map(|verdict| (verdict, number(verdict))),
        pass_probability: passed as f64 / count as f64,
        pass_probability_interval: wilson_interval(passed, count),
        critical_gap_quantiles_rad: (!gaps.is_empty())
            .then(|| [0.05, 0.5, 0.95].map(|p| quantile(&gaps, p))),
        outcomes,
    }
}
