//! The contact angle along a discrete raceway, blended at its ends.

use crate::error::{Allowed, InputError};
use crate::raceway::Raceway;

/// Shortest blend in fractions of half a raceway: in less, the kink is not resolved.
const SHARE_MIN: f64 = 0.002;
/// Longest blend in fractions of half a raceway: the middle half stays as designed.
const SHARE_MAX: f64 = 0.5;

/// A discrete raceway with its blends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RacewayZone {
    raceway: Raceway,
    blend: Option<Blend>,
}

/// α = (1 − t)³ (c₀ + c₁ t + c₂ t²) with t = (|ψ| − start)/length: at t = 0 it continues α
/// with its slope and curvature, at t = 1 all three are 0.
#[derive(Debug, Clone, PartialEq)]
struct Blend {
    start_rad: f64,
    length_rad: f64,
    coefficients: [f64; 3],
}

impl RacewayZone {
    /// Blends over the last `blend_m` before each end, along a circle of `bottom_m`; 0 for
    /// none.
    pub(super) fn new(raceway: &Raceway, blend_m: f64, bottom_m: f64) -> Result<Self, InputError> {
        let half = raceway.half_angle_rad() * bottom_m;
        let (least, most) = (SHARE_MIN * half, SHARE_MAX * half);
        if blend_m != 0.0 && !(blend_m >= least && blend_m <= most) {
            return Err(InputError::new(
                "blend_m",
                blend_m,
                Allowed::Between(
                    least,
                    most,
                    "or 0, which leaves the slope discontinuity; a quarter of the length of the raceway at most",
                ),
            ));
        }
        let blend = (blend_m > 0.0).then(|| Blend::new(raceway, blend_m / bottom_m));
        if let Some(blend) = &blend {
            let rises = |k: i32| blend.contact_angle_rad(f64::from(k) / 100.0)[1] > 0.0;
            if (0..100).any(rises) {
                return Err(InputError::rule(
                    "blend_m",
                    blend_m,
                    "shorter: the contact angle must fall steadily to 0 over it",
                ));
            }
        }
        Ok(Self {
            raceway: raceway.clone(),
            blend,
        })
    }

    pub(super) fn raceway(&self) -> &Raceway {
        &self.raceway
    }

    /// Local ψ at which the blend before +θ starts.
    pub(super) fn blend_start_rad(&self) -> Option<f64> {
        self.blend.as_ref().map(|b| b.start_rad)
    }

    /// α and dα/dψ at local ψ within ±θ, at the ends the limits from within.
    pub(super) fn contact_angle_rad(&self, local_angle_rad: f64) -> [f64; 2] {
        let local = local_angle_rad.abs();
        match &self.blend {
            Some(blend) if local > blend.start_rad => {
                let [angle, slope] =
                    blend.contact_angle_rad((local - blend.start_rad) / blend.length_rad);
                [angle, slope * local_angle_rad.signum()]
            }
            _ => self.raceway.contact_angle_rad(local_angle_rad),
        }
    }
}

impl Blend {
    fn new(raceway: &Raceway, length_rad: f64) -> Self {
        let start_rad = raceway.half_angle_rad() - length_rad;
        let slope_at = |local: f64| raceway.contact_angle_rad(local)[1];
        // Far from the end in its own scale, where the slope is analytic.
        let h = length_rad / 32.0;
        let bend = (8.0 * (slope_at(start_rad + h) - slope_at(start_rad - h))
            - slope_at(start_rad + 2.0 * h)
            + slope_at(start_rad - 2.0 * h))
            / (12.0 * h);
        let [value, slope] = raceway.contact_angle_rad(start_rad);
        let (slope, bend) = (slope * length_rad, bend * length_rad * length_rad);
        Self {
            start_rad,
            length_rad,
            coefficients: [
                value,
                3.0 * value + slope,
                6.0 * value + 3.0 * slope + bend / 2.0,
            ],
        }
    }

    /// α and dα/dψ at t in 0 to 1.
    fn contact_angle_rad(&self, t: f64) -> [f64; 2] {
        let [c0, c1, c2] = self.coefficients;
        let rest = (1.0 - t).max(0.0);
        let (value, slope) = ((c2 * t + c1) * t + c0, 2.0 * c2 * t + c1);
        [
            rest.powi(3) * value,
            rest.powi(2) * (rest * slope - 3.0 * value) / self.length_rad,
        ]
    }
}
