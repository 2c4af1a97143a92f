//! Results of a design: closed forms, verdict, recommendation.

use std::f64::consts::FRAC_PI_4;

use cageless::Case;
use cageless::closed_forms::{
    ContactAngleEstimate, CurvePoint, Eq11, balls_in_raceway_max, half_angle_for_gap_rad,
    steady_gap_rad, theoretical_gap_rad,
};
use cageless::kinematics::speed_change_max;
use cageless::raceway::{self, axial_span_limit_m};
use cageless_design::{AxialLag, Criterion, FilmEvidence, LagAndAngle, axial_load_keeping};

use crate::cell::Cell;
use crate::declare::*;
use crate::group::Group;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Judged;
use crate::source::Source::{
    Axial, ContactAngle, Curve, Design, Passages, Points, Profile, Raceway, Recommendation, Slot,
    Verdict,
};

/// Closed forms of a design; those of one raceway are of the first.
#[rustfmt::skip]
pub const DESIGN: &[Quantity] = &[
    means("angle at the bearing centre between two balls that touch, Eq. (10)", quantity("epsilon_deg", "deg", "ball angle ε", Design(|c| degrees(c.bearing.ball_angle_rad())))),
    means("360°/N − ε: gap between evenly spaced balls on a conventional ring", quantity("uniform_gap_deg", "deg", "nominal gap", Design(|c| degrees(c.bearing.nominal_gap_rad())))),
    means("up to this lC the contact points stay on the groove", quantity("axial_span_limit_mm", "mm", "largest lC, Eq. (8)", Design(|c| some(axial_span_limit_m(&c.bearing) * 1e3)))),
    means(BETA0, quantity("beta0_deg", "deg", "β0, Eq. (11)", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Published).to_degrees())))),
    means("β0 with the polar angle of the ball centre in place of the angle of the paper", quantity("beta0_polar_deg", "deg", "β0 with the true polar angle", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Polar).to_degrees())))),
    means("half angle at which β0 is the nominal gap, for the axial span of the case", quantity("half_angle_for_span_deg", "deg", "θ by Eq. (11) for the span", Design(half_angle_for_span))),
    means("gap between balls that pass the raceway at equal intervals of time; balls inside the raceway take less of the circle", quantity("steady_gap_deg", "deg", "steady-state gap, outside the raceway", Design(|c| degrees(steady_gap_rad(&c.bearing, &c.raceways))))),
    means("|d ln Ω/dψ| of a ball that rolls; the larger, the more friction it needs", low(quantity("speed_change_max_per_rad", "", "largest change of the orbital speed in the raceway, fraction of it per rad", Design(|c| of_raceway(c, |r| speed_change_max(&c.bearing, r)))))),
    means("floor(2θ/ε) + 1", integer("balls_in_raceway_max", "most balls inside at once", Design(|c| c.raceways.first().map_or(Cell::Null, |r| count(balls_in_raceway_max(&c.bearing, r)))))),
    means("change of slope of the groove at ±θ, 45° up the side of the groove", low(quantity("slope_discontinuity_deg", "deg", "slope discontinuity at the raceway ends (at 45° groove angle)", Design(|c| of_raceway(c, |r| r.slot().map_or_else(|| r.kink_angle_rad(FRAC_PI_4).to_degrees(), |_| f64::NAN)))))),
];

/// Estimates of the lag in the first raceway by contact angle, under axial load or tilt. They are from rolling
/// without sliding, no results of a motion.
#[rustfmt::skip]
pub const CONTACT_ANGLE: &[Quantity] = &[
    means("how far a ball that rolls on both flanks falls behind one on a plain raceway, at the contact angle by which its section is turned; an estimate from kinematics, with the flank angle under the load of the most loaded ball", part(quantity("kinematic_lag_per_pass_deg", "deg", "lag per pass in pure rolling, estimate", ContactAngle(|e| estimated(e, |e| Some(e.lag_rad)))))),
    means("contact angle on the plain raceway, above that by which the section is turned; an estimate from kinematics", part(quantity("contact_angle_three_quarters_deg", "deg", "contact angle that leaves three quarters of the lag, estimate", ContactAngle(|e| estimated(e, |e| e.three_quarters_rad))))),
    means("contact angle on the plain raceway, above that by which the section is turned; an estimate from kinematics", part(quantity("contact_angle_half_deg", "deg", "contact angle that leaves half of the lag, estimate", ContactAngle(|e| estimated(e, |e| e.half_rad))))),
    means("contact angle on the plain raceway, above that by which the section is turned, beyond which a ball is faster in the raceway; an estimate from kinematics", part(quantity("contact_angle_none_deg", "deg", "contact angle that leaves nothing of the lag, estimate", ContactAngle(|e| estimated(e, |e| e.none_rad))))),
];

