//! Friction of the films of a bearing in static equilibrium.

use super::Film;
use super::contact::LubricatedContact;
use super::groove_traction::curve;
use super::rolling_ball::RollingBall;
use super::rolling_force::Rolling;
use crate::case::Case;
use crate::contact::Law;
use crate::contact::creep::{Creep, inverse_speed_s_m, rolling_speed_m_s};
use crate::contact::friction::{LawConstants, Smooth};

/// Sliding over rolling at which the friction is stated.
const SLIDING: f64 = 0.01;

/// Contacts of a ball.
pub(super) struct BallContacts {
    /// With the inner raceway.
    pub inner: LubricatedContact,
    /// With the flanks of the outer one.
    pub outer: [LubricatedContact; 2],
}

/// Friction over load of all contacts under load together, were they to slide at a hundredth of the speed at which
/// they roll; `None` unless the film is their friction.
pub(super) fn mixed_friction_coefficient(
    case: &Case,
    balls: &[RollingBall],
    contacts: &[BallContacts],
) -> Option<f64> {
    let friction = MixedFriction::new(case)?;
    let [mut friction_n, mut load_n] = [0.0; 2];
    for (ball, contacts) in balls.iter().zip(contacts) {
        for (flank, contact) in ball.outer.iter().zip(&contacts.outer) {
            friction_n += friction.outer_n(contact, flank.rolling);
            load_n += flank.rolling.load_n;
        }
        friction_n += friction.inner_n(&contacts.inner, ball.inner);
        load_n += ball.inner.load_n;
    }
    Some(friction_n / load_n)
}

/// Friction of single contacts of a case, each sliding at a hundredth of the speed at which it rolls.
pub(crate) struct MixedFriction<'a> {
    case: &'a Case,
    film: &'a Film,
    creep: Option<Creep>,
}

impl<'a> MixedFriction<'a> {
    /// Mixed friction of a case; `None` unless the film is its friction.
    pub(crate) fn new(case: &'a Case) -> Option<Self> {
        Some(Self {
            case,
            film: case.film.as_ref().filter(|_| case.mixes_friction())?,
            creep: case.creep(),
        })
    }

    /// Friction of a contact with the outer raceway, N.
    pub(crate) fn outer_n(&self, contact: &LubricatedContact, rolling: Rolling) -> f64 {
        let factor = self.case.contact.outer_friction_factor;
        let creep = self.creep.map(|creep| creep.outer);
        self.friction_n(contact, rolling, factor, creep)
    }

    /// Friction of a contact with the inner raceway, N.
    pub(crate) fn inner_n(&self, contact: &LubricatedContact, rolling: Rolling) -> f64 {
        let creep = self.creep.map(|creep| creep.inner);
        self.friction_n(contact, rolling, 1.0, creep)
    }

    /// Friction where that of asperities is so many times that of the law.
    fn friction_n(
        &self,
        contact: &LubricatedContact,
        rolling: Rolling,
        factor: f64,
        creep: Option<f64>,
    ) -> f64 {
        let Rolling { load_n, speed_m_s } = rolling;
        if !(load_n > 0.0) {
            return 0.0;
        }
        let law = Smooth::new(&self.case.contact.friction, 0.0);
        let given = law.inverse_regularisation_speed();
        let of_creep = |creep| inverse_speed_s_m(creep, load_n, speed_m_s, 1.0);
        let (knee, slip_m_s) = (creep.map_or(given, of_creep), SLIDING * speed_m_s);
        let dry = law.force_with_knee(slip_m_s, factor * load_n, knee);
        let square = rolling_speed_m_s(speed_m_s).powi(2);
        let traction = curve(&self.case.bearing, self.film, *contact);
        let [friction_n, _] = traction.at(load_n, square, 0.0).mixed(dry, slip_m_s);
        friction_n
    }
}
