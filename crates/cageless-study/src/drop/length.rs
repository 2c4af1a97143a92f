//! Lengths in the rows and sentences of drops.

use cageless_results::number_text::short;

/// A length in µm.
pub(super) fn micrometres(m: f64) -> f64 {
    1e6 * m
}

/// A length in µm as text.
pub(super) fn um(m: f64) -> String {
    short(micrometres(m))
}
