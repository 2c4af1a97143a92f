//! The claims of the paper one by one, with what we find.
use cageless::Case;
use cageless_report::Claim;

use super::experiment::Experiment;
use super::histories::History;
use super::structures::Ten;
use super::table2::Computed;

/// First paragraph.
pub fn lead(_table2: &Computed) -> String {
    String::new()
}

/// All claims.
pub fn claims(
    _case: &Case,
    _table2: &Computed,
    _structures: &[Ten],
    _histories: &[History],
    _experiment: &Experiment,
) -> Vec<Claim> {
    vec![]
}
