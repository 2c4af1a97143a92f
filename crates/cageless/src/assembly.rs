//! The way in which the balls of a bearing get between its rings.

/// Largest (N − 1)ε of a bearing that is filled between eccentric rings, rad: 205°. Catalogue
/// bearings reach 204°.
const ECCENTRIC_FILLING_MAX_RAD: f64 = 205.0 / 180.0 * std::f64::consts::PI;

crate::named_enum! {
    /// Way of assembly. ISO 281 rates bearings with a filling slot lower.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Assembly {
        /// Between eccentric rings (Conrad), with a fractured or split ring, or, with a contact angle, over a
        /// counterbored shoulder.
        WithoutSlot = "without-slot",
        /// Through a slot in the shoulders.
        FillingSlot = "filling-slot",
    }
}

impl Assembly {
    /// Way of a radial bearing of which none is given: through a slot where more balls are to go in
    /// than eccentric rings take.
    pub fn of(balls: usize, ball_radius_m: f64, pitch_radius_m: f64) -> Self {
        let ball_angle = 2.0 * (ball_radius_m / pitch_radius_m).asin();
        let filled = (balls - 1) as f64 * ball_angle;
        if filled > ECCENTRIC_FILLING_MAX_RAD {
            Self::FillingSlot
        } else {
            Self::WithoutSlot
        }
    }

    /// bm of ISO 281, radial and angular contact ball bearings.
    pub fn rating_factor(self) -> f64 {
        match self {
            Self::WithoutSlot => 1.3,
            Self::FillingSlot => 1.1,
        }
    }
}
