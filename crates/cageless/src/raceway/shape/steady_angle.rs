//! Flanks over which the orbital speed of a rolling ball falls and rises at a constant rate.

use std::sync::Arc;

use crate::error::InputError;
use crate::raceway::flank_angle::{FlankAngle, Flanks};
use crate::raceway::outline::Outline;

/// Part of half a raceway, from the middle, over which the fall begins.
const MIDDLE: f64 = 0.35;
/// Part of half a raceway, at the end, over which it ceases. α falls to 0 at a finite slope there, about
/// half as steep again as that of the paper's path with the same lag and θ.
const END: f64 = 0.1;

/// αc of ln(Ω/Ω0) = −D θ f(u), u = |ψ|/θ. f′ is −1 but for the middle, where it falls from 0, and
/// the end, where it rises to 0, both linearly: D is the largest |d ln Ω/dψ|.
#[derive(Debug, Clone, PartialEq)]
struct SteadyAngle {
    /// θ.
    half_angle_rad: f64,
    /// D.
    rate: f64,
}

/// Flanks of an outline with a constant rate of the orbital speed.
#[allow(clippy::unnecessary_wraps)] // as every shape
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let (middle, theta) = (outline.middle_rad(), outline.half_angle_rad);
    Ok(Arc::new(SteadyAngle::new(middle, theta)))
}

impl SteadyAngle {
    /// Flanks of α0 in the middle: Ω/Ω0 = 2 cos α/(1 + cos α).
    fn new(middle_rad: f64, half_angle_rad: f64) -> Self {
        let cos = middle_rad.cos();
        let fall = -(2.0 * cos / (1.0 + cos)).ln();
        let rate = fall / (half_angle_rad * (1.0 - (MIDDLE + END) / 2.0));
        Self {
            half_angle_rad,
            rate,
        }
    }
}

impl FlankAngle for SteadyAngle {
    fn junctions_rad(&self) -> Vec<f64> {
        vec![
            MIDDLE * self.half_angle_rad,
            (1.0 - END) * self.half_angle_rad,
        ]
    }

    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let share = (local_angle_rad.abs() / self.half_angle_rad).min(1.0);
        let rest = 1.0 - share;
        let [fall, slope] = if share < MIDDLE {
            [
                1.0 - (END + MIDDLE + share * share / MIDDLE) / 2.0,
                share / MIDDLE,
            ]
        } else if rest > END {
            [rest - END / 2.0, 1.0]
        } else {
            [rest * rest / (2.0 * END), rest / END]
        };
        let scale = self.rate * self.half_angle_rad;
        // cos α = w/(2 − w) with w = Ω/Ω0.
        let lost = -(-scale * fall).exp_m1();
        let kept = 1.0 - lost;
        let angle = 2.0 * (lost / (1.0 + lost)).sqrt().asin();
        let slope = if rest > 1e-12 {
            2.0 * kept * self.rate * slope / ((1.0 + lost).powi(2) * angle.sin())
        } else {
            (2.0 * self.rate / (END * self.half_angle_rad)).sqrt()
        };
        [angle, -slope * local_angle_rad.signum()]
    }
}
