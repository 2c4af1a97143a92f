//! Friction of asperities beside a film.

use super::law::{Law, LawConstants, LawLanes};
use super::parameters::FrictionParameters;
use super::smooth::{Smooth, SmoothLanes};
use crate::numerics::lanes::Lanes;

/// The smooth law of asperities; at raceways the film takes its part, see [`super::FilmTraction`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mixed(pub Smooth);

impl Law for Mixed {
    const MIXES: bool = true;

    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        (self.0).force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        inverse_knees_s_m: [f64; 2],
    ) -> [[f64; 2]; 2] {
        (self.0).forces_with_knees(slips_m_s, normals_n, inverse_knees_s_m)
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.0.coefficient()
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.0.inverse_regularisation_speed()
    }
}

impl LawConstants for Mixed {
    const NAME: &'static str = "mixed";

    fn new(parameters: &FrictionParameters, stick_gain_n_s_m: f64) -> Self {
        Self(Smooth::new(parameters, stick_gain_n_s_m))
    }

    fn describe(parameters: &FrictionParameters) -> String {
        Smooth::describe(parameters)
    }
}

/// [`Mixed`] of each lane.
#[derive(Debug, Clone)]
pub(crate) struct MixedLanes(SmoothLanes);

impl LawLanes for MixedLanes {
    type Constants = Mixed;
    type Law<'a> = Mixed;
    type Evaluated<'a> = &'a Self;

    #[inline(always)]
    fn lane(&self, lane: usize) -> Mixed {
        Mixed(self.0.get(lane))
    }

    #[inline(always)]
    fn evaluated(&self, _: [&Lanes; 2]) -> &Self {
        self
    }

    fn filled(value: impl Fn(usize) -> Mixed) -> Self {
        Self(SmoothLanes::from_fn(|lane| value(lane).0))
    }
}
