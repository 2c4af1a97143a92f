//! Means and deviations over the part of a run after its transient.

use crate::numerics::moments::Moments;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use crate::summary::transient_s;

/// Steps between two samples of the ball speeds, which hardly change in between.
const BALLS_EVERY: u64 = 8;

/// Deviations of the ring and mean speeds of the balls.
#[derive(Debug, Clone, Default)]
pub(super) struct MotionRecorder {
    settled_after_s: f64,
    ring: [Moments; 2],
    orbit: Moments,
    spin: Moments,
    steps: u64,
    last_look_s: f64,
}

impl MotionRecorder {
    /// Standard deviations of the ring's x and y over time, m.
    pub(super) fn ring_deviation_m(&self) -> [f64; 2] {
        self.ring.map(|m| m.deviation())
    }

    /// Mean orbital speed of the balls, rad/s.
    pub(super) fn orbit_speed_rad_s(&self) -> f64 {
        self.orbit.mean
    }

    /// Mean absolute spin of the balls, rad/s.
    pub(super) fn rotation_rad_s(&self) -> f64 {
        self.spin.mean
    }
}

impl Observer for MotionRecorder {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        *self = Self {
            settled_after_s: transient_s(context.case),
            ..Self::default()
        };
        self.last_look_s = self.settled_after_s;
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let step = &view.step;
        if step.t1_s <= self.settled_after_s {
            return Ok(Control::Continue(()));
        }
        let layout = view.layout();
        let ring = layout.ring_motion(&step.y1);
        for (moments, place) in self.ring.iter_mut().zip([ring.x, ring.y]) {
            moments.add(place, step.size_s());
        }
        if self.steps.is_multiple_of(BALLS_EVERY) {
            let c = &view.contacts;
            let mean = |value: &dyn Fn(usize) -> f64| {
                (0..layout.balls).map(value).sum::<f64>() / layout.balls as f64
            };
            let time = step.t1_s - self.last_look_s;
            self.orbit.add(mean(&|k| c.orbit_speed_rad_s(k)), time);
            self.spin.add(mean(&|k| c.rotation_rad_s(k)), time);
            self.last_look_s = step.t1_s;
        }
        self.steps += 1;
        Ok(Control::Continue(()))
    }
}
