//! The `verification` of `summary.json`.

use std::collections::BTreeMap;

use cageless::verification::{Convergence, DECORRELATED, Judgement, Loss, Quantity, Verification};
use serde::Serialize;

/// Verification of a run, in the units of `summary.json`. A number that is not finite
/// becomes `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VerificationFile {
    /// Number of results that change neither with the step nor with the start.
    pub converged: usize,
    /// Number of results that change with the initial state only.
    pub statistical: usize,
    /// Number of results biased by the step.
    pub step_biased: usize,
    /// Number of samples at the step, and as many at half the step.
    pub replicas: usize,
    /// Fraction of its scale by which a converged result may change.
    pub tolerance: f64,
    /// |z| above which a result counts as biased.
    pub z_limit: f64,
    /// Step of the run, µs.
    pub step_us: f64,
    /// Lyapunov time; absent if the run does not diverge.
    pub divergence_time_s: Option<f64>,
    /// Time after which trajectories are unpredictable; absent if not within the run.
    pub predictability_time_s: Option<f64>,
    /// Lyapunov time and predictability as a sentence.
    pub predictability: String,
    /// Largest distance of perturbed runs over the first.
    pub growth: f64,
    /// Energy balance error, relative to the sum of all energy flows.
    pub energy_residual_relative: f64,
    /// Energy balance error at half the step.
    pub energy_residual_relative_half_step: f64,
    /// Momentum balance error, relative to the sum of absolute impulses.
    pub momentum_residual_relative: f64,
    /// Momentum balance error at half the step.
    pub momentum_residual_relative_half_step: f64,
    /// Results by key.
    pub numbers: BTreeMap<String, VerificationNumber>,
    /// Distances from the run over time.
    pub distance: DistanceColumns,
}

/// Verification of one result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VerificationNumber {
    /// `converged`, `statistical` or `step-biased`.
    pub verdict: String,
    /// Unit of all following values except `z`.
    pub unit: String,
    /// Value of the run.
    pub value: f64,
    /// Value at half the step.
    pub half_step_value: f64,
    /// Largest change of a converged result.
    pub tolerance: f64,
    /// Largest change with the step.
    pub step_change: f64,
    /// Largest change by a small perturbation of the start.
    pub start_change: f64,
    /// Mean of the samples at the step.
    pub mean: f64,
    /// Mean over the samples at half the step.
    pub half_step_mean: f64,
    /// Standard deviation of one sample.
    pub spread: f64,
    /// Standard error of `mean`.
    pub standard_error: f64,
    /// Difference of the means over its standard error.
    pub z: f64,
    /// Reason as a sentence.
    pub reason: String,
    /// Place in tables.
    #[serde(skip)]
    pub rank: usize,
}

/// Distances of the replicas from the run, columns of equal length.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DistanceColumns {
    /// Time.
    pub time_s: Vec<f64>,
    /// Near starts.
    pub perturbed: Vec<f64>,
    /// Half the step.
    pub half_step: Vec<f64>,
}

/// Approximate number of rows of [`DistanceColumns`].
const ROWS: usize = 250;

/// Key, unit and factor from SI.
fn display(quantity: Quantity) -> (&'static str, &'static str, f64) {
    let degrees = 1f64.to_degrees();
    match quantity {
        Quantity::Collisions => ("collisions", "1", 1.0),
        Quantity::GapMin => ("gap_min_deg", "°", degrees),
        Quantity::GapMax => ("gap_max_deg", "°", degrees),
        Quantity::RingXMean => ("ring_x_mean_um", "µm", 1e6),
        Quantity::RingYMean => ("ring_y_mean_um", "µm", 1e6),
        Quantity::SlipMax => ("sliding_max_m_s", "m/s", 1.0),
        Quantity::RingXDeviation => ("ring_x_um_std", "µm", 1e6),
        Quantity::RingYDeviation => ("ring_y_um_std", "µm", 1e6),
        Quantity::OrbitSpeedMean => ("orbit_speed_rad_s_mean", "rad/s", 1.0),
        Quantity::SpinMean => ("rotation_rad_s_mean", "rad/s", 1.0),
        Quantity::RingXEnd => ("ring_x_um_end", "µm", 1e6),
        Quantity::RingYEnd => ("ring_y_um_end", "µm", 1e6),
        Quantity::LeadBallAngleEnd => ("ball_1_angle_deg_end", "°", degrees),
    }
}

