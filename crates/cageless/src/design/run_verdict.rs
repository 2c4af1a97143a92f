//! Verdict on the passages of one run.

use super::RacewayVerdict;
use super::criterion::Criterion;
use super::raceway_tallies::RacewayTallies;
use crate::case::Case;

/// Whether the balls passed the raceways of a run as they should. It rests on deceleration or lag and on
/// contacts alone: the critical gap takes runs of its own, see [`super::judge`].
#[derive(Debug, Clone, PartialEq)]
pub struct RunVerdict {
    /// The worst of the raceways.
    pub verdict: RacewayVerdict,
    /// The criterion that decides; `None` if nothing was judged.
    pub deciding: Option<Criterion>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
}

impl RunVerdict {
    /// Verdict from the passages of a run of the case.
    pub fn from_case(case: &Case, passages: &RacewayTallies) -> Self {
        let raceways = 0..case.raceways.len();
        let all: Vec<Criterion> = raceways
            .filter(|_| case.rotor.is_none())
            .filter_map(|k| {
                let twice = passages.of_raceway(k).double_collision_fraction();
                Some([passages.slowing(case, k)?, Criterion::BothNeighbours(twice)])
            })
            .flatten()
            .collect();
        let deciding = Criterion::deciding(&all);
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
            None => {
                "not judged: no ball has passed a discrete raceway since the transient".to_owned()
            }
            Some(criterion) => {
                let (word, nearest) = if criterion.is_met() {
                    ("PASS", "nearest to its limit: ")
                } else {
                    ("FAIL", "")
                };
                format!(
                    "{word} in this run: {}; {nearest}{criterion}; for the \
                     critical gap run `cageless design`",
                    verdict.label()
                )
            }
        };
        Self {
            verdict,
            deciding,
            headline,
        }
    }
}
