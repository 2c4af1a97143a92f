//! Friction of the films of a bearing in static equilibrium.

use super::motion::RollingModel;
use super::rolling_ball::RollingBall;
use super::rolling_force::Rolling;
use super::traction::TractionCurve;
use crate::case::Case;
use crate::contact::Law;
use crate::contact::creep::{inverse_speed_s_m, rolling_speed_m_s};
use crate::contact::friction::{LawConstants, Smooth};

/// Sliding over rolling at which the friction is stated.
const SLIDING: f64 = 0.01;

/// Friction over load of all contacts under load together, were they to slide at a hundredth of the speed at which
/// they roll; `None` unless the film is their friction.
pub(super) fn mixed_friction_coefficient(case: &Case, balls: &[RollingBall]) -> Option<f64> {
    let model = RollingModel::new(case)?.traction?;
    let creep = case.creep();
    let outer = Place {
        case,
        curve: &model.outer,
        factor: case.contact.outer_friction_factor,
        creep: creep.map(|creep| creep.outer),
    };
    let inner = Place {
        curve: &model.inner,
        factor: 1.0,
        creep: creep.map(|creep| creep.inner),
        ..outer
    };
    let [mut friction_n, mut load_n] = [0.0; 2];
    for ball in balls {
        for flank in &ball.outer {
            friction_n += outer.friction_n(flank.rolling, 1.0 - flank.cosine);
            load_n += flank.rolling.load_n;
        }
        friction_n += inner.friction_n(ball.inner, 0.0);
        load_n += ball.inner.load_n;
    }
    Some(friction_n / load_n)
}

/// Contacts of the balls with one raceway.
#[derive(Clone, Copy)]
struct Place<'a> {
    case: &'a Case,
    curve: &'a TractionCurve,
    /// Friction of asperities over that of the law.
    factor: f64,
    /// See [`crate::contact::creep::Creep`].
    creep: Option<f64>,
}

impl Place<'_> {
    /// Friction of one contact at [`SLIDING`], N.
    fn friction_n(&self, rolling: Rolling, raised: f64) -> f64 {
        let Rolling { load_n, speed_m_s } = rolling;
        if !(load_n > 0.0) {
            return 0.0;
        }
        let law = Smooth::new(&self.case.contact.friction, 0.0);
        let given = law.inverse_regularisation_speed();
        let of_creep = |creep| inverse_speed_s_m(creep, load_n, speed_m_s, 1.0);
        let (knee, slip_m_s) = (self.creep.map_or(given, of_creep), SLIDING * speed_m_s);
        let dry = law.force_with_knee(slip_m_s, self.factor * load_n, knee);
        let square = rolling_speed_m_s(speed_m_s).powi(2);
        let [friction_n, _] = self.curve.at(load_n, square, raised).mixed(dry, slip_m_s);
        friction_n
    }
}
