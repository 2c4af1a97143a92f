//! States of a run at the sample times of the divergence.

use crate::case::Case;
use crate::dynamics::state::State;
use crate::simulation::{Control, Observer, ObserverError, StepView};

/// Times at which runs are compared.
const SAMPLES: usize = 1500;

/// Times t_k = T·(k/n)², rounded to steps: close together at the start, where runs diverge
/// within milliseconds, and spread over the whole run.
pub(super) fn sample_times_s(case: &Case) -> Vec<f64> {
    let (step, duration) = (case.solver.step_s, case.solver.duration_s);
    let mut times: Vec<f64> = (1..=SAMPLES)
        .map(|k| {
            let fraction = k as f64 / SAMPLES as f64;
            ((duration * fraction * fraction / step).round().max(1.0) * step).min(duration)
        })
        .collect();
    times.dedup();
    times
}

/// Keeps the states of balls and ring at given times.
#[derive(Debug, Clone, Default)]
pub(super) struct TrajectoryRecorder {
    times: Vec<f64>,
    taken: usize,
    width: usize,
    values: Vec<f64>,
}

impl TrajectoryRecorder {
    /// Recorder of the states at `times`, ascending.
    pub(super) fn new(times: Vec<f64>) -> Self {
        Self {
            times,
            ..Self::default()
        }
    }

    /// State at the k-th time; `None` if the run did not get there.
    pub(super) fn state(&self, k: usize) -> Option<&[f64]> {
        self.values.get(k * self.width..(k + 1) * self.width)
    }

    /// The times.
    pub(super) fn times_s(&self) -> &[f64] {
        &self.times
    }
}

impl Observer for TrajectoryRecorder {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let step = &view.step;
        // The energy ledger is left out.
        self.width = view.layout().alone().motion_len();
        let slack = 1e-6 * (step.t1_s - step.t0_s);
        while let Some(&time) = self.times.get(self.taken) {
            if time > step.t1_s + slack {
                break;
            }
            let state = if (time - step.t1_s).abs() <= slack {
                State::from_vector(view.layout(), &step.y1)
            } else {
                view.state(time)
            };
            self.values.extend_from_slice(&state.values()[..self.width]);
            self.taken += 1;
        }
        Ok(Control::Continue(()))
    }
}
