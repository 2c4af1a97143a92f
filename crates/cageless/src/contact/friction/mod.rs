//! Laws of friction over the sliding speed: a file each, and their list.
//!
//! A law is the struct of its constants with [`Law`] and [`LawConstants`] implemented on it. A new
//! one is a file beside `smooth.rs` and a line of the list below; methods, step limits, messages
//! and pages follow from it.

mod at_knees;
mod at_raceways;
mod check;
mod film_traction;
mod friction_table;
mod law;
mod mixed;
mod own_law;
mod parameters;

pub(crate) use at_knees::AtKnees;
pub(crate) use at_raceways::AtRaceways;
pub(crate) use coulomb::STICK_FRACTION;
pub(crate) use film_traction::{FilmTraction, FilmTractionLanes};
pub use friction_table::FrictionTable;
pub(crate) use law::{EvaluatedLaws, Law, LawConstants, LawLanes, Spinning};
pub(crate) use mixed::Mixed;
pub use own_law::FrictionLaw;
pub(crate) use own_law::{FrictionFault, OwnFriction};
pub(crate) use parameters::ContactKind;
pub use parameters::FrictionParameters;

/// Declares a law whose constants are numbers.
macro_rules! law_struct {
    ($(#[$meta:meta])* pub(crate) struct $name:ident per lane $lanes:ident { $($fields:tt)* }) => {
        lane_struct! { $(#[$meta])* pub(crate) struct $name per lane $lanes { $($fields)* } }

        impl super::law::LawLanes for $lanes {
            type Constants = $name;
            type Law<'a> = $name;
            type Evaluated<'a> = &'a Self;
            #[inline(always)]
            fn lane(&self, lane: usize) -> $name {
                self.get(lane)
            }
            #[inline(always)]
            fn evaluated(&self, _: [&crate::numerics::lanes::Lanes; 2]) -> &Self {
                self
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
        $(pub(crate) use $module::$law;)*

        /// Law of friction over the sliding speed.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum FrictionModel {
            $($(#[$meta])* $law,)*
        }

        /// A law with its constants.
        #[derive(Debug, Clone, PartialEq)]
        #[allow(clippy::large_enum_variant)] // a table, one per contact partner
        pub(crate) enum Friction {
            $(#[doc = concat!("[`", stringify!($law), "`].")] $law($law),)*
            /// The smooth law beside a film.
            Mixed(Mixed),
        }

        /// [`Friction`] of each lane, all of one law.
        #[derive(Debug, Clone)]
        #[allow(clippy::large_enum_variant)] // one per model, read in every evaluation
        pub(crate) enum FrictionLanes {
            $($law($module::$lanes),)*
            Mixed(mixed::MixedLanes),
        }

        impl FrictionModel {
            const ALL: &'static [(&'static str, Self)] =
                &[$((<$law as LawConstants>::NAME, Self::$law)),*];

            /// Every law that a file can name, with its name: all but the last, a law of one's own.
            pub const NAMES: &'static [(&'static str, Self)] =
                Self::ALL.split_at(Self::ALL.len() - 1).0;

            /// Name in files.
            pub fn name(self) -> &'static str {
                match self { $(Self::$law => <$law as LawConstants>::NAME,)* }
            }

            /// Whether a rolling contact sticks, see `Law::STICKS`.
            pub fn sticks(self) -> bool {
                match self { $(Self::$law => <$law as Law>::STICKS,)* }
            }

            /// Largest coefficient of friction.
            pub(crate) fn coefficient_max(self, parameters: &FrictionParameters) -> f64 {
                match self { $(Self::$law => <$law as LawConstants>::coefficient_max(parameters),)* }
            }

            /// Coefficient of friction at rest.
            pub(crate) fn coefficient_at_rest(self, parameters: &FrictionParameters) -> f64 {
                match self { $(Self::$law => <$law as LawConstants>::coefficient_at_rest(parameters),)* }
            }

            /// Largest fall of the coefficient of friction over the sliding speed, s/m.
            pub(crate) fn steepest_fall(self, parameters: &FrictionParameters) -> f64 {
                match self { $(Self::$law => <$law as LawConstants>::steepest_fall(parameters),)* }
            }

            /// The law with its parameters in a few words.
            pub fn describe(self, parameters: &FrictionParameters) -> String {
                match self { $(Self::$law => <$law as LawConstants>::describe(parameters),)* }
            }
        }

        impl Friction {
            /// The law with these parameters; explicit methods give a law that sticks this gain.
            pub(crate) fn new(
                law: FrictionModel,
                parameters: &FrictionParameters,
                stick_gain_n_s_m: f64,
            ) -> Self {
                match law {
                    $(FrictionModel::$law => Self::$law($law::new(parameters, stick_gain_n_s_m)),)*
                }
            }

            /// [`Law::force`].
            #[inline(always)]
            pub(crate) fn force(&self, sliding_m_s: f64, normal_n: f64) -> [f64; 2] {
                match self {
                    $(Self::$law(law) => law.force(sliding_m_s, normal_n),)*
                    Self::Mixed(law) => law.force(sliding_m_s, normal_n),
                }
            }

            /// [`Law::edge`].
            #[inline(always)]
            pub(crate) fn edge(&self, sliding_m_s: f64) -> Option<f64> {
                match self {
                    $(Self::$law(law) => law.edge(sliding_m_s),)*
                    Self::Mixed(law) => law.edge(sliding_m_s),
                }
            }

            /// [`Law::STICKS`].
            #[inline(always)]
            pub(crate) fn sticks(&self) -> bool {
                match self {
                    $(Self::$law(_) => <$law as Law>::STICKS,)*
                    Self::Mixed(_) => Mixed::STICKS,
                }
            }

            /// [`Law::coefficient`].
            #[inline(always)]
            pub(crate) fn coefficient(&self) -> f64 {
                match self {
                    $(Self::$law(law) => law.coefficient(),)*
                    Self::Mixed(law) => law.coefficient(),
                }
            }

            /// [`Law::inverse_regularisation_speed`].
            #[inline(always)]
            pub(crate) fn inverse_regularisation_speed(&self) -> f64 {
                match self {
                    $(Self::$law(law) => law.inverse_regularisation_speed(),)*
                    Self::Mixed(law) => law.inverse_regularisation_speed(),
                }
            }
        }

        impl Friction {
            /// The law beside a film, of laws that mix with one.
            pub(crate) fn mixed(self) -> Self {
                match self {
                    Self::Smooth(law) => Self::Mixed(Mixed(law)),
                    other => other,
                }
            }

            /// First answer of a law of one's own that cannot be.
            pub(crate) fn fault(&self) -> Option<&FrictionFault> {
                match self {
                    Self::Own(own) => own.fault(),
                    _ => None,
                }
            }
        }

        impl FrictionLanes {
            /// Constants lane by lane; all of one law, that of the first lane.
            pub(crate) fn from_fn(value: impl Fn(usize) -> Friction) -> Self {
                match value(0) {
                    Friction::Mixed(first) => Self::Mixed(LawLanes::filled(|lane| {
                        match value(lane) {
                            Friction::Mixed(law) => law,
                            _ => first,
                        }
                    })),
                    $(Friction::$law(first) => Self::$law(LawLanes::filled(|lane| {
                        match value(lane) {
                            Friction::$law(law) => law,
                            _ => first.clone(),
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
                    crate::contact::FrictionLanes::Mixed($name) => $body,
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
    /// `verlet`; relaxed over a few steps in the explicit methods, whose results are of
    /// order one in `step_s`.
    coulomb: Coulomb per lane CoulombLanes,
    /// (μ + (μs − μ)·exp(−|ΔV|/v))·tanh(ΔV/scale)·N: friction that drops from static to
    /// sliding, as dry pairs do.
    stribeck: Stribeck per lane StribeckLanes,
    /// μ(|ΔV|)·tanh(ΔV/scale)·N with μ from a table of measured points.
    table: Table per lane TableLanes,
    /// Friction by a [`FrictionLaw`] of one's own, with the regularisation of the others; last, as no file names it.
    own: Own per lane OwnLanes,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slope is the derivative of the force, by central differences.
    #[test]
    fn slopes_are_derivatives() {
        let table = FrictionTable::new(vec![[0.01, 0.3], [0.2, 0.2], [0.9, 0.1]]).unwrap();
        let measured = FrictionParameters {
            table: Some(table),
            ..FrictionParameters::smooth(0.1, 0.02)
        };
        for law in [
            Friction::new(FrictionModel::Table, &measured, 0.0),
            Friction::Smooth(Smooth {
                coefficient: 0.1,
                inverse_regularisation_speed: 50.0,
            }),
            Friction::Stribeck(Stribeck {
                coefficient: 0.1,
                static_excess: 0.2,
                inverse_stribeck_speed: 10.0,
                inverse_regularisation_speed: 50.0,
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
