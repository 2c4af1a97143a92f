//! The equations of the friction of one ball at the end of a step, where their solution begins.

use super::workspace::{BlockResults, ImplicitFriction};
use crate::ball::BothContacts;
use crate::contact::{Law, SlipProblem, Slips, end_weights, newton_step, positive};

/// Sliding speed below which a law that sticks sticks, m/s: far above rounding, far below any
/// sliding.
pub(super) const STUCK_M_S: f64 = 1e-10;

/// θ of a contact under a law that sticks with this sliding speed at the start of the step.
#[inline(always)]
pub(super) fn sticking_weight(start: f64) -> f64 {
    if start.abs() < STUCK_M_S { 1.0 } else { 0.5 }
}

/// The equations of one ball at the beginning of their solution.
pub(super) struct Beginning {
    problem: SlipProblem,
    /// First iterate, or the solution under a law that sticks.
    slips: Slips,
    /// θ of both contacts.
    weights: BothContacts,
    /// (1 − θ)·f₀.
    rest: BothContacts,
}

impl Beginning {
    /// Equations of the friction at the end of the step, at the beginning of their solution.
    #[inline(always)]
    pub(super) fn new<L: Law, const KNOWN: bool>(
        law: &L,
        whole: &SlipProblem,
        start: &Slips,
        slip: BothContacts,
    ) -> Self {
        let [outer, inner] = if !KNOWN {
            [1.0, 1.0]
        } else if L::STICKS {
            [sticking_weight(start.outer), sticking_weight(start.inner)]
        } else {
            // A Stribeck law falls beyond its peak; that is not stiff.
            end_weights([
                whole.outer_outer * positive(start.outer_slope),
                whole.inner_inner * positive(start.inner_slope),
            ])
        };
        let rest = if KNOWN {
            BothContacts {
                outer: (1.0 - outer) * start.outer_friction,
                inner: (1.0 - inner) * start.inner_friction,
            }
        } else {
            BothContacts::default()
        };
        let weights = BothContacts { outer, inner };
        let problem = whole.split(weights, rest);
        let slips = if L::STICKS {
            law.end_of_step(&problem)
        } else {
            let extrapolated = Slips {
                outer: slip.outer,
                inner: slip.inner,
                ..Slips::default()
            };
            newton_step(law, &problem, &extrapolated.with_friction(law, &problem))
        };
        Self {
            problem,
            slips,
            weights,
            rest,
        }
    }

    #[inline(always)]
    pub(super) fn put(
        &self,
        lane: usize,
        results: &mut BlockResults,
        friction: &mut ImplicitFriction,
    ) {
        friction.problem.put(lane, self.problem);
        friction.slips.put(lane, self.slips);
        friction.weights[0].0[lane] = self.weights.outer;
        friction.weights[1].0[lane] = self.weights.inner;
        results.outer_friction.0[lane] = self.rest.outer;
        results.inner_friction.0[lane] = self.rest.inner;
    }
}