impl VerificationFile {
    /// Verification in the units of `summary.json`.
    pub fn new(c: &Verification) -> Self {
        let d = &c.divergence;
        let stride = d.distances.len().div_ceil(ROWS).max(1);
        let mut distance = DistanceColumns::default();
        for row in d.distances.iter().step_by(stride) {
            distance.time_s.push(row.time_s);
            distance.perturbed.push(row.perturbed);
            distance.half_step.push(row.half_step);
        }
        let numbers = c
            .judgements
            .iter()
            .enumerate()
            .map(|(rank, j)| {
                let (key, unit, factor) = display(j.quantity);
                (key.to_owned(), number(c, j, rank, unit, factor))
            })
            .collect();
        Self {
            converged: c.count(Convergence::Converged),
            statistical: c.count(Convergence::Statistical),
            step_biased: c.count(Convergence::StepBiased),
            replicas: c.replicas,
            tolerance: c.tolerance,
            z_limit: c.z_limit,
            step_us: c.step_s * 1e6,
            divergence_time_s: d.divergence_time_s,
            predictability_time_s: d.predictability_time_s,
            predictability: predictability(c),
            growth: d.growth,
            energy_residual_relative: c.energy_residual_relative[0],
            energy_residual_relative_half_step: c.energy_residual_relative[1],
            momentum_residual_relative: c.momentum_residual_relative[0],
            momentum_residual_relative_half_step: c.momentum_residual_relative[1],
            numbers,
            distance,
        }
    }

    /// Results in the order of tables.
    pub fn ranked(&self) -> Vec<(&str, &VerificationNumber)> {
        let mut numbers: Vec<_> = self.numbers.iter().map(|(k, n)| (k.as_str(), n)).collect();
        numbers.sort_by_key(|(_, n)| n.rank);
        numbers
    }

    /// Warning about results biased by the step, if any.
    pub fn warning(&self) -> Option<String> {
        let biased: Vec<&str> = self
            .ranked()
            .into_iter()
            .filter(|(_, n)| n.verdict == Convergence::StepBiased.name())
            .map(|(key, _)| key)
            .collect();
        (!biased.is_empty()).then(|| {
            format!(
                "dependent on the step beyond scatter: {}; set solver.step_us to {} and verify again",
                biased.join(", "),
                self.step_us / 2.0
            )
        })
    }
}

fn number(
    c: &Verification,
    j: &Judgement,
    rank: usize,
    unit: &str,
    factor: f64,
) -> VerificationNumber {
    let to = |value: f64| value * factor;
    let suffix = if unit == "1" {
        String::new()
    } else {
        format!(" {unit}")
    };
    let known = format!(
        "{} ± {:.1e}{suffix} over {} starts, each ± {:.1e}",
        rounded(to(j.mean), to(j.standard_error)),
        to(j.standard_error),
        c.replicas,
        to(j.spread)
    );
    let reason = match j.verdict {
        Convergence::Converged => {
            let systematic = if j.z.abs() > c.z_limit && c.divergence.divergence_time_s.is_some() {
                format!("; significant dependence on the step (z = {:.1})", j.z)
            } else {
                String::new()
            };
            format!(
                "changes by {:.1e} with the step and {:.1e} with the start, at most {:.1e}{suffix} \
                 allowed{systematic}",
                to(j.step_change),
                to(j.start_change),
                to(j.tolerance)
            )
        }
        Convergence::Statistical if j.beyond_predictability => format!(
            "value at one instant beyond the predictability time, one sample of {known}; z = {:.1} at half \
             the step",
            j.z
        ),
        Convergence::Statistical => format!(
            "{known}; z = {:.1} at half the step, within ±{:.1}",
            j.z, c.z_limit
        ),
        Convergence::StepBiased if j.z.abs() < 1e3 => format!(
            "half the step changes the mean by {:+.1e}{suffix}, z = {:.1} beyond ±{:.1}; {known}",
            to(j.half_step_mean - j.mean),
            j.z,
            c.z_limit
        ),
        Convergence::StepBiased => format!(
            "half the step changes it by {:.1e}{suffix}, more than the {:.1e} allowed and far more \
             than the perturbed starts ({:.1e})",
            to(j.step_change),
            to(j.tolerance),
            to(j.spread)
        ),
    };
    VerificationNumber {
        verdict: j.verdict.name().to_owned(),
        unit: unit.to_owned(),
        value: to(j.value),
        half_step_value: to(j.half_step_value),
        tolerance: to(j.tolerance),
        step_change: to(j.step_change),
        start_change: to(j.start_change),
        mean: to(j.mean),
        half_step_mean: to(j.half_step_mean),
        spread: to(j.spread),
        standard_error: to(j.standard_error),
        z: j.z,
        reason,
        rank,
    }
}

/// `value` to one digit beyond the first of `error`.
pub fn rounded(value: f64, error: f64) -> String {
    let decimals = if error > 0.0 {
        (1.0 - error.log10().floor()).clamp(0.0, 9.0) as usize
    } else {
        6
    };
    format!("{value:.decimals$}")
}

fn predictability(c: &Verification) -> String {
    let d = &c.divergence;
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
            "trajectories predictable for {:.2} ms, until {} reaches {DECORRELATED} of the scales",
            time * 1e3,
            match loss {
                Loss::Step => "the distance to the run at half the step",
                Loss::Start => "the distance of perturbed runs",
            }
        ),
        _ => format!(
            "trajectories predictable to the end, {} s: no distance reaches {DECORRELATED} of the scales",
            c.duration_s
        ),
    };
    format!("{growth}; {limit}")
}
