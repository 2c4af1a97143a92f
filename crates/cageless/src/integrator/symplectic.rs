//! Leapfrog in its synchronous form (velocity Verlet), one evaluation per step.
//!
//! v(½) = v(n) + h/2·a(n);  x(n+1) = x(n) + h·v(½);  v(n+1) = v(½) + h/2·a(n+1), with
//! a(n+1) = a(x(n+1), v(½) + h/2·a(n)): forces that depend on velocities see them
//! extrapolated to the end of the step. (With v(½) itself, as in symplectic Euler, a ball on
//! its circle would seem to fly outwards by h/2·v²/R, and damping would resist that.)
//!
//! Order 2. Where forces depend on places alone it is symplectic and keeps a nearby energy
//! for ever (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, section I.1).
//! Stable on x″ = −ω²x up to ωh = 2, on x″ = −λx′ up to λh = 1.

use super::{CrossingError, Integrator, Step, System};

/// The method.
#[derive(Debug, Clone)]
pub struct Symplectic {
    h: f64,
    start_s: f64,
    steps: u64,
    from_s: f64,
    to_s: f64,
    y: Vec<f64>,
    before: Vec<f64>,
    rate: Vec<f64>,
    rate_before: Vec<f64>,
}

impl Symplectic {
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
            rate: zero(),
            rate_before: zero(),
        }
    }
}

impl Integrator for Symplectic {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        (self.start_s, self.from_s, self.to_s) = (time_s, time_s, time_s);
        self.steps = 0;
        self.y.copy_from_slice(y);
        self.before.copy_from_slice(y);
        system.derivative(time_s, y, &mut self.rate);
    }

    #[inline(always)] // into callers compiled for wider vectors
    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), CrossingError> {
        std::mem::swap(&mut self.before, &mut self.y);
        std::mem::swap(&mut self.rate_before, &mut self.rate);
        self.from_s = self.to_s;
        let regular = self.start_s + (self.steps + 1) as f64 * self.h;
        self.to_s = super::bounded(regular, limit_s, self.h);
        let h = self.to_s - self.from_s;
        let n = self.y.len();
        let (before, rate_before) = (&self.before[..n], &self.rate_before[..n]);
        let y = &mut self.y[..n];
        for k in 0..n {
            y[k] = before[k] + h * rate_before[k];
        }
        for &Drift {
            places,
            rates,
            count,
        } in system.drifts()
        {
            let (speed, push) = (&before[rates..][..count], &rate_before[rates..][..count]);
            let (from, to) = (&before[places..][..count], &mut y[places..][..count]);
            for k in 0..count {
                to[k] = from[k] + h * (speed[k] + 0.5 * h * push[k]);
            }
        }
        self.steps += 1;
        system.derivative(self.to_s, y, &mut self.rate);
        // The trapezoidal rule for all but the places, which stay.
        let rate = &self.rate[..n];
        let mut from = 0;
        let ends = system
            .drifts()
            .iter()
            .map(|d| (d.places, d.places + d.count));
        for (to, next) in ends.chain([(n, n)]) {
            for k in from..to {
                y[k] = before[k] + 0.5 * h * (rate_before[k] + rate[k]);
            }
            from = next;
        }
        Ok(())
    }

    fn step(&self) -> Step<'_> {
        Step {
            from_s: self.from_s,
            to_s: self.to_s,
            before: &self.before,
            rate_before: &self.rate_before,
            after: &self.y,
            rate_after: &self.rate,
        }
    }
}

/// A run of components that are places, and of those that are their rates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Drift {
    /// First place.
    pub places: usize,
    /// First rate.
    pub rates: usize,
    /// How many.
    pub count: usize,
}
