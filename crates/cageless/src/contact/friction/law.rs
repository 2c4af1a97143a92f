//! What a law of friction is.

use super::friction_table::FrictionTable;
use crate::contact::slip_problem::{SlipProblem, Slips};

/// Parameters of the laws for one kind of contact; a law has those that it uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionParameters<'a> {
    /// μ; of the Stribeck law that of fast sliding.
    pub coefficient: f64,
    /// Sliding speed at the knee, m/s.
    pub regularisation_speed_m_s: f64,
    /// μs, at least μ.
    pub static_coefficient: Option<f64>,
    /// v of the Stribeck law, m/s.
    pub stribeck_speed_m_s: Option<f64>,
    /// μ over |ΔV|.
    pub table: Option<&'a FrictionTable>,
}

/// A law of friction with its constants.
pub trait Law: Copy {
    /// Whether a rolling contact sticks: the friction within the cone is then no function of
    /// the sliding speed. Implicit methods call [`Law::end_of_step`]; explicit ones get a stick
    /// that is relaxed over a few steps, `stick_gain` times the sliding speed.
    const STICKS: bool = false;

    /// Friction force along −ΔV under the normal force `normal_n`, N, and its slope over ΔV,
    /// N·s/m.
    fn force(&self, sliding_m_s: f64, normal_n: f64) -> [f64; 2];

    /// [`Self::force`] of two contacts; to rounding the same.
    #[inline(always)]
    fn forces(&self, slips_m_s: [f64; 2], normals_n: [f64; 2]) -> [[f64; 2]; 2] {
        [
            self.force(slips_m_s[0], normals_n[0]),
            self.force(slips_m_s[1], normals_n[1]),
        ]
    }

    /// Coefficient of friction of fast sliding.
    fn coefficient(&self) -> f64;

    /// 1/ΔV at which the force has its knee, s/m; of laws that do not stick.
    fn inverse_regularisation_speed(&self) -> f64 {
        f64::INFINITY
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
pub trait LawConstants: Law + Send + Sync + 'static {
    /// Name in files.
    const NAME: &'static str;

    /// Constants of the law.
    fn new(parameters: &FrictionParameters<'_>, stick_gain_n_s_m: f64) -> Self;

    /// The law with its parameters in a few words.
    fn describe(parameters: &FrictionParameters<'_>) -> String;

    /// Largest coefficient of friction.
    fn coefficient_max(parameters: &FrictionParameters<'_>) -> f64 {
        parameters.coefficient
    }

    /// Largest fall of the coefficient of friction over the sliding speed, s/m.
    fn steepest_fall(_parameters: &FrictionParameters<'_>) -> f64 {
        0.0
    }
}

/// Constants of a law in every lane of a block.
pub(crate) trait LawLanes {
    /// Those of one lane.
    type Constants: LawConstants;
    /// The law in one lane.
    type Law<'a>: Law
    where
        Self: 'a;
    /// The law in a lane.
    fn lane(&self, lane: usize) -> Self::Law<'_>;
    /// The lanes filled one by one.
    fn filled(value: impl Fn(usize) -> Self::Constants) -> Self;
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

/// Implements what follows from the friction of a struct that has its law and parameters as fields.
macro_rules! has_friction {
    ($Owner:ty) => {
        impl $Owner {
            /// Parameters of the law of friction.
            pub fn friction(&self) -> $crate::contact::FrictionParameters<'_> {
                $crate::contact::FrictionParameters {
                    coefficient: self.friction_coefficient,
                    regularisation_speed_m_s: self.regularisation_speed_m_s,
                    static_coefficient: self.static_friction_coefficient,
                    stribeck_speed_m_s: self.stribeck_speed_m_s,
                    table: self.friction_table.as_ref(),
                }
            }

            /// Largest coefficient of friction of the law.
            pub fn friction_coefficient_max(&self) -> f64 {
                self.friction_law.coefficient_max(&self.friction())
            }

            /// Multiplies friction at every sliding speed.
            pub fn scale_friction(&mut self, factor: f64) {
                self.friction_coefficient *= factor;
                let scaled = self.static_friction_coefficient.map(|mu| mu * factor);
                self.static_friction_coefficient = scaled;
                self.friction_table = self.friction_table.as_ref().map(|t| t.scaled(factor));
            }
        }
    };
}
pub(crate) use has_friction;
