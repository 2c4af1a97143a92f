//! Steps by error control, order 8(5,3) or, for loose tolerances, 5(4).

use super::tableau::{DORMAND_PRINCE_8, TSITOURAS_5};
use super::{CrossingError, Integrator, RungeKutta, Step, System};

/// The method: Dormand & Prince's pair of order 8, or Tsitouras' of order 5 for a tolerance of
/// 1e-6 and more, with the error of each step, in the scales of the system, below the
/// tolerance. Where f has an edge (δ^(3/2), √δ, a jump) the
/// steps shrink until it is crossed.
#[derive(Debug, Clone)]
pub struct Adaptive {
    pair: RungeKutta,
    most: f64,
    tolerance: f64,
    size: f64,
    from_s: f64,
    to_s: f64,
    y: Vec<f64>,
    before: Vec<f64>,
    rate: Vec<f64>,
    rate_before: Vec<f64>,
}

/// From this tolerance on the steps are so long for the edges of f that a high order is wasted:
/// on CB74 the pair of order 5 then takes half the evaluations.
const LOOSE: f64 = 1e-6;
/// Least step as a share of the largest.
const LEAST: f64 = 1e-8;

impl Adaptive {
    /// For systems of this dimension, steps up to `most`, errors per step up to
    /// `tolerance` in the system's [`System::error_norm`].
    pub fn new(dimension: usize, most: f64, tolerance: f64) -> Self {
        let zero = || vec![0.0; dimension];
        Self {
            pair: RungeKutta::with_tableau(
                if tolerance >= LOOSE {
                    &TSITOURAS_5
                } else {
                    &DORMAND_PRINCE_8
                },
                dimension,
            ),
            most,
            tolerance,
            size: most,
            from_s: 0.0,
            to_s: 0.0,
            y: zero(),
            before: zero(),
            rate: zero(),
            rate_before: zero(),
        }
    }
}

impl Integrator for Adaptive {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        (self.from_s, self.to_s) = (time_s, time_s);
        self.size = self.most;
        self.y.copy_from_slice(y);
        self.before.copy_from_slice(y);
        system.derivative(time_s, y, &mut self.rate);
    }

    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), CrossingError> {
        self.before.copy_from_slice(&self.y);
        self.rate_before.copy_from_slice(&self.rate);
        self.from_s = self.to_s;
        let wanted = self.size.min(self.most);
        let end = super::bounded(self.from_s + wanted, limit_s, wanted);
        let made = self.pair.step(
            system,
            self.from_s,
            end - self.from_s,
            self.tolerance,
            self.most * LEAST,
            &mut self.y,
            &mut self.rate,
        )?;
        let reached = made.size == end - self.from_s;
        // A step cut short by the limit says little of the next.
        let cut = reached && made.size < wanted;
        self.size = if cut {
            wanted.max(made.next)
        } else {
            made.next
        };
        self.to_s = if reached {
            end
        } else {
            self.from_s + made.size
        };
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
