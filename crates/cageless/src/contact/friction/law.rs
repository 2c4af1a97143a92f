//! Laws of friction.

use super::parameters::FrictionParameters;
use crate::contact::slip_problem::{SlipProblem, Slips};
use crate::numerics::lanes::Lanes;

/// Spin of a contact as friction over its sliding has it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Spinning {
    /// 1/v of the knee that it widens, s/m.
    pub inverse_knee_s_m: f64,
    /// Square of the speed at which it slides beside, (m/s)².
    pub spin_square: f64,
}

/// A law of friction with its constants.
pub(crate) trait Law: Clone {
    /// Whether a rolling contact sticks: the friction within the cone is then no function of
    /// the sliding speed. Implicit methods call [`Law::end_of_step`]; explicit ones get a stick
    /// that is relaxed over a few steps, `stick_gain` times the sliding speed.
    const STICKS: bool = false;

    /// Whether a film takes its part of the friction at raceways.
    const MIXES: bool = false;

    /// Friction force along −ΔV under the normal force `normal_n`, N, and its slope over ΔV,
    /// N·s/m.
    #[inline(always)]
    fn force(&self, sliding_m_s: f64, normal_n: f64) -> [f64; 2] {
        self.force_with_knee(sliding_m_s, normal_n, self.inverse_regularisation_speed())
    }

    /// [`Self::force`] with the knee at another speed, of laws that do not stick: that of a contact
    /// which spins.
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2];

    /// [`Self::force`] of the outer and the inner contact of a ball; to rounding the same.
    #[inline(always)]
    fn forces(&self, slips_m_s: [f64; 2], normals_n: [f64; 2]) -> [[f64; 2]; 2] {
        self.forces_with_knees(slips_m_s, normals_n, self.inverse_knees())
    }

    /// [`Self::forces`] with the knees at other speeds.
    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        inverse_knees_s_m: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let [outer, inner] = inverse_knees_s_m;
        [
            self.force_with_knee(slips_m_s[0], normals_n[0], outer),
            self.force_with_knee(slips_m_s[1], normals_n[1], inner),
        ]
    }

    /// [`Self::force_with_knee`] of the inner contact, where those of a ball differ.
    #[inline(always)]
    fn inner_force(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        self.force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m)
    }

    /// [`Self::force_with_knee`] of a contact that spins.
    #[inline(always)]
    fn spinning_force(&self, sliding_m_s: f64, normal_n: f64, spinning: &Spinning) -> [f64; 2] {
        self.force_with_knee(sliding_m_s, normal_n, spinning.inverse_knee_s_m)
    }

    /// Coefficient of friction of fast sliding.
    fn coefficient(&self) -> f64;

    /// 1/ΔV at which the force has its knee, s/m; of laws that do not stick.
    fn inverse_regularisation_speed(&self) -> f64 {
        f64::INFINITY
    }

    /// [`Self::inverse_regularisation_speed`] at the outer and the inner contact of a ball.
    #[inline(always)]
    fn inverse_knees(&self) -> [f64; 2] {
        [self.inverse_regularisation_speed(); 2]
    }

    /// 1/ΔV over which the force changes most at the outer and the inner contact, s/m.
    #[inline(always)]
    fn inverse_scales(&self) -> [f64; 2] {
        self.inverse_knees()
    }

    /// A function of the sliding speed, m/s, that is zero where the force is not smooth over it; of
    /// laws of which that is so.
    #[inline(always)]
    fn edge(&self, _sliding_m_s: f64) -> Option<f64> {
        None
    }

    /// Friction and sliding speeds at the end of an implicit step; of laws that stick.
    fn end_of_step(&self, _problem: &SlipProblem) -> Slips {
        Slips::default()
    }
}

/// A law as the parameters of a case give it.
pub(crate) trait LawConstants: Law + Send + Sync + 'static {
    /// Name in files.
    const NAME: &'static str;

    /// Constants of the law.
    fn new(parameters: &FrictionParameters, stick_gain_n_s_m: f64) -> Self;

    /// The law with its parameters in a few words.
    fn describe(parameters: &FrictionParameters) -> String;

    /// Largest coefficient of friction.
    fn coefficient_max(parameters: &FrictionParameters) -> f64 {
        parameters.coefficient
    }

    /// Coefficient of friction at rest.
    fn coefficient_at_rest(parameters: &FrictionParameters) -> f64 {
        parameters.coefficient
    }

    /// Largest fall of the coefficient of friction over the sliding speed, s/m.
    fn steepest_fall(_parameters: &FrictionParameters) -> f64 {
        0.0
    }
}

/// Constants of a law in every lane of a block.
pub(crate) trait LawLanes {
    /// Constants of the law in one lane.
    type Constants: LawConstants;
    /// The law in one lane.
    type Law<'a>: Law
    where
        Self: 'a;
    /// The laws at given sliding speeds of two contacts.
    type Evaluated<'a>: EvaluatedLaws
    where
        Self: 'a;
    /// The law in a lane.
    fn lane(&self, lane: usize) -> Self::Law<'_>;
    /// The laws at these sliding speeds of two contacts of each lane, m/s: at no others.
    fn evaluated(&self, slips_m_s: [&Lanes; 2]) -> Self::Evaluated<'_>;
    /// The lanes filled one by one.
    fn filled(value: impl Fn(usize) -> Self::Constants) -> Self;
}

/// Laws of the lanes of a block, ready at given sliding speeds.
pub(crate) trait EvaluatedLaws {
    /// The law in one lane.
    type Law<'l>: Law
    where
        Self: 'l;
    /// The law in a lane.
    fn lane(&self, lane: usize) -> Self::Law<'_>;
}

/// Laws that need no preparation.
impl<L: LawLanes> EvaluatedLaws for &L {
    type Law<'l>
        = L::Law<'l>
    where
        Self: 'l;

    #[inline(always)]
    fn lane(&self, lane: usize) -> L::Law<'_> {
        (**self).lane(lane)
    }
}

/// Coefficient and knee of a law that has them as fields.
macro_rules! knee {
    () => {
        #[inline(always)]
        fn coefficient(&self) -> f64 {
            self.coefficient
        }

        #[inline(always)]
        fn inverse_regularisation_speed(&self) -> f64 {
            self.inverse_regularisation_speed
        }
    };
}
pub(super) use knee;
