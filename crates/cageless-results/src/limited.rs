//! Limits of a user on the results of a drop.

use cageless::touchdown::Limit;

use crate::{Aim, DropJudgement, Results};

/// The verdict with those of the limits that concern these results.
pub(crate) fn limited(
    mut judgement: DropJudgement,
    limits: &[Limit],
    results: &Results,
) -> DropJudgement {
    for limit in limits {
        let found = results.iter().find(|(q, _)| q.name == limit.result);
        let Some((quantity, value)) = found.and_then(|(q, cell)| Some((q, cell.number()?))) else {
            continue;
        };
        let (side, exceeded) = match quantity.aim {
            Some(Aim::High) => ("at least", value < limit.value),
            _ => ("at most", value > limit.value),
        };
        let [value, bound] = [value, limit.value].map(|v| quantity.number_text(v));
        let unit = match quantity.printed_unit() {
            unit if unit.is_empty() => unit,
            unit => format!(" {unit}"),
        };
        let label = quantity.label.trim();
        let text = format!(
            "{label} {value}{unit}, {side} {bound}{unit} ({})",
            limit.source
        );
        judgement.limit(exceeded, text);
    }
    judgement
}
