//! The embedded pair of Dormand and Prince, for starting and for crossing jumps.

use super::System;

/// Nodes, stages and weights of the 5(4) pair (Dormand & Prince 1980; Hairer, Nørsett
/// & Wanner, *Solving Ordinary Differential Equations I*, table II.5.2). The last row
/// of `A` is the fifth-order solution.
const C: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];
const A: [[f64; 6]; 7] = [
    [0.0; 6],
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
/// Fifth- minus fourth-order weights.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Error per sub-step, in the scales of the system, when crossing an interval.
const TOLERANCE: f64 = 1e-11;

/// A jump takes some tens of sub-steps to cross.
const ATTEMPTS_MAX: u32 = 10_000;

/// The state became so rough or so large that no step resolves it.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the equations cannot be resolved at t = {time_s} s")]
pub struct CrossingError {
    /// Where.
    pub time_s: f64,
}

/// Work arrays of the pair.
#[derive(Debug, Clone)]
pub struct RungeKutta {
    stages: [Vec<f64>; 7],
    trial: Vec<f64>,
    difference: Vec<f64>,
}

impl RungeKutta {
    /// For systems of this dimension.
    pub fn new(dimension: usize) -> Self {
        Self {
            stages: std::array::from_fn(|_| vec![0.0; dimension]),
            trial: vec![0.0; dimension],
            difference: vec![0.0; dimension],
        }
    }

    /// Advances `y` from `from_s` over `h`, in as many sub-steps as the error control
    /// wants, so that whatever jumps within is resolved. `rate` is f at `y`, before
    /// and after; the system's last evaluation is at the end.
    ///
    /// # Errors
    /// [`CrossingError`] when the state is no longer finite or takes too many sub-steps.
    pub fn cross<S: System>(
        &mut self,
        system: &mut S,
        from_s: f64,
        h: f64,
        y: &mut [f64],
        rate: &mut [f64],
    ) -> Result<(), CrossingError> {
        let mut done = 0.0;
        let mut size = h;
        let mut attempts = 0;
        while done < h {
            attempts += 1;
            if attempts > ATTEMPTS_MAX {
                return Err(CrossingError {
                    time_s: from_s + done,
                });
            }
            let last = done + size >= h * (1.0 - 1e-12);
            let trial = if last { h - done } else { size };
            let error = self.attempt(system, from_s + done, trial, y, rate) / TOLERANCE;
            if !error.is_finite() {
                return Err(CrossingError {
                    time_s: from_s + done,
                });
            }
            // A jump cannot be resolved below this; what it leaves is as small.
            if error <= 1.0 || trial <= h * 1e-6 {
                y.copy_from_slice(&self.trial);
                rate.copy_from_slice(&self.stages[6]);
                done = if last { h } else { done + trial };
            }
            size = trial * (0.9 * error.max(1e-10).powf(-0.2)).clamp(0.1, 5.0);
            size = size.max(h * 1e-6);
        }
        Ok(())
    }

    /// One step into `self.trial`, with f there in the last stage; returns its error.
    fn attempt<S: System>(
        &mut self,
        system: &mut S,
        time_s: f64,
        h: f64,
        y: &[f64],
        rate: &[f64],
    ) -> f64 {
        self.stages[0].copy_from_slice(rate);
        for s in 1..7 {
            self.trial.copy_from_slice(y);
            for (k, a) in A[s].iter().enumerate().take(s) {
                if *a != 0.0 {
                    for (t, f) in self.trial.iter_mut().zip(&self.stages[k]) {
                        *t += h * a * f;
                    }
                }
            }
            system.derivative(time_s + C[s] * h, &self.trial, &mut self.stages[s]);
        }
        for (i, d) in self.difference.iter_mut().enumerate() {
            *d = h * (0..7).map(|s| ERROR[s] * self.stages[s][i]).sum::<f64>();
        }
        system.error_norm(&self.difference)
    }
}
