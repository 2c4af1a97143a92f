//! Table of the quantities of a variant: every output column, once.

use std::f64::consts::FRAC_PI_4;

use cageless::Case;
use cageless::design::{
    Eq11, Judgement, PassageStatistics, balls_in_raceway_max, half_angle_for_gap_rad,
    steady_gap_rad, theoretical_gap_rad,
};
use cageless::equilibrium::Equilibrium;
use cageless::raceway::{Raceway, axial_span_limit_m};
use cageless::simulation::RunOutcome;
use cageless::summary::Summary;
use cageless_io::plan_file::Computation;
use cageless_io::results::{Cell, ColumnKind, ColumnSpec};

/// An output column.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Name: that of its computation, then its own with the unit.
    pub name: &'static str,
    /// Unit; empty if there is none.
    pub unit: &'static str,
    /// Kind of the contents.
    pub kind: ColumnKind,
    /// Better direction, where there is one.
    pub aim: Option<Aim>,
    pub(crate) of: Source,
}

/// Better direction of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// The less the better.
    Low,
    /// The more the better.
    High,
}

/// A finished run.
pub(crate) struct Finished<'a> {
    pub outcome: &'a RunOutcome,
    pub summary: Option<&'a Summary>,
}

/// Source of a quantity.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Source {
    Static(fn(&Equilibrium) -> Cell),
    Design(fn(&Case) -> Cell),
    Verdict(fn(&Judgement) -> Cell),
    Run(fn(&Finished<'_>) -> Cell),
}

impl Quantity {
    /// The computation that it is part of.
    pub fn computation(&self) -> Computation {
        match self.of {
            Source::Static(_) => Computation::Static,
            Source::Design(_) => Computation::Design,
            Source::Verdict(_) => Computation::Verdict,
            Source::Run(_) => Computation::Run,
        }
    }

    pub(crate) fn column(&self) -> ColumnSpec {
        ColumnSpec {
            name: self.name.to_owned(),
            unit: self.unit.to_owned(),
            kind: self.kind,
        }
    }
}

const fn quantity(name: &'static str, unit: &'static str, of: Source) -> Quantity {
    Quantity {
        name,
        unit,
        kind: ColumnKind::Number,
        aim: None,
        of,
    }
}

const fn list(name: &'static str, unit: &'static str, of: Source) -> Quantity {
    let kind = ColumnKind::Numbers;
    Quantity {
        kind,
        ..quantity(name, unit, of)
    }
}

const fn integer(name: &'static str, of: Source) -> Quantity {
    let kind = ColumnKind::Integer;
    Quantity {
        kind,
        ..quantity(name, "", of)
    }
}

const fn low(quantity: Quantity) -> Quantity {
    let aim = Some(Aim::Low);
    Quantity { aim, ..quantity }
}

const fn high(quantity: Quantity) -> Quantity {
    let aim = Some(Aim::High);
    Quantity { aim, ..quantity }
}

use Source::{Design, Run, Static, Verdict};

/// All outputs, in the order of the columns.
#[rustfmt::skip]
pub const QUANTITIES: &[Quantity] = &[
    quantity("static_ring_x_um", "um", Static(|e| some(e.ring_x_m * 1e6))),
    quantity("static_ring_y_um", "um", Static(|e| some(e.ring_y_m * 1e6))),
    quantity("static_inner_force_max_n", "N", Static(|e| some(largest(&e.inner_force_n)))),
    quantity("static_outer_force_max_n", "N", Static(|e| some(largest(&e.outer_force_n)))),
    integer("static_loaded_balls", Static(|e| count(e.inner_force_n.iter().filter(|f| **f > 0.0).count()))),
    quantity("static_inner_stiffness_n_m1_5", "N/m^1.5", Static(|e| some(e.inner_stiffness_n_m1_5))),
    quantity("static_outer_stiffness_n_m1_5", "N/m^1.5", Static(|e| some(e.outer_stiffness_n_m1_5))),
    low(quantity("static_inner_stress_max_gpa", "GPa", Static(|e| some(e.inner_stress_max_pa * 1e-9)))),
    low(quantity("static_outer_stress_max_gpa", "GPa", Static(|e| some(e.outer_stress_max_pa * 1e-9)))),
    list("static_ball_angle_deg", "deg", Static(|e| Cell::Numbers(e.ball_angle_rad.iter().map(|a| a.to_degrees()).collect()))),
    list("static_inner_force_n", "N", Static(|e| Cell::Numbers(e.inner_force_n.clone()))),
    list("static_outer_force_n", "N", Static(|e| Cell::Numbers(e.outer_force_n.clone()))),

    quantity("design_epsilon_deg", "deg", Design(|c| degrees(c.bearing.ball_angle_rad()))),
    quantity("design_uniform_gap_deg", "deg", Design(|c| degrees(c.bearing.nominal_gap_rad()))),
    quantity("design_axial_span_limit_mm", "mm", Design(|c| some(axial_span_limit_m(&c.bearing) * 1e3))),
    quantity("design_beta0_deg", "deg", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Published).to_degrees()))),
    quantity("design_beta0_polar_deg", "deg", Design(|c| of_raceway(c, |r| theoretical_gap_rad(&c.bearing, r, Eq11::Polar).to_degrees()))),
    quantity("design_half_angle_for_span_deg", "deg", Design(half_angle_for_span)),
    quantity("design_steady_gap_deg", "deg", Design(|c| degrees(steady_gap_rad(&c.bearing, &c.raceways)))),
    integer("design_balls_in_raceway_max", Design(|c| c.raceways.first().map_or(Cell::Null, |r| count(balls_in_raceway_max(&c.bearing, r))))),
    low(quantity("design_kink_deg", "deg", Design(|c| of_raceway(c, |r| r.kink_angle_rad(FRAC_PI_4).to_degrees())))),

    Quantity { kind: ColumnKind::Text, ..quantity("verdict_verdict", "", Verdict(|j| Cell::Text(j.verdict.name().to_owned()))) },
    high(integer("verdict_passes", Verdict(|j| j.passes().map_or(Cell::Null, |passes| count(usize::from(passes)))))),
    quantity("verdict_critical_gap_deg", "deg", Verdict(|j| j.critical_gap_rad.map(f64::to_degrees).into())),
    integer("verdict_passages", Verdict(|j| j.passages.map_or(Cell::Null, |p| count(p.passages)))),
    low(quantity("verdict_collisions_mean", "", Verdict(|j| of_passages(j, |p| p.collisions_mean)))),
    low(quantity("verdict_double_collision_fraction", "", Verdict(|j| of_passages(j, |p| p.double_collision_fraction)))),
    low(quantity("verdict_slip_mean_m_s", "m/s", Verdict(|j| of_passages(j, |p| p.slip_mean_m_s)))),
    high(quantity("verdict_speed_drop_fraction", "", Verdict(|j| of_passages(j, |p| p.speed_drop_fraction)))),
    high(quantity("verdict_gap_leave_min_deg", "deg", Verdict(|j| of_passages(j, |p| p.gap_leave_min_rad.to_degrees())))),
    quantity("verdict_gap_leave_max_deg", "deg", Verdict(|j| of_passages(j, |p| p.gap_leave_max_rad.to_degrees()))),

    low(integer("run_collisions", Run(|r| r.summary.map_or(Cell::Null, |s| Cell::Integer(s.collisions as i64))))),
    high(quantity("run_gap_min_deg", "deg", Run(|r| of_summary(r, |s| s.gap_min_rad.to_degrees())))),
    low(quantity("run_gap_max_deg", "deg", Run(|r| of_summary(r, |s| s.gap_max_rad.to_degrees())))),
    quantity("run_ring_x_um_mean", "um", Run(|r| of_summary(r, |s| s.ring_x_mean_m * 1e6))),
    quantity("run_ring_y_um_mean", "um", Run(|r| of_summary(r, |s| s.ring_y_mean_m * 1e6))),
    low(quantity("run_slip_max_m_s", "m/s", Run(|r| of_summary(r, |s| s.slip_max_m_s)))),
    quantity("run_settled_after_s", "s", Run(|r| of_summary(r, |s| s.settled_after_s))),
    quantity("run_energy_residual_relative", "", Run(|r| some(r.outcome.energy_residual_relative))),
    quantity("run_end_s", "s", Run(|r| some(r.outcome.end_s))),
    integer("run_steps", Run(|r| Cell::Integer(r.outcome.steps as i64))),
    integer("run_rhs_evaluations", Run(|r| Cell::Integer(r.outcome.rhs_evaluations as i64))),
];

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_begin_with_their_computation_and_end_with_their_unit() {
        for (k, quantity) in QUANTITIES.iter().enumerate() {
            assert!(quantity.name.starts_with(quantity.computation().name()));
            let unit = quantity.unit.to_lowercase().replace(['/', '.'], "_");
            let unit = unit.replace('^', "");
            assert!(quantity.name.contains(&unit), "{} {unit}", quantity.name);
            assert!(QUANTITIES[k + 1..].iter().all(|f| f.name != quantity.name));
        }
    }
}
