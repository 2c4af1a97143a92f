//! Check of the parameters of a law.

use super::FrictionLaw;
use super::friction_table::FrictionTable;
use super::law::FrictionParameters;
use crate::error::{Allowed, InputError};
use crate::limits::{not_negative, positive};

/// Rounding of a table that was multiplied by a factor.
const SAME_COEFFICIENT: f64 = 1e-9;

impl FrictionLaw {
    /// Checks the coefficients of friction, and that what only one law has is given with it and with no
    /// other; `fields` are the coefficient, the static one, the Stribeck speed and the table.
    pub(crate) fn check(
        self,
        friction: &FrictionParameters<'_>,
        fields: [&'static str; 4],
    ) -> Result<(), InputError> {
        let [coefficient, static_coefficient, speed, table] = fields;
        not_negative(coefficient, friction.coefficient)?;
        let last = friction.table.map(FrictionTable::coefficient_fast);
        for (field, value, law, name) in [
            (
                static_coefficient,
                friction.static_coefficient,
                FrictionLaw::Stribeck,
                "the Stribeck law",
            ),
            (
                speed,
                friction.stribeck_speed_m_s,
                FrictionLaw::Stribeck,
                "the Stribeck law",
            ),
            (table, last, FrictionLaw::Table, "the law \"table\""),
        ] {
            match value {
                None if self == law => {
                    let rule = format!("given: {name} needs it");
                    return Err(InputError::rule(field, f64::NAN, rule));
                }
                Some(value) if self != law => {
                    let rule = format!("left out: only {name} has it");
                    return Err(InputError::rule(field, value, rule));
                }
                _ => {}
            }
        }
        if let Some(value) = friction.stribeck_speed_m_s {
            positive(speed, value)?;
        }
        if let Some(value) = friction.static_coefficient {
            positive(static_coefficient, value)?;
            if value < friction.coefficient {
                let allowed =
                    Allowed::AtLeast(friction.coefficient, "friction drops once surfaces slide");
                return Err(InputError::new(static_coefficient, value, allowed));
            }
        }
        match last {
            Some(last) if (last - friction.coefficient).abs() > SAME_COEFFICIENT * last => {
                let rule =
                    format!("{last}, the μ of fast sliding in the last row of friction_table");
                Err(InputError::rule(coefficient, friction.coefficient, rule))
            }
            _ => Ok(()),
        }
    }
}
