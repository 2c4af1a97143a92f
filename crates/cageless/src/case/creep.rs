//! Creep of the contacts with the raceways.

use super::Case;
use crate::contact::Regularisation;
use crate::contact::creep::{Creep, creep_stiffness_n1_3};
use crate::error::InputError;
use crate::formulation::Formulation;
use crate::kinematics::rolling_orbit_speed_rad_s;

impl Case {
    /// G ca cb C11 of the contacts with the outer and the inner raceway, N^(1/3).
    pub(crate) fn creep_stiffness_n1_3(&self) -> [f64; 2] {
        let materials = self.bearing.materials();
        let angle = self.bearing.contact_angle_rad();
        let [inner, outer] = self.bearing.contacts_at([angle; 2]);
        [outer, inner].map(|contact| {
            creep_stiffness_n1_3(contact.semi_axes_m(1.0), [&materials.ball, &materials.ring])
        })
    }

    /// Creep of the contacts with the raceways; `None` if the regularisation speed is given.
    pub(crate) fn creep(&self) -> Option<Creep> {
        if self.contact.regularisation != Regularisation::Kalker {
            return None;
        }
        let contact = &self.contact;
        let at_rest = contact.friction_law.coefficient_at_rest(&contact.friction);
        // Any knee does without friction.
        let over = |stiffness: f64, coefficient: f64| match coefficient > 0.0 {
            true => stiffness / coefficient,
            false => stiffness,
        };
        let [outer, inner] = self.creep_stiffness_n1_3();
        Some(Creep {
            outer: over(outer, at_rest * contact.outer_friction_factor),
            inner: over(inner, at_rest),
        })
    }

    /// Least speed at which balls roll on the raceways while the inner ring turns as the operation says; 0 in a drop.
    pub(crate) fn least_rolling_speed_m_s(&self) -> f64 {
        let operation = &self.operation;
        let table = operation.inner_speed_table.as_ref();
        let least_rad_s = table.map_or(operation.inner_speed_rad_s, |table| table.range()[0]);
        let bearing = &self.bearing;
        let orbit = rolling_orbit_speed_rad_s(bearing, least_rad_s, bearing.ball_radius_m());
        orbit.abs() * bearing.dimensions().outer_groove_bottom_radius_m
    }

    /// Refuses Kalker's creep where friction has no regularisation speed of its own contacts.
    pub(super) fn check_creep(&self) -> Result<(), InputError> {
        if self.contact.regularisation != Regularisation::Kalker {
            return Ok(());
        }
        let (law, friction) = (self.contact.friction_law, &self.contact.friction);
        let rests = law.coefficient_at_rest(friction) == 0.0;
        let why = match () {
            () if law.sticks() => "Coulomb's law has no regularisation speed".to_owned(),
            () if self.formulation == Formulation::Paper => {
                "the published equations have one regularisation speed for all contacts".to_owned()
            }
            () if rests && law.coefficient_max(friction) > 0.0 => format!(
                "{} has no friction at rest, and so no creep",
                law.describe(friction)
            ),
            () => return Ok(()),
        };
        let rule = format!("\"speed\": {why}");
        Err(InputError::rule("regularisation", f64::NAN, rule))
    }
}
