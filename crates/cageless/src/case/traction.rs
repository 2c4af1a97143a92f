//! Friction of the films of a case.

use super::Case;
use crate::contact::FrictionModel;
use crate::error::InputError;
use crate::film::Traction;

impl Case {
    /// Whether films take their part of the friction at the raceways.
    pub fn mixes_friction(&self) -> bool {
        (self.film.as_ref()).is_some_and(|film| film.traction == Traction::Film)
    }

    /// Friction at the raceways and between balls in a few words.
    pub fn describe_friction(&self) -> String {
        let law = self.contact.describe_friction();
        let sheared = self.film.as_ref().filter(|_| self.mixes_friction());
        sheared.map_or(law.clone(), |film| {
            format!(
                "sheared film, at most {}, beside asperities with μ = {}, {law}",
                film.traction_coefficient, self.contact.friction.coefficient
            )
        })
    }

    /// Refuses the traction of a film where friction has none.
    pub(super) fn check_traction(&self) -> Result<(), InputError> {
        let Some(film) = self.film.as_ref().filter(|_| self.mixes_friction()) else {
            return Ok(());
        };
        let law = self.contact.friction_law;
        let why = match () {
            () if self.rotor.is_some() => {
                "traction of a film under a falling rotor is not computed".to_owned()
            }
            () if law != FrictionModel::Smooth => format!(
                "asperities beside a film have the law \"smooth\", not {}",
                law.name()
            ),
            () if film.supply == 0.0 => "without supply there is no film".to_owned(),
            () => return Ok(()),
        };
        Err(InputError::rule(
            "traction",
            f64::NAN,
            format!("\"law\": {why}"),
        ))
    }
}
