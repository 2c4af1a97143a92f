//! Steps by error control, order 8(5,3) or, for loose tolerances, 5(4).

use super::method::{Method, NamedMethod, Properties};
use super::runge_kutta::{RungeKutta, UnresolvedStep};
use super::step_state::{StepState, bounded};
use super::system::System;
use super::tableau::{DORMAND_PRINCE_8, TSITOURAS_5};

/// The method: Dormand & Prince's pair of order 8, or Tsitouras' of order 5 for a tolerance of
/// 1e-6 and more, with the error of each step, in the scales of the system, below the
/// tolerance. Steps end at the edges that the system names ([`System::edges`]); at those that it
/// does not, they shrink until they are crossed.
#[derive(Debug, Clone)]
pub struct Adaptive {
    pair: RungeKutta,
    size_max: f64,
    tolerance: f64,
    size: f64,
}

/// From this tolerance on the steps are so long beside the contacts that a high order is wasted:
/// on CB74 the pair of order 5 then takes half the evaluations.
const LOOSE: f64 = 1e-6;
/// Smallest step as a fraction of the largest.
const SMALLEST: f64 = 1e-8;

impl Adaptive {
    /// The method for systems of this dimension, steps up to `size_max`, errors per step up to
    /// `tolerance` in the system's [`System::error_norm`].
    pub(crate) fn new(dimension: usize, size_max: f64, tolerance: f64) -> Self {
        let tableau = if tolerance >= LOOSE {
            &TSITOURAS_5
        } else {
            &DORMAND_PRINCE_8
        };
        Self {
            pair: RungeKutta::with_tableau(tableau, dimension).ending_at_edges(),
            size_max,
            tolerance,
            size: size_max,
        }
    }
}

impl NamedMethod for Adaptive {
    // Order of the tighter pair; error control finds its own step.
    const PROPERTIES: Properties = Properties {
        name: "adaptive",
        label: "adaptive Runge–Kutta",
        order: 8,
        oscillation_limit: f64::INFINITY,
        decay_limit: f64::INFINITY,
        solves_stiff_part: false,
        side_by_side: false,
        automatic_oscillation: [2.0, 2.0],
        automatic_decay: f64::INFINITY,
    };

    fn of_case(dimension: usize, step_s: f64, tolerance: f64) -> Self {
        Self::new(dimension, step_s, tolerance)
    }
}

impl Method for Adaptive {
    fn restart<S: System>(&mut self, _system: &mut S, _step: &StepState) {
        self.size = self.size_max;
    }

    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        step.y1.copy_from_slice(&step.y0);
        step.f1.copy_from_slice(&step.f0);
        let wanted = self.size.min(self.size_max);
        let end = bounded(step.t0_s + wanted, limit_s, wanted);
        let tried = end - step.t0_s;
        let accepted = self.pair.step(
            system,
            step.t0_s,
            tried,
            self.tolerance,
            self.size_max * SMALLEST,
            &mut step.y1,
            &mut step.f1,
        )?;
        let reached = accepted.size == tried;
        // A step cut short by the limit says little of the next.
        let cut = reached && accepted.size < wanted;
        self.size = if cut {
            wanted.max(accepted.next)
        } else {
            accepted.next
        };
        step.t1_s = if reached {
            end
        } else {
            step.t0_s + accepted.size
        };
        Ok(())
    }
}
