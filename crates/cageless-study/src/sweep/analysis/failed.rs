//! Reasons of failed variants.

use std::collections::BTreeMap;

use super::result::FailureGroup;
use cageless_results::{Cell, Computation};

use super::table::Table;
use crate::StudyError;

/// Largest number of distinct reasons; further ones count as the last.
const GROUPS_MAX: usize = 20;

/// Failed variants by their reason, the most frequent first.
pub(super) fn groups(table: &Table) -> Result<Vec<FailureGroup>, StudyError> {
    let mut groups: BTreeMap<String, FailureGroup> = BTreeMap::new();
    table.each(&[0, table.reason], |row| {
        let [index, Cell::Text(reason)] = row.as_slice() else {
            return;
        };
        let mut kind = without_numbers(reason);
        if groups.len() >= GROUPS_MAX && !groups.contains_key(&kind) {
            kind = String::new();
        }
        let group = groups.entry(kind).or_insert_with(|| FailureGroup {
            count: 0,
            variant: index.number().unwrap_or(0.0) as u64,
            reason: reason.clone(),
        });
        group.count += 1;
    })?;
    let mut groups: Vec<_> = groups.into_values().collect();
    groups.sort_by_key(|group| (std::cmp::Reverse(group.count), group.variant));
    Ok(groups)
}

/// Whether the reason of a row says that this computation failed.
pub(super) fn failed(reason: &str, computation: Computation) -> bool {
    let own = format!("{}: ", computation.name());
    reason.starts_with(&own) || reason.contains(&format!("; {own}"))
}

/// Whether the reason of a row says that a computation failed; else its case is impossible.
pub(super) fn is_of_computation(reason: &str) -> bool {
    Computation::ALL.iter().any(|c| failed(reason, *c))
}

/// Reason without its numbers.
fn without_numbers(reason: &str) -> String {
    let kept = |c: &char| !c.is_ascii_digit() && !matches!(c, '.' | '-' | '+');
    reason.chars().filter(kept).collect()
}
