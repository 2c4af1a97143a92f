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
    /// That of the contacts of a bearing.
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
