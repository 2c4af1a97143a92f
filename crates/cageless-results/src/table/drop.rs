//! Results of a drop.

use crate::Across::{Largest, LargestOfAll, Same, Smallest, Sum, WorstState};
use crate::across::Across;
use crate::cell::Cell;
use crate::declare::*;
use crate::kind::Kind;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::{Drop, Plane, RotorDrop};
use crate::{DropJudgement, FinishedDrop};

/// Results of a drop onto one bearing.
#[rustfmt::skip]
pub const DROP: &[Quantity] = &[
    means("`pass`, `fail` or `not-judged`", across(Across::Verdict, text("verdict", "verdict", Drop(|d| judged(d, Kind::Text))))),
    across(Across::Verdict, high(flag("passes", "passes", Drop(|d| judged(d, Kind::Flag))))),
    file_only(text("headline", "verdict with its reason", Drop(|d| Cell::Text(DropJudgement::of_drop(d).headline())))),
    file_only(text("end_state_text", "state at the end in words", Drop(|d| Cell::Text(d.summary.end_state.text().to_owned())))),
    means("`at-rest`, `pendulum`, `bouncing`, `settling`, `forward-whirl`, `backward-whirl` or `falling`", across(WorstState, text("end_state", "state at the end", Drop(|d| Cell::Text(d.summary.end_state.name().to_owned()))))),
    across(Smallest, quantity("first_contact_ms", "ms", "first contact", Drop(|d| d.summary.first_contact_s.map(|t| 1e3 * t).into()))),
    means("contacts of the journal with the inner ring", across(Sum, integer("impacts", "impacts of the rotor", Drop(|d| Cell::Integer(d.summary.impacts as i64))))),
    means("fraction of the time after the first contact in which the journal touches the inner ring", across(Largest, quantity("contact_fraction", "", "time in contact after the first, fraction", Drop(|d| some(d.summary.contact_fraction))))),
    across(Largest, low(quantity("rotor_force_max_n", "N", "largest force on the rotor", Drop(|d| some(d.summary.rotor_force_max_n))))),
    across(Largest, low(quantity("rotor_force_max_over_weight", "", "largest force on the rotor / its weight", Drop(|d| weights(d, Some(d.summary.rotor_force_max_n)))))),
    across(Largest, low(quantity("housing_force_max_n", "N", "largest force on the housing", Drop(|d| d.summary.housing_force_max_n.into())))),
    across(Largest, low(quantity("housing_force_max_over_weight", "", "largest force on the housing / rotor's weight", Drop(|d| weights(d, d.summary.housing_force_max_n))))),
    across(Largest, low(quantity("rotor_displacement_max_um", "um", "largest displacement of the journal from the stator centre", Drop(|d| some(1e6 * d.summary.rotor_displacement_max_m))))),
    means("`rotor.clearance_limit_um` less the largest displacement", across(Smallest, high(quantity("clearance_margin_um", "um", "margin of the journal to its clearance", Drop(clearance_margin))))),
    across(Largest, quantity("housing_displacement_max_um", "um", "largest displacement of the outer ring", Drop(|d| some(1e6 * d.summary.housing_displacement_max_m)))),
    across(Largest, quantity("rotor_sliding_max_m_s", "m/s", "largest sliding speed of the rotor", Drop(|d| some(d.summary.rotor_sliding_max_m_s)))),
    means("time from the start of the drop until the sliding between journal and inner ring falls below 1 % of that at the first contact", across(LargestOfAll, low(quantity("spin_up_ms", "ms", "spin-up of the inner ring", Drop(|d| d.summary.spin_up_s.map(|t| 1e3 * t).into()))))),
    quantity("ring_speed_rpm", "rpm", "inner ring at the end", Drop(|d| some(rpm(d.summary.ring_speed_rad_s)))),
    across(Same, quantity("rotor_speed_rpm", "rpm", "rotor at the end", Drop(|d| some(rpm(d.summary.rotor_speed_rad_s))))),
    across(Largest, low(quantity("backward_whirl_max_hz", "Hz", "largest backward speed of the journal (whirl or swing)", Drop(|d| some(d.summary.backward_whirl_max_hz))))),
    across(Largest, low(quantity("backward_whirl_hz", "Hz", "backward whirl round the bore", Drop(|d| d.summary.backward_whirl_hz.into())))),
    means(HERTZ_PRESSURE, across(Largest, low(quantity("inner_pressure_max_mpa", "MPa", "peak contact pressure, inner raceway", Drop(|d| some(1e-6 * d.summary.inner_pressure_max_pa)))))),
    means(HERTZ_PRESSURE, across(Largest, low(quantity("outer_pressure_max_mpa", "MPa", "peak contact pressure, outer raceway", Drop(|d| some(1e-6 * d.summary.outer_pressure_max_pa)))))),
    means(HERTZ_PRESSURE, across(Largest, low(quantity("ball_pressure_max_mpa", "MPa", "peak contact pressure, ball on ball", Drop(|d| some(1e-6 * d.summary.ball_pressure_max_pa)))))),
    means(COLLISIONS, across(Sum, low(integer("collisions", "collisions between balls", Drop(|d| Cell::Integer(d.summary.collisions.all as i64)))))),
    means(ABOVE_0_1, across(Sum, low(integer("collisions_above_0_1_m_s", "  collisions above 0.1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[0] as i64)))))),
    means(ABOVE_0_5, across(Sum, low(integer("collisions_above_0_5_m_s", "  collisions above 0.5 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[1] as i64)))))),
    means(ABOVE_1, across(Sum, low(integer("collisions_above_1_m_s", "  collisions above 1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[2] as i64)))))),
    means("mean over the last fifth of the time after the first contact", across(Sum, low(quantity("end_collision_rate_hz", "Hz", "collisions between balls per second, at the end", Drop(|d| d.summary.end_collision_rate_hz.into()))))),
    across(Sum, low(quantity("end_collision_rate_above_0_1_m_s_hz", "Hz", "  collisions above 0.1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[0].into())))),
    across(Sum, low(quantity("end_collision_rate_above_0_5_m_s_hz", "Hz", "  collisions above 0.5 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[1].into())))),
    across(Sum, low(quantity("end_collision_rate_above_1_m_s_hz", "Hz", "  collisions above 1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[2].into())))),
    across(Largest, quantity("ball_force_max_n", "N", "largest force between balls", Drop(|d| some(d.summary.ball_force_max_n)))),
    across(Largest, low(quantity("ball_sliding_max_m_s", "m/s", "largest sliding speed of a ball", Drop(|d| some(d.summary.ball_sliding_max_m_s))))),
    means("heat of friction and damping at all contacts and the support", across(Sum, low(quantity("dissipated_j", "J", "heat of all interfaces", Drop(|d| some(d.summary.heat.total_j())))))),
    means("heat of friction at both raceways and between balls", across(Sum, low(quantity("ball_friction_total_j", "J", "heat of friction at the balls", Drop(|d| some(d.summary.heat.balls_j())))))),
    across(Sum, quantity("rotor_friction_j", "J", "  friction between rotor and inner ring", Drop(|d| some(d.summary.heat.rotor_friction_j)))),
    across(Sum, quantity("rotor_damping_j", "J", "  damping between rotor and inner ring", Drop(|d| some(d.summary.heat.rotor_damping_j)))),
    across(Sum, quantity("inner_friction_j", "J", "  friction at the inner raceway", Drop(|d| some(d.summary.heat.inner_friction_j)))),
    across(Sum, quantity("outer_friction_j", "J", "  friction at the outer raceway", Drop(|d| some(d.summary.heat.outer_friction_j)))),
    across(Sum, quantity("ball_friction_j", "J", "  friction between balls", Drop(|d| some(d.summary.heat.ball_friction_j)))),
    across(Sum, quantity("contact_damping_j", "J", "  damping of the balls' contacts", Drop(|d| some(d.summary.heat.contact_damping_j)))),
    across(Sum, quantity("support_damping_j", "J", "  damping of the support", Drop(|d| some(d.summary.heat.support_damping_j)))),
    list("inner_force_max_of_ball_n", "N", "largest force of each ball at the inner raceway", Drop(|d| Cell::Numbers(d.summary.inner_force_max_n.clone()))),
    list("outer_force_max_of_ball_n", "N", "largest force of each ball at the outer raceway", Drop(|d| Cell::Numbers(d.summary.outer_force_max_n.clone()))),
    means(ENERGY_RESIDUAL, across(Largest, quantity("energy_residual_relative", "", "energy balance error (relative)", Drop(|d| some(d.outcome.energy_residual_relative))))),
    means(SIMULATED, across(Same, quantity("simulated_s", "s", "simulated", Drop(|d| some(d.outcome.end_s))))),
];

/// Results of a drop onto several bearings that belong to none of them.
#[rustfmt::skip]
pub const ROTOR_DROP: &[Quantity] = &[
    means("clearance less the largest displacement, the smallest of all `[[clearance]]` planes", high(quantity("plane_margin_min_um", "um", "smallest margin of the planes of the rotor to their clearances", RotorDrop(|d| d.planes.iter().map(|p| 1e6 * (p.clearance.radial_m - p.displacement_max_m)).reduce(f64::min).into())))),
    quantity("rotor_energy_residual_relative", "", "energy balance error of the rotor alone (relative)", RotorDrop(|d| some(d.energy_residual_relative))),
];

/// A plane of a rotor against its clearance to the stator.
#[rustfmt::skip]
pub const PLANE: &[Quantity] = &[
    part(in_tables(text("name", "plane", Plane(|p| Cell::Text(p.clearance.name.clone()))))),
    part(quantity("clearance_um", "um", "clearance", Plane(|p| some(1e6 * p.clearance.radial_m)))),
    part(low(quantity("displacement_max_um", "um", "largest displacement from the stator centre", Plane(|p| some(1e6 * p.displacement_max_m))))),
    part(high(means("negative: the rotor touches the stator", quantity("margin_um", "um", "margin", Plane(|p| some(1e6 * p.clearance.radial_m - 1e6 * p.displacement_max_m)))))),
];

fn judged(drop: &FinishedDrop<'_>, kind: Kind) -> Cell {
    DropJudgement::of_drop(drop).cell(kind)
}

fn clearance_margin(drop: &FinishedDrop<'_>) -> Cell {
    let limit_m = drop
        .case
        .rotor
        .as_ref()
        .and_then(|rotor| rotor.clearance_limit_m);
    let margin_m = limit_m.map(|limit_m| limit_m - drop.summary.rotor_displacement_max_m);
    margin_m.map(|margin_m| 1e6 * margin_m).into()
}

/// A force as a multiple of the weight that the bearing carries; nothing where there is none.
fn weights(drop: &FinishedDrop<'_>, force_n: Option<f64>) -> Cell {
    let weight_n = drop
        .summary
        .rotor_weight_n
        .filter(|weight_n| *weight_n > 0.0);
    let weights = force_n.zip(weight_n).map(|(force, weight)| force / weight);
    weights.into()
}
