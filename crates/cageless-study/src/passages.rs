//! Passages of a run after its transient, with the verdict on them.

use std::collections::VecDeque;

use cageless::Case;
use cageless::design::RunVerdict;
use cageless::passage::{Passage, PassageRecorder, PassageTally};
use cageless::simulation::Observer;
use cageless::summary::transient_s;

/// Most of the last passages that are kept one by one.
const RECENT: usize = 60;

/// Tallies of the passages after the transient.
#[derive(Debug, Clone)]
pub struct Passages {
    /// Passages through all raceways.
    pub all: PassageTally,
    /// Passages through each raceway of the case.
    pub of_raceway: Vec<PassageTally>,
    /// The last of them, one by one.
    pub recent: VecDeque<Passage>,
}

impl Passages {
    /// Empty tallies of a run of `case`.
    pub fn new(case: &Case) -> Self {
        Self {
            all: PassageTally::new(),
            of_raceway: vec![PassageTally::new(); case.raceways.len()],
            recent: VecDeque::new(),
        }
    }

    /// Observer that adds the passages of a run of `case`.
    pub fn recorder(&mut self, case: &Case) -> impl Observer + use<'_> {
        let settled_s = transient_s(case);
        PassageRecorder::new(move |passage| {
            if passage.enter_s > settled_s {
                self.all.add(&passage);
                self.of_raceway[passage.raceway].add(&passage);
                if self.recent.len() == RECENT {
                    self.recent.pop_front();
                }
                self.recent.push_back(passage);
            }
            Ok(())
        })
    }

    /// Verdict on the passages.
    pub fn verdict(&self, case: &Case) -> RunVerdict {
        RunVerdict::from_case(case, &self.of_raceway)
    }
}
