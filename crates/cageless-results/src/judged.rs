//! Results that a verification judges.

use cageless::verification::{Convergence, Judgement};

use crate::number_text::rounded;

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

/// A unit with its symbols.
pub fn unit_text(unit: &str) -> String {
    match unit {
        "deg" => "°".to_owned(),
        "C" => "°C".to_owned(),
        "um" => "µm".to_owned(),
        "us" => "µs".to_owned(),
        "m/s^2" => "m/s²".to_owned(),
        unit => unit.replace(' ', "·"),
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
    /// The reason of the verdict as a sentence.
    pub(crate) fn reason(&self) -> String {
        let (j, z_limit) = (&self.judgement, self.z_limit);
        let suffix = match j.quantity.unit_text() {
            unit if unit.is_empty() => unit,
            unit => format!(" {unit}"),
        };
        let known = format!(
            "{} ± {:.1e}{suffix} over {} starts, each ± {:.1e}",
            rounded(j.mean, j.standard_error),
            j.standard_error,
            self.replicas,
            j.spread
        );
        match j.verdict {
            Convergence::Converged => {
                let systematic = match j.z.abs() > z_limit && self.diverges {
                    true => format!("; significant dependence on the step (z = {:.1})", j.z),
                    false => String::new(),
                };
                format!(
                    "changes by {:.1e} with the step and {:.1e} with the start, at most \
                     {:.1e}{suffix} allowed{systematic}",
                    j.step_change, j.start_change, j.tolerance
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
                "half the step changes the mean by {:+.1e}{suffix}, z = {:.1} beyond \
                 ±{z_limit:.1}; {known}",
                j.half_step_mean - j.mean,
                j.z
            ),
            Convergence::StepBiased => format!(
                "half the step changes it by {:.1e}{suffix}, more than the {:.1e} allowed and far \
                 more than the perturbed starts ({:.1e})",
                j.step_change, j.tolerance, j.spread
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
