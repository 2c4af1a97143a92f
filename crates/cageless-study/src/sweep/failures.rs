//! The variants of a result that failed.

use std::path::Path;

use cageless_io::results::TableReader;
use cageless_results::Cell;

use super::evaluate::REASON;
use crate::StudyError;

/// Number of failures and the reason of the first.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Failures {
    /// Rows with a reason.
    pub count: u64,
    /// The first reason.
    pub first: Option<String>,
}

/// Counts the failed variants of a result.
///
/// # Errors
/// If it cannot be read.
pub fn failures(result: &Path) -> Result<Failures, StudyError> {
    let table = TableReader::open(result)?;
    let mut failures = Failures::default();
    let Some(reason) = table.columns().iter().position(|c| c.name == REASON) else {
        return Ok(failures);
    };
    for row in table.rows_of(&[reason]) {
        if let [Cell::Text(why)] = row?.as_slice() {
            failures.count += 1;
            failures.first.get_or_insert_with(|| why.clone());
        }
    }
    Ok(failures)
}
