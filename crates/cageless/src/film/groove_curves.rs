//! Rolling force of the contacts with grooves that a ball touches under any angle.

use super::contact::LubricatedContact;
use super::curve::RollingCurve;
use super::curve_polynomial::CurvePolynomial;
use super::groove_traction::{ContactRange, GrooveFilms};
use super::hysteresis::Hysteresis;
use super::{Film, Traction};
use crate::bearing::Bearing;
use crate::raceway::{Raceway, Slot};

/// Degree of the constants over the curvature.
const DEGREE: usize = 4;
/// Degree of the constants of an edge over σ.
const EDGE_DEGREE: usize = 10;
/// Largest curvature over that of the bottom of the groove: balls move along the radius.
const MARGIN: f64 = 1.01;

/// Constants of the contacts of one bearing over the curvature of the ring along rolling, cos α over the distance of
/// the contact from its axis, 1/m; all but that curvature is the same under every contact angle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GrooveCurves {
    pub outer: CurvePolynomial,
    pub inner: CurvePolynomial,
    /// Constants at the edges of the slot of each raceway over σ, where it is one; empty without slots.
    pub edges: Vec<Option<CurvePolynomial>>,
    /// Hysteresis of the steel, where it counts.
    pub hysteresis: Option<Hysteresis>,
    /// Friction at the outer and the inner raceway, where it is that of the film.
    pub traction: Option<[GrooveFilms; 2]>,
}

impl GrooveCurves {
    /// Constants of the nominal balls of a bearing with these raceways.
    pub(crate) fn new(bearing: &Bearing, film: &Film, raceways: &[Raceway]) -> Self {
        let d = bearing.dimensions();
        let fit = |groove: fn(&Bearing, f64) -> LubricatedContact, radius_m: f64| {
            let at = |curvature: f64| RollingCurve::new(&groove(bearing, curvature), film);
            CurvePolynomial::new(at, 0.0..=MARGIN / radius_m, DEGREE)
        };
        let edges = |slot: &Slot| {
            let at = |merged: f64| {
                let ring = slot.merged_curvatures_per_m(merged);
                RollingCurve::new(&LubricatedContact::of_ring(bearing, ring), film)
            };
            CurvePolynomial::new(at, 0.0..=1.0, EDGE_DEGREE)
        };
        Self {
            // None at all without slots: a step then asks nothing of it.
            edges: match raceways.iter().any(|raceway| raceway.slot().is_some()) {
                true => (raceways.iter()).map(|r| r.slot().map(edges)).collect(),
                false => vec![],
            },
            outer: fit(
                LubricatedContact::outer_curved,
                d.outer_groove_bottom_radius_m,
            ),
            inner: fit(
                LubricatedContact::inner_curved,
                d.inner_groove_bottom_radius_m,
            ),
            hysteresis: film.hysteresis.then(|| Hysteresis::new(bearing)),
            traction: (film.traction == Traction::Film).then(|| traction(bearing, film, raceways)),
        }
    }
}

/// Friction of the films at the outer and the inner raceway.
fn traction(bearing: &Bearing, film: &Film, raceways: &[Raceway]) -> [GrooveFilms; 2] {
    let d = bearing.dimensions();
    let of_groove = |at: &dyn Fn(f64) -> LubricatedContact,
                     radius_m: f64,
                     edges: &[Option<ContactRange<'_>>]| {
        let groove = ContactRange {
            at,
            range: 0.0..=MARGIN / radius_m,
            degree: DEGREE,
        };
        GrooveFilms::new(bearing, film, &groove, edges)
    };
    let at_edges: Vec<_> = (raceways.iter())
        .map(|raceway| {
            let slot = raceway.slot()?;
            Some(move |merged: f64| {
                LubricatedContact::of_ring(bearing, slot.merged_curvatures_per_m(merged))
            })
        })
        .collect();
    let edges: Vec<_> = (at_edges.iter())
        .map(|at| {
            at.as_ref().map(|at| ContactRange {
                at,
                range: 0.0..=1.0,
                degree: EDGE_DEGREE,
            })
        })
        .collect();
    let outer = |curvature: f64| LubricatedContact::outer_curved(bearing, curvature);
    let inner = |curvature: f64| LubricatedContact::inner_curved(bearing, curvature);
    [
        of_groove(&outer, d.outer_groove_bottom_radius_m, &edges),
        of_groove(&inner, d.inner_groove_bottom_radius_m, &[]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::slotted;
    use crate::film::Oil;
    use crate::reference;

    /// From the plain groove to the edge of a slot.
    #[test]
    fn constants_follow_the_edges_of_a_slot() {
        let case = slotted();
        let film = Film::flooded(Oil::mineral(5e-3, 0.035));
        let curves = GrooveCurves::new(&case.bearing, &film, &case.raceways);
        let edges = curves.edges[0].as_ref().unwrap();
        let slot = case.raceways[0].slot().unwrap();
        for k in 0..=20 {
            let merged = f64::from(k) / 20.0;
            let ring = slot.merged_curvatures_per_m(merged);
            let contact = LubricatedContact::of_ring(&case.bearing, ring);
            let error = edges.error(merged, &RollingCurve::new(&contact, &film));
            assert!(error < 1e-3, "{merged}: {error:e}");
        }
        let plain = LubricatedContact::outer(&case.bearing, 1.0);
        assert!(edges.error(0.0, &RollingCurve::new(&plain, &film)) < 1e-3);
    }

    #[test]
    fn constants_follow_the_curvature() {
        let bearing = reference::bearing();
        let film = Film::flooded(Oil::mineral(5e-3, 0.035));
        let curves = GrooveCurves::new(&bearing, &film, &[]);
        let d = bearing.dimensions();
        for angle_deg in [0.0, 10.0, 15.0, 40.0, 60.0, 85.0_f64] {
            let (cosine, rw) = (angle_deg.to_radians().cos(), bearing.ball_radius_m());
            let flank = LubricatedContact::outer(&bearing, cosine);
            let contact_radius_m = bearing.outer_orbit_radius_m() + rw * cosine;
            let outer = curves
                .outer
                .error(cosine / contact_radius_m, &RollingCurve::new(&flank, &film));
            let ri = d.inner_groove_curvature_radius_m;
            let curvature = cosine / (d.inner_groove_bottom_radius_m + ri * (1.0 - cosine));
            let contact = LubricatedContact::inner_curved(&bearing, curvature);
            let inner = curves
                .inner
                .error(curvature, &RollingCurve::new(&contact, &film));
            assert!(outer < 1e-6 && inner < 1e-6, "{angle_deg}: {outer} {inner}");
        }
        assert_eq!(
            LubricatedContact::inner(&bearing),
            LubricatedContact::inner_curved(&bearing, 1.0 / d.inner_groove_bottom_radius_m)
        );
    }
}
