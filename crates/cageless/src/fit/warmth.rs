//! Temperatures of the parts of a mounted bearing, and their expansion.

/// Temperatures of the parts above 20 °C, K, and their coefficients of thermal expansion, 1/K.
#[derive(Debug, Clone, Copy)]
pub(super) struct Warmth {
    pub inner_k: f64,
    pub outer_k: f64,
    pub ball_k: f64,
    pub shaft_k: f64,
    pub housing_k: f64,
    pub ring_per_k: f64,
    pub ball_per_k: f64,
    pub shaft_per_k: f64,
    pub housing_per_k: f64,
}
