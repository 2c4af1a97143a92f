//! A raceway near the curve of Zhao 2022, Eq. (11), that passes its verdict.

use super::{Judgement, LAG, RacewayVerdict, SEPARATION, STEADY_GAP, judge, verdict_steps};
use crate::critical_gap::{CriticalGapError, PairTest, critical_gap_rad, pair_steps};
use cageless::closed_forms::{Eq11, half_angle_for_gap_rad, steady_gap_rad, theoretical_gap_rad};
use cageless::equilibrium::EquilibriumError;
use cageless::numerics::{brent, last_where, try_brent};
use cageless::raceway::{Raceway, RacewayDimensions, axial_span_limit_m};
use cageless::simulation::Control;
use cageless::{Case, InputError};

/// The usable part of the curve of Zhao 2022, Eq. (11), for the gap of evenly spaced balls, and
/// its middle. Critical gaps bound it; the motion of all balls is not looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StartingPoint {
    /// Smallest θ, below which slip takes more than `SEPARATION` allows of the separation, on elastic flanks all
    /// that lowers it leaves less than `LAG` needs.
    pub half_angle_min_rad: f64,
    /// Largest θ = ε + nominal gap, above which three evenly spaced balls are inside at once.
    pub half_angle_max_rad: f64,
    /// θ in the middle.
    pub half_angle_rad: f64,
    /// lC that goes with it on the curve.
    pub axial_span_m: f64,
}

/// A raceway with its verdict: a recommendation if it passes, else the starting point.
#[derive(Debug, Clone, PartialEq)]
pub struct Recommendation {
    /// The usable part of the curve of Eq. (11) that it comes from.
    pub starting_point: StartingPoint,
    /// lC in whole micrometres and θ in whole thousandths of a degree, as judged.
    pub dimensions: RacewayDimensions,
    /// Verdict on the raceway in the place of the case's own.
    pub judgement: Judgement,
    /// Raceways that were judged.
    pub judged: usize,
}

impl Recommendation {
    /// Whether the raceway passes its verdict; else it is only a starting point.
    pub(crate) fn passes(&self) -> bool {
        self.judgement.passes() == Some(true)
    }
}

/// β0 of the raceways that are judged, over the gap of evenly spaced balls. Balls that are just
/// apart in the raceway collide on the least disturbance; a little less room in it prevents that.
const DEPTHS: [f64; 6] = [1.0, 0.97, 0.94, 0.91, 0.88, 0.85];
/// θ of the raceways that are judged, from the middle of the usable range (0) to its upper end
/// (1). Balls slide less in longer raceways.
const ANGLES: [f64; 2] = [0.0, 0.5];
/// A raceway with this fraction of the largest margin to every limit ends the search for a better
/// one.
const COMFORTABLE: f64 = 0.5;

/// Whole micrometres and thousandths of a degree.
fn rounded(dimensions: RacewayDimensions) -> RacewayDimensions {
    RacewayDimensions {
        axial_span_m: (dimensions.axial_span_m * 1e6).round() / 1e6,
        half_angle_rad: ((dimensions.half_angle_rad.to_degrees() * 1e3).round() / 1e3).to_radians(),
        ..dimensions
    }
}

/// ψ of the middle of the case's first raceway; the bottom if it has none.
fn centre_angle_rad(case: &Case) -> f64 {
    case.raceways
        .first()
        .map_or(0.0, |raceway| raceway.dimensions().centre_angle_rad)
}

/// Raceway of span lC on the curve of Eq. (11), in the place of the case's own.
fn on_curve(case: &Case, axial_span_m: f64) -> Option<Raceway> {
    let gap = case.bearing.nominal_gap_rad();
    let half_angle_rad = half_angle_for_gap_rad(
        &case.bearing,
        case.raceway_form(),
        axial_span_m,
        gap,
        Eq11::Published,
    )?;
    let dimensions = RacewayDimensions {
        axial_span_m,
        half_angle_rad,
        centre_angle_rad: centre_angle_rad(case),
    };
    Raceway::formed(dimensions, case.raceway_form(), &case.bearing).ok()
}

/// Span on the curve at which θ is `half_angle`; θ falls with the span.
fn span_for_angle(case: &Case, half_angle: f64) -> Option<f64> {
    let limit = axial_span_limit_m(&case.bearing) * (1.0 - 1e-9);
    // The curve begins at the narrowest span that any angle serves.
    on_curve(case, limit)?;
    let narrowest = last_where(limit, 0.0, 1e-4 * limit, |span| {
        on_curve(case, span).is_some()
    });
    let difference =
        |span: f64| on_curve(case, span).map_or(f64::NAN, |r| r.half_angle_rad() - half_angle);
    brent(difference, narrowest, limit, 1e-9)
}

