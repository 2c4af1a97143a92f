//! Contacts between balls and force on the outer ring over a run.

use crate::contact_tracker::ContactTracker;
use crate::numerics::moments::Moments;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// Tally of the contacts between balls and of the force on the outer ring, over a run and over its end.
#[derive(Debug, Clone)]
pub struct ContactTally {
    late_s: f64,
    contact_tracker: ContactTracker,
    /// Contacts begun in all.
    pub begun: f64,
    /// Contacts begun at the end.
    pub begun_late: f64,
    /// Impulse between the balls, N·s.
    pub impulse_n_s: f64,
    last_force_sum: f64,
    force: [Moments; 2],
}

impl ContactTally {
    /// Tally of a run whose end begins at `late_s`, s.
    pub fn new(late_s: f64) -> Self {
        Self {
            late_s,
            contact_tracker: ContactTracker::new(0),
            begun: 0.0,
            begun_late: 0.0,
            impulse_n_s: 0.0,
            last_force_sum: 0.0,
            force: [Moments::default(); 2],
        }
    }

    /// Standard deviation of the force on the outer ring at the end, both directions together, N.
    pub fn force_deviation_n(&self) -> f64 {
        let [x, y] = self.force.map(|force| force.deviation());
        x.hypot(y)
    }
}

impl Observer for ContactTally {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.contact_tracker = ContactTracker::new(context.model.balls());
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let c = &view.contacts;
        let h = view.step.t1_s - view.step.t0_s;
        let late = view.step.t1_s > self.late_s;
        self.contact_tracker.update(c);
        let begun = f64::from(self.contact_tracker.count());
        self.begun += begun;
        self.begun_late += if late { begun } else { 0.0 };
        let sum = if c.balls_touch() {
            (0..c.balls()).map(|k| c.pair_force_n(k)).sum()
        } else {
            0.0
        };
        self.impulse_n_s += 0.5 * h * (self.last_force_sum + sum);
        self.last_force_sum = sum;
        if late {
            for (moments, force) in self.force.iter_mut().zip(c.outer_ring_force_n()) {
                moments.add(force, h);
            }
        }
        Ok(Control::Continue(()))
    }
}
