//! Flanks whose angle is a power of 1 − (ψ/θ)², times a polynomial.

use super::flank_angle::FlankAngle;
use crate::numerics::angle::over_sine;

/// Most terms of the polynomial.
pub(super) const TERMS_MAX: usize = 7;

/// αc = α0 (1 − (ψ/θ)²)^p Q, with Q = 1 in the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerAngle {
    /// α0.
    middle_rad: f64,
    /// θ.
    half_angle_rad: f64,
    /// p.
    exponent: f64,
    /// Q in ascending powers of 2 (ψ/θ)² − 1.
    polynomial: [f64; TERMS_MAX],
}

/// Least 1 − (ψ/θ)² at which the slope is taken: with p < 1 it has no limit at the ends.
const SLOPE_AT: f64 = 1e-12;

impl PowerAngle {
    /// αc = α0 (1 − (ψ/θ)²)^p.
    pub(crate) fn new(middle_rad: f64, half_angle_rad: f64, exponent: f64) -> Self {
        let mut polynomial = [0.0; TERMS_MAX];
        polynomial[0] = 1.0;
        Self {
            middle_rad,
            half_angle_rad,
            exponent,
            polynomial,
        }
    }

    /// αc = (1 − (ψ/θ)²)^p times this polynomial in 2 (ψ/θ)² − 1.
    pub(crate) fn with_polynomial(mut self, polynomial: [f64; TERMS_MAX]) -> Self {
        let [middle, _] = horner(&polynomial, -1.0);
        self.middle_rad = middle;
        self.polynomial = polynomial.map(|c| c / middle);
        self
    }

    /// Flanks of this shape with another α0 and θ.
    pub(crate) fn scaled(self, middle_rad: f64, half_angle_rad: f64) -> Self {
        Self {
            middle_rad,
            half_angle_rad,
            ..self
        }
    }

    /// α0.
    pub(crate) fn middle_rad(&self) -> f64 {
        self.middle_rad
    }

    /// θ.
    pub(crate) fn half_angle_rad(&self) -> f64 {
        self.half_angle_rad
    }

    /// Q and dQ/dψ at local ψ.
    fn factor(&self, local_angle_rad: f64) -> [f64; 2] {
        let share = local_angle_rad / self.half_angle_rad;
        let [value, slope] = horner(&self.polynomial, 2.0 * share * share - 1.0);
        [value, slope * 4.0 * share / self.half_angle_rad]
    }

    /// αc and dαc/dψ at local ψ within ±θ.
    pub(crate) fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let (theta, p) = (self.half_angle_rad, self.exponent);
        let rest = (theta - local_angle_rad) * (theta + local_angle_rad) / (theta * theta);
        let slope_at = rest.max(SLOPE_AT);
        let fall = 2.0 * local_angle_rad / (theta * theta);
        let [factor, rise] = self.factor(local_angle_rad);
        let power = self.middle_rad * rest.max(0.0).powf(p);
        [
            power * factor,
            power * rise - self.middle_rad * p * slope_at.powf(p - 1.0) * fall * factor,
        ]
    }
}

impl FlankAngle for PowerAngle {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        Self::at(self, local_angle_rad)
    }

    /// With αc = α0 w^p Q and p < 1: sin αc/αc · α0² w^(2p − 1) Q (w Q′ + p w′ Q).
    fn sine_slope(&self, local_angle_rad: f64) -> f64 {
        let [angle, slope] = Self::at(self, local_angle_rad);
        if !self.ends_at_right_angle() {
            return angle.sin() * slope;
        }
        let (theta, p) = (self.half_angle_rad, self.exponent);
        let rest = (theta - local_angle_rad) * (theta + local_angle_rad) / (theta * theta);
        let fall = -2.0 * local_angle_rad / (theta * theta);
        let [factor, rise] = self.factor(local_angle_rad);
        let power = rest.max(0.0).powf(2.0 * p - 1.0);
        let product = self.middle_rad.powi(2) * power * factor * (rest * rise + p * fall * factor);
        product / over_sine(angle)
    }

    fn ends_at_right_angle(&self) -> bool {
        self.exponent < 1.0
    }

    fn order(&self) -> f64 {
        self.exponent
    }

    /// Smooth up to the ends: sin²θ − sin²ψ = sin(θ − ψ) sin(θ + ψ).
    fn regular(&self, square: f64, _end: f64) -> f64 {
        let local_angle_rad = square.sqrt().asin();
        let theta = self.half_angle_rad;
        let ratio = over_sine(theta - local_angle_rad) * over_sine(theta + local_angle_rad);
        let [factor, _] = self.factor(local_angle_rad);
        self.middle_rad * (ratio / (theta * theta)).powf(self.exponent) * factor
    }
}

/// Σ c_k x^k and its slope.
fn horner(coefficients: &[f64], x: f64) -> [f64; 2] {
    let next = |[value, slope]: [f64; 2], c: &f64| [value * x + c, slope * x + value];
    coefficients.iter().rev().fold([0.0; 2], next)
}
