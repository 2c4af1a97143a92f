//! Limits of single input values. They are wide enough for every bearing and catch what was
//! meant in another unit: a modulus in MPa, a radius in metres, a density in g/cm³.
//!
//! ```
//! let limit = cageless::LIMITS.iter().find(|limit| limit.field == "ball_radius_m").unwrap();
//! assert!((limit.least..=limit.most).contains(&3.969e-3) && !(limit.least..=limit.most).contains(&3.969));
//! ```

use std::ops::RangeInclusive;

use crate::error::{Allowed, InputError};

/// Least and greatest value of an input field, both allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Field of [`InputError`]; its suffix is the unit of the two values.
    pub field: &'static str,
    /// Least value; `-∞` where a check elsewhere has the lower limit.
    pub least: f64,
    /// Greatest value; `∞` where a check elsewhere has the upper limit.
    pub most: f64,
    /// Reason for both.
    pub reason: &'static str,
}

const fn limit(field: &'static str, least: f64, most: f64, reason: &'static str) -> Limit {
    Limit {
        field,
        least,
        most,
        reason,
    }
}

const NONE: f64 = f64::NEG_INFINITY;
const INFINITY: f64 = f64::INFINITY;
const FACTOR: &str = "friction of clean metals over that of a film of oil is below";
const STIFFNESS: &str = "from plastic balls of a tenth of a millimetre to steel balls of a metre";

/// Every field with limits of its own. Dimensions that are limited by each other (radii of
/// grooves and shoulders, number of balls), by the elastic contact (speed, load) and by the
/// step (damping) are not listed.
#[rustfmt::skip]
pub const LIMITS: &[Limit] = &[
    limit("ball_radius_m", 5e-5, 0.5, "balls of bearings have diameters from 0.1 mm to 1 m"),
    limit("inner_ring_mass_kg", 1e-6, 1e6, "from a miniature ring to the rotor of a power station"),
    limit("density_kg_m3", 500.0, 25_000.0, "no solid of bearings is outside; steel has 7850 kg/m³"),
    limit("youngs_modulus_pa", 5e8, 1.3e12, "from PTFE to diamond; steel has 206 GPa"),
    limit("gravity_m_s2", NONE, 1000.0, "about 100 times that of the Earth"),
    limit("friction_coefficient", NONE, 2.0, "clean metals in vacuum stay below; it is no percentage"),
    limit("static_friction_coefficient", NONE, 2.0, "clean metals in vacuum stay below; it is no percentage"),
    limit("outer_friction_factor", NONE, 100.0, FACTOR),
    limit("ball_friction_factor", NONE, 100.0, FACTOR),
    limit("stribeck_speed_m_s", 1e-6, 1e3, "friction that drops below or above is constant"),
    limit("regularisation_speed_m_s", 1e-6, 10.0, "the smooth law is a step below and no friction above"),
    limit("inner_stiffness_n_m1_5", 1e6, 1e14, STIFFNESS),
    limit("outer_stiffness_n_m1_5", 1e6, 1e14, STIFFNESS),
    limit("ball_stiffness_n_m1_5", 1e6, 1e14, STIFFNESS),
    limit("tolerance", NONE, 0.01, "the motion is not resolved beyond"),
    limit("mass_kg", 1e-3, 1e6, "from a miniature housing to a machine"),
    limit("rotor_mass_kg", 1e-3, 1e6, "from a miniature spindle to the rotor of a power station"),
    limit("rotor_polar_inertia_kg_m2", 1e-12, 1e6, "from a miniature spindle to the rotor of a power station"),
    limit("radial_clearance_m", 1e-6, INFINITY, "rotor and inner ring must part; 200 µm are 0.2 mm"),
    limit("drive_torque_n_m", -1e7, 1e7, "the largest turbines drive with some 1e7 N·m"),
    limit("contact_stiffness_n_mp", 1e3, 1e16, "from foam to a block of steel; 1 N/µm is 1e6 N/m"),
    limit("contact_damping_s_m", NONE, 1e3, "a coefficient of restitution near 0 at a few mm/s"),
    limit("inner_ring_polar_inertia_kg_m2", 1e-14, 1e6, "from a miniature ring to the rotor of a power station"),
    limit("support_mass_kg", 1e-6, 1e6, "from the outer ring of a miniature bearing to a machine"),
    limit("support_stiffness_n_m", 1e3, 1e13, "from foam to a block of steel; 1 N/µm is 1e6 N/m"),
    limit("stop_stiffness_n_m", 1e3, 1e13, "from foam to a block of steel; 1 N/µm is 1e6 N/m"),
    limit("stiffness_n_m", 1e3, 1e13, "from foam to a block of steel; 1 N/µm is 1e6 N/m"),
];

/// Passes a value within the limits of its field, and every value of a field without limits.
pub(crate) fn within(field: &'static str, value: f64) -> Result<(), InputError> {
    let find = |field: &str| LIMITS.iter().find(|l| l.field == field);
    // Journal and bore have the limits of every contact.
    let of_contact = || find(field.strip_prefix("rotor_")?);
    let Some(limit) = find(field).or_else(of_contact) else {
        return Ok(());
    };
    Allowed::AtLeast(limit.least, limit.reason).check(field, value)?;
    Allowed::AtMost(limit.most, limit.reason).check(field, value)
}

/// Passes a finite value above zero, within the limits of its field.
pub(crate) fn positive(field: &'static str, value: f64) -> Result<(), InputError> {
    if value.is_finite() && value > 0.0 {
        within(field, value)
    } else {
        Err(InputError::new(field, value, Allowed::Above(0.0, "")))
    }
}

/// Passes a value from one bound to the other, both included; `why` says what they are.
pub(crate) fn from_to(
    field: &'static str,
    value: f64,
    allowed: RangeInclusive<f64>,
    why: &'static str,
) -> Result<(), InputError> {
    match allowed.contains(&value) {
        true => Ok(()),
        false => {
            let (least, most) = allowed.into_inner();
            Err(InputError::new(
                field,
                value,
                Allowed::Between(least, most, why),
            ))
        }
    }
}

/// Passes a value that keeps to a rule, which completes "it must be".
pub(crate) fn require(
    field: &'static str,
    value: f64,
    kept: bool,
    rule: impl Into<String>,
) -> Result<(), InputError> {
    match kept {
        true => Ok(()),
        false => Err(InputError::rule(field, value, rule)),
    }
}

/// Passes a finite value of zero or more, within the limits of its field.
pub(crate) fn not_negative(field: &'static str, value: f64) -> Result<(), InputError> {
    if value.is_finite() && value >= 0.0 {
        within(field, value)
    } else {
        Err(InputError::new(field, value, Allowed::AtLeast(0.0, "")))
    }
}

/// Passes a finite value within the limits of its field.
pub(crate) fn finite(field: &'static str, value: f64) -> Result<(), InputError> {
    require(field, value, value.is_finite(), "a finite number")?;
    within(field, value)
}
