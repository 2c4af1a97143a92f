//! Blend of the flanks of a discrete raceway into the plain one.

use super::flank_angle::FlankAngle;
use crate::error::InputError;
use crate::limits::{from_to, require};

/// Half the length of a contact along the groove over the radius of the ball: Hertz's minor semi-axis under some
/// 1.5 GPa. No contact meets an end within less.
pub(super) const CONTACT_SHARE: f64 = 0.03;

/// Ends of a discrete raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ends {
    /// Blended into the plain raceway over this length along the bottom of the groove, m; 0 leaves the end as
    /// the shape has it.
    Blended(f64),
    /// Ends as `export` machines them: blended over 0.5 mm, or over a fifth of half the raceway where that is shorter.
    Machined,
}

/// Ends of the raceways of Zhao 2022, as the shape has them.
impl Default for Ends {
    fn default() -> Self {
        Self::Blended(0.0)
    }
}

/// Blend that a machined end has at most, m: it leaves structure (d) of Zhao 2022 within its machining error of
/// 2 µm.
const MACHINED_M: f64 = 0.5e-3;
/// Share of half a raceway that it takes at most.
const MACHINED_SHARE: f64 = 0.2;

impl Ends {
    /// Length of the blend of a raceway of this half length along the bottom of the groove, m.
    pub fn blend_m(self, half_m: f64) -> f64 {
        match self {
            Self::Blended(blend_m) => blend_m,
            Self::Machined => MACHINED_M.min(MACHINED_SHARE * half_m),
        }
    }
}

/// Shortest blend in fractions of half a raceway: in less, the kink is not resolved.
const SHARE_MIN: f64 = 0.002;
/// Longest blend in fractions of half a raceway: the middle half stays as designed.
const SHARE_MAX: f64 = 0.5;

/// αc = (1 − t)³ (c₀ + c₁ t + c₂ t²) with t = (|ψ| − start)/length: at t = 0 it continues αc
/// with its slope and curvature, at t = 1 all three are 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Blend {
    start_rad: f64,
    length_rad: f64,
    coefficients: [f64; 3],
}

impl Blend {
    /// Blend over the last `blend_m` before the ends ±θ of flanks of αc and dαc/dψ, along a circle of `bottom_m`.
    ///
    /// # Errors
    /// An [`InputError`] if it is too short or too long, or the angle does not fall over it.
    pub(super) fn new(
        flanks: impl Fn(f64) -> [f64; 2],
        half_angle_rad: f64,
        blend_m: f64,
        bottom_m: f64,
    ) -> Result<Self, InputError> {
        let half = half_angle_rad * bottom_m;
        let why = "or 0, which leaves the slope discontinuity; a quarter of the length of the raceway \
                   at most";
        from_to("blend_m", blend_m, SHARE_MIN * half..=SHARE_MAX * half, why)?;
        let blend = Self::over(flanks, half_angle_rad, blend_m / bottom_m);
        let rises = |k: i32| blend.along(f64::from(k) / 100.0)[1] > 0.0;
        let rule = "shorter: the contact angle must fall steadily to 0 over it";
        require("blend_m", blend_m, !(0..100).any(rises), rule)?;
        Ok(blend)
    }

    /// Blend over the last `length_rad` before the ends ±θ of a function and its slope over ψ.
    pub(super) fn over(
        flanks: impl Fn(f64) -> [f64; 2],
        half_angle_rad: f64,
        length_rad: f64,
    ) -> Self {
        let start_rad = half_angle_rad - length_rad;
        let slope_at = |local: f64| flanks(local)[1];
        // Far from the end in its own scale, where the slope is analytic.
        let h = length_rad / 32.0;
        let bend = (8.0 * (slope_at(start_rad + h) - slope_at(start_rad - h))
            - slope_at(start_rad + 2.0 * h)
            + slope_at(start_rad - 2.0 * h))
            / (12.0 * h);
        let [value, slope] = flanks(start_rad);
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

    /// Local ψ at which the blend before +θ starts.
    pub(super) fn start_rad(&self) -> f64 {
        self.start_rad
    }

    /// Value and slope over ψ at local ψ beyond its start.
    pub(super) fn value_and_slope(&self, local_angle_rad: f64) -> [f64; 2] {
        let local = local_angle_rad.abs();
        let [value, slope] = self.along((local - self.start_rad) / self.length_rad);
        [value, slope * local_angle_rad.signum()]
    }

    /// αc and dαc/dψ at t in 0 to 1.
    fn along(&self, t: f64) -> [f64; 2] {
        let [c0, c1, c2] = self.coefficients;
        let rest = (1.0 - t).max(0.0);
        let (value, slope) = ((c2 * t + c1) * t + c0, 2.0 * c2 * t + c1);
        [
            rest.powi(3) * value,
            rest.powi(2) * (rest * slope - 3.0 * value) / self.length_rad,
        ]
    }
}

impl FlankAngle for Blend {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        self.value_and_slope(local_angle_rad)
    }

    fn order(&self) -> f64 {
        0.0
    }

    fn regular(&self, square: f64, _end: f64) -> f64 {
        self.at(square.sqrt().asin())[0]
    }
}
