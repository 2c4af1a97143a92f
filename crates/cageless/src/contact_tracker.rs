//! Start of contact between neighbouring balls.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::contact_tracker::ContactTracker;
//! use cageless::dynamics::{Model, RightHandSide};
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//! let model = Model::new(&case)?;
//! let rhs = RightHandSide::new(&model);
//! let mut tracker = ContactTracker::new(case.bearing.balls());
//! tracker.update(&rhs.contacts());
//! assert_eq!(tracker.count(), 0);
//! # Ok::<(), cageless::InputError>(())
//! ```

use crate::dynamics::Contacts;

/// Detects from step to step which pairs of neighbouring balls have started to touch.
#[derive(Debug, Clone)]
pub struct ContactTracker {
    closed: Vec<bool>,
    started: Vec<bool>,
    any_closed: bool,
    any_started: bool,
}

impl ContactTracker {
    /// Tracks `balls` balls. A contact already closed at the first update counts as started.
    pub fn new(balls: usize) -> Self {
        Self {
            closed: vec![false; balls],
            started: vec![false; balls],
            any_closed: false,
            any_started: false,
        }
    }

    /// Takes the contacts at the end of a step.
    pub fn update(&mut self, contacts: &Contacts<'_>) {
        let touch = contacts.balls_touch();
        // Most steps have no contact, and none before.
        if !touch && !self.any_closed && !self.any_started {
            return;
        }
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
    pub fn started(&self, k: usize) -> bool {
        self.started[k]
    }

    /// Number of contacts that started at the last update.
    pub fn count(&self) -> u32 {
        if !self.any_started {
            return 0;
        }
        self.started.iter().map(|&started| u32::from(started)).sum()
    }
}