/// The profile of a measured raceway, the first of the case.
#[rustfmt::skip]
pub const PROFILE: &[Quantity] = &[
    means("of the function that is fitted to the profile", part(quantity("profile_flank_angle_deg", "deg", "flank angle in the middle of the measured raceway", Profile(|p| degrees(p.middle_rad()))))),
    means("the rows of the profile that are farthest from its middle", part(quantity("profile_half_angle_deg", "deg", "half angle θ of the measured raceway", Profile(|p| degrees(p.half_angle_rad()))))),
    means("root mean square over the rows of the profile", part(low(quantity("profile_deviation_deg", "deg", "deviation of the profile from the function that is fitted to it", Profile(|p| degrees(p.deviation_rad[0])))))),
    part(low(quantity("profile_deviation_max_deg", "deg", "largest deviation of a row of the profile", Profile(|p| degrees(p.deviation_rad[1]))))),
];

/// A raceway that is fitted to points of its surface.
#[rustfmt::skip]
pub const GROOVE: &[Quantity] = &[
    means("no where the groove is plain in its place", part(flag("found", "raceway found", Points(|p| flagged(Some(p.deviation.points > 0)))))),
    means("within the half angle of a groove with flanks; on the rounded edges of a slot", part(integer("measured_points", "points of the raceway", Points(|p| count(p.deviation.points))))),
    means("root mean square of their distances from the fitted surface", part(low(quantity("measured_deviation_um", "um", "deviation of the points from the fitted raceway", Points(|p| some(p.deviation.mean_m * 1e6)))))),
    part(low(quantity("measured_deviation_max_um", "um", "largest deviation of a point", Points(|p| some(p.deviation.largest_m * 1e6))))),
    means("how much farther out than on the plain raceway the middle lies than designed, along the normals of its flanks; of a slot how much farther out a ball on both edges sits, along the normals at its contacts", part(quantity("measured_depth_error_um", "um", "depth error", Points(|p| some(p.depth_error_m * 1e6))))),
];

/// A slot that is fitted to points of its edges.
#[rustfmt::skip]
pub const SLOT: &[Quantity] = &[
    part(quantity("edge_radius_mm", "mm", "radius of the rounded edges", Slot(|s| some(s.edge_radius_m.value * 1e3)))),
    means("largest axial distance between the contact points of a ball on both edges", part(quantity("axial_span_mm", "mm", "axial span lC", Slot(|s| some(s.axial_span_m.value * 1e3))))),
    part(quantity("slot_width_mm", "mm", "width between the walls below the edges", Slot(|s| some(s.width_m * 1e3)))),
    part(quantity("half_angle_deg", "deg", "half angle θ", Slot(|s| degrees(s.half_angle_rad.value)))),
    part(quantity("centre_angle_deg", "deg", "angular position ψ of the middle", Slot(|s| degrees(s.centre_angle_rad.value)))),
    means("median of the points of the floor below the bottom of the groove of the case; none with fewer than 10", part(quantity("slot_depth_mm", "mm", "depth of the floor", Slot(|s| s.slot_depth_m.map(|depth| depth * 1e3).into())))),
];

