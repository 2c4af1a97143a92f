//! Keys that stand in several places of a plan.

use super::{Axis, PlanFile};
use crate::case_file::{CaseBase, CaseError, Change};

/// Refuses two axes of one key, and changes to `case` in `[set]` that an axis undoes.
pub(super) fn check(
    plan: &PlanFile,
    case: &CaseBase,
    changes: &[Change<'_>],
) -> Result<(), CaseError> {
    let samples = plan.samples.iter().flat_map(|s| &s.axes);
    let axes: Vec<_> = plan.grid.iter().chain(samples).collect();
    if let Some((one, other)) = twice(&axes) {
        let message = format!(
            "{} varies on line {} already: an axis belongs to the grid or to the samples",
            other.key, one.line
        );
        return Err(plan.error(other.line, &other.key, message));
    }
    for change in changes {
        let mut axes = axes.iter();
        let varied = axes.find(|axis| plain(&axis.key) == plain(change.key));
        if let Some(axis) = varied.filter(|_| is_possible_without(case, changes, change.key)) {
            let message = format!(
                "{} varies on line {}: its value in [set] has no effect, leave it out",
                change.key, axis.line
            );
            return Err(plan.error(change.place.1, change.key, message));
        }
    }
    Ok(())
}

/// The first two axes of one key.
fn twice<'a>(axes: &[&'a Axis]) -> Option<(&'a Axis, &'a Axis)> {
    axes.iter().enumerate().find_map(|(k, one)| {
        let mut others = axes[k + 1..].iter();
        let other = others.find(|other| plain(&other.key) == plain(&one.key))?;
        Some((*one, *other))
    })
}

/// Whether there is a case without this one of the changes.
fn is_possible_without(case: &CaseBase, changes: &[Change<'_>], key: &str) -> bool {
    let others = changes.iter().filter(|change| change.key != key);
    let others: Vec<_> = others.copied().collect();
    case.with(&others).is_ok()
}

/// The key without the number of the first section, which may be left out.
fn plain(key: &str) -> String {
    key.replacen(".1.", ".", 1)
}
