//! The inner ring at rest.

/// Place of the inner ring at rest, from which a run starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RestingRing {
    /// Centre, m.
    pub place_m: [f64; 3],
    /// p and q of its axis.
    pub axis: [f64; 2],
}
