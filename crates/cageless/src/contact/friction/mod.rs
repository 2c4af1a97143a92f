//! Laws of friction over the sliding speed: a file each, and their list.
//!
//! ```
//! use cageless::contact::friction::{Law, Smooth};
//!
//! let law = Smooth {
//!     coefficient: 0.1,
//!     inverse_slip_scale: 1.0 / 0.02,
//! };
//! let [sliding_n, _] = law.force(1.0, 500.0);
//! assert_eq!(sliding_n, 50.0); // μ·N far from rolling
//! let [_, slope_n_s_m] = law.force(0.0, 500.0);
//! assert!((slope_n_s_m - 50.0 / 0.02).abs() < 1e-9);
//! ```
//!
//! A law is the struct of its constants with [`Law`] and [`LawConstants`] implemented on it. A new
//! one is a file beside `smooth.rs` and a line of the list below; methods, step limits, messages
//! and pages follow from it.

mod tanh;

use super::{SlipProblem, Slips};

pub use table::{FrictionTable, POINTS_MAX};
pub use tanh::tanh;

/// Parameters of the laws for one kind of contact; a law has those that it uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionParameters<'a> {
    /// Law.
    pub law: FrictionLaw,
    /// μ; of the Stribeck law that of fast sliding.
    pub coefficient: f64,
    /// Sliding speed at the knee, m/s.
    pub slip_scale_m_s: f64,
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
    fn force(&self, slip_m_s: f64, normal_n: f64) -> [f64; 2];

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
    fn inverse_slip_scale(&self) -> f64 {
        f64::INFINITY
    }

    /// A function of the sliding speed, m/s, that is zero where the force is not smooth over it; of
    /// laws of which that is so.
    #[inline(always)]
    fn edge(&self, _slip_m_s: f64) -> Option<f64> {
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

/// Declares a law whose constants are numbers.
macro_rules! law_struct {
    ($(#[$meta:meta])* pub struct $name:ident per lane $lanes:ident { $($fields:tt)* }) => {
        lane_struct! { $(#[$meta])* pub struct $name per lane $lanes { $($fields)* } }

        impl super::LawLanes for $lanes {
            type Constants = $name;
            type Law<'a> = $name;
            #[inline(always)]
            fn lane(&self, lane: usize) -> $name {
                self.get(lane)
            }
            fn filled(value: impl Fn(usize) -> $name) -> Self {
                Self::from_fn(value)
            }
        }
    };
}

/// Declares the list of laws and what follows from it.
macro_rules! friction_laws {
    ($(
        $(#[$meta:meta])*
        $module:ident: $law:ident per lane $lanes:ident,
    )*) => {
        $(mod $module;)*
        $(pub use $module::$law;)*

        /// Law of friction over the sliding speed.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum FrictionLaw {
            $($(#[$meta])* $law,)*
        }

        /// A law with its constants.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[allow(clippy::large_enum_variant)] // a table, one per contact partner
        pub enum Friction {
            $(#[doc = concat!("[`", stringify!($law), "`].")] $law($law),)*
        }

        /// [`Friction`] of each lane, all of one law.
        #[derive(Debug, Clone)]
        #[allow(clippy::large_enum_variant)] // one per model, read in every evaluation
        pub(crate) enum FrictionLanes {
            $($law($module::$lanes),)*
        }

        impl FrictionLaw {
            /// Every law with its name in files.
            pub const NAMES: &'static [(&'static str, Self)] =
                &[$((<$law as LawConstants>::NAME, Self::$law)),*];

            /// Name in files.
            pub fn name(self) -> &'static str {
                match self { $(Self::$law => <$law as LawConstants>::NAME,)* }
            }

            /// Whether a rolling contact sticks, see [`Law::STICKS`].
            pub fn sticks(self) -> bool {
                match self { $(Self::$law => <$law as Law>::STICKS,)* }
            }
        }

        impl FrictionParameters<'_> {
            /// Largest coefficient of friction.
            pub fn coefficient_max(&self) -> f64 {
                match self.law { $(FrictionLaw::$law => <$law as LawConstants>::coefficient_max(self),)* }
            }

            /// Largest fall of the coefficient of friction over the sliding speed, s/m.
            pub fn steepest_fall(&self) -> f64 {
                match self.law { $(FrictionLaw::$law => <$law as LawConstants>::steepest_fall(self),)* }
            }

            /// The law with its parameters in a few words.
            pub fn describe(&self) -> String {
                match self.law { $(FrictionLaw::$law => <$law as LawConstants>::describe(self),)* }
            }
        }

        impl Friction {
            /// The law with these parameters; explicit methods give a law that sticks this gain.
            pub fn new(parameters: &FrictionParameters<'_>, stick_gain_n_s_m: f64) -> Self {
                match parameters.law {
                    $(FrictionLaw::$law => Self::$law($law::new(parameters, stick_gain_n_s_m)),)*
                }
            }

            /// [`Law::force`].
            #[inline(always)]
            pub fn force(&self, slip_m_s: f64, normal_n: f64) -> [f64; 2] {
                match self { $(Self::$law(law) => law.force(slip_m_s, normal_n),)* }
            }

            /// [`Law::edge`].
            #[inline(always)]
            pub fn edge(&self, slip_m_s: f64) -> Option<f64> {
                match self { $(Self::$law(law) => law.edge(slip_m_s),)* }
            }

            /// [`Law::STICKS`].
            #[inline(always)]
            pub fn sticks(&self) -> bool {
                match self { $(Self::$law(_) => <$law as Law>::STICKS,)* }
            }

            /// [`Law::coefficient`].
            #[inline(always)]
            pub fn coefficient(&self) -> f64 {
                match self { $(Self::$law(law) => law.coefficient(),)* }
            }

            /// [`Law::inverse_slip_scale`].
            #[inline(always)]
            pub fn inverse_slip_scale(&self) -> f64 {
                match self { $(Self::$law(law) => law.inverse_slip_scale(),)* }
            }
        }

        impl FrictionLanes {
            /// Constants lane by lane; all of one law, that of the first lane.
            pub fn from_fn(value: impl Fn(usize) -> Friction) -> Self {
                match value(0) {
                    $(Friction::$law(first) => Self::$law(LawLanes::filled(|lane| {
                        match value(lane) {
                            Friction::$law(law) => law,
                            #[allow(unreachable_patterns)] // where there is one law
                            _ => first,
                        }
                    })),)*
                }
            }
        }

        /// Evaluates an expression with the constants of the law, whichever it is.
        macro_rules! with_law {
            ($friction:expr, $name:ident => $body:expr) => {
                match $friction {
                    $(crate::contact::FrictionLanes::$law($name) => $body,)*
                }
            };
        }
        pub(crate) use with_law;
    };
}

friction_laws! {
    /// μ·tanh(ΔV/scale)·N.
    smooth: Smooth per lane SmoothLanes,
    /// μ·sign(ΔV)·N while sliding, whatever holds within the cone while rolling: exact in
    /// `symplectic`; relaxed over a few steps in the explicit methods, whose results are of
    /// order one in `step_s`.
    coulomb: Coulomb per lane CoulombLanes,
    /// (μ + (μs − μ)·exp(−|ΔV|/v))·tanh(ΔV/scale)·N: friction that drops from static to
    /// sliding, as dry pairs do.
    stribeck: Stribeck per lane StribeckLanes,
    /// μ(|ΔV|)·tanh(ΔV/scale)·N with μ from a table of measured points.
    table: Table per lane TableLanes,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slope is the derivative of the force, by central differences.
    #[test]
    fn slopes_are_derivatives() {
        let table = FrictionTable::new(vec![[0.01, 0.3], [0.2, 0.2], [0.9, 0.1]]).unwrap();
        let measured = FrictionParameters {
            law: FrictionLaw::Table,
            coefficient: 0.1,
            slip_scale_m_s: 0.02,
            static_coefficient: None,
            stribeck_speed_m_s: None,
            table: Some(&table),
        };
        for law in [
            Friction::new(&measured, 0.0),
            Friction::Smooth(Smooth {
                coefficient: 0.1,
                inverse_slip_scale: 50.0,
            }),
            Friction::Stribeck(Stribeck {
                coefficient: 0.1,
                static_excess: 0.2,
                inverse_stribeck_speed: 10.0,
                inverse_slip_scale: 50.0,
            }),
        ] {
            for slip in [-1.0, -0.3, -0.02, 1e-3, 0.05, 0.7] {
                let force = |slip: f64| law.force(slip, 100.0)[0];
                let h = 1e-6;
                let expected = (force(slip + h) - force(slip - h)) / (2.0 * h);
                let found = law.force(slip, 100.0)[1];
                assert!(
                    (found - expected).abs() < 1e-5 * (1.0 + expected.abs()),
                    "{slip}"
                );
            }
        }
    }
}
