//! A law at the raceway contacts of a ball, with a film there if it mixes with one.

use super::at_knees::AtKnees;
use super::film_traction::FilmTraction;
use super::law::{Law, Spinning};
use crate::contact::slip_problem::{SlipProblem, Slips};

/// A law with its knees, and films at the outer and the inner contact; a knee given belongs to the outer one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtRaceways<L> {
    /// The law.
    pub law: AtKnees<L>,
    /// Films, of laws that mix.
    pub films: [FilmTraction; 2],
}

impl<L: Law> AtRaceways<L> {
    #[inline(always)]
    fn mixed(&self, contact: usize, dry: [f64; 2], sliding_m_s: f64) -> [f64; 2] {
        match L::MIXES {
            true => self.films[contact].mixed(dry, sliding_m_s),
            false => dry,
        }
    }
}

impl<L: Law> Law for AtRaceways<L> {
    const STICKS: bool = L::STICKS;
    const MIXES: bool = L::MIXES;

    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let dry = (self.law).force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m);
        self.mixed(0, dry, sliding_m_s)
    }

    #[inline(always)]
    fn spinning_force(&self, sliding_m_s: f64, normal_n: f64, spinning: &Spinning) -> [f64; 2] {
        let dry = (self.law).spinning_force(sliding_m_s, normal_n, spinning);
        match L::MIXES {
            true => self.films[0].mixed_spinning(dry, sliding_m_s, spinning.spin_square),
            false => dry,
        }
    }

    #[inline(always)]
    fn inner_force(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let dry = (self.law).force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m);
        self.mixed(1, dry, sliding_m_s)
    }

    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        inverse_knees_s_m: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let [outer, inner] = (self.law).forces_with_knees(slips_m_s, normals_n, inverse_knees_s_m);
        [
            self.mixed(0, outer, slips_m_s[0]),
            self.mixed(1, inner, slips_m_s[1]),
        ]
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.law.coefficient()
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.law.inverse_regularisation_speed()
    }

    #[inline(always)]
    fn inverse_knees(&self) -> [f64; 2] {
        self.law.inverse_knees
    }

    #[inline(always)]
    fn inverse_scales(&self) -> [f64; 2] {
        let [outer, inner] = self.law.inverse_knees;
        let [at_outer, at_inner] = &self.films;
        match L::MIXES {
            true => [
                outer.max(at_outer.inverse_speed),
                inner.max(at_inner.inverse_speed),
            ],
            false => [outer, inner],
        }
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
