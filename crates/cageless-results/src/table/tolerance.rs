//! Results of a tolerance analysis.

use std::f64::consts::PI;

use cageless_design::tolerance::{Influence as Deviates, Interval};

use crate::cell::Cell;
use crate::declare::*;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::{Influence, Samples, Tolerance, VerdictCount};
use crate::{Deviation, software};

/// Results of the analysis as a whole; the nominal bearing is the one as drawn.
#[rustfmt::skip]
pub const TOLERANCE: &[Quantity] = &[
    part(text("title", "title", Tolerance(|t| Cell::Text(format!("Tolerances: {}", t.particulars.title))))),
    part(text("software", "program and instruction set", Tolerance(|_| Cell::Text(software())))),
    part(integer("ball_grade", "grade of the balls (ISO 3290-1), 0 for equal balls", Tolerance(|t| Cell::Integer(t.ball_grade.into())))),
    part(high(flag("passes", "passes", Tolerance(|t| flagged(t.assessment.passes()))))),
    part(text("headline", "verdict with its reason", Tolerance(|t| Cell::Text(t.assessment.headline())))),
    part(high(flag("nominal_passes", "nominal bearing passes", Tolerance(|t| flagged(t.assessment.nominal.passes()))))),
    part(means("none of a case without `[film]`", high(flag("dry_passes", "nominal bearing passes without oil", Tolerance(|t| flagged(t.assessment.nominal.dry.as_ref().and_then(|dry| dry.passes()))))))),
    part(means("none of a case without `[film]`", text("dry_headline", "verdict with its reason on the nominal bearing without oil", Tolerance(|t| t.assessment.nominal.dry.as_ref().map_or(Cell::Null, |dry| Cell::Text(dry.headline.clone())))))),
    part(in_tables(means(VERDICT_NAMES, text("nominal_verdict", "verdict on the nominal bearing", Tolerance(|t| Cell::Text(t.assessment.nominal.verdict.name().to_owned())))))),
    part(means(CRITICAL_GAP, quantity("nominal_critical_gap_deg", "deg", "critical gap, nominal", Tolerance(|t| t.assessment.nominal.critical_gap_rad.map(f64::to_degrees).into())))),
    part(means(JUDGED_GAP, quantity("nominal_judged_steady_gap_deg", "deg", "steady-state gap of the verdict, nominal", Tolerance(|t| t.assessment.nominal.steady_gap_rad.map(f64::to_degrees).into())))),
    part(high(means(LAG_FRACTION, quantity("nominal_lag_fraction", "", "lag of the row and raceway with the least, share of rolling, nominal", Tolerance(|t| t.assessment.nominal.passages.map(|p| p.lag_fraction).into()))))),
    part(low(means(DOUBLE_COLLISIONS, quantity("nominal_double_collision_fraction", "", "passages with a double collision, nominal", Tolerance(|t| t.assessment.nominal.passages.map(|p| p.double_collision_fraction).into()))))),
    part(low(quantity("nominal_sliding_m_s", "m/s", "largest sliding speed in a passage, mean, nominal", Tolerance(|t| t.assessment.nominal.passages.map(|p| p.sliding_mean_m_s).into())))),
    part(quantity("uniform_gap_deg", "deg", "nominal gap", Tolerance(|t| degrees(t.case.bearing.nominal_gap_rad())))),
];

