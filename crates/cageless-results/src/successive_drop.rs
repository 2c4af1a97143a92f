//! Results of one of several drops one after the other.

use crate::table::SUCCESSION;
use crate::{DropResult, Record, Results, Subject, SuccessiveDrop};

/// Results of one of several drops one after the other, with those of the drop itself, whose verdict
/// from here on has the limits that concern the succession. That of the record has the rotor's as well.
pub fn succession_record(mut drop: SuccessiveDrop<'_>, result: &mut DropResult) -> Record {
    let judged = Results::of(SUCCESSION, Subject::Succession(&drop));
    result.judge_in_succession(&drop.particulars.limits, &judged);
    drop.judgement = result.judgement.clone().with_rotor(drop.rotor);
    Record::of(SUCCESSION, Subject::Succession(&drop))
        .with_sentences("reasons", drop.judgement.reasons())
        .with_part("result", Some(Record::from(result.results.clone())))
}
