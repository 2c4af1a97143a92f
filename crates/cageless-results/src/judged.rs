//! Results that a verification judges.

use cageless::verification::{Convergence, Judgement};

use crate::number_text::{rounded, significant};
use crate::unit::{printed, unit_text, with_unit};

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
        let (factor, unit) = printed(&j.quantity.unit_text());
        let two = |v: f64| with_unit(&significant(factor * v, 2), &unit);
        let half_step = j.half_step_mean - j.mean;
        let sign = if half_step > 0.0 { "+" } else { "" };
        let known = format!(
            "{} ± {} over {} starts, each ± {}",
            rounded(factor * j.mean, factor * j.standard_error),
            two(j.standard_error),
            self.replicas,
            two(j.spread),
        );
        match j.verdict {
            Convergence::Converged => {
                let systematic = match j.z.abs() > z_limit && self.diverges {
                    true => format!("; significant dependence on the step (z = {:.1})", j.z),
                    false => String::new(),
                };
                format!(
                    "changes by {} with the step and {} with the start, at most {} allowed{systematic}",
                    two(j.step_change),
                    two(j.start_change),
                    two(j.tolerance)
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
                "half the step changes the mean by {sign}{}, z = {:.1} beyond ±{z_limit:.1}; {known}",
                two(half_step),
                j.z
            ),
            Convergence::StepBiased => format!(
                "half the step changes it by {}, more than the {} allowed and far more than the perturbed \
                 starts ({})",
                two(j.step_change),
                two(j.tolerance),
                two(j.spread)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn reason(verdict: Convergence, unit: &'static str, mean: f64, change: f64) -> String {
        let quantity = Named {
            name: "a_result",
            label: "a result",
            unit,
        };
        let judgement = Judgement {
            quantity,
            verdict,
            value: mean,
            half_step_value: mean,
            tolerance: 1e-3,
            step_change: change,
            start_change: 0.0,
            mean,
            half_step_mean: mean + change,
            spread: 2e-4,
            standard_error: 1e-4,
            z: 3.0,
            beyond_predictability: false,
        };
        let result = JudgedResult {
            judgement,
            replicas: 5,
            z_limit: 2.5,
            diverges: false,
        };
        result.reason()
    }

    /// Changes are numbers for readers, torques in N·mm, angles without a space before their sign.
    #[test]
    fn reasons_have_the_numbers_and_units_of_readers() {
        assert_eq!(
            reason(Convergence::Converged, "N m", 0.02, 0.0),
            "changes by 0 N·mm with the step and 0 N·mm with the start, at most 1 N·mm allowed"
        );
        assert_eq!(
            reason(Convergence::Converged, "deg", 1.0, 2.5e-7),
            "changes by 2.5 × 10⁻⁷° with the step and 0° with the start, at most 0.001° allowed"
        );
        assert_eq!(
            reason(Convergence::StepBiased, "um", 3.0, -0.125),
            "half the step changes the mean by −0.12 µm, z = 3.0 beyond ±2.5; 3.00000 ± 0.0001 µm over 5 \
             starts, each ± 0.0002 µm"
        );
    }
}