/// One influence that deviates alone, to both ends of its tolerance: ranges are over these bearings and
/// the nominal one.
#[rustfmt::skip]
pub const INFLUENCE: &[Quantity] = &[
    part(in_tables(text("name", "deviates", Influence(|i| Cell::Text(i.result.influence.name().to_owned()))))),
    part(quantity("low", "", "from", Influence(|i| end(i, 0)))),
    part(quantity("high", "", "to", Influence(|i| end(i, 1)))),
    part(in_tables(text("unit", "unit", Influence(|i| Cell::Text(drawn(i.result.influence).1.to_owned()))))),
    part(integer("trials", "bearings", Influence(|i| count(i.result.trials)))),
    part(integer("passed", "pass", Influence(|i| count(i.result.passed)))),
    part(range("critical_gap_deg", "deg", "critical gap", Influence(|i| ends(i.result.critical_gap_rad.map(|r| r.map(f64::to_degrees)))))),
    part(range("lag_fraction", "", "lag, share of rolling", Influence(|i| ends(i.result.lag_fraction)))),
    part(range("double_collision_fraction", "", "passages with a double collision", Influence(|i| ends(i.result.double_collision_fraction)))),
    part(range("sliding_mean_m_s", "m/s", "sliding speed", Influence(|i| ends(i.result.sliding_mean_m_s)))),
];

/// Bearings of the Monte Carlo sample, in which everything deviates.
#[rustfmt::skip]
pub const SAMPLES: &[Quantity] = &[
    part(integer("count", "bearings of the Monte Carlo sample", Samples(|s| count(s.samples.count)))),
    part(integer("seed", "seed", Samples(|s| s.seed.into()))),
    part(integer("passed", "bearings that pass", Samples(|s| count(s.samples.passed)))),
    part(means("none where a run stopped", quantity("pass_probability", "", "probability of passing", Samples(|s| s.samples.pass_probability.into())))),
    part(range("pass_probability_interval", "", "  95 % interval (Wilson)", Samples(|s| ends(Some(s.samples.pass_probability_interval))))),
    part(means("linear between the values of neighbouring ranks; none where a bearing has no critical gap", range("critical_gap_quantiles_deg", "deg", "critical gap, 5 % … 50 % … 95 %", Samples(|s| s.samples.critical_gap_quantiles_rad.map_or(Cell::Null, |q| Cell::Numbers(q.map(f64::to_degrees).to_vec())))))),
    part(text("first_impossible", "reason of the first infeasible bearing", Samples(|s| s.samples.outcomes.iter().filter(|o| !o.is_open()).find_map(|o| o.reason.clone()).map_or(Cell::Null, Cell::Text)))),
];

/// Bearings of the sample with one verdict.
#[rustfmt::skip]
pub const VERDICT_COUNT: &[Quantity] = &[
    part(in_tables(means(VERDICT_NAMES, text("verdict", "verdict", VerdictCount(|v| Cell::Text(v.verdict.name().to_owned())))))),
    part(in_tables(flag("passes", "pass", VerdictCount(|v| flagged(v.verdict.passes()))))),
    part(integer("count", "bearings", VerdictCount(|v| count(v.outcomes.len())))),
    part(list("critical_gap_deg", "deg", "critical gap of each", VerdictCount(|v| Cell::Numbers(v.outcomes.iter().filter_map(|o| o.critical_gap_rad.map(f64::to_degrees)).collect())))),
];

/// Factor from SI and unit of a deviation on the drawing.
fn drawn(influence: Deviates) -> (f64, &'static str) {
    match influence {
        Deviates::GrooveDepth
        | Deviates::AxialSpan
        | Deviates::BallRadius
        | Deviates::Clearance => (1e6, "µm"),
        Deviates::HalfAngle | Deviates::SectionAngle => (1f64.to_degrees(), "°"),
        Deviates::Friction | Deviates::Supply => (1.0, ""),
        Deviates::Viscosity => (1e3, "mPa·s"),
        Deviates::Speed => (30.0 / PI, "rpm"),
        Deviates::Load => (1.0, "N"),
    }
}

fn end(deviation: &Deviation<'_>, k: usize) -> Cell {
    let influence = deviation.result.influence;
    // Not −0.
    some(deviation.tolerances.range(deviation.case, influence)[k] * drawn(influence).0 + 0.0)
}

fn ends(interval: Interval) -> Cell {
    interval.map_or(Cell::Null, |ends| Cell::Numbers(ends.to_vec()))
}
