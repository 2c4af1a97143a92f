//! Labels of what belongs to a bearing.

use cageless_study::drop::DropStudy;

/// Label of a table, figure or section of bearing `k`, below a linear rotor with its number.
pub(super) fn label(study: &DropStudy, name: &str, k: usize) -> String {
    match study.drop.rotor() {
        None => name.to_owned(),
        Some(_) => format!("{name}, bearing {}", k + 1),
    }
}
