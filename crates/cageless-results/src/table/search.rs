//! Results of a search for a raceway.

use cageless_design::search::{
    AxialSeparation, Cause, ClosedForms, Evaluation, MapCell, PairSeparation, SpeedMap,
};

use crate::cell::Cell;
use crate::declare::*;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::{
    Map, Motion, Paper, Placement, Point, Rejection, Search, Structure, StructureAt,
};
use crate::unit::rpm;
use crate::{AtPoint, SearchedPlacement};

/// The search as a whole.
#[rustfmt::skip]
pub const SEARCH: &[Quantity] = &[
    part(quantity("critical_gap_min_fraction", "", "smallest critical gap, share of the steady-state gap", Search(|s| some(s.found.request.critical_gap_min_fraction)))),
    part(quantity("axial_load_max_n", "N", "largest axial load", Search(|s| some(s.found.request.axial_load_max_n)))),
    part(integer("starts", "uneven initial states of each structure", Search(|s| s.found.request.starts.into()))),
    part(integer("seed", "seed", Search(|s| s.seed.into()))),
    part(list("curve_axial_span_mm", "mm", "axial span lC of the curve of Eq. (11)", Search(|s| Cell::Numbers(s.curve.iter().map(|p| p.0 * 1e3).collect())))),
    part(list("curve_half_angle_deg", "deg", "half angle θ of the curve of Eq. (11)", Search(|s| Cell::Numbers(s.curve.iter().map(|p| p.1.to_degrees()).collect())))),
];

/// An operating point.
#[rustfmt::skip]
pub const POINT: &[Quantity] = &[
    // Rounding away what the conversion to SI leaves.
    part(quantity("inner_speed_rpm", "rpm", "speed of the inner ring", Point(|p| millionths(rpm(p.inner_speed_rad_s))))),
    part(quantity("radial_load_n", "N", "radial load", Point(|p| some(p.radial_load_n)))),
    part(quantity("axial_load_n", "N", "axial load", Point(|p| some(p.axial_load_n)))),
];

/// A structure: the raceways of a design.
#[rustfmt::skip]
pub const STRUCTURE: &[Quantity] = &[
    part(quantity("axial_span_mm", "mm", "axial span lC", Structure(|e| millionths(e.structure.axial_span_m * 1e3)))),
    part(quantity("half_angle_deg", "deg", "half angle θ", Structure(|e| millionths(e.structure.half_angle_rad.to_degrees())))),
    part(in_tables(text("shape", "shape", Structure(|e| Cell::Text(e.structure.form.shape.name().to_owned()))))),
    part(quantity("contact_angle_deg", "deg", "contact angle of the raceway", Structure(|e| millionths(e.structure.section_angle_rad.to_degrees())))),
    part(quantity("centre_angles_deg", "deg", "angular positions ψ", Structure(|e| angles(&e.structure.centres_rad)))),
    part(means("`accepted`, `rejected`, or `left out` by `search.runs_max`", text("status", "status", Structure(|e| Cell::Text(status(e).to_owned()))))),
    part(high(flag("passes", "passes", Structure(|e| flagged((status(e) != "left out").then_some(status(e) == "accepted")))))),
    part(text("reason", "requirement that is missed", Structure(|e| e.rejection.as_ref().map_or(Cell::Null, |r| Cell::Text(r.cause.name().to_owned()))))),
    part(text("why", "the reason in words", Structure(|e| Cell::Text(match (&e.rejection, status(e)) {
        (Some(rejection), _) => rejection.to_string(),
        (None, "left out") => "not tried: search.runs_max was reached".to_owned(),
        _ => String::new(),
    })))),
    part(flag("on_front", "on the Pareto front", Structure(|e| flagged(Some(e.on_front))))),
    part(means(BETA0_SEARCHED, quantity("beta0_deg", "deg", "β0, Eq. (11)", Structure(|e| closed_deg(e, |f| f.theoretical_gap_rad))))),
    part(means("of a free ball on a plain ring at rest; part of the steady-state gap; with `[film]`", quantity("film_lag_per_turn_deg", "deg", "lag of a ball by the film per orbit", Structure(|e| e.forms.map(|f| f.film_lag_rad.to_degrees()).filter(|lag| *lag != 0.0).into())))),
    part(quantity("steady_gap_deg", "deg", "steady-state gap, outside the raceway", Structure(|e| closed_deg(e, |f| f.steady_gap_rad)))),
];

