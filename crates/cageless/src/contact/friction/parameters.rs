//! Parameters of the laws of friction.

use super::friction_table::FrictionTable;
use super::own_law::OwnFriction;
use crate::error::InputError;
use crate::limits::{not_negative, positive};

/// A kind of contact with friction of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactKind {
    /// Ball against raceway and ball against ball.
    Balls,
    /// Journal against bore; its fields in errors have the prefix `rotor_`.
    Rotor,
}

/// Field of an error about a parameter of a contact.
macro_rules! field {
    ($of:expr, $name:literal) => {
        match $of {
            $crate::contact::friction::ContactKind::Balls => $name,
            $crate::contact::friction::ContactKind::Rotor => concat!("rotor_", $name),
        }
    };
}
pub(super) use field;

/// Parameters of the laws of friction for one kind of contact; a law has those that it uses.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrictionParameters {
    /// μ; of the Stribeck law and a table that of fast sliding.
    pub coefficient: f64,
    /// Sliding speed at the knee of all laws but Coulomb's, m/s.
    pub regularisation_speed_m_s: f64,
    /// μs of the Stribeck law, at least μ; of no other law.
    pub static_coefficient: Option<f64>,
    /// v of the Stribeck law, m/s; of no other law.
    pub stribeck_speed_m_s: Option<f64>,
    /// μ over |ΔV|, of the law of that name; of no other law.
    pub table: Option<FrictionTable>,
    /// Law of one's own; of no other law.
    pub(crate) own: Option<OwnFriction>,
}

/// Creep of a rolling contact at its limit of friction, over the rolling speed: that of Kalker's theory for steel at
/// μ = 0.1.
const CREEP: f64 = 1e-3;
/// Least and largest regularisation speed that a rolling speed gives, m/s.
const REGULARISATION_M_S: [f64; 2] = [1e-6, FrictionParameters::REGULARISATION_MAX_M_S];

impl FrictionParameters {
    /// Largest regularisation speed that a rolling speed gives, m/s.
    pub(crate) const REGULARISATION_MAX_M_S: f64 = 0.02;

    /// Regularisation speed of balls whose centres roll at this speed, m/s: a thousandth of it, from 1e-6 to
    /// 0.02 m/s.
    pub(crate) fn regularisation_of_rolling_m_s(rolling_m_s: f64) -> f64 {
        let [least, most] = REGULARISATION_M_S;
        (CREEP * rolling_m_s).clamp(least, most)
    }

    /// Parameters of the smooth law.
    pub(crate) fn smooth(coefficient: f64, regularisation_speed_m_s: f64) -> Self {
        Self {
            coefficient,
            regularisation_speed_m_s,
            static_coefficient: None,
            stribeck_speed_m_s: None,
            table: None,
            own: None,
        }
    }

    /// Parameters of a friction law of one's own.
    pub(crate) fn own(law: OwnFriction, regularisation_speed_m_s: f64) -> Self {
        Self {
            own: Some(law.clone()),
            ..Self::smooth(law.coefficient_fast(), regularisation_speed_m_s)
        }
    }

    /// Multiplies friction at every sliding speed.
    pub(crate) fn scale(&mut self, factor: f64) {
        self.coefficient *= factor;
        self.static_coefficient = self.static_coefficient.map(|mu| mu * factor);
        self.table = self.table.as_ref().map(|t| t.scaled(factor));
        self.own = self.own.as_ref().map(|own| own.scaled(factor));
    }

    /// Checks each parameter.
    pub(super) fn check(&self, of: ContactKind) -> Result<(), InputError> {
        positive(
            field!(of, "regularisation_speed_m_s"),
            self.regularisation_speed_m_s,
        )?;
        not_negative(field!(of, "friction_coefficient"), self.coefficient)?;
        if let Some(value) = self.stribeck_speed_m_s {
            positive(field!(of, "stribeck_speed_m_s"), value)?;
        }
        if let Some(value) = self.static_coefficient {
            positive(field!(of, "static_friction_coefficient"), value)?;
        }
        Ok(())
    }
}
