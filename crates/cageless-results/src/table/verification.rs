//! Results of the verification of a run or a drop.

use cageless::verification::{Convergence, DECORRELATED, Divergence, Loss, TOLERANCE as ALLOWED};

use crate::cell::Cell;
use crate::declare::*;
use crate::meanings::*;
use crate::number_text::significant;
use crate::quantity::Quantity;
use crate::source::Source::{Distance, DropVerified, Judged, RotorVerified, Si, Verified};

/// The verification of a run.
#[rustfmt::skip]
pub const VERIFICATION: &[Quantity] = &[
    part(high(integer("converged", "converged results", Verified(|v| count(v.count(Convergence::Converged)))))),
    part(integer("statistical", "chaotic but statistically consistent results", Verified(|v| count(v.count(Convergence::Statistical))))),
    part(low(integer("step_biased", "results that depend on the step size", Verified(|v| count(v.count(Convergence::StepBiased)))))),
    part(means("as many again at half the step", integer("replicas", "runs at the step", Verified(|v| count(v.replicas))))),
    part(means("fraction of its scale by which a converged result may change", quantity("tolerance", "", "tolerance of a converged result", Verified(|v| some(v.tolerance))))),
    part(means("beyond it a result depends on the step", quantity("z_limit", "", "limit of |z|", Verified(|v| some(v.z_limit))))),
    part(quantity("step_us", "us", "step", Verified(|v| some(v.step_s * 1e6)))),
    part(quantity("divergence_time_s", "s", "Lyapunov time", Verified(|v| v.divergence.divergence_time_s.into()))),
    part(quantity("predictability_time_s", "s", "predictability of the trajectories", Verified(|v| v.divergence.predictability_time_s.into()))),
    part(in_tables(text("predictability", "predictability", Verified(|v| Cell::Text(predictability(&v.divergence, v.duration_s)))))),
    part(quantity("growth", "", "growth of the distance of perturbed runs", Verified(|v| some(v.divergence.growth)))),
    part(low(means(ENERGY_RESIDUAL, quantity("energy_residual_relative", "", "energy balance error (relative)", Verified(|v| some(v.energy_residual_relative[0])))))),
    part(quantity("energy_residual_relative_half_step", "", "  at half the step", Verified(|v| some(v.energy_residual_relative[1])))),
    part(low(means("error of the momentum balance over the sum of the absolute impulses", quantity("momentum_residual_relative", "", "momentum balance error (relative)", Verified(|v| some(v.momentum_residual_relative[0])))))),
    part(quantity("momentum_residual_relative_half_step", "", "  at half the step", Verified(|v| some(v.momentum_residual_relative[1])))),
];

/// The verification of a drop in one bearing.
#[rustfmt::skip]
pub const DROP_VERIFICATION: &[Quantity] = &[
    part(high(integer("converged", "converged results", DropVerified(|v| count(v.count(Convergence::Converged)))))),
    part(integer("statistical", "chaotic but statistically consistent results", DropVerified(|v| count(v.count(Convergence::Statistical))))),
    part(low(integer("step_biased", "results that depend on the step size", DropVerified(|v| count(v.count(Convergence::StepBiased)))))),
    part(quantity("step_s", "s", "step", DropVerified(|v| some(v.step_s)))),
    part(means("as many again at half the step", integer("replicas", "drops at the step", DropVerified(|v| count(v.replicas))))),
    part(means("fraction of its value by which a converged result may change", quantity("tolerance", "", "tolerance of a converged result", DropVerified(|_| some(ALLOWED))))),
    part(means("beyond it a result depends on the step", quantity("z_limit", "", "limit of |z|", DropVerified(|v| some(v.z_limit))))),
    part(in_tables(text("end_states", "states at the end", DropVerified(|v| states(&v.end_states))))),
    part(in_tables(text("half_step_end_states", "  at half the step", DropVerified(|v| states(&v.half_step_end_states))))),
];

/// The verification of a drop of a rotor in several bearings.
#[rustfmt::skip]
pub const ROTOR_VERIFICATION: &[Quantity] = &[
    part(range("rotor_energy_residual_relative", "", "energy balance error of the rotor (relative), at the step and at half of it", RotorVerified(|e| Cell::Numbers(e.to_vec())))),
];

