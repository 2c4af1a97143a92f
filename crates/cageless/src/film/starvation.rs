//! Share of the rolling force that a starved inlet leaves.

use super::Film;

/// Least S that the share of a starved inlet was computed for.
pub const INLET_RATIO_MIN: f64 = 2.0;

/// T/T* = (S² + 162.8 S)/(S² + 193.1 S + 1257) of S, thickness of the film at the inlet over the least of the flooded
/// contact (Biboulet & Houpert, Part 1, doi 10.1243/13506501JET790, Eq. (44), of line contacts, from S = 2 on).
pub(crate) fn starved_share(inlet_ratio: f64) -> f64 {
    if inlet_ratio == f64::INFINITY {
        return 1.0;
    }
    let s = inlet_ratio;
    (s * s + 162.8 * s) / (s * s + 193.1 * s + 1257.0)
}

impl Film {
    /// Film with the supply of an inlet of this S, the same at all contacts.
    pub fn starved(self, inlet_ratio: f64) -> Self {
        Self {
            supply: starved_share(inlet_ratio),
            inlet_ratio: Some(inlet_ratio),
            ..self
        }
    }
}
