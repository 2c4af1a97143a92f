//! Tolerance table and probability of passing from judged trials.

use super::deviation::{Influence, Trial};
use super::sample_count::SampleCount;
use crate::{Judgement, PassageStatistics, RacewayVerdict};
use cageless::numerics::quantile;

/// Result of one trial.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The verdict.
    pub verdict: RacewayVerdict,
    /// Critical gap, if there is one.
    pub critical_gap_rad: Option<f64>,
    /// Steady-state gap that it is judged over.
    pub steady_gap_rad: Option<f64>,
    /// Passages of the most critical raceway; `None` without any.
    pub passages: Option<PassageStatistics>,
    /// Reason if infeasible or not judged.
    pub reason: Option<String>,
    /// Whether it works, with the verdict, the criterion that decides, and its margin.
    pub headline: String,
    /// Outcome of the same bearing without oil; `None` of a dry one.
    pub dry: Option<Box<Outcome>>,
}

impl Outcome {
    /// Whether the bearing passes; `None` where it is not judged.
    pub fn passes(&self) -> Option<bool> {
        self.verdict.passes()
    }

    /// Whether it neither passes nor fails, as its run stopped.
    pub fn is_open(&self) -> bool {
        self.verdict == RacewayVerdict::NotJudged
    }

    /// Outcome of a bearing that was judged; one whose run stopped is not.
    pub fn judged(judgement: &Judgement) -> Self {
        let dry = judgement.dry.as_deref();
        let dry = dry.map(|dry| Box::new(Self::judged(dry)));
        let stopped = judgement.stopped.as_ref();
        if let Some(stop) = stopped.filter(|stop| !stop.cause.gives_way()) {
            let reason = format!("the run stopped {}", stop.reason());
            return Self {
                verdict: RacewayVerdict::NotJudged,
                critical_gap_rad: None,
                steady_gap_rad: None,
                passages: None,
                headline: format!("not judged: {reason}"),
                reason: Some(reason),
                dry,
            };
        }
        Self {
            verdict: judgement.verdict,
            critical_gap_rad: judgement.critical_gap_rad,
            steady_gap_rad: judgement.steady_gap_rad,
            passages: judgement.passages,
            reason: matches!(
                judgement.verdict,
                RacewayVerdict::Infeasible | RacewayVerdict::NotJudged
            )
            .then(|| judgement.reasons.join("; ")),
            headline: judgement.headline(),
            dry,
        }
    }

