//! Results of a verification.

use cageless::verification::{Convergence, Distance, Judgement, Verification};

use crate::judged::{JudgedResult, Named, VerifiedDrop};
use crate::table::{DISTANCE, DROP_VERIFICATION, JUDGEMENT, VERIFICATION, VERIFIED};
use crate::{Cell, Part, Quantity, Record, Subject};

/// Rows of the distances over time, about.
const ROWS: usize = 250;

/// The judgement of an SI result in the unit of its row.
fn in_unit<Q>(j: &Judgement<Q>, quantity: &'static Quantity) -> Judgement<Named> {
    let to = |si: f64| {
        let cell = quantity.of(Subject::Si(&si));
        cell.as_ref().and_then(Cell::number).unwrap_or(f64::NAN)
    };
    Judgement {
        quantity: quantity.named(),
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
    let numbers = v.judgements.iter();
    let numbers = numbers.fold(Record::default(), |numbers, judgement| {
        let quantity = &VERIFIED[judgement.quantity as usize];
        let result = JudgedResult {
            judgement: in_unit(judgement, quantity),
            replicas: v.replicas,
            z_limit: v.z_limit,
            diverges: v.divergence.divergence_time_s.is_some(),
        };
        numbers.with_part(
            quantity.name,
            Some(Record::of(JUDGEMENT, Subject::Judged(&result))),
        )
    });
    let stride = v.divergence.distances.len().div_ceil(ROWS).max(1);
    let distances = v.divergence.distances.iter().step_by(stride).copied();
    let distances: Vec<Distance> = distances.collect();
    let distance = Record::of(DISTANCE, Subject::Distance(&distances));
    Record::of(VERIFICATION, Subject::Verified(v))
        .with_part("numbers", Some(numbers))
        .with_part("distance", Some(distance))
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

impl VerifiedDrop {
    /// Results of the verification, with the judgement of each of the `numbers`.
    pub fn record(&self) -> Record {
        let numbers = self.judgements.iter().map(|judgement| {
            let result = JudgedResult {
                judgement: *judgement,
                replicas: self.replicas,
                z_limit: self.z_limit,
                diverges: false,
            };
            Record::of(JUDGEMENT, Subject::Judged(&result))
        });
        Record::of(DROP_VERIFICATION, Subject::DropVerified(self))
            .with_part("numbers", Part::Many(numbers.collect()))
    }
}
