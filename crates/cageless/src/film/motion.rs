//! Rolling force of all contacts of a case, as the equations of motion in the plane take it.

use super::contact::LubricatedContact;
use super::curve::RollingCurve;
use super::curve_polynomial::CurvePolynomial;
use super::hysteresis::Hysteresis;
use super::traction::{TractionContact, TractionCurve, TractionModel};
use super::{Film, Traction};
use crate::case::Case;

/// Degree of the constants of the outer contact over the cosine of its angle.
const DEGREE: usize = 3;
/// Least cosine of flanks beyond that of the raceway: balls pressed in, and of other sizes, bear further down.
const MARGIN: f64 = 0.02;
/// Places of a raceway at which its cosine is looked at.
const PLACES: usize = 64;

/// Constants of the contacts of one bearing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RollingModel {
    /// Inner contact.
    pub inner: RollingCurve,
    /// Constants of the outer contact over cos α; the same for all without raceways.
    pub outer: CurvePolynomial,
    /// Hysteresis of the steel, where it counts.
    pub hysteresis: Option<Hysteresis>,
    /// Friction, where it is that of the film.
    pub traction: Option<TractionModel>,
}

impl RollingModel {
    /// Constants of a case; `None` without a film.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        let film = case.film.as_ref()?;
        let bearing = &case.bearing;
        let least = least_cosine(case);
        let at = |cosine: f64| RollingCurve::new(&LubricatedContact::outer(bearing, cosine), film);
        Some(Self {
            inner: RollingCurve::new(&LubricatedContact::inner(bearing), film),
            outer: match least {
                None => CurvePolynomial::constant(at(1.0)),
                Some(least) => CurvePolynomial::new(at, least - MARGIN..=1.0, DEGREE),
            },
            hysteresis: film.hysteresis.then(|| Hysteresis::new(bearing)),
            traction: (film.traction == Traction::Film)
                .then(|| TractionModel::new(case, film, least)),
        })
    }
}

impl TractionModel {
    /// Constants of the contacts of a case in a film, whose flanks have this least cosine.
    fn new(case: &Case, film: &Film, least_cosine: Option<f64>) -> Self {
        let bearing = &case.bearing;
        let [at_outer, at_inner] = case.creep_stiffness_n1_3();
        let outer = TractionContact {
            contact: LubricatedContact::outer(bearing, 1.0),
            flank: least_cosine
                .map(|cosine| (LubricatedContact::outer(bearing, cosine), 1.0 - cosine)),
            creep_stiffness_n1_3: at_outer,
        };
        let inner = TractionContact {
            contact: LubricatedContact::inner(bearing),
            flank: None,
            creep_stiffness_n1_3: at_inner,
        };
        Self {
            outer: TractionCurve::new(film, &outer),
            inner: TractionCurve::new(film, &inner),
        }
    }
}

/// Least cosine of the angle of the flanks of any raceway; `None` without raceways.
fn least_cosine(case: &Case) -> Option<f64> {
    let places = case.raceways.iter().flat_map(|raceway| {
        let centre_rad = raceway.dimensions().centre_angle_rad;
        let step_rad = raceway.half_angle_rad() / PLACES as f64;
        (0..PLACES).map(move |k| raceway.effective_radius_m(centre_rad + k as f64 * step_rad))
    });
    let least_m = places.reduce(f64::min)?;
    Some(least_m / case.bearing.ball_radius_m())
}

#[cfg(test)]
mod tests {
    use super::super::{Film, Oil};
    use super::*;
    use crate::reference::Structure;

    #[test]
    fn constants_follow_the_cosine() {
        let film = Film::flooded(Oil::mineral(5e-3, 0.035));
        let case = Case {
            film: Some(film),
            ..Structure::D.case()
        };
        let model = RollingModel::new(&case).unwrap();
        let least = least_cosine(&case).unwrap() - MARGIN;
        for k in 0..=20 {
            let cosine = least + (1.0 - least) * f64::from(k) / 20.0;
            let contact = LubricatedContact::outer(&case.bearing, cosine);
            let expected = RollingCurve::new(&contact, &film);
            let relative = model.outer.error(cosine, &expected);
            assert!(relative < 3e-7, "{cosine}: {relative:e}");
        }
    }
}
