//! The step of an integration: states and rates at both ends.

use super::system::System;
use crate::numerics::aligned::Aligned;

/// The last accepted step: states y and rates f at its start (0) and end (1).
#[derive(Debug, Clone, Default)]
pub struct StepState {
    /// Start, s.
    pub t0_s: f64,
    /// State at the start.
    pub y0: Aligned,
    /// f at the start.
    pub f0: Aligned,
    /// End, s.
    pub t1_s: f64,
    /// State at the end.
    pub y1: Aligned,
    /// f at the end; the system's work arrays are as of this evaluation.
    pub f1: Aligned,
}

impl StepState {
    /// A step of a system of this dimension.
    pub(super) fn new(dimension: usize) -> Self {
        let zero = || Aligned::zeros(dimension);
        Self {
            y0: zero(),
            f0: zero(),
            y1: zero(),
            f1: zero(),
            ..Self::default()
        }
    }

    pub(super) fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        (self.t0_s, self.t1_s) = (time_s, time_s);
        self.y0.copy_from_slice(y);
        self.y1.copy_from_slice(y);
        system.derivative(time_s, y, &mut self.f1);
        self.f0.copy_from_slice(&self.f1);
    }

    /// The end becomes the start of the next step, whose end is left to the method.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.t0_s = self.t1_s;
        std::mem::swap(&mut self.y0, &mut self.y1);
        std::mem::swap(&mut self.f0, &mut self.f1);
    }

    /// Length of the step, s.
    #[inline]
    pub fn size_s(&self) -> f64 {
        self.t1_s - self.t0_s
    }

    /// Component `k` at `time_s` within the step by cubic Hermite interpolation; error
    /// h⁴/384 times the fourth derivative.
    pub fn interpolate(&self, k: usize, time_s: f64) -> f64 {
        self.at(time_s)([&self.y0, &self.y1, &self.f0, &self.f1].map(|values| values[k]))
    }

    /// [`Self::interpolate`] of all components.
    pub(crate) fn interpolate_all(&self, time_s: f64) -> Vec<f64> {
        let (states, rates) = (self.y0.iter().zip(&*self.y1), self.f0.iter().zip(&*self.f1));
        let component = self.at(time_s);
        let all = states.zip(rates);
        all.map(|((y0, y1), (f0, f1))| component([*y0, *y1, *f0, *f1]))
            .collect()
    }

    /// States and rates at both ends to the state at `time_s`.
    #[inline]
    fn at(&self, time_s: f64) -> impl Fn([f64; 4]) -> f64 + use<> {
        let h = self.size_s();
        // A step of no length, after a restart, is its end.
        let s = match h > 0.0 {
            true => (time_s - self.t0_s) / h,
            false => 1.0,
        };
        let r = 1.0 - s;
        move |[y0, y1, f0, f1]| {
            let (f0, f1) = (f0 * h, f1 * h);
            y0 * r * r * (1.0 + 2.0 * s) + y1 * s * s * (3.0 - 2.0 * s) + s * r * (f0 * r - f1 * s)
        }
    }
}

/// The grid of steps of one size from the last restart on.
#[derive(Debug, Clone)]
pub(super) struct FixedSteps {
    pub h: f64,
    start_s: f64,
    steps: u64,
}

impl FixedSteps {
    pub(super) fn new(h: f64) -> Self {
        Self {
            h,
            start_s: 0.0,
            steps: 0,
        }
    }

    pub(super) fn restart(&mut self, time_s: f64) {
        (self.start_s, self.steps) = (time_s, 0);
    }

    /// End of the next step, at most `limit_s`, and whether it lies on the grid.
    #[inline(always)]
    pub(super) fn next_end(&mut self, limit_s: f64) -> (f64, bool) {
        self.steps += 1;
        let regular = self.start_s + self.steps as f64 * self.h;
        let end = bounded(regular, limit_s, self.h);
        (end, (end - regular).abs() <= 1e-6 * self.h)
    }
}

/// End of a step of size `h` that should end at `end_s` but not pass `limit_s`. A remainder
/// of the size of rounding errors is taken into the step.
pub(super) fn bounded(end_s: f64, limit_s: f64, h: f64) -> f64 {
    if end_s > limit_s - 1e-6 * h {
        limit_s
    } else {
        end_s
    }
}
