//! Fourth-order Adams–Bashforth–Moulton in the mode predict–evaluate–correct–evaluate,
//! the method of Zhao 2022, Section 4.
//!
//! Order 4 on smooth problems. Stability on dy/dt = λy: real λh down to −1.28. On the
//! imaginary axis every step grows a little, by (ωh)⁶ times a small constant (0.7 % per
//! step at 0.8), and violently above 0.93: an undamped contact gains energy unless the
//! step is well below its period.
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*,
//! section III.1.

use super::method::{Method, NamedMethod, Properties};
use super::runge_kutta::{RungeKutta, UnresolvedStep};
use super::step_state::{FixedSteps, StepState};
use super::system::System;
use crate::numerics::aligned::Aligned;

/// Weights of f(n), f(n−1), f(n−2), f(n−3) in the predictor.
const BASHFORTH: [f64; 4] = [55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0];
/// Weights of f(n+1), f(n), f(n−1), f(n−2) in the corrector.
const MOULTON: [f64; 4] = [9.0 / 24.0, 19.0 / 24.0, -5.0 / 24.0, 1.0 / 24.0];

/// The method with its history.
///
/// The first three steps, and each step in which the system changes its mode with
/// the three after it, are made by an error-controlled Runge–Kutta pair: history never
/// reaches across a jump of f.
#[derive(Debug, Clone)]
pub struct Abm4 {
    steps: FixedSteps,
    /// f at the three points before the start of the step, newest first.
    history: [Aligned; 3],
    /// Number of points, the start of the step included, whose f belongs to the present mode.
    known: usize,
    mode: u64,
    starter: RungeKutta,
}

impl Abm4 {
    /// The method for systems of this dimension, with step `h`.
    pub fn new(dimension: usize, h: f64) -> Self {
        Self {
            steps: FixedSteps::new(h),
            history: std::array::from_fn(|_| Aligned::zeros(dimension)),
            known: 0,
            mode: 0,
            starter: RungeKutta::new(dimension),
        }
    }

    /// Predicts, evaluates, corrects, evaluates.
    #[inline(always)] // into callers compiled for wider vectors
    fn predict_and_correct<S: System>(&self, system: &mut S, step: &mut StepState) {
        let n = step.y1.len();
        let [f1, f2, f3] = self.history.each_ref().map(|f| &f[..n]);
        let (h, y0, f0) = (self.steps.h, &step.y0[..n], &step.f0[..n]);
        let (y, f) = (&mut step.y1[..n], &mut step.f1[..n]);
        for i in 0..n {
            let slope = BASHFORTH[0] * f0[i]
                + BASHFORTH[1] * f1[i]
                + BASHFORTH[2] * f2[i]
                + BASHFORTH[3] * f3[i];
            y[i] = y0[i] + h * slope;
        }
        system.derivative(step.t1_s, y, f);
        for i in 0..n {
            let slope =
                MOULTON[0] * f[i] + MOULTON[1] * f0[i] + MOULTON[2] * f1[i] + MOULTON[3] * f2[i];
            y[i] = y0[i] + h * slope;
        }
        system.derivative(step.t1_s, y, f);
    }
}

impl NamedMethod for Abm4 {
    // Order and stability: violent growth on the imaginary axis from 0.93, real axis −1.28.
    const PROPERTIES: Properties = Properties {
        name: "abm4",
        label: "ABM4",
        order: 4,
        oscillation_limit: 0.93,
        decay_limit: 1.28,
        solves_stiff_part: false,
        side_by_side: false,
        automatic_oscillation: [0.17, 0.4],
        automatic_decay: 0.5,
    };

    fn of_case(dimension: usize, step_s: f64, _tolerance: f64) -> Self {
        Self::new(dimension, step_s)
    }
}

impl Method for Abm4 {
    fn restart<S: System>(&mut self, system: &mut S, step: &StepState) {
        self.steps.restart(step.t1_s);
        self.mode = system.mode();
        self.known = 1;
    }

    #[inline(always)] // into callers compiled for wider vectors
    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        // A last step that the limit cuts short is left to the starter.
        let (end, whole) = self.steps.next_end(limit_s);
        step.t1_s = end;
        let multistep = self.known == 4 && whole;
        let mut jumped = false;
        if multistep {
            self.predict_and_correct(system, step);
            jumped = system.mode() != self.mode;
        }
        if !multistep || jumped {
            step.y1.copy_from_slice(&step.y0);
            step.f1.copy_from_slice(&step.f0);
            let h = step.size_s();
            self.starter
                .integrate_across(system, step.t0_s, h, &mut step.y1, &mut step.f1)?;
            let mode = system.mode();
            // Rates from before the jump must not be used after it.
            let smooth = mode == self.mode && !jumped && whole;
            self.known = if smooth { self.known + 1 } else { 1 };
            self.mode = mode;
        }
        self.history.rotate_right(1);
        self.history[0].copy_from_slice(&step.f0);
        Ok(())
    }
}
