//! Search for a raceway in a given oil.

use std::ops::RangeInclusive;

use super::film_lag::film_lag_at_rest_rad;
use super::raceway_layout::OperatingPoint;
use super::request::Request;
use crate::verdict::half_turn_lag_rad;
use crate::{IN_OIL, STEADY_GAP_MAX};
use cageless::Case;
use cageless::InputError;

/// Refuses several operating points in oil, as its lag differs with each.
pub(super) fn check_film(case: &Case, request: &Request) -> Result<(), InputError> {
    let Some(film) = &case.film else {
        return Ok(());
    };
    let one = request.points.len() == 1 && request.map_speeds_rad_s.is_empty();
    let rule = "left out, with all of [film]: a search in oil has one speed and one load; leave out others of [search]";
    match one {
        true => Ok(()),
        false => Err(InputError::rule("supply", film.supply, rule)),
    }
}

/// Lag of a ball per orbit by the film on a plain ring, rad: that of a run less that of the run without oil, as a
/// verdict takes it; where a run stops that at rest. 0 without a film, not finite where it stops the ball.
pub(super) fn film_lag_rad(case: &Case, point: &OperatingPoint) -> f64 {
    let at_rest_rad = film_lag_at_rest_rad(case, point);
    if at_rest_rad == 0.0 || !at_rest_rad.is_finite() {
        return at_rest_rad;
    }
    let wet = point.case(case, vec![]);
    let dry = Case {
        film: None,
        ..wet.clone()
    };
    let measured = half_turn_lag_rad(&wet).zip(half_turn_lag_rad(&dry));
    measured.map_or(at_rest_rad, |(wet, dry)| (wet - dry).max(0.0))
}

impl Request {
    /// Critical gap over the steady gap that is asked for: with a film that of the least scatter.
    pub(super) fn gap_range(&self, in_oil: bool) -> RangeInclusive<f64> {
        match in_oil {
            true => IN_OIL[0]..=IN_OIL[1],
            false => self.critical_gap_min_fraction..=STEADY_GAP_MAX,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;
    use cageless::film::{Film, Oil};

    /// A search in oil has one operating point, a range of its own, and the lag of a ball at rest in the load.
    #[test]
    fn a_search_in_oil_has_one_operating_point() {
        let dry = structure(5.1, 25.2);
        let mut wet = dry.clone();
        wet.film = Some(Film::flooded(Oil::mineral(5e-3, 0.035)));
        let own = Request::from_case(&dry);
        let point = own.points[0];
        let mut two = own.clone();
        two.points.push(point);
        let mut further = own.clone();
        further.map_speeds_rad_s.push(300.0);
        for (request, allowed) in [(&own, true), (&two, false), (&further, false)] {
            assert!(check_film(&dry, request).is_ok());
            let checked = check_film(&wet, request);
            assert_eq!(checked.is_ok(), allowed, "{checked:?}");
        }
        assert_eq!(own.gap_range(false), 0.8..=1.0);
        assert_eq!(own.gap_range(true), 1.0..=1.1);
        assert_eq!(film_lag_rad(&dry, &point), 0.0);
        let lag_deg = film_lag_at_rest_rad(&wet, &point).to_degrees();
        assert!((lag_deg - 1.878).abs() < 0.01, "{lag_deg}");
        // That of the prototype in motion.
        let moving_deg = film_lag_rad(&wet, &point).to_degrees();
        assert!((moving_deg - 1.952).abs() < 0.02, "{moving_deg}");
        let faster = OperatingPoint {
            inner_speed_rad_s: 2.0 * point.inner_speed_rad_s,
            ..point
        };
        assert!(film_lag_at_rest_rad(&wet, &faster).to_degrees() < 0.7 * lag_deg);
    }
}
