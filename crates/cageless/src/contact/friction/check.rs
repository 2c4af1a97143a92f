//! Check of the parameters of a law.

use super::FrictionModel;
use super::friction_table::FrictionTable;
use super::own_law::OwnFriction;
use super::parameters::{ContactKind, FrictionParameters, field};
use crate::error::{Allowed, InputError};

/// Rounding of a table that was multiplied by a factor.
const SAME_COEFFICIENT: f64 = 1e-9;

impl FrictionModel {
    /// Checks the parameters, and that what only one law has is given with it and with no other.
    pub(crate) fn check(
        self,
        friction: &FrictionParameters,
        of: ContactKind,
    ) -> Result<(), InputError> {
        let static_coefficient = field!(of, "static_friction_coefficient");
        let last = friction.table.as_ref().map(FrictionTable::coefficient_fast);
        let own = friction.own.as_ref().map(OwnFriction::coefficient_fast);
        let stribeck = (FrictionModel::Stribeck, "the Stribeck law");
        for (field, value, (law, name)) in [
            (static_coefficient, friction.static_coefficient, stribeck),
            (
                field!(of, "stribeck_speed_m_s"),
                friction.stribeck_speed_m_s,
                stribeck,
            ),
            (
                field!(of, "friction_table"),
                last,
                (FrictionModel::Table, "the law \"table\""),
            ),
            (
                field!(of, "own_friction"),
                own,
                (FrictionModel::Own, "a law of one's own"),
            ),
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
        friction.check(of)?;
        match (friction.static_coefficient, last) {
            (Some(value), _) => {
                let why = "friction drops once surfaces slide";
                Allowed::AtLeast(friction.coefficient, why).check(static_coefficient, value)
            }
            (_, Some(last)) if (last - friction.coefficient).abs() > SAME_COEFFICIENT * last => {
                let rule =
                    format!("{last}, the μ of fast sliding in the last row of friction_table");
                let field = field!(of, "friction_coefficient");
                Err(InputError::rule(field, friction.coefficient, rule))
            }
            _ => Ok(()),
        }
    }
}
