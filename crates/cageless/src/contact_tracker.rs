//! Start of contact between neighbouring balls.
//!
//! ```
//! use cageless::ContactCounts;
//!
//! // One contact, slower than every speed that counts are kept above, and another.
//! let mut counts = ContactCounts { all: 1, ..ContactCounts::default() };
//! counts += counts;
//! assert_eq!((counts.all, counts.above[0]), (2, 0));
//! ```

use std::ops::AddAssign;

use crate::collision::Pair;
use crate::dynamics::{Contacts, Model};
use crate::simulation::StepView;

/// Approach speeds above which contacts between balls are counted apart, m/s: slower ones are
/// chatter of balls that push each other along.
pub(crate) const APPROACH_SPEEDS_M_S: [f64; 3] = [0.1, 0.5, 1.0];

/// Numbers of contacts between neighbouring balls that began.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactCounts {
    /// All of them.
    pub all: u64,
    /// Number of contacts with an approach speed above each of `APPROACH_SPEEDS_M_S`.
    pub above: [u64; APPROACH_SPEEDS_M_S.len()],
}

impl AddAssign for ContactCounts {
    fn add_assign(&mut self, other: Self) {
        self.all += other.all;
        for (sum, more) in self.above.iter_mut().zip(other.above) {
            *sum += more;
        }
    }
}

/// Counts the contacts that begin in each step, by their approach speed.
#[derive(Debug, Clone)]
pub(crate) struct ContactCounter {
    tracker: ContactTracker,
    distances_m: Vec<f64>,
}

impl ContactCounter {
    /// Counter of the balls of `model`.
    pub(crate) fn new(model: &Model) -> Self {
        let balls = model.balls();
        Self {
            tracker: ContactTracker::new(balls),
            distances_m: (0..balls).map(|k| model.pair_distance_m(k)).collect(),
        }
    }

    /// Contacts that began in the step of `view`; `None` if none did.
    #[inline]
    pub(crate) fn step(&mut self, view: &StepView<'_>) -> Option<ContactCounts> {
        self.tracker.update(&view.contacts);
        self.tracker.any_started.then(|| self.counts(view))
    }

    fn counts(&self, view: &StepView<'_>) -> ContactCounts {
        let mut counts = ContactCounts::default();
        for (k, distance_m) in self.distances_m.iter().enumerate() {
            if self.tracker.started(k) {
                let speed_m_s = Pair::new(view, k, *distance_m).touch().approach_speed_m_s;
                counts += ContactCounts {
                    all: 1,
                    above: APPROACH_SPEEDS_M_S.map(|limit| u64::from(speed_m_s > limit)),
                };
            }
        }
        counts
    }
}

/// Detects from step to step which pairs of neighbouring balls have started to touch.
#[derive(Debug, Clone)]
pub(crate) struct ContactTracker {
    closed: Vec<bool>,
    started: Vec<bool>,
    any_closed: bool,
    any_started: bool,
}

impl ContactTracker {
    /// Tracks `balls` balls. A contact already closed at the first update counts as started.
    pub(crate) fn new(balls: usize) -> Self {
        Self {
            closed: vec![false; balls],
            started: vec![false; balls],
            any_closed: false,
            any_started: false,
        }
    }

    /// Takes the contacts at the end of a step.
    #[inline]
    pub(crate) fn update(&mut self, contacts: &Contacts<'_>) {
        let touch = contacts.balls_touch();
        // Most steps have no contact, and none before.
        if touch || self.any_closed || self.any_started {
            self.update_pairs(contacts, touch);
        }
    }

    fn update_pairs(&mut self, contacts: &Contacts<'_>, touch: bool) {
        self.any_started = false;
        for (k, (closed, started)) in self.closed.iter_mut().zip(&mut self.started).enumerate() {
            let now = touch && contacts.pair_deflection_m(k) > 0.0;
            *started = now && !*closed;
            *closed = now;
            self.any_started |= *started;
        }
        self.any_closed = touch;
    }

    /// Whether the contact of ball `k` with the ball ahead started at the last update.
    #[inline]
    pub(crate) fn started(&self, k: usize) -> bool {
        self.started[k]
    }

    /// Number of contacts that started at the last update.
    #[inline]
    pub(crate) fn count(&self) -> u32 {
        if !self.any_started {
            return 0;
        }
        self.started.iter().map(|&started| u32::from(started)).sum()
    }
}
