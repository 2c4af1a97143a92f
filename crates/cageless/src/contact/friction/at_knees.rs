//! A law with a knee of its own at each raceway contact of a ball.

use super::law::Law;
use crate::contact::slip_problem::{SlipProblem, Slips};

/// A law whose knees are these.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtKnees<L> {
    /// The law.
    pub law: L,
    /// 1/v_s at the outer and the inner contact, s/m.
    pub inverse_knees: [f64; 2],
}

impl<L: Law> Law for AtKnees<L> {
    const STICKS: bool = L::STICKS;
    const MIXES: bool = L::MIXES;

    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        self.law
            .force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        inverse_knees_s_m: [f64; 2],
    ) -> [[f64; 2]; 2] {
        self.law
            .forces_with_knees(slips_m_s, normals_n, inverse_knees_s_m)
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.law.coefficient()
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.inverse_knees[0]
    }

    #[inline(always)]
    fn inverse_knees(&self) -> [f64; 2] {
        self.inverse_knees
    }

    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        self.law.edge(sliding_m_s)
    }

    #[inline(always)]
    fn end_of_step(&self, problem: &SlipProblem) -> Slips {
        self.law.end_of_step(problem)
    }
}