/// A structure at an operating point.
#[rustfmt::skip]
pub const STRUCTURE_AT: &[Quantity] = &[
    part(means("with the neighbours of the pair further off than at even spacing", quantity("critical_gap_deg", "deg", "critical gap", StructureAt(|a| at(a, |s, _| s.critical_gap_rad.to_degrees()))))),
    part(means("steady-state gap less critical gap", high(quantity("margin_deg", "deg", "gap reserve", StructureAt(|a| at(a, |s, steady| (steady - s.critical_gap_rad).to_degrees())))))),
    part(low(quantity("slip_shortfall", "", "sliding lowers the critical gap, fraction of β0", StructureAt(|a| a.evaluation.spacing[a.point].map(|s| s.shortfall).into())))),
    part(low(quantity("pressure_mpa", "MPa", "peak contact pressure at rest, outer raceway", StructureAt(|a| a.evaluation.spacing[a.point].map(|s| s.stress_pa * 1e-6).into())))),
    part(means("by rolling at the contact angle of the load", high(quantity("axial_lag_rolling_fraction", "", "lag left under the largest axial load, by rolling", StructureAt(|a| axial(a, |s| Some(s.rolling_fraction))))))),
    part(means("of the structures on the front, in space", high(quantity("axial_lag_fraction", "", "lag left under the largest axial load", StructureAt(|a| axial(a, AxialSeparation::fraction)))))),
    part(means("in space", high(quantity("axial_lag_deg", "deg", "lag per pass under the largest axial load", StructureAt(|a| axial(a, |s| s.lags_rad.map(|[_, under]| under.to_degrees()))))))),
];

/// Runs of all balls from uneven initial states.
#[rustfmt::skip]
pub const MOTION: &[Quantity] = &[
    part(low(quantity("collisions", "", "collisions per ball and orbit", Motion(|(m, _)| some(m.collisions))))),
    part(low(quantity("collisions_late", "", "collisions per ball and orbit in steady state", Motion(|(m, _)| some(m.collisions_late))))),
    part(low(means(DOUBLE_COLLISIONS, quantity("double_collision_fraction", "", "passages with a double collision", Motion(|(m, _)| some(m.double_collision_fraction)))))),
    part(low(quantity("impulse_mn_s", "mN s", "impulse between balls per ball and orbit", Motion(|(m, _)| some(m.impulse_n_s * 1e3))))),
    part(means("standard deviation of the gaps on arrival over the steady-state gap", low(quantity("spacing_scatter", "", "spacing scatter on arrival", Motion(|(m, steady)| some(m.gap_deviation_rad / steady)))))),
    part(high(quantity("gap_min_deg", "deg", "smallest gap on arrival", Motion(|(m, _)| degrees(m.gap_min_rad))))),
    part(means("largest in a passage, mean over the passages", low(quantity("sliding_m_s", "m/s", "sliding speed", Motion(|(m, _)| some(m.sliding_m_s)))))),
    part(high(means("1 for a ball that rolls, less for one that slides", quantity("speed_drop_fraction", "", "speed reduction achieved, share of rolling", Motion(|(m, _)| some(m.speed_drop_fraction)))))),
    part(means(LAG_FRACTION, high(quantity("lag_fraction", "", "lag of the row and raceway with the least, share of rolling", Motion(|(m, _)| some(m.lag_fraction)))))),
    part(means("standard deviation of the force of the balls on the outer ring", low(quantity("force_deviation_n", "N", "vibration", Motion(|(m, _)| some(m.force_deviation_n)))))),
    part(low(quantity("friction_w", "W", "power of sliding friction, whole run", Motion(|(m, _)| some(m.friction_w))))),
    part(low(means("of the oil film, with `film.hysteresis` also of the steel; with `[film]`", quantity("rolling_resistance_w", "W", "power of rolling resistance, whole run", Motion(|(m, _)| (m.rolling_resistance_w != 0.0).then_some(m.rolling_resistance_w).into()))))),
];

/// Structures that a requirement excludes.
#[rustfmt::skip]
pub const REJECTION: &[Quantity] = &[
    part(in_tables(text("reason", "requirement", Rejection(|r| Cell::Text(r.kind.name.to_owned()))))),
    part(in_tables(text("meaning", "meaning", Rejection(|r| Cell::Text(r.kind.meaning.to_owned()))))),
    part(integer("count", "structures", Rejection(|r| count(r.count)))),
];

