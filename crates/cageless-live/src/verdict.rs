//! The simulated verdict on the raceways of a case.

use cageless::Case;
use cageless::design::{Criterion, judge};
use cageless::simulation::Control;
use serde_json::{Value, json};

use crate::refusal::Refusal;

/// Judges the raceways of a case as `cageless design` does.
pub(crate) fn verdict(
    case: &Case,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<Value, Refusal> {
    let judgement = judge(case, control)?;
    let worst = judgement
        .raceways
        .iter()
        .find(|r| r.verdict == judgement.verdict);
    let criteria: Vec<Value> = worst
        .map_or(&[][..], |r| &r.criteria)
        .iter()
        .map(|c: &Criterion| {
            json!({
                "name": c.name(), "value": c.value(), "limit": c.limit(), "margin": c.margin(),
                "at_least": c.at_least(), "met": c.is_met(), "text": c.to_string(),
            })
        })
        .collect();
    Ok(json!({
        "verdict": judgement.verdict.name(),
        "label": judgement.verdict.label(),
        "passes": judgement.passes(),
        "headline": judgement.headline(),
        "criterion": judgement.deciding.map(Criterion::name),
        "margin": judgement.deciding.map(Criterion::margin),
        "reasons": judgement.reasons,
        "critical_gap_deg": judgement.critical_gap_rad.map(f64::to_degrees),
        "criteria": criteria,
        "passages": judgement.passages.map(|p| json!({
            "passages": p.passages,
            "collisions_mean": p.collisions_mean,
            "double_collision_fraction": p.double_collision_fraction,
            "slip_mean_m_s": p.slip_mean_m_s,
            "speed_drop_fraction": p.speed_drop_fraction,
            "gap_leave_min_deg": p.gap_leave_min_rad.to_degrees(),
            "gap_leave_max_deg": p.gap_leave_max_rad.to_degrees(),
        })),
        "stopped": judgement.stopped.map(|s| s.to_string()),
    }))
}