/// Fraction of β0 that slip takes from the critical gap.
fn shortfall(
    case: &Case,
    raceway: Raceway,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<f64, CriticalGapError> {
    let beta0 = theoretical_gap_rad(&case.bearing, &raceway, Eq11::Published);
    let case = case.with_raceways(vec![raceway]);
    Ok(1.0 - critical_gap_rad(&case, &PairTest::default(), control)? / beta0)
}

/// Critical gaps that [`starting_point`] takes as a rule.
const CRITICAL_GAPS: f64 = 8.0;

/// Finds the range of θ on the curve of Eq. (11) within which the separation neither
/// suffers from slip nor lets three balls into the raceway at once, and the raceway in
/// its middle. `None` if there is no such range: slip takes over before the third ball
/// is kept out. `control` is called with the estimated fraction of the work that is done.
///
/// # Errors
/// The case is impossible, one of its runs fails, or `control` ended the work.
pub fn starting_point(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Option<StartingPoint>, CriticalGapError> {
    if let Some(film) = &case.film {
        let rule = "left out, with all of [film]: the recommendation of a raceway does not count the lag of a film yet";
        return Err(EquilibriumError::from(InputError::rule("supply", film.supply, rule)).into());
    }
    let bearing = &case.bearing;
    let half_angle_max_rad = bearing.ball_angle_rad() + bearing.nominal_gap_rad();
    let limit = axial_span_limit_m(bearing) * (1.0 - 1e-6);
    let (Some(narrow), Some(deepest)) = (
        span_for_angle(case, half_angle_max_rad),
        on_curve(case, limit),
    ) else {
        return Ok(None);
    };
    // On elastic flanks more is taken than by sliding.
    let allowed = match case.has_elastic_flanks() {
        true => 1.0 - LAG.limit(),
        false => SEPARATION.limit(),
    };
    let mut gaps = 0.0;
    let mut excess = |span: f64| match on_curve(case, span) {
        Some(raceway) => {
            let mut fraction = |part: f64| control(((gaps + part) / CRITICAL_GAPS).min(1.0));
            let shortfall = shortfall(case, raceway, &mut fraction)?;
            gaps += 1.0;
            Ok(shortfall - allowed)
        }
        None => Err(CriticalGapError::NeverCloses),
    };
    if excess(narrow)? > 0.0 {
        return Ok(None);
    }
    let half_angle_min_rad = if excess(limit)? <= 0.0 {
        deepest.half_angle_rad()
    } else {
        // To a hundredth of the ball's radius: finer than the threshold means anything.
        let tolerance = 1e-3 * bearing.ball_radius_m();
        let wide = try_brent(&mut excess, narrow, limit, tolerance)?.unwrap_or(limit);
        on_curve(case, wide).map_or(half_angle_max_rad, |raceway| raceway.half_angle_rad())
    };
    let half_angle_rad = 0.5 * (half_angle_min_rad + half_angle_max_rad);
    Ok(
        span_for_angle(case, half_angle_rad).map(|axial_span_m| StartingPoint {
            half_angle_min_rad,
            half_angle_max_rad,
            half_angle_rad,
            axial_span_m,
        }),
    )
}

/// lC at which a raceway of this θ has β0 = `gap_rad`, below the span `widest_m`.
fn span_for_gap(case: &Case, half_angle_rad: f64, gap_rad: f64, widest_m: f64) -> Option<f64> {
    let excess = |axial_span_m: f64| {
        let dimensions = RacewayDimensions {
            axial_span_m,
            half_angle_rad,
            centre_angle_rad: 0.0,
        };
        Raceway::formed(dimensions, case.raceway_form(), &case.bearing)
            .map_or(f64::NAN, |raceway| {
                theoretical_gap_rad(&case.bearing, &raceway, Eq11::Published) - gap_rad
            })
    };
    // The path exists above a span that depends on the angle.
    let narrowest = (1..20)
        .map(|k| widest_m * f64::from(k) / 20.0)
        .find(|&span| excess(span).is_finite())?;
    brent(excess, narrowest, widest_m * (1.0 + 1e-6), 1e-9)
}

/// The raceways to be judged at one angle, the deepest first; the starting point is left out.
fn neighbours(case: &Case, start: &StartingPoint, fraction: f64) -> Vec<RacewayDimensions> {
    let half_angle_rad =
        start.half_angle_rad + fraction * (start.half_angle_max_rad - start.half_angle_rad);
    let Some(widest_m) = span_for_angle(case, half_angle_rad) else {
        return vec![];
    };
    let uniform = case.bearing.nominal_gap_rad();
    DEPTHS
        .into_iter()
        .filter(|&depth| depth < 1.0 || fraction > 0.0)
        .filter_map(|depth| {
            let gap = depth * uniform;
            let axial_span_m = span_for_gap(case, half_angle_rad, gap, widest_m)?;
            let dimensions = rounded(RacewayDimensions {
                axial_span_m,
                half_angle_rad,
                centre_angle_rad: centre_angle_rad(case),
            });
            let raceway = Raceway::formed(dimensions, case.raceway_form(), &case.bearing).ok()?;
            // A shallower raceway passes without spreading the balls.
            let steady = steady_gap_rad(&case.bearing, std::slice::from_ref(&raceway));
            (gap >= STEADY_GAP.limit() * steady).then_some(dimensions)
        })
        .collect()
}

/// Best raceway: the first that passes with half of the possible margin, else the one with the largest margin.
fn best(
    raceways: impl Iterator<Item = RacewayDimensions>,
    judged: &mut dyn FnMut(RacewayDimensions) -> Result<Option<Recommendation>, CriticalGapError>,
) -> Result<Option<Recommendation>, CriticalGapError> {
    let margin = |r: &Recommendation| {
        let deciding = r.judgement.deciding;
        deciding.map_or(f64::NEG_INFINITY, |criterion| criterion.relative_margin())
    };
    let mut best: Option<Recommendation> = None;
    for dimensions in raceways {
        let Some(found) = judged(dimensions)?.filter(Recommendation::passes) else {
            continue;
        };
        if best.as_ref().is_none_or(|b| margin(&found) > margin(b)) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|b| margin(b) >= COMFORTABLE) {
            break;
        }
    }
    Ok(best)
}

/// A raceway that passes its verdict at the load and speed of the case: the middle of the usable
/// part of the curve of Eq. (11) if that passes, else shallower and longer ones near it, of which
/// the first with half of the possible margin, or the one with the largest margin, is taken. If
/// none passes, the middle with its verdict. `None` if the curve has no usable part, and in space, where balls do
/// not reach β0 of Eq. (11), or with a film, of which the curve knows nothing: there the search looks for a raceway.
///
/// `entered` is the case with a raceway in the place of its own, as it is judged when the raceway
/// is entered in its file; `None` if that is impossible. `control` is called with the estimated
/// fraction of the work that is done.
///
/// # Errors
/// The case is impossible, one of the runs for the starting point fails, or `control` ended the
/// work.
pub fn recommend(
    case: &Case,
    entered: &dyn Fn(RacewayDimensions) -> Option<Case>,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Option<Recommendation>, CriticalGapError> {
    if case.moves_in_space() || case.film.is_some() {
        return Ok(None);
    }
    let Some(start) = starting_point(case, &mut |part| control(STARTING_FRACTION * part))? else {
        return Ok(None);
    };
    let mut judged = 0u8;
    let mut judged_raceway = |dimensions: RacewayDimensions| {
        let Some(case) = entered(dimensions) else {
            return Ok(None);
        };
        let mut fraction = |part: f64| {
            // How many more follow is not known: each takes half of what is left.
            let left = 0.5f64.powf(f64::from(judged) + part);
            control(1.0 - (1.0 - STARTING_FRACTION) * left)
        };
        let judgement = match judge(&case, &mut fraction) {
            Err(CriticalGapError::Interrupted) => return Err(CriticalGapError::Interrupted),
            Err(_) => return Ok(None),
            Ok(judgement) => judgement,
        };
        judged += 1;
        Ok(Some(Recommendation {
            starting_point: start,
            dimensions,
            judgement,
            judged: judged as usize,
        }))
    };
    let middle = judged_raceway(rounded(RacewayDimensions {
        axial_span_m: start.axial_span_m,
        half_angle_rad: start.half_angle_rad,
        centre_angle_rad: centre_angle_rad(case),
    }))?;
    if middle.as_ref().is_some_and(Recommendation::passes) {
        return Ok(middle);
    }
    let mut angles = ANGLES;
    // A shallower raceway slows the balls less, but only a longer one leaves them more time.
    if matches!(&middle, Some(m) if m.judgement.verdict == RacewayVerdict::Slips) {
        angles.reverse();
    }
    let near = angles.into_iter();
    let near = near.flat_map(|fraction| neighbours(case, &start, fraction));
    let best = best(near, &mut judged_raceway)?;
    Ok(best.or(middle).map(|r| Recommendation {
        judged: judged as usize,
        ..r
    }))
}

/// Raceways that are judged as a rule.
const JUDGED: f64 = 2.0;

/// Steps that [`recommend`] takes as a rule for a case, with its own or a middling raceway.
pub fn recommendation_steps(case: &Case) -> f64 {
    if case.moves_in_space() || case.film.is_some() {
        return 0.0;
    }
    let raceway = match case.raceways.first() {
        Some(raceway) => Some(raceway.clone()),
        None => on_curve(case, 0.8 * axial_span_limit_m(&case.bearing)),
    };
    raceway.map_or(0.0, |raceway| {
        let case = case.with_raceways(vec![raceway]);
        CRITICAL_GAPS * pair_steps(&case, &PairTest::default()) + JUDGED * verdict_steps(&case)
    })
}

/// Fraction of the work of a recommendation that its starting point takes, roughly.
const STARTING_FRACTION: f64 = 0.3;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DECELERATION;
    use crate::common::{structure, structures};

    #[test]
    fn dimensions_are_rounded_to_what_a_drawing_states() {
        let found = rounded(RacewayDimensions {
            axial_span_m: 5.123_456e-3,
            half_angle_rad: 25.123_456f64.to_radians(),
            centre_angle_rad: 0.3,
        });
        assert!((found.axial_span_m - 5.123e-3).abs() < 1e-12);
        assert!((found.half_angle_rad.to_degrees() - 25.123).abs() < 1e-9);
        assert_eq!(found.centre_angle_rad, 0.3);
    }

    /// The structures of Zhao 2022, Table 2, lie on the curve, to the digits of the table.
    #[test]
    fn spans_of_the_curve_are_those_of_the_paper() {
        let case = structure(5.1, 25.2);
        for (span_mm, angle_deg, ..) in structures() {
            let span = span_for_angle(&case, angle_deg.to_radians()).unwrap();
            assert!((span * 1e3 - span_mm).abs() < 0.01, "{span_mm}: {span}");
            let on_curve = on_curve(&case, span).unwrap().half_angle_rad();
            assert!((on_curve.to_degrees() - angle_deg).abs() < 1e-3);
        }
        let limit = axial_span_limit_m(&case.bearing);
        let least = on_curve(&case, limit * (1.0 - 1e-9))
            .unwrap()
            .half_angle_rad();
        assert!(span_for_angle(&case, 0.9 * least).is_none());
        let turned = crate::common::raceway(&case.bearing, 5.1, 25.2, 40.0);
        let turned = case.with_raceways(vec![turned]);
        let centre = on_curve(&turned, 5.1e-3)
            .unwrap()
            .dimensions()
            .centre_angle_rad;
        assert!((centre.to_degrees() - 40.0).abs() < 1e-9);
        assert_eq!(centre_angle_rad(&case.with_raceways(vec![])), 0.0);
    }

    /// A raceway of any angle has the gap that its span was sought for.
    #[test]
    fn spans_for_a_gap_have_that_gap() {
        let case = structure(5.1, 25.2);
        let nominal = case.bearing.nominal_gap_rad();
        for angle_deg in [20.0f64, 25.2] {
            let angle = angle_deg.to_radians();
            let widest = span_for_angle(&case, angle).unwrap();
            for depth in [1.0, 0.9, 0.8] {
                let span = span_for_gap(&case, angle, depth * nominal, widest).unwrap();
                let raceway = crate::common::raceway(&case.bearing, span * 1e3, angle_deg, 0.0);
                let found = theoretical_gap_rad(&case.bearing, &raceway, Eq11::Published);
                assert!(
                    (found / nominal - depth).abs() < 1e-5,
                    "{angle_deg} {depth}: {found}"
                );
            }
            assert!(span_for_gap(&case, angle, 1.2 * nominal, widest).is_none());
        }
    }

    /// The usable part of the curve ends where three evenly spaced balls are inside and where slip
    /// takes 5 % of the separation; its neighbours are shallower and no narrower than they spread.
    #[test]
    fn the_starting_point_is_the_middle_of_what_is_usable() {
        let case = structure(5.1, 25.2);
        let mut go_on = |_| Control::Continue(());
        let start = starting_point(&case, &mut go_on).unwrap().unwrap();
        // ε + the nominal gap: 360°/14.
        let most = start.half_angle_max_rad.to_degrees();
        assert!((most - 360.0 / 14.0).abs() < 1e-9, "{most}");
        let span = span_for_angle(&case, start.half_angle_min_rad).unwrap();
        let lost = shortfall(&case, on_curve(&case, span).unwrap(), &mut go_on).unwrap();
        assert!((lost - 0.05).abs() < 2e-3, "{lost}");
        let middle = 0.5 * (start.half_angle_min_rad + start.half_angle_max_rad);
        assert_eq!(start.half_angle_rad, middle);
        let own = on_curve(&case, start.axial_span_m).unwrap();
        assert!((own.half_angle_rad() - middle).abs() < 1e-5);

        for (fraction, depths) in [
            (0.0, vec![0.97, 0.94, 0.91, 0.88]),
            (0.5, vec![1.0, 0.97, 0.94, 0.91, 0.88]),
        ] {
            let found = neighbours(&case, &start, fraction);
            let angle = middle + fraction * (start.half_angle_max_rad - middle);
            for (dimensions, depth) in found.iter().zip(&depths) {
                assert!((dimensions.half_angle_rad - angle).abs() < 1e-5);
                let raceway = Raceway::new(*dimensions, &case.bearing).unwrap();
                let beta0 = theoretical_gap_rad(&case.bearing, &raceway, Eq11::Published);
                let nominal = case.bearing.nominal_gap_rad();
                assert!((beta0 / nominal - depth).abs() < 2e-3, "{depth}: {beta0}");
            }
            // The next would be shallower than 0.8 of the steady gap.
            assert_eq!(found.len(), depths.len(), "{found:?}");
        }
    }

    /// The recommended raceway of some that are judged in turn, by the place in the list, and how many were judged;
    /// each reaches a fraction of the deceleration, of which 0.8 are the least, or cannot be judged.
    fn recommended(reached: &[Option<f64>]) -> (Option<usize>, usize) {
        let start = StartingPoint {
            half_angle_min_rad: 0.3,
            half_angle_max_rad: 0.5,
            half_angle_rad: 0.4,
            axial_span_m: 5e-3,
        };
        let place = |k: usize| RacewayDimensions {
            axial_span_m: 1e-3 * (k + 1) as f64,
            half_angle_rad: 0.4,
            centre_angle_rad: 0.0,
        };
        let mut count = 0;
        let mut judged = |dimensions: RacewayDimensions| {
            let deciding = reached[count].map(|reached| DECELERATION.of(reached));
            count += 1;
            Ok(deciding.map(|deciding| Recommendation {
                starting_point: start,
                dimensions,
                judgement: Judgement {
                    verdict: deciding.verdict(),
                    reasons: vec![],
                    deciding: Some(deciding),
                    critical_gap_rad: None,
                    pressure_at_rest_pa: None,
                    steady_gap_rad: None,
                    passages: None,
                    raceways: vec![],
                    film: None,
                    dry: None,
                    stopped: None,
                },
                judged: count,
            }))
        };
        let best = best((0..reached.len()).map(place), &mut judged).unwrap();
        let found = best.map(|best| (1e3 * best.dimensions.axial_span_m).round() as usize - 1);
        (found, count)
    }

    /// Margins of what is at least 0.8 are (value − 0.8)/0.2: half of the possible one is at 0.9.
    #[test]
    fn the_recommendation_has_the_largest_margin() {
        for (reached, expected) in [
            (vec![Some(0.85), Some(0.82)], (Some(0), 2)),
            (vec![Some(0.82), Some(0.85)], (Some(1), 2)),
            (vec![Some(0.82), Some(0.87), Some(0.85)], (Some(1), 3)),
            // What fails or cannot be judged is none, however near.
            (vec![Some(0.79), None, Some(0.81), Some(0.5)], (Some(2), 4)),
            (vec![Some(0.79), None], (None, 2)),
            (vec![], (None, 0)),
            // A comfortable one ends the search.
            (vec![Some(0.82), Some(0.91), Some(0.99)], (Some(1), 2)),
        ] {
            assert_eq!(recommended(&reached), expected, "{reached:?}");
        }
    }
}
