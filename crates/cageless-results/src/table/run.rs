//! Results of a run.

use std::f64::consts::FRAC_PI_2;

use cageless::ContactCounts;
use cageless::OrbitMeans;
use cageless::SpatialSummary;
use cageless::dynamics::EnergyTerm;
use cageless::passage::PassageMeans;
use cageless::rating::{PassingFrequencies, skf_friction_torque_n_m};
use cageless::summary::{ContactPeak, Summary};
use cageless_design::Criterion;

use crate::Finished;
use crate::cell::Cell;
use crate::declare::*;
use crate::group::Group;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::{Run, Vibration};
use crate::unit::rpm;

/// Results of a run.
#[rustfmt::skip]
pub const RUN: &[Quantity] = &[
    means(VERDICT_NAMES, text("verdict", "verdict", Run(|r| Cell::Text(r.verdict.verdict.name().to_owned())))),
    high(flag("passes", "passes", Run(|r| flagged(r.verdict.verdict.passes())))),
    file_only(text("headline", "verdict with its reason", Run(|r| Cell::Text(r.verdict.headline.clone())))),
    means(CRITERION, text("criterion", "criterion that decides", Run(|r| r.verdict.deciding.map_or(Cell::Null, |c| Cell::Text(c.name().to_owned()))))),
    means(MARGIN, high(quantity("margin", "", "margin to the nearest limit", Run(|r| r.verdict.deciding.map(Criterion::margin).into())))),
    group(Group::Friction, means("`power_loss_w` over the speed of the inner ring: gross sliding and damping, with `[film]` also rolling resistance; without cage, seals and churning", low(quantity("friction_torque_n_m", "N m", "friction torque in the model, rolling in oil included", Run(|r| of_means(r, |means| means.friction_torque_n_m)))))),
    group(Group::Friction, means("estimate for a deep groove ball bearing with a cage: P of ISO 281, d the bore, μ = 0.0015; none with moments, a tilt, a contact angle or several rows", quantity("friction_torque_skf_n_m", "N m", "friction torque with lubricant and cage, SKF ½ μ P d", Run(|r| skf_friction_torque_n_m(r.case).into())))),
    group(Group::Friction, means("power of the drive, averaged over whole orbits of the balls: the heat of friction and damping, and what is stored less the work of loads (`power_loss_stored_w`); where the speed varies, the heat alone", low(quantity("power_loss_w", "W", "power loss in the model, damping included", Run(|r| of_means(r, |means| means.power_loss_w)))))),
    group(Group::Friction, quantity("power_loss_inner_friction_w", "W", "  friction at the inner raceway", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::InnerFriction))))),
    group(Group::Friction, quantity("power_loss_outer_friction_w", "W", "  friction at the outer raceway", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::OuterFriction))))),
    group(Group::Friction, unless_zero(quantity("power_loss_ball_friction_w", "W", "  friction between balls", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::BallFriction)))))),
    group(Group::Friction, means("heat of the oil film at both raceways, with `film.hysteresis` also of the steel; with `[film]`", in_oil(low(quantity("rolling_resistance_power_w", "W", "  rolling resistance at both raceways", Run(|r| of_film(r, |m| m.power_w(EnergyTerm::RollingResistance)))))))),
    group(Group::Friction, quantity("power_loss_damping_w", "W", "  damping of the contacts (an assumed constant)", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::Damping))))),
    group(Group::Friction, unless_zero(means("and damping in the seats of outer rings that slide under springs", quantity("power_loss_inner_ring_damping_w", "W", "  drag on the inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::Drag))))))),
    group(Group::Friction, unless_zero(quantity("power_loss_rotor_friction_w", "W", "  friction between rotor and inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::RotorFriction)))))),
    group(Group::Friction, unless_zero(quantity("power_loss_rotor_damping_w", "W", "  damping between rotor and inner ring", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::RotorDamping)))))),
    group(Group::Friction, unless_zero(quantity("power_loss_support_damping_w", "W", "  damping of the support", Run(|r| of_means(r, |m| m.power_w(EnergyTerm::SupportDamping)))))),
    not_in_tables(means("rise of the stored energy less the work of the loads, per second", quantity("power_loss_stored_w", "W", "  stored, less work of loads", Run(|r| of_means(r, |means| means.stored_w))))),
    group(Group::Friction, means(REGULARISATION_SPEED, part(quantity("regularisation_speed_mean_m_s", "m/s", "regularisation speed of the friction, mean", Run(|r| r.summary.and_then(|s| s.regularisation_speed_mean_m_s).into()))))),
    group(Group::Film, means("`rolling_resistance_power_w` over the speed of the inner ring; part of `friction_torque_n_m`", part(low(quantity("rolling_resistance_torque_n_m", "N m", "torque of rolling resistance", Run(|r| of_film(r, |m| m.power_w(EnergyTerm::RollingResistance) / m.inner_speed_rad_s))))))),
    group(Group::Film, means("orbital speed of rolling times the time from ψ = 90° to 270°, less 180°, mean over the balls; with `[film]`", in_oil(quantity("half_turn_lag_deg", "deg", "lag of the balls over the half orbit away from the load", Run(|r| half_turn(r, |lag| lag.to_degrees())))))),
    group(Group::Film, means("2/π times that lag: by film, weight, contact angles and contacts of the balls together; none where that is all of it; `design` has the part of the film", part(quantity("half_turn_deficit_fraction", "", "share of its speed that a ball loses over that half orbit", Run(|r| half_turn(r, deficit)))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, low(quantity("inner_pressure_max_mpa", "MPa", "peak contact pressure, inner raceway", Run(|r| of_summary(r, |s| pressure_mpa(&s.peaks.inner))))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, low(quantity("outer_pressure_max_mpa", "MPa", "peak contact pressure, outer raceway", Run(|r| of_summary(r, |s| pressure_mpa(&s.peaks.outer))))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, low(quantity("ball_pressure_max_mpa", "MPa", "peak contact pressure, ball on ball", Run(|r| of_summary(r, |s| pressure_mpa(&s.peaks.balls))))))),
    group(Group::Pressure, quantity("inner_force_max_n", "N", "largest force at the inner raceway", Run(|r| of_summary(r, |s| s.peaks.inner.force_n)))),
    group(Group::Pressure, quantity("outer_force_max_n", "N", "largest force at the outer raceway", Run(|r| of_summary(r, |s| s.peaks.outer.force_n)))),
    group(Group::Pressure, quantity("ball_force_max_n", "N", "largest force between balls", Run(|r| of_summary(r, |s| s.peaks.balls.force_n)))),
    group(Group::Pressure, means(PRESSURE_VELOCITY, quantity("inner_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, inner raceway", Run(|r| of_summary(r, |s| pressure_velocity_mpa_m_s(&s.peaks.inner)))))),
    group(Group::Pressure, means(PRESSURE_VELOCITY, quantity("outer_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, outer raceway", Run(|r| of_summary(r, |s| pressure_velocity_mpa_m_s(&s.peaks.outer)))))),
    group(Group::Pressure, means(PRESSURE_VELOCITY, quantity("ball_pressure_velocity_max_mpa_m_s", "MPa m/s", "pressure × sliding speed, ball on ball", Run(|r| of_summary(r, |s| pressure_velocity_mpa_m_s(&s.peaks.balls)))))),
    group(Group::Displacement, unless_zero(quantity("ring_x_mean_um", "um", "mean displacement of the inner ring, x", Run(|r| of_summary(r, |s| s.ring_x_mean_m * 1e6))))),
    group(Group::Displacement, quantity("ring_y_mean_um", "um", "mean displacement of the inner ring, y", Run(|r| of_summary(r, |s| s.ring_y_mean_m * 1e6)))),
    group(Group::Displacement, quantity("ring_z_mean_um", "um", "mean displacement of the inner ring, z", Run(|r| of_space(r, |s| s.ring_z_mean_m * 1e6)))),
    group(Group::Displacement, unless_zero(quantity("tilt_x_mean_mrad", "mrad", "mean tilt of the inner ring about X", Run(|r| of_space(r, |s| s.tilt_mean_rad[0] * 1e3))))),
    group(Group::Displacement, unless_zero(quantity("tilt_y_mean_mrad", "mrad", "mean tilt of the inner ring about Y", Run(|r| of_space(r, |s| s.tilt_mean_rad[1] * 1e3))))),
    group(Group::Pressure, means(FORCE_ANGLE, quantity("inner_contact_angle_mean_deg", "deg", "contact angle at the inner raceway, mean", Run(|r| of_space(r, |s| s.inner_contact_angle_mean_rad.to_degrees()))))),
    group(Group::Pressure, means(FORCE_ANGLE, quantity("outer_contact_angle_mean_deg", "deg", "contact angle at the outer raceway, mean", Run(|r| of_space(r, |s| s.outer_contact_angle_mean_rad.to_degrees()))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, quantity("inner_ellipse_edge_max_deg", "deg", "edge of contact ellipses, inner raceway, largest angle", Run(|r| of_space(r, |s| s.ellipse_edge_max_rad[0].to_degrees()))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, quantity("outer_ellipse_edge_max_deg", "deg", "edge of contact ellipses, outer raceway, largest angle", Run(|r| of_space(r, |s| s.ellipse_edge_max_rad[1].to_degrees()))))),
    group(Group::Displacement, unless_zero(means("by which the outer ring of each row is displaced against its contact sign at the start, given or by its spring; in space", part(few("row_preload_start_um", "um", "preload of the rows by displacement, at the start", Run(|r| of_rows(r, |s| s.row_preload_start_m.iter().map(|m| m * 1e6).collect()))))))),
    group(Group::Displacement, unless_zero(means("the same of the run after its transient: a spring lets the ring follow its balls", part(few("row_preload_mean_um", "um", "preload of the rows by displacement, mean", Run(|r| of_rows(r, |s| s.row_preload_mean_m.iter().map(|m| m * 1e6).collect()))))))),
    group(Group::Pressure, means("of the balls of each row on its outer ring, along z, friction included; in space", part(few("row_axial_force_mean_n", "N", "axial force of the rows, mean", Run(|r| of_rows(r, |s| s.row_axial_force_mean_n.clone())))))),
    group(Group::Contacts, means(COLLISIONS, low(integer("collisions", "collisions between balls", Run(|r| of_contacts(r, |c| c.all)))))),
    group(Group::Contacts, unless_zero(means(ABOVE_0_1, low(integer("collisions_above_0_1_m_s", "  collisions above 0.1 m/s", Run(|r| of_contacts(r, |c| c.above[0]))))))),
    group(Group::Contacts, unless_zero(means(ABOVE_0_5, low(integer("collisions_above_0_5_m_s", "  collisions above 0.5 m/s", Run(|r| of_contacts(r, |c| c.above[1]))))))),
    group(Group::Contacts, unless_zero(means(ABOVE_1, low(integer("collisions_above_1_m_s", "  collisions above 1 m/s", Run(|r| of_contacts(r, |c| c.above[2]))))))),
    group(Group::Spacing, quantity("gap_min_deg", "deg", "smallest gap", Run(|r| of_summary(r, |s| s.gap_min_rad.to_degrees())))),
    group(Group::Spacing, low(quantity("gap_max_deg", "deg", "largest gap", Run(|r| of_summary(r, |s| s.gap_max_rad.to_degrees()))))),
    group(Group::Spacing, means("of all balls, after the transient", low(quantity("gap_deviation_deg", "deg", "standard deviation of the gaps", Run(|r| of_summary(r, |s| s.gap_deviation_rad.to_degrees())))))),
    not_in_tables(quantity("gap_deviation_change_deg", "deg", "  change of that from the first to the second half of the run", Run(|r| of_summary(r, |s| s.gap_deviation_change_rad.to_degrees())))),
    group(Group::Spacing, low(quantity("outer_ring_force_deviation_n", "N", "standard deviation of the force on the outer ring", Run(|r| of_summary(r, |s| s.outer_ring_force_deviation_n))))),
    group(Group::Friction, means("of balls at the raceways, wherever the contact carries load", low(quantity("sliding_max_m_s", "m/s", "largest sliding speed under load", Run(|r| of_summary(r, |s| s.sliding_max_m_s)))))),
    group(Group::Friction, quantity("orbit_speed_rpm", "rpm", "orbital speed of the balls, mean", Run(|r| of_means(r, |m| rpm(m.orbit_speed_rad_s))))),
    group(Group::Friction, quantity("rotation_speed_rpm", "rpm", "rotational speed of the balls, mean", Run(|r| of_means(r, |m| rpm(m.rotation_rad_s))))),
    not_in_tables(means(FTF, quantity("ftf_hz", "Hz", "FTF in pure rolling", Run(|r| of_rolling(r, |f| f.ftf_hz))))),
    not_in_tables(means(BPFO, quantity("bpfo_hz", "Hz", "BPFO in pure rolling", Run(|r| of_rolling(r, |f| f.bpfo_hz))))),
    not_in_tables(means(BPFI, quantity("bpfi_hz", "Hz", "BPFI in pure rolling", Run(|r| of_rolling(r, |f| f.bpfi_hz))))),
    not_in_tables(means(BSF, quantity("bsf_hz", "Hz", "BSF in pure rolling", Run(|r| of_rolling(r, |f| f.bsf_hz))))),
    group(Group::Frequencies, quantity("ftf_observed_hz", "Hz", "FTF in the motion (orbits of the balls)", Run(|r| of_means(r, |means| means.ftf_hz)))),
    group(Group::Frequencies, quantity("bpfo_observed_hz", "Hz", "BPFO in the motion", Run(|r| of_means(r, |means| means.bpfo_hz)))),
    group(Group::Frequencies, quantity("bpfi_observed_hz", "Hz", "BPFI in the motion", Run(|r| of_means(r, |means| means.bpfi_hz)))),
    group(Group::Frequencies, quantity("bsf_observed_hz", "Hz", "BSF in the motion", Run(|r| of_means(r, |means| means.bsf_hz)))),
    group(Group::Passages, integer("passages", "passages through a discrete raceway", Run(|r| Cell::Integer(r.passages.count as i64)))),
    group(Group::Passages, quantity("passage_duration_mean_ms", "ms", "time of a passage, mean", Run(|r| of_passages(r, |p| p.duration_s * 1e3)))),
    group(Group::Passages, means(LAG, high(quantity("lag_per_pass_deg", "deg", "lag of a ball per pass of a discrete raceway, mean", Run(|r| of_passages(r, |p| p.lag_rad.to_degrees())))))),
    group(Group::Passages, low(quantity("passage_collisions_mean", "", "contacts per passage, mean", Run(|r| of_passages(r, |p| p.collisions))))),
    group(Group::Passages, unless_zero(means(DOUBLE_COLLISIONS, low(quantity("double_collision_fraction", "", "passages with a double collision", Run(|r| of_passages(r, |p| p.double_collision_fraction))))))),
    group(Group::Passages, quantity("passage_sliding_mean_m_s", "m/s", "largest sliding speed in a passage, mean", Run(|r| of_passages(r, |p| p.sliding_m_s)))),
    group(Group::Passages, unless_zero(means(UNLOADED, quantity("passage_unloaded_fraction", "", "time in raceways without force at the inner raceway, share", Run(|r| of_passages(r, |p| p.unloaded_fraction)))))),
    group(Group::Passages, quantity("passage_gap_min_mean_deg", "deg", "smallest gap ahead in a passage, mean", Run(|r| of_passages(r, |p| p.gap_min_rad.to_degrees())))),
    group(Group::Computation, means("statistics are of the time after it", quantity("settled_after_s", "s", "end of the transient", Run(|r| of_summary(r, |s| s.settled_after_s))))),
    group(Group::Computation, means("whole orbits of the balls over which mean powers and speeds are averaged; 0: the run is shorter than one, the means are over its end", integer("averaged_orbits", "orbits of mean powers and speeds", Run(|r| r.summary.and_then(|s| s.means).map_or(Cell::Null, |m| Cell::Integer(i64::from(m.orbits))))))),
    group(Group::Computation, means(ENERGY_RESIDUAL, quantity("energy_residual_relative", "", "energy balance error (relative)", Run(|r| some(r.outcome.energy_residual_relative))))),
    group(Group::Computation, means(SIMULATED, quantity("simulated_s", "s", "simulated", Run(|r| some(r.outcome.end_s))))),
    not_in_tables(integer("steps", "steps", Run(|r| Cell::Integer(r.outcome.steps as i64)))),
    not_in_tables(means("evaluations of the right-hand side of the equations of motion", integer("rhs_evaluations", "force evaluations", Run(|r| Cell::Integer(r.outcome.rhs_evaluations as i64))))),
    file_only(quantity("wall_s", "s", "time of the computation", Run(|r| some(r.wall_s)))),
];

/// Results that rings are compared by beyond those of a run.
#[rustfmt::skip]
pub const COMPARED: &[Quantity] = &[
    part(low(quantity("vibration_rms_m_s2", "m/s^2", "vibration of the housing, vertical, RMS", Vibration(|rms| some(*rms))))),
];

fn of_means(run: &Finished<'_>, value: fn(&OrbitMeans) -> f64) -> Cell {
    let means = run.summary.and_then(|s| s.means.as_ref());
    means.map(value).into()
}

/// A mean of a run with a film.
fn of_film(run: &Finished<'_>, value: fn(&OrbitMeans) -> f64) -> Cell {
    match run.case.film {
        Some(_) => of_means(run, value),
        None => Cell::Null,
    }
}

/// 2/π of a lag over half an orbit; NaN where it is all of the speed or more.
fn deficit(lag_rad: f64) -> f64 {
    let share = lag_rad / FRAC_PI_2;
    if share < 1.0 { share } else { f64::NAN }
}

fn half_turn(run: &Finished<'_>, value: fn(f64) -> f64) -> Cell {
    let lag_rad = run.summary.and_then(|s| s.half_turn_lag_rad);
    lag_rad.map(value).into()
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

fn of_passages(run: &Finished<'_>, value: fn(&PassageMeans) -> f64) -> Cell {
    some(value(&run.passages.means()))
}

/// A number of a run in space.
fn of_space(run: &Finished<'_>, value: fn(&SpatialSummary) -> f64) -> Cell {
    run.summary.and_then(|s| s.space.as_ref()).map(value).into()
}

/// A number of every row of a run in space.
fn of_rows(run: &Finished<'_>, values: fn(&SpatialSummary) -> Vec<f64>) -> Cell {
    let values = run.summary.and_then(|s| s.space.as_ref()).map(values);
    values.map_or(Cell::Null, Cell::Numbers)
}

fn pressure_mpa(peak: &ContactPeak) -> f64 {
    peak.pressure_pa * 1e-6
}

fn pressure_velocity_mpa_m_s(peak: &ContactPeak) -> f64 {
    peak.pressure_velocity_pa_m_s * 1e-6
}

fn of_summary(run: &Finished<'_>, value: fn(&Summary) -> f64) -> Cell {
    run.summary.map(value).into()
}

#[cfg(test)]
mod tests {
    use super::deficit;

    /// A ball has no more than its speed to lose.
    #[test]
    fn nothing_is_lost_beyond_all_of_the_speed() {
        assert!((deficit(0.1) - 0.2 / std::f64::consts::PI).abs() < 1e-15);
        assert!(deficit(1.6).is_nan());
    }
}
