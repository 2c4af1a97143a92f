//! Passages of a run after its transient, with the verdict on them.

use std::collections::VecDeque;

use cageless::Case;
use cageless::passage::{Passage, PassageRecorder, PassageTally};
use cageless::simulation::{Observer, RunOutcome};
use cageless::summary::{Summary, transient_s};
use cageless_design::{RacewayTallies, RunEvidence, RunVerdict};
use cageless_results::Stopped;

/// Most of the last passages that are kept one by one.
const RECENT: usize = 60;

/// Tallies of the passages after the transient.
#[derive(Debug, Clone)]
pub struct Passages {
    /// Passages through all raceways.
    pub all: PassageTally,
    /// Passages through each raceway of the case.
    pub of_raceway: RacewayTallies,
    /// The last of them, one by one.
    pub recent: VecDeque<Passage>,
}

impl Passages {
    /// Empty tallies of a run of `case`.
    pub fn new(case: &Case) -> Self {
        Self {
            all: PassageTally::new(),
            of_raceway: RacewayTallies::new(case),
            recent: VecDeque::new(),
        }
    }

    /// Observer that adds the passages of a run of `case`.
    pub fn recorder(&mut self, case: &Case) -> impl Observer + use<'_> {
        let settled_s = transient_s(case);
        PassageRecorder::new(move |passage| {
            if passage.enter_s > settled_s {
                self.all.add(&passage);
                self.of_raceway.add(&passage);
                if self.recent.len() == RECENT {
                    self.recent.pop_front();
                }
                self.recent.push_back(passage);
            }
            Ok(())
        })
    }

    /// Verdict on a run with this outcome and summary; one that ended early is not judged.
    pub fn verdict(
        &self,
        case: &Case,
        outcome: &RunOutcome,
        summary: Option<&Summary>,
    ) -> RunVerdict {
        if let Some(stopped) = Stopped::of(case, outcome) {
            return RunVerdict::unfinished(case, &stopped.reason(case));
        }
        let run = RunEvidence {
            passages: &self.of_raceway,
            pressure_max_pa: summary.map(|s| s.peaks.pressure_max_pa()),
            half_turn_lag_rad: summary.and_then(|s| s.half_turn_lag_rad),
        };
        RunVerdict::new(case, &run)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cageless::simulation::{Control, Ending, run};
    use cageless_io::case_file::{CaseFile, template};

    /// Passages after two orbits of the balls are tallied, in all and raceway by raceway; the last 60
    /// are kept one by one.
    #[test]
    fn passages_after_the_transient_are_tallied() {
        let two = template(false).replace("[raceway]", "[[raceway]]").replace(
            "[operation]",
            "[[raceway]]\naxial_span_mm = 5.4\nhalf_angle_deg = 18.167\ncentre_angle_deg = 90.0\n\
             [operation]",
        );
        let changes = ["solver.duration_s=0.1".to_owned()];
        let file = CaseFile::parse(&two, "case.toml", &changes).unwrap();
        let case = file.case();
        let (mut all, mut passages) = (vec![], Passages::new(case));
        let mut outcome = {
            let mut every = PassageRecorder::new(|passage| {
                all.push(passage);
                Ok(())
            });
            let mut recorder = passages.recorder(case);
            run(case, &mut [&mut every, &mut recorder], &mut |_| {
                Control::Continue(())
            })
            .unwrap()
        };
        // Ω = ωi·Ri/(Ri + Ro) of rolling balls.
        let orbit = case.operation.inner_speed_rad_s * 18.24 / (18.24 + 27.765);
        let settled_s = 2.0 * std::f64::consts::TAU / orbit;
        let late: Vec<Passage> = (all.iter().copied())
            .filter(|passage| passage.enter_s > settled_s)
            .collect();
        assert!(late.len() > 100 && all.len() > late.len() + 20);
        let tally = |raceway: Option<usize>| {
            let mut tally = PassageTally::new();
            let of = late
                .iter()
                .filter(|p| raceway.is_none_or(|r| p.raceway == r));
            of.for_each(|passage| tally.add(passage));
            tally
        };
        assert_eq!(passages.all, tally(None));
        let [first, second] = [0, 1].map(|k| *passages.of_raceway.of_raceway(k));
        assert_eq!([first, second], [0, 1].map(|k| tally(Some(k))));
        assert_ne!(first, second);
        assert!(passages.recent.iter().eq(&late[late.len() - 60..]));
        let verdict = passages.verdict(case, &outcome, None);
        assert!(verdict.deciding.is_some());
        // The same passages of a longer run that was ended are no verdict on it.
        outcome.ending = Ending::Interrupted;
        let verdict = passages.verdict(case, &outcome, None);
        assert_eq!(
            verdict.headline,
            "not judged: interrupted after 0.1 s of 0.1 s"
        );
        assert_eq!(verdict.deciding, None);
    }
}
