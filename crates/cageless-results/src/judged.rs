//! Results that a verification judges.

use cageless::verification::{Convergence, Judgement};

use crate::number_text::rounded;
use crate::unit::{printed, unit_text};

/// Name, label and unit of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named {
    /// Name with the unit at its end.
    pub name: &'static str,
    /// Wording for readers.
    pub label: &'static str,
    /// Unit in ASCII; empty if there is none.
    pub unit: &'static str,
}

impl Named {
    /// The unit with its symbols.
    pub fn unit_text(&self) -> String {
        unit_text(self.unit)
    }
}

/// The judgement of one result, in its unit.
pub struct JudgedResult {
    /// The judgement.
    pub judgement: Judgement<Named>,
    /// Drops or runs at the step.
    pub replicas: usize,
    /// |z| beyond which a result depends on the step.
    pub z_limit: f64,
    /// Whether perturbed runs diverge.
    pub diverges: bool,
}

impl JudgedResult {
    /// The reason of the verdict as a sentence, in the unit of readers.
    pub(crate) fn reason(&self) -> String {
        let (j, z_limit) = (&self.judgement, self.z_limit);
        let (factor, suffix) = match printed(&j.quantity.unit_text()) {
            (factor, unit) if unit.is_empty() => (factor, unit),
            (factor, unit) => (factor, format!(" {unit}")),
        };
        let [mean, error, spread] = [j.mean, j.standard_error, j.spread].map(|v| factor * v);
        let [step, start] = [j.step_change, j.start_change].map(|v| factor * v);
        let (half_step, allowed) = (factor * j.half_step_mean - mean, factor * j.tolerance);
        let known = format!(
            "{} ± {error:.1e}{suffix} over {} starts, each ± {spread:.1e}{suffix}",
            rounded(mean, error),
            self.replicas,
        );
        match j.verdict {
            Convergence::Converged => {
                let systematic = match j.z.abs() > z_limit && self.diverges {
                    true => format!("; significant dependence on the step (z = {:.1})", j.z),
                    false => String::new(),
                };
                format!(
                    "changes by {step:.1e}{suffix} with the step and {start:.1e}{suffix} with the start, \
                     at most {allowed:.1e}{suffix} allowed{systematic}"
                )
            }
            Convergence::Statistical if j.beyond_predictability => format!(
                "value at one instant beyond the predictability time, one sample of {known}; \
                 z = {:.1} at half the step",
                j.z
            ),
            Convergence::Statistical => format!(
                "{known}; z = {:.1} at half the step, within ±{z_limit:.1}",
                j.z
            ),
            Convergence::StepBiased if j.z.abs() < 1e3 => format!(
                "half the step changes the mean by {half_step:+.1e}{suffix}, z = {:.1} beyond \
                 ±{z_limit:.1}; {known}",
                j.z
            ),
            Convergence::StepBiased => format!(
                "half the step changes it by {step:.1e}{suffix}, more than the {allowed:.1e}{suffix} allowed \
                 and far more than the perturbed starts ({spread:.1e}{suffix})"
            ),
        }
    }
}

/// The verification of a drop in one bearing.
pub struct VerifiedDrop {
    /// Step of the drop, s.
    pub step_s: f64,
    /// Drops at the step, and as many at half of it.
    pub replicas: usize,
    /// |z| beyond which a result depends on the step.
    pub z_limit: f64,
    /// Judgements of the scalar results that every drop has.
    pub judgements: Vec<Judgement<Named>>,
    /// State at the end of the drops at the step.
    pub end_states: Vec<String>,
    /// State at the end of the drops at half the step.
    pub half_step_end_states: Vec<String>,
}

impl VerifiedDrop {
    pub(crate) fn count(&self, verdict: Convergence) -> usize {
        let of_verdict = self.judgements.iter().filter(|j| j.verdict == verdict);
        of_verdict.count()
    }
}
