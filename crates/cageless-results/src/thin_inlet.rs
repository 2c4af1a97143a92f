//! Film at the inlet of the contacts that is thinner than starvation was computed for.

use cageless::Case;
use cageless::film::INLET_RATIO_MIN;

use crate::number_text::short;

/// Warning about a film at the inlet whose supply lies outside the computed range.
pub fn thin_inlet(case: &Case) -> Option<String> {
    let film = case.film.as_ref()?;
    let ratio = film.inlet_ratio.filter(|ratio| *ratio < INLET_RATIO_MIN)?;
    let thicker = match ratio < 1.0 {
        true => {
            "; film thickness and Λ are those of flooded contacts, thicker than all the oil on the track"
        }
        false => "",
    };
    Some(format!(
        "film.inlet_film_um is S = {} times the least flooded film, below {INLET_RATIO_MIN}, down to which starvation \
         was computed: the supply of {} is extrapolated{thicker}",
        short(ratio),
        short(film.supply)
    ))
}
