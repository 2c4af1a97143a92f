//! Verdict on the passages of a run, or of runs from several starts.

use super::RacewayVerdict;
use super::criterion::{Criterion, percent_beside};
use super::raceway_tallies::RacewayTallies;
use crate::case::Case;
use crate::numerics::moments::Moments;

/// Whether the balls passed the raceways of a run as they should. It rests on deceleration or lag and on
/// contacts alone: the critical gap takes runs of its own, see [`super::judge`].
#[derive(Debug, Clone, PartialEq)]
pub struct RunVerdict {
    /// The worst of the raceways.
    pub verdict: RacewayVerdict,
    /// The criterion that decides; `None` if nothing was judged.
    pub deciding: Option<Criterion>,
    /// Standard error of its value over several starts; `None` of one run.
    pub standard_error: Option<f64>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
    /// Slowing and double collisions in each raceway; `None` where no ball passed.
    of_raceways: Vec<Option<[Criterion; 2]>>,
}

impl RunVerdict {
    /// Verdict from the passages of a run of the case.
    pub fn from_case(case: &Case, passages: &RacewayTallies) -> Self {
        let of_raceway = |k: usize| {
            let twice = passages.of_raceway(k).double_collision_fraction();
            let slowing = case.rotor.is_none().then(|| passages.slowing(case, k))??;
            Some([slowing, Criterion::BothNeighbours(twice)])
        };
        let of_raceways: Vec<_> = (0..case.raceways.len()).map(of_raceway).collect();
        let all: Vec<_> = (of_raceways.iter().flatten().flatten())
            .map(|criterion| (*criterion, None))
            .collect();
        let reason = "no ball has passed a discrete raceway since the transient";
        Self {
            of_raceways,
            ..Self::of(case, &all, "this run", reason)
        }
    }

    /// Verdict from the mean of each criterion over runs of the case from several starts. One that passes
    /// from some starts and fails from others is judged by what it does on average.
    pub fn of_starts(case: &Case, runs: &[Self]) -> Self {
        let mut all = vec![];
        for (raceway, side) in (0..case.raceways.len()).flat_map(|k| [(k, 0), (k, 1)]) {
            let of_run = |run: &Self| Some(run.of_raceways.get(raceway)?.as_ref()?[side]);
            let found: Vec<Criterion> = runs.iter().filter_map(of_run).collect();
            let Some(criterion) = found.first() else {
                continue;
            };
            let mut moments = Moments::default();
            found.iter().for_each(|c| moments.add(c.value(), 1.0));
            let error = moments.deviation() / (moments.weight() - 1.0).sqrt();
            let error = (found.len() > 1).then_some(error);
            all.push((criterion.with_value(moments.mean()), error));
        }
        let judged = |run: &&Self| run.deciding.is_some();
        let over = match (runs.iter().filter(judged).count(), runs.len()) {
            (judged, all) if judged == all => format!("the mean of {all} starts"),
            (judged, all) => format!("the mean of {judged} of {all} starts"),
        };
        let reason = "no ball has passed a discrete raceway since the transient of any start";
        Self::of(case, &all, &over, reason)
    }

    /// Verdict on a run of the case that ended early, which has none.
    pub fn unfinished(case: &Case, reason: &str) -> Self {
        Self::of(case, &[], "", reason)
    }

    /// Verdict from criteria with their standard errors, `over` what they were read from; `reason` is why there
    /// are none where the case has something to judge.
    fn of(case: &Case, all: &[(Criterion, Option<f64>)], over: &str, reason: &str) -> Self {
        let criteria: Vec<Criterion> = all.iter().map(|(criterion, _)| *criterion).collect();
        let deciding = Criterion::deciding(&criteria);
        let standard_error = deciding.and_then(|criterion| {
            let place = criteria.iter().position(|c| *c == criterion)?;
            all[place].1
        });
        let verdict = match deciding {
            None => RacewayVerdict::NotJudged,
            Some(criterion) => criterion.verdict(),
        };
        let headline = match deciding {
            None if case.rotor.is_some() => {
                "not judged: the inner ring has no constant speed under a falling rotor; \
                 `cageless drop` judges the drop"
                    .to_owned()
            }
            None if case.raceways.is_empty() => {
                "not judged: the outer ring has no discrete raceway".to_owned()
            }
            None => format!("not judged: {reason}"),
            Some(criterion) => {
                let (word, nearest) = if criterion.is_met() {
                    ("PASS", "nearest to its limit: ")
                } else {
                    ("FAIL", "")
                };
                let error = standard_error.map_or(String::new(), |error| {
                    let shown = percent_beside(error, 0.0);
                    let points = shown.trim_end_matches(" %");
                    format!(", standard error {points} percentage points")
                });
                format!(
                    "{word} in {over}: {}; {nearest}{criterion}{error}; for the \
                     critical gap run `cageless design`",
                    verdict.label()
                )
            }
        };
        Self {
            verdict,
            deciding,
            standard_error,
            headline,
            of_raceways: vec![],
        }
    }
}
