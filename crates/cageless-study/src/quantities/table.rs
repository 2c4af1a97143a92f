//! Table of the scalar results: every key, column and line of a table, once.

use std::f64::consts::{FRAC_PI_4, TAU};

use cageless::Case;
use cageless::contact_tracker::ContactCounts;
use cageless::design::{
    Criterion, Eq11, Judgement, PassageStatistics, balls_in_raceway_max, half_angle_for_gap_rad,
    steady_gap_rad, theoretical_gap_rad,
};
use cageless::dynamics::energy::EnergyTerm;
use cageless::orbit_means::OrbitMeans;
use cageless::passage::PassageTally;
use cageless::raceway::{Raceway, axial_span_limit_m};
use cageless::rating::{PassingFrequencies, skf_friction_torque_n_m};
use cageless::summary::Summary;
use cageless_io::results::Cell;

use super::Across::{Largest, LargestOfAll, Same, Smallest, Sum, WorstState};
use super::Source::{self, Design, Drop, RotorDrop, Run, Static, Verdict};
use super::{Across, Aim, Finished, FinishedDrop, Kind, Quantity, verdict};
use crate::drop::DropJudgement;

/// All scalar results, in the order of keys, columns and tables.
#[rustfmt::skip]
pub const QUANTITIES: &[Quantity] = &[
    quantity("ring_x_um", "um", "displacement of the inner ring, x", Static(|e| some(e.ring_x_m * 1e6))),
    quantity("ring_y_um", "um", "displacement of the inner ring, y", Static(|e| some(e.ring_y_m * 1e6))),
    quantity("inner_force_max_n", "N", "largest force at the inner raceway", Static(|e| some(largest(&e.inner_force_n)))),
    quantity("outer_force_max_n", "N", "largest force at the outer raceway", Static(|e| some(largest(&e.outer_force_n)))),
    integer("loaded_balls", "balls under load", Static(|e| count(e.inner_force_n.iter().filter(|f| **f > 0.0).count()))),
    quantity("inner_stiffness_n_m1_5", "N/m^1.5", "contact stiffness K, inner raceway", Static(|e| some(e.inner_stiffness_n_m1_5))),
    quantity("outer_stiffness_n_m1_5", "N/m^1.5", "contact stiffness K, outer raceway", Static(|e| some(e.outer_stiffness_n_m1_5))),
    low(quantity("inner_stress_max_gpa", "GPa", "peak contact pressure, inner raceway", Static(|e| some(e.inner_stress_max_pa * 1e-9)))),
    low(quantity("outer_stress_max_gpa", "GPa", "peak contact pressure, outer raceway", Static(|e| some(e.outer_stress_max_pa * 1e-9)))),
    list("ball_angle_deg", "deg", "angle ψ of each ball", Static(|e| Cell::Numbers(e.ball_angle_rad.iter().map(|a| a.to_degrees()).collect()))),
    list("inner_force_n", "N", "force of each ball at the inner raceway", Static(|e| Cell::Numbers(e.inner_force_n.clone()))),
    list("outer_force_n", "N", "force of each ball at the outer raceway", Static(|e| Cell::Numbers(e.outer_force_n.clone()))),

    quantity("epsilon_deg", "deg", "ball angle ε", Design(|c| degrees(c.bearing.ball_angle_rad()))),
    quantity("uniform_gap_deg", "deg", "nominal gap", Design(|c| degrees(c.bearing.nominal_gap_rad()))),
    quantity("axial_span_limit_mm", "mm", "largest lC, Eq. (8)", Design(|c| some(axial_span_limit_m(&c.bearing) * 1e3))),
    quantity("beta0_deg", "deg", "β0, Eq. (11)", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Published).to_degrees()))),
    quantity("beta0_polar_deg", "deg", "β0 with the true polar angle", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Polar).to_degrees()))),
    quantity("half_angle_for_span_deg", "deg", "θ by Eq. (11) for the span", Design(half_angle_for_span)),
    quantity("steady_gap_deg", "deg", "mean ball spacing outside the raceway (steady state)", Design(|c| degrees(steady_gap_rad(&c.bearing, &c.raceways)))),
    integer("balls_in_raceway_max", "most balls inside at once", Design(|c| c.raceways.first().map_or(Cell::Null, |r| count(balls_in_raceway_max(&c.bearing, r))))),
    low(quantity("kink_deg", "deg", "slope discontinuity at the raceway ends (at 45° groove angle)", Design(|c| of_raceway(c, |r| r.kink_angle_rad(FRAC_PI_4).to_degrees())))),

    text("verdict", "verdict", Verdict(|j| Cell::Text(j.verdict.name().to_owned()))),
    high(flag("passes", "passes", Verdict(|j| flagged(j.passes())))),
    quantity("critical_gap_deg", "deg", "critical gap", Verdict(|j| j.critical_gap_rad.map(f64::to_degrees).into())),
    integer("passages", "passages", Verdict(|j| j.passages.map_or(Cell::Null, |p| count(p.passages)))),
    low(quantity("collisions_mean", "", "contacts with neighbours per passage, mean", Verdict(|j| of_passages(j, |p| p.collisions_mean)))),
    low(quantity("double_collision_fraction", "", "double collisions, fraction of the passages", Verdict(|j| of_passages(j, |p| p.double_collision_fraction)))),
    low(quantity("slip_mean_m_s", "m/s", "largest sliding speed in a passage, mean", Verdict(|j| of_passages(j, |p| p.slip_mean_m_s)))),
    high(quantity("speed_drop_fraction", "", "reduction of the orbital speed in the raceway, fraction of that of rolling", Verdict(|j| of_passages(j, |p| p.speed_drop_fraction)))),
    high(quantity("gap_leave_min_deg", "deg", "smallest gap on leaving", Verdict(|j| of_passages(j, |p| p.gap_leave_min_rad.to_degrees())))),
    quantity("gap_leave_max_deg", "deg", "largest gap on leaving", Verdict(|j| of_passages(j, |p| p.gap_leave_max_rad.to_degrees()))),

    text("verdict", "verdict", Run(|r| Cell::Text(r.verdict.verdict.name().to_owned()))),
    high(flag("passes", "passes", Run(|r| flagged(r.verdict.verdict.passes())))),
    file_only(text("headline", "verdict with its reason", Run(|r| Cell::Text(r.verdict.headline.clone())))),
    text("criterion", "criterion that decides", Run(|r| r.verdict.deciding.map_or(Cell::Null, |c| Cell::Text(c.name().to_owned())))),
    high(quantity("margin", "", "margin to the nearest limit", Run(|r| r.verdict.deciding.map(Criterion::margin).into()))),

    low(quantity("friction_torque_n_m", "N m", "torque of gross sliding in the model", Run(|r| of_means(r, OrbitMeans::friction_torque_n_m)))),
    quantity("friction_torque_skf_n_m", "N m", "friction torque with lubricant and cage, SKF ½ μ P d", Run(|r| skf_friction_torque_n_m(r.case).into())),
    low(quantity("power_loss_w", "W", "power loss in the model, damping included", Run(|r| of_means(r, OrbitMeans::power_loss_w)))),
    quantity("power_loss_inner_friction_w", "W", "  friction at the inner raceway", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::InnerFriction)))),
    quantity("power_loss_outer_friction_w", "W", "  friction at the outer raceway", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::OuterFriction)))),
    quantity("power_loss_ball_friction_w", "W", "  friction between balls", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::BallFriction)))),
    quantity("power_loss_damping_w", "W", "  damping of the contacts (contact.damping, an assumed constant)", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::Damping)))),
    quantity("power_loss_drag_w", "W", "  drag on the inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::Drag)))),
    quantity("power_loss_rotor_friction_w", "W", "  friction between rotor and inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::RotorFriction)))),
    quantity("power_loss_rotor_damping_w", "W", "  damping between rotor and inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::RotorDamping)))),
    quantity("power_loss_support_damping_w", "W", "  damping of the support", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::SupportDamping)))),
    quantity("power_loss_stored_w", "W", "  stored, less work of loads", Run(|r| of_means(r, OrbitMeans::stored_w))),

    low(quantity("inner_stress_max_gpa", "GPa", "peak contact pressure, inner raceway", Run(|r| of_summary(r, |s| s.peaks.inner.pressure_pa * 1e-9)))),
    low(quantity("outer_stress_max_gpa", "GPa", "peak contact pressure, outer raceway", Run(|r| of_summary(r, |s| s.peaks.outer.pressure_pa * 1e-9)))),
    low(quantity("ball_stress_max_gpa", "GPa", "peak contact pressure, ball on ball", Run(|r| of_summary(r, |s| s.peaks.balls.pressure_pa * 1e-9)))),
    quantity("inner_force_max_n", "N", "largest force at the inner raceway", Run(|r| of_summary(r, |s| s.peaks.inner.force_n))),
    quantity("outer_force_max_n", "N", "largest force at the outer raceway", Run(|r| of_summary(r, |s| s.peaks.outer.force_n))),
    quantity("ball_force_max_n", "N", "largest force between balls", Run(|r| of_summary(r, |s| s.peaks.balls.force_n))),
    quantity("inner_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, inner raceway", Run(|r| of_summary(r, |s| s.peaks.inner.pressure_velocity_pa_m_s * 1e-6))),
    quantity("outer_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, outer raceway", Run(|r| of_summary(r, |s| s.peaks.outer.pressure_velocity_pa_m_s * 1e-6))),
    quantity("ball_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, ball on ball", Run(|r| of_summary(r, |s| s.peaks.balls.pressure_velocity_pa_m_s * 1e-6))),

    quantity("ring_x_um_mean", "um", "mean displacement of the inner ring, x", Run(|r| of_summary(r, |s| s.ring_x_mean_m * 1e6))),
    quantity("ring_y_um_mean", "um", "mean displacement of the inner ring, y", Run(|r| of_summary(r, |s| s.ring_y_mean_m * 1e6))),
    low(integer("collisions", "collisions between balls", Run(|r| of_contacts(r, |c| c.all)))),
    low(integer("collisions_above_0_1_m_s", "  collisions above 0.1 m/s", Run(|r| of_contacts(r, |c| c.above[0])))),
    low(integer("collisions_above_0_5_m_s", "  collisions above 0.5 m/s", Run(|r| of_contacts(r, |c| c.above[1])))),
    low(integer("collisions_above_1_m_s", "  collisions above 1 m/s", Run(|r| of_contacts(r, |c| c.above[2])))),
    quantity("gap_min_deg", "deg", "smallest gap", Run(|r| of_summary(r, |s| s.gap_min_rad.to_degrees()))),
    low(quantity("gap_max_deg", "deg", "largest gap", Run(|r| of_summary(r, |s| s.gap_max_rad.to_degrees())))),
    low(quantity("gap_deviation_deg", "deg", "standard deviation of the gaps", Run(|r| of_summary(r, |s| s.gap_deviation_rad.to_degrees())))),
    quantity("gap_deviation_change_deg", "deg", "  change of that from the first to the second half of the run", Run(|r| of_summary(r, |s| s.gap_deviation_change_rad.to_degrees()))),
    low(quantity("outer_ring_force_deviation_n", "N", "standard deviation of the force on the outer ring", Run(|r| of_summary(r, |s| s.outer_ring_force_deviation_n)))),
    low(quantity("slip_max_m_s", "m/s", "largest sliding speed under load", Run(|r| of_summary(r, |s| s.slip_max_m_s)))),

    quantity("orbit_speed_rpm", "rpm", "orbital speed of the balls, mean", Run(|r| of_means(r, |m| rpm(m.orbit_speed_rad_s)))),
    quantity("rotation_speed_rpm", "rpm", "rotational speed of the balls, mean", Run(|r| of_means(r, |m| rpm(m.rotation_rad_s)))),
    quantity("ftf_hz", "Hz", "FTF in pure rolling", Run(|r| of_rolling(r, |f| f.ftf_hz))),
    quantity("bpfo_hz", "Hz", "BPFO in pure rolling", Run(|r| of_rolling(r, |f| f.bpfo_hz))),
    quantity("bpfi_hz", "Hz", "BPFI in pure rolling", Run(|r| of_rolling(r, |f| f.bpfi_hz))),
    quantity("bsf_hz", "Hz", "BSF in pure rolling", Run(|r| of_rolling(r, |f| f.bsf_hz))),
    quantity("ftf_observed_hz", "Hz", "FTF in the motion (orbits of the balls)", Run(|r| of_means(r, OrbitMeans::ftf_hz))),
    quantity("bpfo_observed_hz", "Hz", "BPFO in the motion", Run(|r| of_means(r, OrbitMeans::bpfo_hz))),
    quantity("bpfi_observed_hz", "Hz", "BPFI in the motion", Run(|r| of_means(r, OrbitMeans::bpfi_hz))),
    quantity("bsf_observed_hz", "Hz", "BSF in the motion", Run(|r| of_means(r, OrbitMeans::bsf_hz))),

    integer("passages", "passages through a discrete raceway", Run(|r| Cell::Integer(r.passages.count as i64))),
    quantity("passage_duration_mean_ms", "ms", "time of a passage, mean", Run(|r| of_tally(r, |p| p.duration_mean_s() * 1e3))),
    low(quantity("passage_collisions_mean", "", "contacts per passage, mean", Run(|r| of_tally(r, PassageTally::collisions_mean)))),
    low(quantity("double_collision_fraction", "", "double collisions, fraction of the passages", Run(|r| of_tally(r, PassageTally::double_collision_fraction)))),
    quantity("passage_slip_mean_m_s", "m/s", "largest sliding speed in a passage, mean", Run(|r| of_tally(r, PassageTally::slip_mean_m_s))),
    quantity("passage_gap_min_mean_deg", "deg", "smallest gap ahead in a passage, mean", Run(|r| of_tally(r, |p| p.gap_min_mean_rad().to_degrees()))),

    quantity("settled_after_s", "s", "end of the transient", Run(|r| of_summary(r, |s| s.settled_after_s))),
    integer("orbits", "orbits of mean powers and speeds", Run(|r| r.summary.and_then(|s| s.means).map_or(Cell::Null, |m| Cell::Integer(i64::from(m.orbits))))),
    quantity("energy_residual_relative", "", "energy balance error (relative)", Run(|r| some(r.outcome.energy_residual_relative))),
    quantity("end_s", "s", "simulated", Run(|r| some(r.outcome.end_s))),
    integer("steps", "steps", Run(|r| Cell::Integer(r.outcome.steps as i64))),
    integer("rhs_evaluations", "force evaluations", Run(|r| Cell::Integer(r.outcome.rhs_evaluations as i64))),
    file_only(quantity("wall_s", "s", "time of the computation", Run(|r| some(r.wall_s)))),

    across(Across::Verdict, text("verdict", "verdict", Drop(|d| judged(d, Kind::Text)))),
    across(Across::Verdict, high(flag("passes", "passes", Drop(|d| judged(d, Kind::Flag))))),
    file_only(text("headline", "verdict with its reason", Drop(|d| Cell::Text(DropJudgement::of_drop(d).headline())))),
    file_only(text("end_state_text", "state at the end in words", Drop(|d| Cell::Text(d.summary.end_state.text().to_owned())))),
    across(WorstState, text("end_state", "state at the end", Drop(|d| Cell::Text(d.summary.end_state.name().to_owned())))),
    across(Smallest, quantity("first_contact_ms", "ms", "first contact", Drop(|d| d.summary.first_contact_s.map(|t| 1e3 * t).into()))),
    across(Sum, integer("impacts", "impacts of the rotor", Drop(|d| Cell::Integer(d.summary.impacts as i64)))),
    across(Largest, quantity("contact_fraction", "", "time in contact after the first, fraction", Drop(|d| some(d.summary.contact_fraction)))),
    across(Largest, low(quantity("rotor_force_max_n", "N", "largest force on the rotor", Drop(|d| some(d.summary.rotor_force_max_n))))),
    across(Largest, low(quantity("rotor_force_max_weights", "", "largest force on the rotor / its weight", Drop(|d| weights(d, Some(d.summary.rotor_force_max_n)))))),
    across(Largest, low(quantity("housing_force_max_n", "N", "largest force on the housing", Drop(|d| d.summary.housing_force_max_n.into())))),
    across(Largest, low(quantity("housing_force_max_weights", "", "largest force on the housing / rotor's weight", Drop(|d| weights(d, d.summary.housing_force_max_n))))),
    across(Largest, low(quantity("rotor_displacement_max_um", "um", "largest displacement of the journal from the stator centre", Drop(|d| some(1e6 * d.summary.rotor_displacement_max_m))))),
    across(Smallest, high(quantity("clearance_margin_um", "um", "margin of the journal to its clearance", Drop(clearance_margin)))),
    across(Largest, quantity("housing_displacement_max_um", "um", "largest displacement of the outer ring", Drop(|d| some(1e6 * d.summary.housing_displacement_max_m)))),
    across(Largest, quantity("rotor_slip_max_m_s", "m/s", "largest sliding speed of the rotor", Drop(|d| some(d.summary.rotor_slip_max_m_s)))),
    across(LargestOfAll, low(quantity("spin_up_ms", "ms", "spin-up of the inner ring", Drop(|d| d.summary.spin_up_s.map(|t| 1e3 * t).into())))),
    quantity("ring_speed_rpm", "rpm", "inner ring at the end", Drop(|d| some(rpm(d.summary.ring_speed_rad_s)))),
    across(Same, quantity("rotor_speed_rpm", "rpm", "rotor at the end", Drop(|d| some(rpm(d.summary.rotor_speed_rad_s))))),
    across(Largest, low(quantity("backward_whirl_max_hz", "Hz", "largest backward speed of the journal (whirl or swing)", Drop(|d| some(d.summary.backward_whirl_max_hz))))),
    across(Largest, low(quantity("backward_whirl_hz", "Hz", "backward whirl round the bore", Drop(|d| d.summary.backward_whirl_hz.into())))),
    across(Largest, low(quantity("inner_stress_max_gpa", "GPa", "peak contact pressure, inner raceway", Drop(|d| some(1e-9 * d.summary.inner_stress_max_pa))))),
    across(Largest, low(quantity("outer_stress_max_gpa", "GPa", "peak contact pressure, outer raceway", Drop(|d| some(1e-9 * d.summary.outer_stress_max_pa))))),
    across(Largest, low(quantity("ball_stress_max_gpa", "GPa", "peak contact pressure, ball on ball", Drop(|d| some(1e-9 * d.summary.ball_stress_max_pa))))),
    across(Sum, low(integer("collisions", "collisions between balls", Drop(|d| Cell::Integer(d.summary.collisions.all as i64))))),
    across(Sum, low(integer("collisions_above_0_1_m_s", "  collisions above 0.1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[0] as i64))))),
    across(Sum, low(integer("collisions_above_0_5_m_s", "  collisions above 0.5 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[1] as i64))))),
    across(Sum, low(integer("collisions_above_1_m_s", "  collisions above 1 m/s", Drop(|d| Cell::Integer(d.summary.collisions.above[2] as i64))))),
    across(Sum, low(quantity("end_collision_rate_hz", "Hz", "collisions between balls per second, at the end", Drop(|d| d.summary.end_collision_rate_hz.into())))),
    across(Sum, low(quantity("end_collision_rate_above_0_1_m_s_hz", "Hz", "  collisions above 0.1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[0].into())))),
    across(Sum, low(quantity("end_collision_rate_above_0_5_m_s_hz", "Hz", "  collisions above 0.5 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[1].into())))),
    across(Sum, low(quantity("end_collision_rate_above_1_m_s_hz", "Hz", "  collisions above 1 m/s per second, at the end", Drop(|d| d.summary.end_collision_rate_above_hz[2].into())))),
    across(Largest, quantity("ball_force_max_n", "N", "largest force between balls", Drop(|d| some(d.summary.ball_force_max_n)))),
    across(Largest, low(quantity("ball_slip_max_m_s", "m/s", "largest sliding speed of a ball", Drop(|d| some(d.summary.ball_slip_max_m_s))))),
    across(Sum, low(quantity("heat_j", "J", "heat of all interfaces", Drop(|d| some(d.summary.heat.total_j()))))),
    across(Sum, low(quantity("ball_heat_j", "J", "heat of friction at the balls", Drop(|d| some(d.summary.heat.balls_j()))))),
    across(Sum, quantity("rotor_friction_j", "J", "  friction between rotor and inner ring", Drop(|d| some(d.summary.heat.rotor_friction_j)))),
    across(Sum, quantity("rotor_damping_j", "J", "  damping between rotor and inner ring", Drop(|d| some(d.summary.heat.rotor_damping_j)))),
    across(Sum, quantity("inner_friction_j", "J", "  friction at the inner raceway", Drop(|d| some(d.summary.heat.inner_friction_j)))),
    across(Sum, quantity("outer_friction_j", "J", "  friction at the outer raceway", Drop(|d| some(d.summary.heat.outer_friction_j)))),
    across(Sum, quantity("ball_friction_j", "J", "  friction between balls", Drop(|d| some(d.summary.heat.ball_friction_j)))),
    across(Sum, quantity("contact_damping_j", "J", "  damping of the balls' contacts", Drop(|d| some(d.summary.heat.contact_damping_j)))),
    across(Sum, quantity("support_damping_j", "J", "  damping of the support", Drop(|d| some(d.summary.heat.support_damping_j)))),
    list("inner_force_max_of_ball_n", "N", "largest force of each ball at the inner raceway", Drop(|d| Cell::Numbers(d.summary.inner_force_max_n.clone()))),
    list("outer_force_max_of_ball_n", "N", "largest force of each ball at the outer raceway", Drop(|d| Cell::Numbers(d.summary.outer_force_max_n.clone()))),
    across(Largest, quantity("energy_residual_relative", "", "energy balance error (relative)", Drop(|d| some(d.outcome.energy_residual_relative)))),
    across(Same, quantity("end_s", "s", "simulated", Drop(|d| some(d.outcome.end_s)))),
    high(quantity("plane_margin_min_um", "um", "smallest margin of the planes of the rotor to their clearances", RotorDrop(|d| d.planes.iter().map(|p| 1e6 * (p.clearance.radial_m - p.displacement_max_m)).reduce(f64::min).into()))),
    quantity("rotor_energy_residual_relative", "", "energy balance error of the rotor alone (relative)", RotorDrop(|d| some(d.rotor_energy_residual_relative))),
];

const fn quantity(
    name: &'static str,
    unit: &'static str,
    label: &'static str,
    of: Source,
) -> Quantity {
    Quantity {
        name,
        unit,
        label,
        kind: Kind::Number,
        aim: None,
        across: None,
        in_sweeps: true,
        in_tables: true,
        of,
    }
}

const fn list(name: &'static str, unit: &'static str, label: &'static str, of: Source) -> Quantity {
    let kind = Kind::Numbers;
    Quantity {
        kind,
        ..quantity(name, unit, label, of)
    }
}

const fn of_kind(kind: Kind, name: &'static str, label: &'static str, of: Source) -> Quantity {
    Quantity {
        kind,
        ..quantity(name, "", label, of)
    }
}

const fn integer(name: &'static str, label: &'static str, of: Source) -> Quantity {
    of_kind(Kind::Integer, name, label, of)
}

const fn flag(name: &'static str, label: &'static str, of: Source) -> Quantity {
    let in_tables = false;
    Quantity {
        in_tables,
        ..of_kind(Kind::Flag, name, label, of)
    }
}

const fn text(name: &'static str, label: &'static str, of: Source) -> Quantity {
    let in_tables = false;
    Quantity {
        in_tables,
        ..of_kind(Kind::Text, name, label, of)
    }
}

/// A result that neither columns of sweeps nor tables have: a sentence, or a time that differs from
/// run to run.
const fn file_only(quantity: Quantity) -> Quantity {
    let (in_sweeps, in_tables) = (false, false);
    Quantity {
        in_sweeps,
        in_tables,
        ..quantity
    }
}

/// A result of a drop with the rule for a rotor in several bearings.
const fn across(across: Across, quantity: Quantity) -> Quantity {
    let across = Some(across);
    Quantity { across, ..quantity }
}

const fn low(quantity: Quantity) -> Quantity {
    let aim = Some(Aim::Low);
    Quantity { aim, ..quantity }
}

const fn high(quantity: Quantity) -> Quantity {
    let aim = Some(Aim::High);
    Quantity { aim, ..quantity }
}

fn flagged(value: Option<bool>) -> Cell {
    value.map_or(Cell::Null, |value| Cell::Integer(i64::from(value)))
}

fn judged(drop: &FinishedDrop<'_>, kind: Kind) -> Cell {
    verdict(kind, &DropJudgement::of_drop(drop))
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

fn rpm(speed_rad_s: f64) -> f64 {
    speed_rad_s * 60.0 / TAU
}

fn of_means(run: &Finished<'_>, value: fn(&OrbitMeans) -> f64) -> Cell {
    let means = run.summary.and_then(|s| s.means.as_ref());
    means.map(value).into()
}

fn of_contacts(run: &Finished<'_>, count: fn(&ContactCounts) -> u64) -> Cell {
    let contacts = run
        .summary
        .map(|s| Cell::Integer(count(&s.collisions) as i64));
    contacts.unwrap_or(Cell::Null)
}

/// A frequency of balls in pure rolling; nothing where the speed of the ring varies.
fn of_rolling(run: &Finished<'_>, value: fn(&PassingFrequencies) -> f64) -> Cell {
    let varies = run.case.operation.inner_speed_table.is_some() || run.case.rotor.is_some();
    (!varies)
        .then(|| value(&PassingFrequencies::new(run.case)))
        .into()
}

fn of_tally(run: &Finished<'_>, value: fn(&PassageTally) -> f64) -> Cell {
    some(value(run.passages))
}

fn some(value: f64) -> Cell {
    Some(value).into()
}

fn degrees(angle_rad: f64) -> Cell {
    some(angle_rad.to_degrees())
}

fn count(value: usize) -> Cell {
    Cell::Integer(value as i64)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

fn of_raceway(case: &Case, value: impl Fn(&Raceway) -> f64) -> Cell {
    case.raceways.first().map(value).into()
}

fn of_passages(judgement: &Judgement, value: fn(&PassageStatistics) -> f64) -> Cell {
    judgement.passages.as_ref().map(value).into()
}

fn of_summary(run: &Finished<'_>, value: fn(&Summary) -> f64) -> Cell {
    run.summary.map(value).into()
}

/// θ by Eq. (11) for the case's own span and the gap of evenly spaced balls.
fn half_angle_for_span(case: &Case) -> Cell {
    let bearing = &case.bearing;
    let angle = case.raceways.first().and_then(|raceway| {
        let span = raceway.dimensions().axial_span_m;
        half_angle_for_gap_rad(bearing, span, bearing.nominal_gap_rad(), Eq11::Published)
    });
    angle.map(f64::to_degrees).into()
}
