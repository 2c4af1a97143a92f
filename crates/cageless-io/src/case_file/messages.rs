//! Messages about allowed values, in the units of the file.

use cageless::Allowed;
use cageless::{Bearing, Case, InputError};

use super::document::CaseDocument;
use super::key::Key;
use super::unit::{Side, Unit, decimal, round};
use super::value::CaseValue;

/// Allowed values of a field of [`cageless`], in the unit of its key. Rules that contain numbers
/// in SI units are rewritten in file units.
pub(super) fn in_file_units(
    error: &InputError,
    key: &Key,
    document: &CaseDocument,
    raceway: Option<usize>,
) -> String {
    let unit = key.unit;
    let span = |index: usize| {
        let key = format!("raceway.{}.axial_span_mm", index + 1);
        document.number(&key).unwrap_or(f64::NAN)
    };
    let limit = |words: &str, si: f64, side: Side, why: &str| match why {
        "" => format!("{words} {}", unit.show(si, side)),
        why => format!("{words} {} ({why})", unit.show(si, side)),
    };
    match &error.allowed {
        Allowed::Above(low, why) => limit("more than", *low, Side::Lower, why),
        Allowed::AtLeast(low, why) => limit("at least", *low, Side::Lower, why),
        Allowed::Below(high, why) => limit("less than", *high, Side::Upper, why),
        Allowed::AtMost(high, why) => limit("at most", *high, Side::Upper, why),
        Allowed::Between(low, high, why) => {
            let between = format!("between {} and", unit.show(*low, Side::Lower));
            limit(&between, *high, Side::Upper, why)
        }
        Allowed::Reaching(what, now, most) => format!(
            "such that {what} is at most {}, and it is {}",
            unit.show(*most, Side::Upper),
            unit.show(*now, Side::Lower)
        ),
        Allowed::Rule(rule) => match (error.field, raceway) {
            ("half_angle_rad", Some(index)) => format!(
                "an angle at which the contact path rises steadily to the plain raceway (Zhao \
                 2022, Eq. (9)): with axial_span_mm = {} it turns back or leaves the groove",
                decimal(span(index))
            ),
            _ => rule.clone(),
        },
        left_out @ Allowed::LeftOut(_) => left_out.to_string(),
    }
}

/// Allowed values of `start.gaps`.
pub(super) fn gaps(document: &CaseDocument, bearing: &Bearing) -> String {
    let n = bearing.balls();
    let gaps = match document.value("start.gaps") {
        Some(CaseValue::Numbers(gaps)) => gaps,
        _ => return format!("a list of {n} gaps"),
    };
    if gaps.len() != n {
        return format!(
            "a list of {n} gaps in °, one per ball; these are {}",
            gaps.len()
        );
    }
    if let Some((k, gap)) = gaps.iter().enumerate().find(|(_, gap)| **gap < 0.0) {
        return format!(
            "0° or more each, balls cannot overlap; gap {} is {gap}",
            k + 1
        );
    }
    format!(
        "gaps that add up to {:.4}°, which is 360 - {n} ε (Zhao 2022, Eq. (10)); these add up \
         to {:.4}",
        n as f64 * Unit::Degree.of_si(bearing.nominal_gap_rad()),
        gaps.iter().sum::<f64>()
    )
}

/// The key that a value follows from and how, if `path` is not given itself.
pub(super) fn origin_of(
    document: &CaseDocument,
    path: &str,
) -> Option<(&'static str, &'static str)> {
    if document.has(path) {
        return None;
    }
    Some(match path {
        "bearing.ball_radius_mm" => ("bearing.ball_diameter_mm", "half of ball_diameter_mm"),
        "bearing.inner_groove_bottom_radius_mm" | "bearing.outer_groove_bottom_radius_mm"
            if document.has("bearing.pitch_diameter_mm") =>
        {
            let how = "from pitch_diameter_mm, ball diameter and clearance";
            ("bearing.pitch_diameter_mm", how)
        }
        "bearing.inner_groove_curvature_radius_mm" => (
            "bearing.inner_conformity",
            "inner_conformity times the ball diameter",
        ),
        "bearing.outer_groove_curvature_radius_mm" => (
            "bearing.outer_conformity",
            "outer_conformity times the ball diameter",
        ),
        "bearing.outer_shoulder_radius_mm" => (
            "bearing.outer_shoulder_radius_mm",
            "estimated, as the key is left out",
        ),
        "film.supply" if document.has("film.inlet_film_um") => {
            ("film.inlet_film_um", "from inlet_film_um")
        }
        "bearing.inner_ring_mass_kg" => (
            "bearing.inner_ring_mass_kg",
            "estimated, as the key is left out",
        ),
        _ => return None,
    })
}

/// Allowed initial displacement of the ring; the limit is that of [`cageless::Case::check`].
pub(super) fn ring(bearing: &Bearing) -> String {
    let most = 0.5 * bearing.radial_internal_clearance_m() + 0.1 * bearing.ball_radius_m();
    let most = round(Unit::Micrometre.of_si(most), Side::Upper);
    format!("between -{most} µm and {most} µm (the clearance and a tenth of the ball's radius)")
}

/// The first raceway that overlaps one before it, and how far apart they must be.
pub(super) fn overlap(case: &Case) -> Option<(usize, String)> {
    let raceways = &case.raceways;
    let overlap = |one: usize, other: usize| {
        let pair = vec![raceways[one].clone(), raceways[other].clone()];
        case.with_raceways(pair)
            .check()
            .is_err_and(|e| e.field == "centre_angle_rad")
    };
    let pairs =
        (0..raceways.len()).flat_map(|one| (one + 1..raceways.len()).map(move |o| (one, o)));
    let (one, other) = pairs
        .into_iter()
        .find(|&(one, other)| overlap(one, other))?;
    let apart = raceways[one].half_angle_rad() + raceways[other].half_angle_rad();
    let allowed = format!(
        "{} or more away from the middle of raceway {}, or the two overlap",
        Unit::Degree.show(apart, Side::Lower),
        one + 1
    );
    Some((other, allowed))
}
