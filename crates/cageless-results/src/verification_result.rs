//! Results of a verification.

use cageless::verification::{Convergence, Distance, Judgement, Verification};

use crate::number_text::rounded;
use crate::table::{DISTANCE, DROP_VERIFICATION, JUDGEMENT, VERIFICATION, VERIFIED};
use crate::{Cell, Part, Quantity, Record, Results, Subject};

/// Rows of the distances over time, about.
const ROWS: usize = 250;

/// The judgement of one result, in its unit.
pub struct JudgedResult {
    /// The judgement.
    pub judgement: Judgement<&'static Quantity>,
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

fn judged(result: &JudgedResult) -> Record {
    Results::of(JUDGEMENT, Subject::Judged(result)).into()
}

/// The judgement of an SI result in the unit of its row.
fn in_unit<Q>(j: &Judgement<Q>, quantity: &'static Quantity) -> Judgement<&'static Quantity> {
    let to = |si: f64| {
        let cell = quantity.of(Subject::Si(&si));
        cell.as_ref().and_then(Cell::number).unwrap_or(f64::NAN)
    };
    Judgement {
        quantity,
        verdict: j.verdict,
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
        beyond_predictability: j.beyond_predictability,
    }
}

/// Results of the verification of a run, with the judgement of each of the `numbers` by its name and
/// the `distance` of the replicas over time.
pub fn verification_record(v: &Verification) -> Record {
    let numbers = v.judgements.iter().zip(VERIFIED);
    let numbers = numbers.fold(Record::default(), |numbers, (judgement, quantity)| {
        let result = JudgedResult {
            judgement: in_unit(judgement, quantity),
            replicas: v.replicas,
            z_limit: v.z_limit,
            diverges: v.divergence.divergence_time_s.is_some(),
        };
        numbers.with_part(quantity.name, Some(judged(&result)))
    });
    let stride = v.divergence.distances.len().div_ceil(ROWS).max(1);
    let distances = v.divergence.distances.iter().step_by(stride).copied();
    let distances: Vec<Distance> = distances.collect();
    let distance = Results::of(DISTANCE, Subject::Distance(&distances));
    Record::from(Results::of(VERIFICATION, Subject::Verified(v)))
        .with_part("numbers", Some(numbers))
        .with_part("distance", Some(distance.into()))
}

/// Names of the results of a run that depend on the step, as a warning.
pub fn step_warning(verification: &Record) -> Option<String> {
    let numbers = verification.part("numbers")?.members();
    let biased = numbers.filter(|n| n.text("verdict") == Convergence::StepBiased.name());
    let biased: Vec<&str> = biased.map(|n| n.text("name")).collect();
    (!biased.is_empty()).then(|| {
        format!(
            "dependent on the step beyond scatter: {}; set solver.step_us to {} and verify again",
            biased.join(", "),
            verification.number("step_us") / 2.0
        )
    })
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
    pub judgements: Vec<Judgement<&'static Quantity>>,
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

    /// Results of the verification, with the judgement of each of the `numbers`.
    pub fn record(&self) -> Record {
        let numbers = self.judgements.iter().map(|judgement| {
            judged(&JudgedResult {
                judgement: *judgement,
                replicas: self.replicas,
                z_limit: self.z_limit,
                diverges: false,
            })
        });
        Record::from(Results::of(DROP_VERIFICATION, Subject::DropVerified(self)))
            .with_part("numbers", Part::Many(numbers.collect()))
    }
}