/// Lag under axial load and tilt, by motion in space; lists are over pairs of both.
#[rustfmt::skip]
pub const AXIAL: &[Quantity] = &[
    means(KEEPS, part(high(quantity("axial_load_three_quarters_n", "N", "axial load that leaves three quarters of the lag", Axial(|l| axial_load_keeping(l, 0.75).load_n().into()))))),
    means(KEEPS, part(high(quantity("axial_load_half_n", "N", "axial load that leaves half of the lag", Axial(|l| axial_load_keeping(l, 0.5).load_n().into()))))),
    means(KEEPS, part(high(quantity("axial_load_none_n", "N", "axial load that leaves nothing of the lag", Axial(|l| axial_load_keeping(l, 0.0).load_n().into()))))),
    part(list("axial_load_n", "N", "axial load", Axial(|l| Cell::Numbers(l.iter().map(|at| at.axial_load_n).collect())))),
    part(list("tilt_x_mrad", "mrad", "tilt about the horizontal axis", Axial(|l| Cell::Numbers(l.iter().map(|at| at.tilt_x_rad * 1e3).collect())))),
    means(LAG, part(list("lag_per_pass_deg", "deg", "lag of a ball per pass of the raceway, mean", Axial(|l| lags(l, |found| found.lag_rad))))),
    means("nothing where a contact leaves its groove or the run stops", part(list("inner_contact_angle_mean_deg", "deg", "contact angle at the inner raceway, mean", Axial(|l| lags(l, |found| found.inner_contact_angle_rad))))),
    means("of the first raceway, by runs of pairs in space; nothing where the gap of a pair never closes or always does, or the run stops", part(list("critical_gap_deg", "deg", "critical gap", Axial(|l| Cell::Numbers(l.iter().map(|at| match at.critical_gap_rad { Some(Ok(gap_rad)) => gap_rad.to_degrees(), _ => f64::NAN }).collect()))))),
];

/// Verdict on the raceways of a case: the critical gap is the largest, the verdict the worst of all.
#[rustfmt::skip]
pub const VERDICT: &[Quantity] = &[
    means(VERDICT_NAMES, text("verdict", "verdict", Verdict(|j| Cell::Text(j.judgement.verdict.name().to_owned())))),
    high(flag("passes", "passes", Verdict(|j| flagged(j.judgement.passes())))),
    file_only(text("headline", "verdict with its reason", Verdict(|j| Cell::Text(j.judgement.headline())))),
    means(CRITERION, text("criterion", "criterion that decides", Verdict(|j| j.judgement.deciding.map_or(Cell::Null, |c| Cell::Text(c.name().to_owned()))))),
    means(MARGIN, high(quantity("margin", "", "margin to the nearest limit", Verdict(|j| j.judgement.deciding.map(Criterion::margin).into())))),
    means(CRITICAL_GAP, quantity("critical_gap_deg", "deg", "critical gap", Verdict(|j| j.judgement.critical_gap_rad.map(f64::to_degrees).into()))),
    means(JUDGED_GAP, quantity("judged_steady_gap_deg", "deg", "steady-state gap of the verdict", Verdict(|j| j.judgement.steady_gap_rad.map(f64::to_degrees).into()))),
    means("largest Hertz pressure at both raceways in static equilibrium, over eight places of the balls within their spacing; ISO 76 allows 4200 MPa", low(quantity("pressure_at_rest_mpa", "MPa", "peak contact pressure at rest", Verdict(|j| j.judgement.pressure_at_rest_pa.map(|pa| pa * 1e-6).into())))),
    means("steady-state gap less critical gap; on elastic flanks and in space the steady-state gap has the lag of the motion in the place of that of rolling", high(quantity("gap_reserve_deg", "deg", "gap reserve", Verdict(|j| j.judgement.steady_gap_rad.zip(j.judgement.critical_gap_rad).map(|(steady, gap)| (steady - gap).to_degrees()).into())))),
];

