//! How far the numbers of a run can be trusted.
//!
//! The run is repeated from starts that are turned a little, and at half the step
//! ([`members`]). Each member is run by [`Member::run`], or by the caller
//! with a [`Watch`] among its observers, in any order and on any thread;
//! [`Certificate::new`] compares the [`Record`]s and calls each headline number
//! [converged](Verdict::Converged), [statistical](Verdict::Statistical) or
//! [neither](Verdict::Neither). Definitions and limits: `docs/theory/certificate.md`.

mod divergence;
mod judgement;
mod member;
mod momentum;
mod motion;
mod quantity;
mod trajectory;

pub use divergence::{Distance, Divergence, LOST, Loss};
pub use judgement::{Judgement, Verdict};
pub use member::{
    FAR_RAD, Member, MemberError, NEAR, NEAR_RAD, Record, Role, Turn, Watch, members,
};
pub use quantity::Quantity;

use crate::case::Case;
use crate::error::InputError;
use crate::numerics::student::two_sided_limit;

/// Far starts, by default.
pub const FAR: usize = 4;
/// Share of its scale by which a converged number may change.
pub const TOLERANCE: f64 = 1e-3;
/// Probability that chance alone calls an unbiased number biased: that of three standard
/// deviations of a normal distribution.
const FALSE_ALARM: f64 = 0.0027;

/// The judgement of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// Step of the run that is judged.
    pub step_s: f64,
    /// Simulated time.
    pub duration_s: f64,
    /// Draws at the step, and as many at half of it: the given start and the far ones.
    pub members: usize,
    /// Share of its scale by which a converged number may change.
    pub tolerance: f64,
    /// |z| above which a number is biased: Student's limit for [`Self::members`] runs at
    /// either step, as probable as three standard deviations are for many runs.
    pub z_limit: f64,
    /// One for each [`Quantity`], in the order of [`Quantity::ALL`].
    pub judgements: Vec<Judgement>,
    /// How members part.
    pub divergence: Divergence,
    /// Energy that the ledger misses over the sum of its absolute entries, at the step and at
    /// half of it.
    pub energy_residual_relative: [f64; 2],
    /// Momentum that the external forces do not account for over the sum of their absolute
    /// impulses, at the step and at half of it.
    pub momentum_residual_relative: [f64; 2],
}

impl Certificate {
    /// Judges the run from the records of all [`members`], in their order.
    ///
    /// # Errors
    /// The case is impossible.
    ///
    /// # Panics
    /// If the records are not those of `members(case, far)`, far ≥ 1.
    pub fn new(case: &Case, records: &[Record]) -> Result<Self, InputError> {
        let pick = |wanted: &dyn Fn(&Role) -> bool| -> Vec<&Record> {
            records.iter().filter(|r| wanted(&r.role)).collect()
        };
        let full = pick(&|role| !role.half_step && role.turn != Turn::Near);
        let half = pick(&|role| role.half_step);
        let near = pick(&|role| !role.half_step && role.turn != Turn::Far);
        let count = full.len();
        assert!(
            count >= 2 && half.len() == count && near.len() >= 2,
            "records of all members"
        );
        let divergence = Divergence::new(case, &near, half[0])?;
        let z_limit = two_sided_limit(FALSE_ALARM, 2 * count - 2);
        let judgements = Quantity::ALL
            .into_iter()
            .map(|quantity| {
                let of = |records: &[&Record]| -> Vec<f64> {
                    records.iter().map(|r| r.value(quantity)).collect()
                };
                let draws = judgement::Draws {
                    near: &of(&near),
                    full: &of(&full),
                    half: &of(&half),
                };
                let tolerance = TOLERANCE * quantity.scale(case, draws.full[0]);
                let lost = quantity.is_point() && divergence.predictability_time_s.is_some();
                Judgement::new(quantity, &draws, tolerance, z_limit, lost)
            })
            .collect();
        Ok(Self {
            step_s: case.solver.step_s,
            duration_s: case.solver.duration_s,
            members: count,
            tolerance: TOLERANCE,
            z_limit,
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

    /// How many numbers got `verdict`.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.judgements
            .iter()
            .filter(|j| j.verdict == verdict)
            .count()
    }

    /// The judgement of one number.
    pub fn judgement(&self, quantity: Quantity) -> &Judgement {
        &self.judgements[quantity as usize]
    }
}
