//! Numerical verification of a run: which results are converged.
//!
//! The run is repeated from perturbed initial states and at half the step
//! ([`replicas`]). Each replica is run by [`Replica::run`], or by the caller
//! with a [`ReplicaObserver`] among its observers, in any order and on any thread;
//! [`Verification::new`] compares the [`Record`]s and classifies each headline result as
//! [converged](Convergence::Converged), [statistical](Convergence::Statistical) or
//! [biased by the step](Convergence::StepBiased). Definitions and limits: `docs/theory/verification.md`.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::verification::replicas;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! // The run, its replicas from slightly and strongly perturbed starts, and those at half the step.
//! let runs = replicas(&case, 0, 2);
//! assert!(runs.iter().any(|replica| replica.role.half_step));
//! ```

mod convergence;
mod divergence;
mod momentum;
mod motion;
mod quantity;
mod replica;
mod trajectory;

pub use convergence::{Convergence, Judgement};
pub use divergence::{DECORRELATED, Distance, Divergence, Loss};
pub use quantity::Quantity;
pub use replica::{Perturbation, Record, Replica, ReplicaError, ReplicaObserver, Role, replicas};

use crate::case::Case;
use crate::error::InputError;
use crate::numerics::student::two_sided_limit;

/// Default number of large perturbations.
pub const LARGE_PERTURBATIONS: usize = 4;
/// Fraction of its scale by which a converged result may change.
pub const TOLERANCE: f64 = 1e-3;
/// Probability that chance alone calls an unbiased number biased: that of three standard
/// deviations of a normal distribution.
const FALSE_ALARM: f64 = 0.0027;

/// Judges one result from its values in all [`replicas`]: that of the run itself first. A converged
/// one changes by [`TOLERANCE`] of `scale` at most; one that is `lost` lies beyond the
/// predictability time.
///
/// # Panics
/// If the values are not those of `replicas(case, seed, large)`, large ≥ 1.
pub fn judge<Q>(quantity: Q, values: &[(Role, f64)], scale: f64, lost: bool) -> Judgement<Q> {
    let [perturbed, full, half] = samples(values, |(role, _)| *role)
        .map(|sample| -> Vec<f64> { sample.into_iter().map(|(_, value)| *value).collect() });
    let samples = convergence::Samples {
        perturbed: &perturbed,
        full: &full,
        half: &half,
    };
    let limit = z_limit(full.len());
    Judgement::new(quantity, &samples, TOLERANCE * scale, limit, lost)
}

/// |z| above which a number from so many runs at either step is biased.
pub fn z_limit(replicas: usize) -> f64 {
    two_sided_limit(FALSE_ALARM, 2 * replicas - 2)
}

/// Replicas that are compared with each other: given start and small perturbations; given start and
/// large perturbations; the same at half the step.
const SAMPLES: [fn(Role) -> bool; 3] = [
    |role| !role.half_step && role.perturbation != Perturbation::Large,
    |role| !role.half_step && role.perturbation != Perturbation::Small,
    |role| role.half_step,
];

fn samples<T>(records: &[T], role: impl Fn(&T) -> Role) -> [Vec<&T>; 3] {
    SAMPLES.map(|wanted| {
        let found: Vec<&T> = records.iter().filter(|r| wanted(role(r))).collect();
        assert!(found.len() >= 2, "records of all replicas");
        found
    })
}

/// Verification of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// Step of the verified run, s.
    pub step_s: f64,
    /// Simulated time.
    pub duration_s: f64,
    /// Samples at the step, and as many at half of it: the given start and the far ones.
    pub replicas: usize,
    /// Fraction of its scale by which a converged result may change.
    pub tolerance: f64,
    /// |z| above which a number is biased: Student's limit for [`Self::replicas`] runs at
    /// either step, as probable as three standard deviations are for many runs.
    pub z_limit: f64,
    /// One for each [`Quantity`] that the case has, in the order of `Quantity::ALL`.
    pub judgements: Vec<Judgement>,
    /// Divergence of the replicas.
    pub divergence: Divergence,
    /// Energy balance error relative to the sum of absolute flows, at the step and at half
    /// the step.
    pub energy_residual_relative: [f64; 2],
    /// Momentum that the external forces do not account for over the sum of their absolute
    /// impulses, at the step and at half of it.
    pub momentum_residual_relative: [f64; 2],
}

impl Verification {
    /// Judges the run from the records of all [`replicas`], in their order.
    ///
    /// # Errors
    /// The case is impossible.
    ///
    /// # Panics
    /// If the records are not those of `replicas(case, seed, far)`, far ≥ 1.
    pub fn new(case: &Case, records: &[Record]) -> Result<Self, InputError> {
        let [perturbed, full, half] = samples(records, |r| r.role);
        let divergence = Divergence::new(case, &perturbed, half[0])?;
        // What no run of the case has is not judged.
        let has = |quantity: &Quantity| records.iter().any(|r| !r.value(*quantity).is_nan());
        let judgements = Quantity::ALL
            .into_iter()
            .filter(has)
            .map(|quantity| {
                let values: Vec<_> = (records.iter())
                    .map(|r| (r.role, r.value(quantity)))
                    .collect();
                let scale = quantity.scale(case, full[0].value(quantity));
                let lost = quantity.is_point() && divergence.predictability_time_s.is_some();
                judge(quantity, &values, scale, lost)
            })
            .collect();
        Ok(Self {
            step_s: case.solver.step_s,
            duration_s: case.solver.duration_s,
            replicas: full.len(),
            tolerance: TOLERANCE,
            z_limit: z_limit(full.len()),
            judgements,
            divergence,
            energy_residual_relative: [
                full[0].energy_residual_relative,
                half[0].energy_residual_relative,
            ],
            momentum_residual_relative: [
                full[0].momentum_residual_relative,
                half[0].momentum_residual_relative,
            ],
        })
    }

    /// Number of results classified as `verdict`.
    pub fn count(&self, verdict: Convergence) -> usize {
        self.judgements
            .iter()
            .filter(|j| j.verdict == verdict)
            .count()
    }

    /// Statistics of one result; `None` of one that the case does not have.
    #[cfg(test)]
    pub(crate) fn judgement(&self, quantity: Quantity) -> Option<&Judgement> {
        self.judgements.iter().find(|j| j.quantity == quantity)
    }
}