/// Further results of a verdict with an oil film.
#[rustfmt::skip]
pub const FILM_VERDICT: &[Quantity] = &[
    group(Group::Film, means("over the half orbit away from the load, less that of the run without oil; part of the steady-state gap", in_oil(quantity("film_lag_per_turn_deg", "deg", "lag of a ball by the film per orbit, in motion", Verdict(|j| film(j, |f| f.lag_rad.to_degrees())))))),
    group(Group::Film, means("2/π times that lag; balls queue from some 1.3 times `free_share` on, never below 1.1", in_oil(quantity("film_speed_deficit_fraction", "", "share d of its speed that a ball loses by the film, in motion", Verdict(|j| film(j, |f| f.speed_deficit)))))),
    group(Group::Film, means("0.85 d 360°/N, behind a ball that enters the load zone; above 0.65 of the critical gap oil spaces the balls more than the raceway", in_oil(quantity("film_opening_gap_deg", "deg", "gap that the film opens, in motion", Verdict(|j| film(j, |f| f.opening_gap_rad.to_degrees())))))),
    group(Group::Film, means("of the pitch circle, 1 − N ε/360°", part(quantity("free_share", "", "share that balls leave free", Verdict(|j| film(j, |f| f.free_share)))))),
    means("outside the raceways, with the lag of the film", in_oil(quantity("film_steady_gap_deg", "deg", "steady-state gap with the film", Verdict(|j| j.judgement.steady_gap_rad.map(f64::to_degrees).into())))),
    means(VERDICT_NAMES, in_oil(text("dry_verdict", "verdict without oil", Verdict(|j| j.judgement.dry.as_ref().map_or(Cell::Null, |dry| Cell::Text(dry.verdict.name().to_owned())))))),
    in_oil(high(flag("dry_passes", "passes without oil", Verdict(|j| flagged(j.judgement.dry.as_ref().and_then(|dry| dry.passes())))))),
    file_only(text("dry_headline", "verdict with its reason, without oil", Verdict(|j| j.judgement.dry.as_ref().map_or(Cell::Null, |dry| Cell::Text(dry.headline()))))),
];

/// Passages of balls in the runs of a verdict.
#[rustfmt::skip]
pub const PASSAGES: &[Quantity] = &[
    integer("passages", "passages", Passages(|p| count(p.passages))),
    means("contacts of a ball with its neighbours during one passage of the raceway", low(quantity("collisions_mean", "", "contacts with neighbours per passage, mean", Passages(|p| some(p.collisions_mean))))),
    means(DOUBLE_COLLISIONS, low(quantity("double_collision_fraction", "", "passages with a double collision", Passages(|p| some(p.double_collision_fraction))))),
    means("the largest sliding speed of a ball in each passage, averaged over the passages", low(quantity("sliding_mean_m_s", "m/s", "largest sliding speed in a passage, mean", Passages(|p| some(p.sliding_mean_m_s))))),
    means("1 for a ball that rolls, less for one that slides", high(quantity("speed_drop_fraction", "", "speed reduction achieved, share of rolling", Passages(|p| some(p.speed_drop_fraction))))),
    means(LAG, high(quantity("lag_per_pass_deg", "deg", "lag of a ball per pass of the raceway, mean", Passages(|p| degrees(p.lag_mean_rad))))),
    high(quantity("gap_leave_min_deg", "deg", "smallest gap on leaving", Passages(|p| some(p.gap_leave_min_rad.to_degrees())))),
    quantity("gap_leave_max_deg", "deg", "largest gap on leaving", Passages(|p| some(p.gap_leave_max_rad.to_degrees()))),
];

/// One of the raceways of a case.
#[rustfmt::skip]
pub const RACEWAY: &[Quantity] = &[
    part(quantity("axial_span_mm", "mm", "axial span lC", Raceway(|r| some(r.raceway.dimensions().axial_span_m * 1e3)))),
    part(quantity("half_angle_deg", "deg", "half angle θ", Raceway(|r| degrees(r.raceway.half_angle_rad())))),
    part(quantity("centre_angle_deg", "deg", "angular position ψ of the middle", Raceway(|r| degrees(r.raceway.dimensions().centre_angle_rad)))),
    means(BETA0, part(quantity("beta0_deg", "deg", "β0, Eq. (11)", Raceway(|r| degrees(theoretical_gap_rad(&r.case.bearing, r.raceway, Eq11::Published)))))),
    means(CRITICAL_GAP, part(quantity("critical_gap_deg", "deg", "critical gap", Raceway(|r| r.judgement.critical_gap_rad.map(f64::to_degrees).into())))),
    means(VERDICT_NAMES, part(text("verdict", "verdict", Raceway(|r| Cell::Text(r.judgement.verdict.name().to_owned()))))),
    part(high(flag("passes", "passes", Raceway(|r| flagged(r.judgement.verdict.passes()))))),
];

