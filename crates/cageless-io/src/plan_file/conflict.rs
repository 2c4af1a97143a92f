//! Keys that stand in several places of a plan.

use super::key::{covers, say_the_same};
use super::{Axis, PlanFile};
use crate::arrangement::ArrangementDocument;
use crate::case_file::{CaseError, Change};

/// Refuses two axes of one key or quantity, scattered keys of which one is part of another or of an axis, and
/// changes to `case` in `[set]` that an axis undoes.
pub(super) fn check(
    plan: &PlanFile,
    case: &ArrangementDocument,
    changes: &[Change<'_>],
) -> Result<(), CaseError> {
    let samples = plan.samples.iter().flat_map(|s| &s.axes);
    let axes: Vec<_> = plan.grid.iter().chain(samples).collect();
    if let Some((one, other)) = twice(&axes) {
        let message = if one.key == other.key {
            format!(
                "{} varies on line {} already: an axis belongs to the grid or to the samples",
                other.key, one.line
            )
        } else {
            overlap(&other.key, &one.key, one.line)
        };
        return Err(plan.error(other.line, &other.key, message));
    }
    let scattered: Vec<_> = plan.scatter.iter().flat_map(|s| &s.keys).collect();
    for (k, key) in scattered.iter().enumerate() {
        let axes = axes.iter().map(|axis| (&axis.key, axis.line));
        let before = scattered[..k].iter().map(|key| (&key.key, key.line));
        // The deviations of an axis are about its values.
        let mut others = axes.chain(before).filter(|(other, _)| **other != key.key);
        if let Some((other, line)) = others.find(|(other, _)| meet(&key.key, other)) {
            let message = overlap(&key.key, other, line);
            return Err(plan.error(key.line, &key.key, message));
        }
    }
    for change in changes {
        let mut axes = axes.iter();
        // A clearance takes the pitch diameter of groove radii.
        let undoes = |axis: &str| say_the_same(axis, change.key) && !axis.ends_with("clearance_um");
        let varied = axes.find(|axis| covers(&axis.key, change.key) || undoes(&axis.key));
        if let Some(axis) = varied.filter(|_| is_possible_without(case, changes, change.key)) {
            let what = match covers(&axis.key, change.key) {
                true => "varies".to_owned(),
                false => format!("is given by {}, which varies", axis.key),
            };
            let message = format!(
                "{} {what} on line {}: its value in [set] has no effect, leave it out",
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
        let other = others.find(|other| meet(&one.key, &other.key))?;
        Some((*one, *other))
    })
}

/// Whether there is a case without this one of the changes.
fn is_possible_without(case: &ArrangementDocument, changes: &[Change<'_>], key: &str) -> bool {
    let others = changes.iter().filter(|change| change.key != key);
    let others: Vec<_> = others.copied().collect();
    case.with(&others).is_ok()
}

/// Whether two keys replace the same value.
fn meet(one: &str, other: &str) -> bool {
    covers(one, other) || covers(other, one) || say_the_same(one, other)
}

/// The message of a key that meets another on `line`.
fn overlap(key: &str, other: &str, line: usize) -> String {
    if say_the_same(key, other) {
        return format!("{key} and {other} on line {line} both say the same: vary one of them");
    }
    if covers(key, other) && covers(other, key) {
        return format!("{key} and {other} on line {line} are one key: vary one of them");
    }
    format!(
        "{key} is a part of {other} on line {line}, or the other way round: vary the key of all \
         bearings, or that of each"
    )
}
