//! Results of one of several drops one after the other.

use crate::limited::limited;
use crate::table::SUCCESSION;
use crate::{DropResult, Record, Results, Subject, SuccessiveDrop};

/// Results of one of several drops one after the other, with those of the drop itself; its verdict is
/// that of the drop with the limits that concern the succession.
pub fn succession_record(mut drop: SuccessiveDrop<'_>, result: &DropResult) -> Record {
    drop.judgement = result.judgement.clone();
    let judged = Results::of(SUCCESSION, Subject::Succession(&drop));
    drop.judgement = limited(drop.judgement, &drop.case.limits, &judged);
    Record::from(Results::of(SUCCESSION, Subject::Succession(&drop)))
        .with_sentences("reasons", drop.judgement.reasons)
        .with_part("result", Some(Record::from(result.results.clone())))
}
