//! Limits of a user on the results of a drop.

use cageless::touchdown::Limit;

use crate::table::{DROP, SUCCESSION, milliseconds};
use crate::{Aim, DropJudgement, Quantity, Results};

/// The verdict with those of the limits that concern a drop with these results.
pub(crate) fn limited(
    mut judgement: DropJudgement,
    limits: &[Limit],
    results: &Results,
) -> DropJudgement {
    for limit in limits {
        let mut all = DROP.iter().chain(SUCCESSION);
        let Some(quantity) = all.find(|q| q.name == limit.result) else {
            continue;
        };
        add(&mut judgement, limit, quantity, results);
    }
    judgement
}

/// The verdict on a drop in succession: limits on its results are judged by these.
pub(crate) fn limited_in_succession(
    mut judgement: DropJudgement,
    limits: &[Limit],
    results: &Results,
) -> DropJudgement {
    for limit in limits {
        let of_drop = DROP.iter().any(|q| q.name == limit.result);
        let found = results
            .iter()
            .find(|(q, _)| q.name == limit.result && !of_drop);
        if let Some((quantity, _)) = found {
            judgement.judge_again(quantity.name);
            add(&mut judgement, limit, quantity, results);
        }
    }
    judgement
}

fn add(judgement: &mut DropJudgement, limit: &Limit, quantity: &Quantity, results: &Results) {
    let least = quantity.aim == Some(Aim::High);
    let by_magnitude = quantity.is_limited_in_magnitude();
    let negative = results
        .value(quantity.name)
        .is_some_and(|value| value < 0.0);
    let side = match (least, by_magnitude && negative) {
        (true, _) => "at least",
        (false, true) => "in magnitude at most",
        (false, false) => "at most",
    };
    let text = |value: f64| quantity.with_unit(value);
    let (label, source) = (quantity.label.trim(), &limit.source);
    let allowed = format!("{side} {} ({source})", text(limit.value));
    if let Some(value) = results.value(quantity.name) {
        if value.is_nan() {
            let text =
                format!("{label} is not known, so that its limit cannot be judged: {allowed}");
            judgement.not_judged(quantity.name, text);
            return;
        }
        let exceeded = match (least, by_magnitude) {
            (true, _) => value < limit.value,
            (false, true) => value.abs() > limit.value,
            (false, false) => value > limit.value,
        };
        judgement.limit(exceeded, format!("{label} {}, {allowed}", text(value)));
        return;
    }
    if quantity.occurs && !least {
        judgement.limit(false, format!("{label} none, {allowed}"));
        return;
    }
    let end_ms = results.value("simulated_s").map(milliseconds);
    let missing = match end_ms.filter(|_| quantity.awaited) {
        Some(end_ms) => {
            let so_far = format!("{label} not reached within {}", text(end_ms));
            if !least && end_ms > limit.value {
                judgement.limit(true, format!("{so_far}, {allowed}"));
                return;
            }
            format!("{so_far} (solver.duration_s)")
        }
        None if results.get(quantity.name).is_none() => {
            format!("{label} is computed of drops in succession alone (drop --drops)")
        }
        None => format!("{label} has no value in this drop"),
    };
    judgement.not_judged(
        quantity.name,
        format!("{missing}, so that its limit cannot be judged: {allowed}"),
    );
}
