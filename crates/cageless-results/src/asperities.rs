//! Friction of asperities beside a sheared film.

use cageless::Case;

/// Warning about asperities that slide more easily than the film beside them.
pub fn slippery_asperities(case: &Case) -> Option<String> {
    let film = case.film.as_ref().filter(|_| case.mixes_friction())?;
    let (asperities, most) = (case.contact.friction.coefficient, film.traction_coefficient);
    (asperities < most).then(|| {
        format!(
            "with film.traction = \"film\" contact.friction_coefficient = {asperities} is that of asperities, which \
             slide more easily than the film, {most}: boundary friction of steel is 0.11"
        )
    })
}
