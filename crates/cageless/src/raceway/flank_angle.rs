//! The angle of the flanks along a stretch of a raceway.

use super::blend::Blend;
use super::contact_path::ContactPath;
use super::power_angle::PowerAngle;
use super::steady_angle::SteadyAngle;

/// αc over ψ, each smooth within the raceway.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum FlankAngle {
    /// That of the quartic contact path.
    Quartic(ContactPath),
    /// A power of 1 − (ψ/θ)², times a polynomial.
    Power(PowerAngle),
    /// That of an orbital speed that changes at a constant rate.
    Steady(SteadyAngle),
    /// A blend into the plain raceway.
    Blend(Blend),
}

impl FlankAngle {
    /// αc and dαc/dψ at local ψ within ±θ; at the ends the limit from within.
    pub fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        match self {
            Self::Quartic(path) => path.contact_angle_rad(local_angle_rad),
            Self::Power(power) => power.at(local_angle_rad),
            Self::Steady(steady) => steady.at(local_angle_rad),
            Self::Blend(blend) => blend.at(local_angle_rad),
        }
    }

    /// Local ψ at which αc is less smooth than between them.
    pub fn junctions_rad(&self) -> Vec<f64> {
        match self {
            Self::Steady(steady) => steady.junctions_rad().to_vec(),
            _ => vec![],
        }
    }

    /// r = Rw cos αc at local ψ.
    pub fn radius_m(&self, local_angle_rad: f64, ball_radius_m: f64) -> f64 {
        match self {
            Self::Quartic(path) => path.radius_by_root(local_angle_rad),
            Self::Power(_) | Self::Steady(_) | Self::Blend(_) => {
                let [angle, _] = self.at(local_angle_rad);
                ball_radius_m * angle.cos()
            }
        }
    }

    /// n such that αc/(sin²θ − sin²ψ)ⁿ is smooth over sin²ψ.
    pub fn order(&self) -> f64 {
        match self {
            Self::Quartic(_) | Self::Steady(_) => 1.0,
            Self::Power(power) => power.exponent(),
            Self::Blend(_) => 0.0,
        }
    }

    /// αc/(sin²θ − sin²ψ)ⁿ at `square` = sin²ψ, with sin²θ = `end`.
    pub fn regular(&self, square: f64, end: f64) -> f64 {
        let local = square.sqrt().asin();
        match self {
            Self::Quartic(_) | Self::Steady(_) => self.at(local)[0] / (end - square),
            Self::Power(power) => power.regular(local),
            Self::Blend(blend) => blend.at(local)[0],
        }
    }
}