/// Results of a run that its verification judges, in the order of [`cageless::verification::Quantity::ALL`].
#[rustfmt::skip]
pub const VERIFIED: &[Quantity] = &[
    part(means(COLLISIONS, integer("collisions", "collisions between balls", Si(|v| some(*v))))),
    part(quantity("gap_min_deg", "deg", "smallest gap", Si(|v| degrees(*v)))),
    part(quantity("gap_max_deg", "deg", "largest gap", Si(|v| degrees(*v)))),
    part(quantity("ring_x_mean_um", "um", "mean displacement of the inner ring, x", Si(|v| some(v * 1e6)))),
    part(quantity("ring_y_mean_um", "um", "mean displacement of the inner ring, y", Si(|v| some(v * 1e6)))),
    part(quantity("sliding_max_m_s", "m/s", "largest sliding speed under load", Si(|v| some(*v)))),
    part(quantity("ring_x_um_std", "um", "standard deviation of the displacement of the inner ring, x", Si(|v| some(v * 1e6)))),
    part(quantity("ring_y_um_std", "um", "standard deviation of the displacement of the inner ring, y", Si(|v| some(v * 1e6)))),
    part(quantity("orbit_speed_rad_s_mean", "rad/s", "orbital speed of the balls, mean", Si(|v| some(*v)))),
    part(quantity("rotation_rad_s_mean", "rad/s", "rotational speed of the balls, mean", Si(|v| some(*v)))),
    part(quantity("inner_force_max_n", "N", "largest force at the inner raceway", Si(|v| some(*v)))),
    part(quantity("outer_force_max_n", "N", "largest force at the outer raceway", Si(|v| some(*v)))),
    part(quantity("power_loss_w", "W", "power loss, mean", Si(|v| some(*v)))),
    part(quantity("friction_torque_n_m", "N m", "friction torque, mean", Si(|v| some(*v)))),
    part(means(LAG, quantity("lag_per_pass_deg", "deg", "lag of a ball per pass of a discrete raceway, mean", Si(|v| degrees(*v))))),
    part(quantity("ring_x_um_end", "um", "displacement of the inner ring at the end, x", Si(|v| some(v * 1e6)))),
    part(quantity("ring_y_um_end", "um", "displacement of the inner ring at the end, y", Si(|v| some(v * 1e6)))),
    part(quantity("ball_1_angle_deg_end", "deg", "angular position ψ of ball 1 at the end", Si(|v| degrees(*v)))),
];

/// The judgement of one result, in its unit.
#[rustfmt::skip]
pub const JUDGEMENT: &[Quantity] = &[
    part(text("name", "name", Judged(|j| Cell::Text(j.judgement.quantity.name.to_owned())))),
    part(in_tables(text("label", "result", Judged(|j| Cell::Text(j.judgement.quantity.label.trim().to_owned()))))),
    part(quantity("value", "", "value", Judged(|j| some(j.judgement.value)))),
    part(in_tables(text("unit", "unit", Judged(|j| Cell::Text(j.judgement.quantity.unit_text()))))),
    part(in_tables(text("verdict", "verdict", Judged(|j| Cell::Text(j.judgement.verdict.name().to_owned()))))),
    file_only(quantity("half_step_value", "", "value at half the step", Judged(|j| some(j.judgement.half_step_value)))),
    file_only(quantity("tolerance", "", "largest change of a converged result", Judged(|j| some(j.judgement.tolerance)))),
    file_only(quantity("step_change", "", "largest change with the step", Judged(|j| some(j.judgement.step_change)))),
    file_only(quantity("start_change", "", "largest change by a small perturbation of the start", Judged(|j| some(j.judgement.start_change)))),
    file_only(quantity("mean", "", "mean of the replicas at the step", Judged(|j| some(j.judgement.mean)))),
    file_only(quantity("half_step_mean", "", "mean of the replicas at half the step", Judged(|j| some(j.judgement.half_step_mean)))),
    file_only(quantity("spread", "", "standard deviation of one replica", Judged(|j| some(j.judgement.spread)))),
    file_only(quantity("standard_error", "", "standard error of the mean", Judged(|j| some(j.judgement.standard_error)))),
    file_only(quantity("z", "", "difference of the means over its standard error", Judged(|j| some(j.judgement.z)))),
    part(in_tables(text("reason", "reason", Judged(|j| Cell::Text(j.reason()))))),
];

/// Distances of the replicas from the run over time.
#[rustfmt::skip]
pub const DISTANCE: &[Quantity] = &[
    part(list("time_s", "s", "time", Distance(|d| Cell::Numbers(d.iter().map(|row| row.time_s).collect())))),
    part(list("perturbed", "", "distance of perturbed runs over the scales", Distance(|d| Cell::Numbers(d.iter().map(|row| row.perturbed).collect())))),
    part(list("half_step", "", "distance of the run at half the step over the scales", Distance(|d| Cell::Numbers(d.iter().map(|row| row.half_step).collect())))),
];

fn states(states: &[String]) -> Cell {
    let cells = states.iter().map(|state| Cell::Text(state.clone()));
    Cell::List(cells.collect())
}

/// Lyapunov time and predictability as a sentence.
fn predictability(d: &Divergence, duration_s: f64) -> String {
    let growth = match (d.divergence_time_s, d.fitted_over_s) {
        (Some(time), Some([from, to])) => format!(
            "Lyapunov time {:.2} ms (fitted from {:.1} ms to {:.1} ms)",
            time * 1e3,
            from * 1e3,
            to * 1e3
        ),
        _ => format!(
            "the run does not diverge: the distance of perturbed runs grows by a factor of {:.1} at most",
            d.growth
        ),
    };
    let limit = match (d.predictability_time_s, d.loss) {
        (Some(time), Some(loss)) => format!(
            "trajectories predictable for {} ms, until {} reaches {DECORRELATED} of the scales",
            significant(time * 1e3, 3),
            match loss {
                Loss::Step => "the distance to the run at half the step",
                Loss::Start => "the distance of perturbed runs",
            }
        ),
        _ => format!(
            "trajectories predictable to the end, {} s: no distance reaches {DECORRELATED} of the scales",
            duration_s
        ),
    };
    format!("{growth}; {limit}")
}
