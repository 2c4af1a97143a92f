//! The path of the inner ring's centre, sampled finely enough for its own vibration.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use cageless::dynamics::RingCoordinate;
use cageless::simulation::{Observer, ObserverError, RunContext, StepView};

/// Time between samples, s. On its loaded balls the ring vibrates with periods of some tenths of
/// a millisecond.
const INTERVAL_S: f64 = 1e-5;
/// Most samples, the last ones.
const SAMPLES: usize = 4000;

/// One position of the centre of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingPosition {
    /// Time, s.
    pub time_s: f64,
    /// Centre, to the right, m.
    pub x_m: f64,
    /// Centre, upwards, m.
    pub y_m: f64,
}

/// Records the end of the path; its memory does not depend on the length of the run.
#[derive(Debug, Clone, Default)]
pub struct RingPathRecorder {
    taken: u64,
    samples: VecDeque<RingPosition>,
}

impl RingPathRecorder {
    /// A recorder without samples.
    pub fn new() -> Self {
        Self::default()
    }

    /// The last positions, the oldest first.
    pub fn into_path(self) -> Vec<RingPosition> {
        self.samples.into()
    }
}

impl Observer for RingPathRecorder {
    fn begin(&mut self, _: &RunContext<'_>) -> Result<(), ObserverError> {
        self.taken = 1;
        self.samples.clear();
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<ControlFlow<()>, ObserverError> {
        let layout = view.layout();
        let [x, y] = [RingCoordinate::X, RingCoordinate::Y].map(|c| layout.ring(c));
        loop {
            let time_s = self.taken as f64 * INTERVAL_S;
            if time_s > view.step.t1_s {
                return Ok(ControlFlow::Continue(()));
            }
            if self.samples.len() == SAMPLES {
                self.samples.pop_front();
            }
            self.samples.push_back(RingPosition {
                time_s,
                x_m: view.step.interpolate(x, time_s),
                y_m: view.step.interpolate(y, time_s),
            });
            self.taken += 1;
        }
    }
}
