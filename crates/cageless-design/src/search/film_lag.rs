//! Lag of the balls by a film at rest.

use super::raceway_layout::OperatingPoint;
use cageless::Case;
use cageless::equilibrium::settle;
use cageless::film::FilmAtRest;

/// Lag of a free ball by the film on a plain ring at rest, rad; 0 without a film, not finite where it stops the ball
/// and without an equilibrium.
pub(super) fn film_lag_at_rest_rad(case: &Case, point: &OperatingPoint) -> f64 {
    if case.film.is_none() {
        return 0.0;
    }
    let plain = point.case(case, vec![]);
    let film = settle(&plain)
        .ok()
        .and_then(|rest| FilmAtRest::new(&plain, &rest));
    film.map_or(f64::NAN, |film| film.lag_rad)
}