/// Angular positions, shapes and contact angles of the raceways that are tried.
#[rustfmt::skip]
pub const PLACEMENT: &[Quantity] = &[
    part(quantity("centre_angles_deg", "deg", "angular positions ψ", Placement(|p| angles(p.centres_rad)))),
    part(in_tables(text("shape", "shape", Placement(|p| Cell::Text(p.form.shape.name().to_owned()))))),
    part(quantity("contact_angle_deg", "deg", "contact angle of the raceway", Placement(|p| millionths(p.section_angle_rad.to_degrees())))),
    part(integer("structures", "structures evaluated", Placement(|p| count(p.evaluations.len())))),
    part(high(integer("accepted", "acceptable structures", Placement(|p| count(p.evaluations.iter().filter(|e| e.objectives.is_some()).count()))))),
    part(low(quantity("least_shortfall", "", "sliding lowers the critical gap by at least, fraction of β0", Placement(least_shortfall)))),
];

/// Critical gaps and verdicts over lC (columns) and θ (rows).
#[rustfmt::skip]
pub const MAP: &[Quantity] = &[
    part(list("axial_span_mm", "mm", "axial span lC of the columns", Map(|m| Cell::Numbers(m.axial_span_m.iter().map(|s| s * 1e3).collect())))),
    part(list("half_angle_deg", "deg", "half angle θ of the rows", Map(|m| Cell::Numbers(m.half_angle_rad.iter().map(|a| (a.to_degrees() * 1e6).round() / 1e6).collect())))),
    file_only(quantity("critical_gap_deg", "deg", "critical gap of each cell", Map(|m| grid(m, |c| c.spacing.map(|s| s.critical_gap_rad.to_degrees()).into())))),
    file_only(quantity("steady_gap_deg", "deg", "steady-state gap of each cell", Map(|m| grid(m, |c| c.forms.map(|f| f.steady_gap_rad.to_degrees()).into())))),
    file_only(text("verdict", "`smooth`, or the requirement that each cell misses", Map(|m| grid(m, |c| Cell::Text(c.cause.as_ref().map_or("smooth", Cause::name).to_owned()))))),
    file_only(high(flag("passes", "whether each cell passes", Map(|m| grid(m, |c| flagged(Some(c.cause.is_none()))))))),
];

/// A structure of the paper for this bearing.
#[rustfmt::skip]
pub const PAPER: &[Quantity] = &[
    part(text("letter", "letter in Fig. 8 of Zhao 2022", Paper(|p| Cell::Text(p.0.clone())))),
    part(quantity("axial_span_mm", "mm", "axial span lC", Paper(|p| some(p.1[0])))),
    part(quantity("half_angle_deg", "deg", "half angle θ", Paper(|p| some(p.1[1])))),
];

fn status(evaluation: &Evaluation) -> &'static str {
    match (&evaluation.rejection, &evaluation.objectives) {
        (Some(_), _) => "rejected",
        (None, Some(_)) => "accepted",
        (None, None) => "left out",
    }
}

fn millionths(value: f64) -> Cell {
    some((value * 1e6).round() / 1e6)
}

fn angles(angles_rad: &[f64]) -> Cell {
    Cell::List(
        angles_rad
            .iter()
            .map(|a| millionths(a.to_degrees()))
            .collect(),
    )
}

fn at(at: &AtPoint<'_>, of: fn(&PairSeparation, f64) -> f64) -> Cell {
    let steady = at.evaluation.forms.map_or(f64::NAN, |f| f.steady_gap_rad);
    at.evaluation.spacing[at.point]
        .map(|s| of(&s, steady))
        .into()
}

/// An angle of the closed forms of a structure.
fn closed_deg(evaluation: &Evaluation, angle_rad: fn(&ClosedForms) -> f64) -> Cell {
    let forms = evaluation.forms.as_ref();
    forms.map(|forms| angle_rad(forms).to_degrees()).into()
}

/// Value under the largest axial load, where there is one.
fn axial(at: &AtPoint<'_>, left: fn(&AxialSeparation) -> Option<f64>) -> Cell {
    let separation = at.evaluation.axial.get(at.point);
    separation.and_then(left).into()
}

fn grid(map: &SpeedMap, of: fn(&MapCell) -> Cell) -> Cell {
    let rows = map.cells.chunks(map.axial_span_m.len());
    Cell::List(
        rows.map(|row| Cell::List(row.iter().map(of).collect()))
            .collect(),
    )
}

/// Smallest fraction by which sliding lowers the critical gap, over the structures that have one at every
/// operating point; each structure enters with its worst point.
fn least_shortfall(placement: &SearchedPlacement<'_>) -> Cell {
    let worst = placement.evaluations.iter().filter_map(|e| {
        let all: Option<Vec<f64>> = e.spacing.iter().map(|s| s.map(|s| s.shortfall)).collect();
        all?.into_iter().reduce(f64::max)
    });
    worst.reduce(f64::min).into()
}
