//! Fourth-order Adams–Bashforth–Moulton in the mode predict–evaluate–correct–evaluate,
//! the method of Zhao 2022, Section 4.
//!
//! Order 4 on smooth problems. Stability on dy/dt = λy: real λh down to −1.28. On the
//! imaginary axis every step grows a little, by (ωh)⁶ times a small constant (0.7 % per
//! step at 0.8), and violently above 0.93: an undamped contact gains energy unless the
//! step is well below its period.
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*,
//! section III.1.

use super::{CrossingError, Integrator, RungeKutta, Step, System};

/// Weights of f(n), f(n−1), f(n−2), f(n−3) in the predictor.
const BASHFORTH: [f64; 4] = [55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0];
/// Weights of f(n+1), f(n), f(n−1), f(n−2) in the corrector.
const MOULTON: [f64; 4] = [9.0 / 24.0, 19.0 / 24.0, -5.0 / 24.0, 1.0 / 24.0];

/// The method with its history.
///
/// The first three steps, and each step in which the system changes its regime with
/// the three after it, are made by an error-controlled Runge–Kutta pair: history never
/// reaches across a jump of f.
#[derive(Debug, Clone)]
pub struct Abm4 {
    h: f64,
    start_s: f64,
    steps: u64,
    from_s: f64,
    to_s: f64,
    y: Vec<f64>,
    before: Vec<f64>,
    trial: Vec<f64>,
    /// f at the last four points, newest first.
    history: [Vec<f64>; 4],
    /// How many entries of the history belong to the present regime.
    known: usize,
    regime: u64,
    starter: RungeKutta,
}

impl Abm4 {
    /// For systems of this dimension, with step `h`.
    pub fn new(dimension: usize, h: f64) -> Self {
        let zero = || vec![0.0; dimension];
        Self {
            h,
            start_s: 0.0,
            steps: 0,
            from_s: 0.0,
            to_s: 0.0,
            y: zero(),
            before: zero(),
            trial: zero(),
            history: std::array::from_fn(|_| zero()),
            known: 0,
            regime: 0,
            starter: RungeKutta::new(dimension),
        }
    }

    /// Predict, evaluate, correct, evaluate, into `trial` and `history[3]`.
    fn predict_and_correct<S: System>(&mut self, system: &mut S) {
        let [f0, f1, f2, f3] = &mut self.history;
        let time_s = self.to_s;
        for i in 0..self.y.len() {
            let slope = BASHFORTH[0] * f0[i]
                + BASHFORTH[1] * f1[i]
                + BASHFORTH[2] * f2[i]
                + BASHFORTH[3] * f3[i];
            self.trial[i] = self.y[i] + self.h * slope;
        }
        // The oldest rate is not needed any more.
        system.derivative(time_s, &self.trial, f3);
        for i in 0..self.y.len() {
            let slope =
                MOULTON[0] * f3[i] + MOULTON[1] * f0[i] + MOULTON[2] * f1[i] + MOULTON[3] * f2[i];
            self.trial[i] = self.y[i] + self.h * slope;
        }
        system.derivative(time_s, &self.trial, f3);
    }

    /// One step of the starter, into `y` and `history[3]`.
    fn start_up<S: System>(&mut self, system: &mut S) -> Result<(), CrossingError> {
        let (from_s, h) = (self.from_s, self.to_s - self.from_s);
        let [newest, .., oldest] = &mut self.history;
        oldest.copy_from_slice(newest);
        self.starter.cross(system, from_s, h, &mut self.y, oldest)
    }
}

impl Integrator for Abm4 {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        (self.start_s, self.from_s, self.to_s) = (time_s, time_s, time_s);
        self.steps = 0;
        self.y.copy_from_slice(y);
        self.before.copy_from_slice(y);
        system.derivative(time_s, y, &mut self.history[0]);
        self.regime = system.regime();
        self.known = 1;
    }

    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), CrossingError> {
        self.before.copy_from_slice(&self.y);
        self.from_s = self.to_s;
        let regular = self.start_s + (self.steps + 1) as f64 * self.h;
        self.to_s = super::bounded(regular, limit_s, self.h);
        // A last step that the limit cuts short is left to the starter.
        let whole = (self.to_s - regular).abs() <= 1e-6 * self.h;
        let mut jumped = false;
        if self.known == 4 && whole {
            self.predict_and_correct(system);
            jumped = system.regime() != self.regime;
            if !jumped {
                std::mem::swap(&mut self.y, &mut self.trial);
            }
        }
        if self.known < 4 || jumped || !whole {
            self.start_up(system)?;
            let regime = system.regime();
            // Rates from before the jump must not be used after it.
            let smooth = regime == self.regime && !jumped && whole;
            self.known = if smooth { self.known + 1 } else { 1 };
            self.regime = regime;
        }
        self.history.rotate_right(1);
        self.steps += 1;
        Ok(())
    }

    fn step(&self) -> Step<'_> {
        Step {
            from_s: self.from_s,
            to_s: self.to_s,
            before: &self.before,
            rate_before: &self.history[1],
            after: &self.y,
            rate_after: &self.history[0],
        }
    }
}