    /// Outcome of a bearing that cannot be built.
    pub fn impossible(reason: String) -> Self {
        Self {
            verdict: RacewayVerdict::Infeasible,
            critical_gap_rad: None,
            steady_gap_rad: None,
            passages: None,
            headline: format!(
                "{}: {}; {reason}",
                RacewayVerdict::works(Some(false)),
                RacewayVerdict::Infeasible.label()
            ),
            reason: Some(reason),
            dry: None,
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

/// Lowest and highest value of outcomes; `None` if one of them has no value.
fn range<'o>(
    outcomes: impl Iterator<Item = &'o Outcome>,
    of: impl Fn(&'o Outcome) -> Option<f64>,
) -> Interval {
    let values: Option<Vec<f64>> = outcomes.map(of).collect();
    interval(values?.into_iter())
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
    /// Reasons of the trials whose run stopped.
    pub open: Vec<String>,
    /// Critical gaps, this and the numbers below with those of the nominal bearing; `None` if a bearing has none.
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
    /// Number of bearings that pass.
    pub passed: usize,
    /// Number of bearings that are not judged: they neither pass nor fail.
    pub open: usize,
    /// Number of each verdict.
    pub verdicts: [(RacewayVerdict, usize); RacewayVerdict::ALL.len()],
    /// Probability of passing; `None` if some are open.
    pub pass_probability: Option<f64>,
    /// 95 % interval of the probability (Wilson 1927), whatever those that are open would do.
    pub pass_probability_interval: [f64; 2],
    /// 5 %, 50 % and 95 % quantile of the critical gap; `None` if a bearing has none.
    pub critical_gap_quantiles_rad: Option<[f64; 3]>,
    /// Every outcome.
    pub outcomes: Vec<Outcome>,
}

impl Samples {
    /// How many of them pass.
    fn count(&self) -> SampleCount {
        SampleCount {
            passed: self.passed,
            count: self.count,
            open: self.open,
        }
    }

    /// Whether 95 % of all bearings pass; `None` where the interval leaves it open.
    pub(crate) fn passes(&self) -> Option<bool> {
        self.count().passes()
    }
}

/// The tolerance table and the probability.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The nominal bearing.
    pub nominal: Outcome,
    /// One influence at a time; those without a tolerance, or without all of their bearings, are left out.
    pub influences: Vec<InfluenceResult>,
    /// Influences that lack bearings, because the analysis was interrupted.
    pub incomplete: Vec<Influence>,
    /// All at once; `None` without samples.
    pub samples: Option<Samples>,
    /// Bearings that were judged.
    pub judged: usize,
    /// Bearings that were to be judged.
    pub asked: usize,
}

impl Assessment {
    /// Whether the tolerances pass: the nominal bearing does, and `PASS_FRACTION` of those in which
    /// everything deviates, if there are any. `None` where a nominal bearing that passes is all that is known for
    /// sure: the analysis was interrupted, or has too few bearings.
    pub fn passes(&self) -> Option<bool> {
        match &self.samples {
            _ if self.nominal.passes() != Some(true) => self.nominal.passes(),
            _ if self.is_interrupted() => None,
            None => Some(true),
            Some(samples) => samples.passes(),
        }
    }

    /// Whether it lacks bearings that were to be judged.
    pub fn is_interrupted(&self) -> bool {
        self.judged < self.asked
    }

    /// Whether it works, with the probability of passing and the verdict on the nominal bearing, or why there is none.
    pub fn headline(&self) -> String {
        let word = RacewayVerdict::works(self.passes());
        let nominal = &self.nominal.headline;
        let samples = self.samples.as_ref().map(|s| self.of_samples(s));
        let interrupted = self.is_interrupted().then(|| {
            format!(
                "interrupted after {} of {} bearings",
                self.judged, self.asked
            )
        });
        let reasons: Vec<String> = interrupted.into_iter().chain(samples).collect();
        match reasons.as_slice() {
            // Nothing says what deviations together do.
            [] if self.passes() == Some(true) => {
                format!(
                    "{word} as drawn, all tolerances together are not judged; nominal design {nominal}"
                )
            }
            [] => format!("{word}; nominal design {nominal}"),
            reasons => format!("{word}: {}; nominal design {nominal}", reasons.join("; ")),
        }
    }

    /// How many of the samples pass, and what keeps them from being judged.
    fn of_samples(&self, samples: &Samples) -> String {
        let count = samples.count();
        let decides = self.nominal.passes() == Some(true) && !self.is_interrupted();
        let open = count.why_open("bearings").filter(|_| decides);
        count.text("bearings") + &open.map_or(String::new(), |why| format!("; {why}"))
    }

    /// Number of bearings whose run stopped, and the reason of the first; `None` without any.
    pub fn stopped(&self) -> Option<(usize, &str)> {
        let rows = self.influences.iter().flat_map(|row| &row.open);
        let samples = self.samples.iter().flat_map(|samples| {
            let open = samples.outcomes.iter().filter(|o| o.is_open());
            open.filter_map(|o| o.reason.as_ref())
        });
        let mut all = rows.chain(samples);
        let first = all.next()?;
        Some((1 + all.count(), first))
    }
}

/// Puts together what became of [`super::trials`], in their order; `None` of those that were not judged.
///
/// # Panics
/// If there is not one entry per trial, or no outcome of the first, the nominal bearing.
pub fn assess(trials: &[Trial], outcomes: &[Option<Outcome>]) -> Assessment {
    assert_eq!(trials.len(), outcomes.len());
    let [Some(nominal), ..] = outcomes else {
        panic!("the nominal bearing is not judged");
    };
    let of = |influence: Option<Influence>| {
        let all = trials.iter().zip(outcomes).skip(1);
        let all = all.filter(move |(trial, _)| trial.influence == influence);
        all.map(|(_, outcome)| outcome.as_ref())
    };
    let (mut influences, mut incomplete) = (vec![], vec![]);
    for influence in Influence::ALL {
        match of(Some(influence)).collect::<Option<Vec<&Outcome>>>() {
            None => incomplete.push(influence),
            Some(all) if all.is_empty() => {}
            Some(all) => influences.push(row(influence, nominal, &all)),
        }
    }
    let sampled: Vec<Outcome> = of(None).flatten().cloned().collect();
    Assessment {
        influences,
        incomplete,
        samples: (!sampled.is_empty()).then(|| samples(sampled)),
        judged: outcomes.iter().flatten().count(),
        asked: trials.len(),
        nominal: nominal.clone(),
    }
}

fn row(influence: Influence, nominal: &Outcome, of: &[&Outcome]) -> InfluenceResult {
    let mut verdicts: Vec<RacewayVerdict> = of.iter().map(|o| o.verdict).collect();
    verdicts.sort();
    verdicts.dedup();
    let all = || of.iter().copied().chain([nominal]);
    let over =
        |of: fn(&PassageStatistics) -> f64| range(all(), move |o| o.passages.as_ref().map(of));
    let open = of.iter().filter(|o| o.is_open());
    InfluenceResult {
        influence,
        trials: of.len(),
        passed: of.iter().filter(|o| o.passes() == Some(true)).count(),
        verdicts,
        open: open.filter_map(|o| o.reason.clone()).collect(),
        critical_gap_rad: range(all(), |o| o.critical_gap_rad),
        lag_fraction: over(|p| p.lag_fraction),
        double_collision_fraction: over(|p| p.double_collision_fraction),
        sliding_mean_m_s: over(|p| p.sliding_mean_m_s),
    }
}

fn samples(outcomes: Vec<Outcome>) -> Samples {
    let count = outcomes.len();
    let number = |verdict| outcomes.iter().filter(|o| o.verdict == verdict).count();
    let passed = outcomes.iter().filter(|o| o.passes() == Some(true)).count();
    let open = number(RacewayVerdict::NotJudged);
    let gaps: Option<Vec<f64>> = outcomes.iter().map(|o| o.critical_gap_rad).collect();
    let quantiles = gaps.map(|mut gaps| {
        gaps.sort_by(f64::total_cmp);
        [0.05, 0.5, 0.95].map(|p| quantile(&gaps, p))
    });
    let sample = SampleCount {
        passed,
        count,
        open,
    };
    Samples {
        count,
        passed,
        open,
        verdicts: RacewayVerdict::ALL.map(|verdict| (verdict, number(verdict))),
        pass_probability: sample.probability(),
        pass_probability_interval: sample.interval(),
        critical_gap_quantiles_rad: quantiles,
        outcomes,
    }
}
