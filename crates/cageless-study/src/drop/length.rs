//! Lengths in the sentences of drops.

use cageless_results::number_text::short;

/// A length in µm.
pub(super) fn um(m: f64) -> String {
    short(1e6 * m)
}
