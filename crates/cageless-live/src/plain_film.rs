//! Film of a case on its plain ring, which estimates of its raceways have in common.

use cageless::Case;
use cageless::equilibrium::{EquilibriumError, settle_controlled};
use cageless::film::FilmAtRest;
use cageless::simulation::Control;

/// The film at rest without raceways; `None` of a dry case, and where nothing rests.
///
/// # Errors
/// `control` ended the search.
pub(crate) fn plain_film(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<Option<FilmAtRest>, EquilibriumError> {
    if !case.film.is_some_and(|film| film.supply > 0.0) {
        return Ok(None);
    }
    let plain = case.conventional();
    match settle_controlled(&plain, control) {
        Ok(settled) => Ok(FilmAtRest::new(&plain, &settled)),
        Err(EquilibriumError::Interrupted) => Err(EquilibriumError::Interrupted),
        Err(_) => Ok(None),
    }
}