/// A raceway near the curve of Eq. (11): recommended if it passes its verdict, else only a starting point.
#[rustfmt::skip]
pub(crate) const RECOMMENDATION: &[Quantity] = &[
    part(quantity("half_angle_min_deg", "deg", "smallest usable half angle θ on the curve of Eq. (11)", Recommendation(|r| degrees(r.starting_point.half_angle_min_rad)))),
    part(quantity("half_angle_max_deg", "deg", "largest usable half angle θ on the curve of Eq. (11)", Recommendation(|r| degrees(r.starting_point.half_angle_max_rad)))),
    part(quantity("half_angle_deg", "deg", "half angle θ as judged", Recommendation(|r| thousandths(r.dimensions.half_angle_rad.to_degrees())))),
    part(quantity("axial_span_mm", "mm", "axial span lC as judged", Recommendation(|r| thousandths(r.dimensions.axial_span_m * 1e3)))),
    part(high(flag("passes", "passes", Recommendation(|r| flagged(r.judgement.passes()))))),
    means(VERDICT_NAMES, part(text("verdict", "verdict", Recommendation(|r| Cell::Text(r.judgement.verdict.name().to_owned()))))),
    part(text("headline", "verdict with its reason", Recommendation(|r| Cell::Text(r.judgement.headline())))),
    means(CRITICAL_GAP, part(quantity("critical_gap_deg", "deg", "critical gap", Recommendation(|r| r.judgement.critical_gap_rad.map(f64::to_degrees).into())))),
    part(integer("judged", "raceways judged", Recommendation(|r| count(r.judged)))),
    part(quantity("starting_half_angle_deg", "deg", "half angle θ of the starting point on the curve of Eq. (11)", Recommendation(|r| thousandths(r.starting_point.half_angle_rad.to_degrees())))),
    part(quantity("starting_axial_span_mm", "mm", "axial span lC of the starting point on the curve of Eq. (11)", Recommendation(|r| thousandths(r.starting_point.axial_span_m * 1e3)))),
];

/// The lC–θ curve of Zhao 2022, Fig. 5.
#[rustfmt::skip]
pub(crate) const CURVE: &[Quantity] = &[
    part(list("axial_span_mm", "mm", "axial span lC", Curve(|c| Cell::Numbers(c.iter().map(|p| p.axial_span_m * 1e3).collect())))),
    part(list("half_angle_deg", "deg", "half angle θ by Eq. (11)", Curve(|c| angles(c, |p| p.half_angle_rad)))),
    part(list("half_angle_polar_deg", "deg", "half angle θ by Eq. (11) with the true polar angle", Curve(|c| angles(c, |p| p.half_angle_polar_rad)))),
];

/// A number of the film of a verdict.
fn film(judged: &Judged<'_>, value: impl Fn(&FilmEvidence) -> f64) -> Cell {
    judged.judgement.film.as_ref().map(value).into()
}

fn estimated(
    estimate: &Option<ContactAngleEstimate>,
    angle_rad: impl Fn(&ContactAngleEstimate) -> Option<f64>,
) -> Cell {
    let angle = estimate.as_ref().and_then(angle_rad);
    angle.map(f64::to_degrees).into()
}

fn lags(lags: &[AxialLag], angle_rad: fn(&LagAndAngle) -> f64) -> Cell {
    let angle = |at: &AxialLag| at.lag.as_ref().map_or(f64::NAN, angle_rad).to_degrees();
    Cell::Numbers(lags.iter().map(angle).collect())
}

fn of_raceway(case: &Case, value: impl Fn(&raceway::Raceway) -> f64) -> Cell {
    case.raceways.first().map(value).into()
}

/// θ by Eq. (11) for the case's own span and the gap of evenly spaced balls.
fn half_angle_for_span(case: &Case) -> Cell {
    let bearing = &case.bearing;
    let angle = case.raceways.first().and_then(|raceway| {
        let span = raceway.dimensions().axial_span_m;
        half_angle_for_gap_rad(
            bearing,
            raceway.form(),
            span,
            bearing.nominal_gap_rad(),
            Eq11::Published,
        )
    });
    angle.map(f64::to_degrees).into()
}

/// A number as judged and printed; the conversion to SI leaves rounding.
fn thousandths(value: f64) -> Cell {
    some((value * 1e3).round() / 1e3)
}

fn angles(curve: &[CurvePoint], angle_rad: fn(&CurvePoint) -> Option<f64>) -> Cell {
    let angles = curve.iter().map(angle_rad);
    Cell::Numbers(
        angles
            .map(|a| a.map_or(f64::NAN, f64::to_degrees))
            .collect(),
    )
}
