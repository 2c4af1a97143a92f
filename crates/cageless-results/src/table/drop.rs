//! Results of a drop.

use cageless::Case;
use cageless::rating::rolling_torque_n_m;
use cageless::touchdown::{EndPower, EndState, InterfaceHeat};
use cageless::unloaded_equilibrium;

use crate::Across::{Largest, LargestOfAll, Same, Smallest, Sum, WorstState};
use crate::FinishedDrop;
use crate::across::Across;
use crate::cell::Cell;
use crate::declare::*;
use crate::group::Group;
use crate::kind::Kind;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::{Drop, Plane, RotorDrop, Succession};
use crate::unit::rpm;

/// Results of a drop onto one bearing.
#[rustfmt::skip]
pub const DROP: &[Quantity] = &[
    means("`pass`, `fail` or `not-judged`", across(Across::Verdict, text("verdict", "verdict", Drop(|d| judged(d, Kind::Text))))),
    across(Across::Verdict, high(flag("passes", "passes", Drop(|d| judged(d, Kind::Flag))))),
    file_only(text("headline", "verdict with its reason", Drop(|d| Cell::Text(d.judgement.headline())))),
    file_only(text("end_state_text", "state at the end in words", Drop(|d| Cell::Text(d.summary.end_state.text().to_owned())))),
    means("`at-rest`, `pendulum`, `bouncing`, `settling`, `forward-whirl`, `backward-whirl` or `falling`", across(WorstState, text("end_state", "state at the end", Drop(|d| Cell::Text(d.summary.end_state.name().to_owned()))))),
    group(Group::Rotor, awaited(across(Smallest, quantity("first_contact_ms", "ms", "first contact", Drop(|d| d.summary.first_contact_s.map(milliseconds).into()))))),
    group(Group::Rotor, means("contacts of the rotor, by its journal or a shoulder, with the inner ring", across(Sum, integer("impacts", "impacts of the rotor", Drop(|d| Cell::Integer(d.summary.impacts as i64)))))),
    group(Group::Rotor, means("fraction of the time after the first contact in which the rotor touches the inner ring", across(Largest, quantity("contact_fraction", "", "time in contact after the first, share", Drop(|d| some(d.summary.contact_fraction)))))),
    group(Group::Forces, across(Largest, low(quantity("rotor_force_max_n", "N", "largest force on the rotor", Drop(|d| some(d.summary.rotor_force_max_n)))))),
    group(Group::Forces, across(Largest, low(quantity("rotor_force_max_over_weight", "", "largest force on the rotor / its weight", Drop(|d| weights(d, Some(d.summary.rotor_force_max_n))))))),
    group(Group::Forces, unless_zero(means("between a shoulder and the face of the inner ring; of a rotor with an axial touch-down clearance", across(Largest, low(quantity("shoulder_force_max_n", "N", "  largest axial force of a shoulder", Drop(|d| d.summary.shoulder_force_max_n.into()))))))),
    group(Group::Forces, across(Largest, low(quantity("housing_force_max_n", "N", "largest force on the housing", Drop(|d| d.summary.housing_force_max_n.into()))))),
    group(Group::Forces, across(Largest, low(quantity("housing_force_max_over_weight", "", "largest force on the housing / rotor's weight", Drop(|d| weights(d, d.summary.housing_force_max_n)))))),
    group(Group::Rotor, across(Largest, low(quantity("rotor_displacement_max_um", "um", "largest displacement of the journal from the stator centre", Drop(|d| some(1e6 * d.summary.rotor_displacement_max_m)))))),
    group(Group::Rotor, unless_zero(means("in space", across(Largest, low(quantity("rotor_axial_displacement_max_um", "um", "largest displacement of the rotor along the axis", Drop(|d| d.summary.rotor_axial_displacement_max_m.map(|z| 1e6 * z).into()))))))),
    group(Group::Rotor, means("`rotor.clearance_limit_um` less the largest displacement", across(Smallest, high(quantity("clearance_margin_um", "um", "margin of the journal to its clearance", Drop(clearance_margin)))))),
    group(Group::Rotor, unless_zero(across(Largest, quantity("housing_displacement_max_um", "um", "largest displacement of the outer ring", Drop(|d| some(1e6 * d.summary.housing_displacement_max_m)))))),
    group(Group::Rotor, not_in_tables(across(Largest, quantity("rotor_sliding_max_m_s", "m/s", "largest sliding speed of the rotor", Drop(|d| some(d.summary.rotor_sliding_max_m_s)))))),
    group(Group::Rotor, means("time from the start of the drop until the sliding between journal and inner ring falls below 1 % of that at the first contact; that of the first contact with a rotor that does not turn", awaited(across(LargestOfAll, low(quantity("spin_up_ms", "ms", "spin-up of the inner ring", Drop(|d| d.summary.spin_up_s.map(milliseconds).into()))))))),
    group(Group::Rotor, not_in_tables(quantity("ring_speed_rpm", "rpm", "inner ring at the end", Drop(|d| some(rpm(d.summary.ring_speed_rad_s)))))),
    group(Group::Rotor, across(Same, quantity("rotor_speed_rpm", "rpm", "rotor at the end", Drop(|d| some(rpm(d.summary.rotor_speed_rad_s)))))),
    group(Group::Rotor, not_in_tables(across(Largest, low(quantity("backward_whirl_max_hz", "Hz", "largest backward speed of the journal (whirl or swing)", Drop(|d| some(d.summary.backward_whirl_max_hz))))))),
    group(Group::Rotor, means("largest mean over 5 ms of a backward whirl at any time, which fails the drop: the journal runs round the bore against the rotation, once at least in lasting contact (95 % of each 5 ms), or all through the last fifth of the time after the first contact", occurs(across(Largest, low(quantity("backward_whirl_hz", "Hz", "backward whirl round the bore, largest", Drop(|d| d.summary.backward_whirl.map(|whirl| whirl.frequency_max_hz).into()))))))),
    group(Group::Rotor, means("mean over the last fifth of the time after the first contact, or since the whirl began in it, of a rotor that ends in backward whirl", occurs(across(Largest, low(quantity("backward_whirl_end_hz", "Hz", "backward whirl at the end", Drop(backward_whirl_end))))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, across(Largest, low(quantity("inner_pressure_max_mpa", "MPa", "peak contact pressure, inner raceway", Drop(|d| some(1e-6 * d.summary.inner_pressure_max_pa))))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, across(Largest, low(quantity("outer_pressure_max_mpa", "MPa", "peak contact pressure, outer raceway", Drop(|d| some(1e-6 * d.summary.outer_pressure_max_pa))))))),
    group(Group::Pressure, unless_zero(means(HERTZ_PRESSURE, across(Largest, low(quantity("ball_pressure_max_mpa", "MPa", "peak contact pressure, ball on ball", Drop(|d| some(1e-6 * d.summary.ball_pressure_max_pa)))))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, across(Largest, quantity("inner_ellipse_edge_max_deg", "deg", "edge of contact ellipses, inner raceway, largest angle", Drop(|d| d.summary.ellipse_edge_max_rad.map(|edge| edge[0].to_degrees()).into()))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, across(Largest, quantity("outer_ellipse_edge_max_deg", "deg", "edge of contact ellipses, outer raceway, largest angle", Drop(|d| d.summary.ellipse_edge_max_rad.map(|edge| edge[1].to_degrees()).into()))))),
    group(Group::Contacts, means(COLLISIONS, across(Sum, low(integer("collisions", "collisions between balls", Drop(|d| Cell::Integer(d.summary.collisions.all as i64))))))),
    group(Group::Contacts, not_in_tables(means(ABOVE_0_1, across(Sum, low(integer("collisions_above_0_1_m_s", "  collisions above 0.1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[0] as i64)))))))),
    group(Group::Contacts, not_in_tables(means(ABOVE_0_5, across(Sum, low(integer("collisions_above_0_5_m_s", "  collisions above 0.5 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[1] as i64)))))))),
    group(Group::Contacts, unless_zero(means(ABOVE_1, across(Sum, low(integer("collisions_above_1_m_s", "  collisions above 1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[2] as i64)))))))),
    group(Group::Contacts, unless_zero(means("mean over the last fifth of the time after the first contact", across(Sum, low(quantity("end_collision_rate_hz", "Hz", "collisions between balls per second, at the end", Drop(|d| d.summary.end_collision_rate_hz.into()))))))),
    group(Group::Contacts, not_in_tables(across(Sum, low(quantity("end_collision_rate_above_0_1_m_s_hz", "Hz", "  collisions above 0.1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[0].into())))))),
    group(Group::Contacts, not_in_tables(across(Sum, low(quantity("end_collision_rate_above_0_5_m_s_hz", "Hz", "  collisions above 0.5 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[1].into())))))),
    group(Group::Contacts, not_in_tables(across(Sum, low(quantity("end_collision_rate_above_1_m_s_hz", "Hz", "  collisions above 1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[2].into())))))),
    group(Group::Forces, not_in_tables(across(Largest, quantity("ball_force_max_n", "N", "largest force between balls", Drop(|d| some(d.summary.ball_force_max_n)))))),
    group(Group::Heat, across(Largest, low(quantity("ball_sliding_max_m_s", "m/s", "largest sliding speed of a ball", Drop(|d| some(d.summary.ball_sliding_max_m_s)))))),
    group(Group::Heat, means("heat of friction and damping at all contacts and the support", across(Sum, low(quantity("dissipated_j", "J", "heat of all interfaces", Drop(|d| heat(d, InterfaceHeat::total_j))))))),
    group(Group::Heat, not_in_tables(means("heat of friction at both raceways and between balls", across(Sum, low(quantity("ball_friction_total_j", "J", "heat of friction at the balls", Drop(|d| heat(d, InterfaceHeat::balls_j)))))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("rotor_friction_j", "J", "  friction between rotor and inner ring", Drop(|d| heat(d, |h| h.rotor_friction_j)))))),
    group(Group::Heat, not_in_tables(across(Sum, quantity("rotor_damping_j", "J", "  damping between rotor and inner ring", Drop(|d| heat(d, |h| h.rotor_damping_j)))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("inner_friction_j", "J", "  friction at the inner raceway", Drop(|d| heat(d, |h| h.inner_friction_j)))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("outer_friction_j", "J", "  friction at the outer raceway", Drop(|d| heat(d, |h| h.outer_friction_j)))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("ball_friction_j", "J", "  friction between balls", Drop(|d| heat(d, |h| h.ball_friction_j)))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("contact_damping_j", "J", "  damping of the balls' contacts", Drop(|d| heat(d, |h| h.contact_damping_j)))))),
    group(Group::Heat, unless_zero(across(Sum, quantity("support_damping_j", "J", "  damping of the support", Drop(|d| heat(d, |h| h.support_damping_j)))))),
    group(Group::Heat, means("with which a spin-down begins: power of all interfaces over the mean speed of the rotor, in the last fifth of the time after the first contact, and ½ μ P d of SKF at least (μ = 0.0015, P the weight that the bearing carries), as balls that roll lose little in the model; while an inner ring still comes up to speed, the torque that accelerates it brakes the rotor as well; none of a slow rotor, whose rotational energy is less than a hundred times its largest other kinetic energy", across(Sum, quantity("braking_torque_n_m", "N m", "torque of the bearing that brakes the rotor, at the end", Drop(braking_torque))))),
    file_only(across(Largest, means("of the losses alone, from the first to the second half of the last fifth of the time after the first contact", quantity("braking_torque_change_fraction", "", "change of the torque that brakes the rotor", Drop(|d| d.summary.end_power.as_ref().and_then(|p| p.torque_change).into()))))),
    group(Group::Heat, means("mean over the last fifth of the time after the first contact", across(Sum, quantity("end_power_w", "W", "heat of all interfaces per second, at the end", Drop(|d| end(d, |p| p.total_w)))))),
    group(Group::Heat, not_in_tables(means(INTO_PART, across(Sum, quantity("inner_ring_power_w", "W", "  into the inner ring", Drop(|d| end(d, |p| p.parts_w[0]))))))),
    group(Group::Heat, not_in_tables(means(INTO_PART, across(Sum, quantity("ball_power_w", "W", "  into the balls", Drop(|d| end(d, |p| p.parts_w[1]))))))),
    group(Group::Heat, not_in_tables(means(INTO_PART, across(Sum, quantity("outer_ring_power_w", "W", "  into the outer ring", Drop(|d| end(d, |p| p.parts_w[2]))))))),
    group(Group::Temperature, means(ADIABATIC, across(Largest, low(quantity("inner_ring_temperature_c", "C", "temperature of the inner ring at the end", Drop(|d| temperature(d, 0))))))),
    group(Group::Temperature, means(ADIABATIC, across(Largest, low(quantity("ball_temperature_c", "C", "temperature of the balls at the end", Drop(|d| temperature(d, 1))))))),
    group(Group::Temperature, means(ADIABATIC, across(Largest, low(quantity("outer_ring_temperature_c", "C", "temperature of the outer ring at the end", Drop(|d| temperature(d, 2))))))),
    list("inner_force_max_of_ball_n", "N", "largest force of each ball at the inner raceway", Drop(|d| Cell::Numbers(d.summary.inner_force_max_n.clone()))),
    list("outer_force_max_of_ball_n", "N", "largest force of each ball at the outer raceway", Drop(|d| Cell::Numbers(d.summary.outer_force_max_n.clone()))),
    group(Group::Computation, means(ENERGY_RESIDUAL, across(Largest, quantity("energy_residual_relative", "", "energy balance error (relative)", Drop(|d| some(d.outcome.energy_residual_relative)))))),
    group(Group::Computation, means(SIMULATED, across(Same, quantity("simulated_s", "s", "simulated", Drop(|d| some(d.outcome.end_s)))))),
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
    part(in_tables(means("`pass` or `fail`", text("verdict", "verdict", Plane(|p| Cell::Text(if p.displacement_max_m > p.clearance.radial_m { "fail" } else { "pass" }.to_owned())))))),
];

/// One of several drops one after the other, onto one bearing.
#[rustfmt::skip]
pub const SUCCESSION: &[Quantity] = &[
    part(integer("drop", "drop", Succession(|s| count(s.number)))),
    part(integer("bearing", "bearing", Succession(|s| count(s.bearing + 1)))),
    file_only(quantity("inner_ring_start_c", "C", "inner ring at the start", Succession(|s| some(s.particulars.parts_c()[0])))),
    file_only(quantity("ball_start_c", "C", "balls at the start", Succession(|s| some(s.particulars.parts_c()[1])))),
    file_only(quantity("outer_ring_start_c", "C", "outer ring at the start", Succession(|s| some(s.particulars.parts_c()[2])))),
    part(means("at the start of the drop, with the expansion of rings and balls by the heat of the drops before", quantity("radial_internal_clearance_um", "um", "Gr", Succession(|s| some(1e6 * s.case.bearing.radial_internal_clearance_m()))))),
    file_only(means("of the balls of each row on its outer ring, along z, at the start of the drop, before anything loads the bearing: the preload, of which that of held rings changes with the expansion and that of a spring does not; in space", few("row_axial_force_n", "N", "axial force of the rows", Succession(|s| preload_n(s.case))))),
    part(means("at the start of the drop, radial, with the expansion of the inner ring", quantity("touchdown_clearance_um", "um", "touch-down clearance", Succession(|s| s.case.rotor.as_ref().map(|r| 1e6 * r.radial_clearance_m).into())))),
    part(low(quantity("dissipated_j", "J", "heat of all interfaces", Succession(|s| some(s.heat_j))))),
    part(means("time to standstill from the end of the simulated time, braked by `rotor.drive_torque_n_m` and by each bearing with its `braking_torque_n_m`, once every inner ring has come up to speed; 0 of a slow rotor, with the heat of all its rotational energy", quantity("spin_down_s", "s", "spin-down", Succession(|s| s.spin_down_s.into())))),
    part(means("of this bearing", low(quantity("spin_down_heat_j", "J", "heat of the spin-down", Succession(|s| s.spin_down_heat_j.into()))))),
    part(means(STANDSTILL, low(quantity("inner_ring_standstill_c", "C", "inner ring at standstill", Succession(|s| s.standstill_c.map(|c| c[0]).into()))))),
    part(means(STANDSTILL, low(quantity("ball_standstill_c", "C", "balls at standstill", Succession(|s| s.standstill_c.map(|c| c[1]).into()))))),
    part(means(STANDSTILL, low(quantity("outer_ring_standstill_c", "C", "outer ring at standstill", Succession(|s| s.standstill_c.map(|c| c[2]).into()))))),
    part(means("`pass`, `fail` or `not-judged`: that of the drop onto this bearing, with the planes of the rotor, the limits on these rows and the heat", in_tables(text("verdict", "verdict", Succession(|s| Cell::Text(s.judgement.name().to_owned())))))),
];

const INTO_PART: &str = "half of the friction between two bodies, half of the damping of the balls' contacts into the balls and a quarter into each ring; mean over the last fifth of the time after the first contact";
const STANDSTILL: &str = "at standstill of the rotor, all heat of drop and spin-down kept; a part takes as much of the heat of the spin-down as at the end of the drop, of rolling a quarter into each ring and half into the balls";
const ADIABATIC: &str =
    "start and heat of the drop over the heat capacity of the part, none of which is lost";

/// A time in the unit of those of drops.
pub(crate) fn milliseconds(time_s: f64) -> f64 {
    1e3 * time_s
}

/// Axial forces of the rows of an unloaded bearing.
fn preload_n(case: &Case) -> Cell {
    let unloaded = || unloaded_equilibrium(case).ok();
    let found = case.moves_in_space().then(unloaded).flatten();
    found.map_or(Cell::Null, |e| Cell::Numbers(e.row_axial_force_n))
}

fn backward_whirl_end(drop: &FinishedDrop<'_>) -> Cell {
    let s = drop.summary;
    let whirls = s.end_state == EndState::BackwardWhirl;
    whirls.then_some(s.end_whirl_hz.abs()).into()
}

/// Torque with which the bearing brakes a rotor that spins down.
fn braking_torque(drop: &FinishedDrop<'_>) -> Cell {
    let rolling_n_m = || {
        let carried_n = drop.summary.rotor_weight_n.unwrap_or(0.0);
        rolling_torque_n_m(&drop.case.bearing, carried_n)
    };
    let own_n_m = drop.summary.end_power.as_ref().and_then(|p| p.torque_n_m);
    own_n_m.map(|own_n_m| own_n_m.max(rolling_n_m())).into()
}

fn end(drop: &FinishedDrop<'_>, of: fn(&EndPower) -> f64) -> Cell {
    drop.summary.end_power.as_ref().map(of).into()
}

fn heat(drop: &FinishedDrop<'_>, of: fn(&InterfaceHeat) -> f64) -> Cell {
    some(of(&drop.summary.heat))
}

fn temperature(drop: &FinishedDrop<'_>, part: usize) -> Cell {
    let case = drop.case;
    let thermal = &drop.particulars.thermal;
    let capacities = thermal.capacities_j_k(&case.bearing, case.rows.len()).ok();
    let rise_k = capacities.map(|c| drop.summary.heat.of_parts_j()[part] / c[part]);
    rise_k
        .map(|rise_k| drop.particulars.parts_c()[part] + rise_k)
        .into()
}

fn judged(drop: &FinishedDrop<'_>, kind: Kind) -> Cell {
    drop.judgement.cell(kind)
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
