//! Elastic hysteresis of rolling steel.
//!
//! A contact resists rolling by the moment (Bălan et al., Lubricants 3 (2015) 222, Eq. (9))
//!
//!   M = 7.48·10⁻⁷ R^0.33 Q^1.33 [1 − 3.519·10⁻³ (k − 1)^0.8063] N·m,   k = R_y/R_x,
//!
//! R the radius of the ball in m. A couple: it acts on the spin of the ball and on the ring alone, and its loss is M times
//! the speed at which one turns against the other.

use super::contact::LubricatedContact;
use crate::bearing::Bearing;
use crate::numerics::inverse_root::{binary_logarithm, inverse_cube_root};

/// u₀², m²/s²: the moment goes through zero with the speed of rolling.
const LEAST_SPEED_SQUARE: f64 = 1e-6;

/// Moment of a contact over Q^1.33, N·m/N^1.33.
fn factor(contact: &LubricatedContact, ball_radius_m: f64) -> f64 {
    let ratio = contact.cross_radius_m / contact.rolling_radius_m;
    7.48e-7 * ball_radius_m.powf(0.33) * (1.0 - 3.519e-3 * (ratio - 1.0).powf(0.8063))
}

/// Hysteresis of the contacts of a nominal ball, N·m/N^1.33; flanks have that of the plain raceway, within 0.2 %.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Hysteresis {
    /// At the outer raceway.
    pub outer: f64,
    /// At the inner raceway.
    pub inner: f64,
}

impl Hysteresis {
    /// Hysteresis of the contacts of a bearing, N·m/N^1.33.
    pub(crate) fn new(bearing: &Bearing) -> Self {
        let of = |contact| factor(&contact, bearing.ball_radius_m());
        Self {
            outer: of(LubricatedContact::outer(bearing, 1.0)),
            inner: of(LubricatedContact::inner(bearing)),
        }
    }
}

/// Moment of a contact of this factor under a load, N·m.
pub(super) fn moment_n_m(factor: f64, load_n: f64) -> f64 {
    factor * load_n.max(0.0).powf(1.33)
}

/// Sense of a rotation by the speed of the surface of the ball, m/s: ±1 above u₀.
#[inline(always)]
pub(crate) fn sense(speed_m_s: f64) -> f64 {
    speed_m_s / (speed_m_s * speed_m_s + LEAST_SPEED_SQUARE).sqrt()
}

/// Q^1.33 = Q^(4/3) Q^(−1/300), relative error below 1e-6 from a micronewton to a meganewton; 0 of 0.
#[inline(always)]
pub(crate) fn power_1_33(load_n: f64) -> f64 {
    let root = inverse_cube_root(load_n);
    let x = -std::f64::consts::LN_2 / 300.0 * binary_logarithm(load_n);
    let small = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0))));
    load_n * load_n * (root * root) * small
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_follows_the_standard_library() {
        for k in -120..=120 {
            let load_n = (0.115 * f64::from(k)).exp();
            let relative = power_1_33(load_n) / load_n.powf(1.33) - 1.0;
            assert!(relative.abs() < 1e-6, "{load_n}: {relative:e}");
        }
        assert_eq!(power_1_33(0.0), 0.0);
    }
}
