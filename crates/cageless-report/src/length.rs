//! Lengths in the units of figures and drawings.

/// A length, mm, of one in m.
pub(crate) fn mm(m: f64) -> f64 {
    1e3 * m
}

/// A length, µm, of one in m.
pub(crate) fn um(m: f64) -> f64 {
    1e6 * m
}
