//! The keys of friction, which `[contact]` and `[rotor]` have in common.

use crate::case_file::declaration::prelude::*;

/// The laws, for the template.
pub(crate) const LAWS: Line = Line::Shown(
    "\"smooth\"",
    "\"smooth\", μ tanh(ΔV/regularisation_speed_m_s), \"coulomb\", \"stribeck\"\n\
     (with static_friction_coefficient, at least μ, and\n\
     stribeck_speed_m_s: μ + (μs − μ) exp(−|ΔV|/speed)) or \"table\"\n\
     (with friction_table = [[ΔV in m/s, μ], …])",
);

/// Declares a section of a struct with a field `friction`, whose rows stand between the others: `symbol`
/// of the coefficient, what follows "friction" in its meanings, and presences and template lines of
/// the coefficient and of the regularisation speed.
macro_rules! section_with_friction {
    (
        $(#[$doc:meta])* impl $Name:ty { $($before:tt)* }
        friction($symbol:literal, $between:literal) {
            coefficient: $coefficient:expr, $coefficient_line:expr;
            law: $law_line:expr;
            table: $left_out:literal;
            regularisation: $speed:expr, $unless_given:literal, $speed_line:expr;
        }
        { $($after:tt)* }
    ) => {
        $crate::case_file::declaration::section! {
            $(#[$doc])*
            impl $Name {
                $($before)*
                friction_law => friction_law: FrictionModel = default(FrictionModel::Smooth.name()), Plain,
                    concat!("friction", $between, " against sliding speed"), $law_line;
                @friction: cageless::FrictionParameters {
                    friction_coefficient => coefficient: f64 = $coefficient, Plain; AtLeast(0.0),
                        concat!($symbol, $between), $coefficient_line;
                    static_friction_coefficient => static_coefficient: Option<f64> = Optional,
                        Plain; Above(0.0), concat!("μs of the Stribeck law", $between), Absent;
                    stribeck_speed_m_s => stribeck_speed_m_s: Option<f64> = Optional, Si("m/s"); Above(0.0),
                        concat!("sliding speed over which the Stribeck law falls from μs to ", $symbol),
                        Absent;
                    friction_table => table: Option<FrictionTable> = Optional, Plain,
                        concat!("measured ", $symbol, " over the sliding speed, of friction_law = \"table\"; \
                            friction_coefficient is its last ", $symbol, $left_out), Absent;
                    regularisation_speed_m_s formerly slip_scale_m_s => regularisation_speed_m_s: f64 = $speed,
                        Si("m/s"); Above(0.0),
                        concat!("regularisation speed v_s: friction reaches 76 % of ", $symbol,
                            " N at ΔV = v_s", $unless_given, "; \"coulomb\" does not use it"), $speed_line;
                }
                $($after)*
            }
        }
    };
}
pub(crate) use section_with_friction;
