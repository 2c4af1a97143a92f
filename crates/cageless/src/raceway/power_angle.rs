//! Flanks whose angle is a power of 1 − (ψ/θ)².

/// αc = α0 (1 − (ψ/θ)²)^p.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PowerAngle {
    /// α0.
    middle_rad: f64,
    /// θ.
    half_angle_rad: f64,
    /// p.
    exponent: f64,
}

/// Least 1 − (ψ/θ)² at which the slope is taken: with p < 1 it has no limit at the ends.
const SLOPE_AT: f64 = 1e-12;

impl PowerAngle {
    pub fn new(middle_rad: f64, half_angle_rad: f64, exponent: f64) -> Self {
        Self {
            middle_rad,
            half_angle_rad,
            exponent,
        }
    }

    /// p.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// αc and dαc/dψ at local ψ within ±θ.
    pub fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let (theta, p) = (self.half_angle_rad, self.exponent);
        let rest = (theta - local_angle_rad) * (theta + local_angle_rad) / (theta * theta);
        let slope_at = rest.max(SLOPE_AT);
        let fall = 2.0 * local_angle_rad / (theta * theta);
        [
            self.middle_rad * rest.max(0.0).powf(p),
            -self.middle_rad * p * slope_at.powf(p - 1.0) * fall,
        ]
    }

    /// αc/(sin²θ − sin²ψ)^p, smooth up to the ends: sin²θ − sin²ψ = sin(θ − ψ) sin(θ + ψ).
    pub fn regular(&self, local_angle_rad: f64) -> f64 {
        let theta = self.half_angle_rad;
        let over_sine = |angle: f64| angle / angle.sin();
        let ratio = over_sine(theta - local_angle_rad) * over_sine(theta + local_angle_rad);
        self.middle_rad * (ratio / (theta * theta)).powf(self.exponent)
    }
}
