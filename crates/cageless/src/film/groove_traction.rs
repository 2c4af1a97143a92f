//! Traction of films in contacts with grooves that a ball touches under any angle, or at the edges of slots.

use std::ops::RangeInclusive;

use super::Film;
use super::contact::LubricatedContact;
use super::rolling_force::Rolling;
use super::traction::{ContactShape, TractionContact, TractionCurve};
use crate::bearing::Bearing;
use crate::contact::FilmTraction;
use crate::numerics::chebyshev::Polynomial;

/// Shape of a contact over what it changes with, as polynomials.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ShapePolynomial {
    thickening: Polynomial,
    area: Polynomial,
    inverse_area: Polynomial,
    creep: Polynomial,
}

impl ShapePolynomial {
    /// Polynomials of a degree over a range of places.
    fn new(at: impl Fn(f64) -> ContactShape, range: &RangeInclusive<f64>, degree: usize) -> Self {
        let (from, to) = (*range.start(), *range.end());
        let fit = |of: fn(&ContactShape) -> f64| {
            Polynomial::of_degree(|place| of(&at(place)), from, to, degree)
        };
        Self {
            thickening: fit(|shape| shape.thickening),
            area: fit(|shape| shape.area),
            inverse_area: fit(|shape| shape.inverse_area),
            creep: fit(|shape| shape.creep),
        }
    }

    /// Shape at a place.
    #[inline(always)]
    fn at(&self, place: f64) -> ContactShape {
        ContactShape {
            thickening: self.thickening.value(place),
            area: self.area.value(place),
            inverse_area: self.inverse_area.value(place),
            creep: self.creep.value(place),
        }
    }
}

/// Place at the edge of a slot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlotEdge {
    /// Number of the slot, from 0.
    pub slot: usize,
    /// σ.
    pub merged: f64,
}

/// Films of the contacts with one groove.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GrooveFilms {
    curve: TractionCurve,
    /// Shape over the curvature of the ring along rolling.
    shape: ShapePolynomial,
    /// Shape at the edges of the slot of each raceway over σ, where it is one.
    edges: Vec<Option<ShapePolynomial>>,
}

/// Contacts with a groove, or with an edge, over what they change with.
pub(super) struct ContactRange<'a> {
    /// The contact at a place.
    pub at: &'a dyn Fn(f64) -> LubricatedContact,
    /// First and last place.
    pub range: RangeInclusive<f64>,
    /// Degree of polynomials over it.
    pub degree: usize,
}

impl GrooveFilms {
    /// Films of the contacts with a groove of a bearing, that with most curvature as reference.
    pub(super) fn new(
        bearing: &Bearing,
        film: &Film,
        groove: &ContactRange<'_>,
        edges: &[Option<ContactRange<'_>>],
    ) -> Self {
        let reference = (groove.at)(*groove.range.end());
        let shapes = |of: &ContactRange<'_>| {
            let at = |place: f64| shape(bearing, film, &reference, &(of.at)(place));
            ShapePolynomial::new(at, &of.range, of.degree)
        };
        Self {
            curve: curve(bearing, film, reference),
            shape: shapes(groove),
            edges: edges.iter().map(|edge| edge.as_ref().map(shapes)).collect(),
        }
    }

    /// Film of a contact where the ring has this curvature along rolling, 1/m.
    #[inline(always)]
    pub(crate) fn at(&self, load_n: f64, speed_square: f64, curvature: f64) -> FilmTraction {
        (self.curve).of_shape(load_n, speed_square, &self.shape.at(curvature))
    }

    /// Film at the edge of a slot; `None` if it is none.
    #[inline(always)]
    pub(crate) fn at_edge(
        &self,
        load_n: f64,
        speed_square: f64,
        edge: SlotEdge,
    ) -> Option<FilmTraction> {
        let shape = self.edges.get(edge.slot)?.as_ref()?.at(edge.merged);
        Some(self.curve.of_shape(load_n, speed_square, &shape))
    }
}

/// Constants of the traction of a contact.
pub(super) fn curve(bearing: &Bearing, film: &Film, contact: LubricatedContact) -> TractionCurve {
    let of = TractionContact {
        contact,
        flank: None,
        creep_stiffness_n1_3: contact.creep_stiffness_n1_3(bearing),
    };
    TractionCurve::new(film, &of)
}

/// Shape of a contact against a reference.
fn shape(
    bearing: &Bearing,
    film: &Film,
    reference: &LubricatedContact,
    contact: &LubricatedContact,
) -> ContactShape {
    let one = Rolling {
        load_n: 1.0,
        speed_m_s: 1.0,
    };
    let ratio = |of: &dyn Fn(&LubricatedContact) -> f64| of(contact) / of(reference);
    let area = ratio(&LubricatedContact::area_m2_n2_3);
    ContactShape {
        thickening: ratio(&|of| of.film_thickness(&film.oil, one).central_m).ln(),
        area,
        inverse_area: 1.0 / area,
        creep: area / ratio(&|of| of.creep_stiffness_n1_3(bearing)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Oil, Traction};
    use super::*;
    use crate::common::slotted;
    use crate::film::GrooveCurves;

    /// Under any angle and from the plain groove to the edge of a slot a film is that of its own contact; C11 of the table
    /// is linear from row to row.
    #[test]
    fn films_follow_the_contact() {
        let case = slotted();
        let film = Film {
            traction: Traction::Film,
            ..Film::flooded(Oil::mineral(5e-3, 0.035))
        };
        let bearing = &case.bearing;
        let curves = GrooveCurves::new(bearing, &film, &case.raceways);
        let [outer, inner] = curves.traction.as_ref().unwrap();
        let slot = case.raceways[0].slot().unwrap();
        let bottoms_m = [
            bearing.dimensions().outer_groove_bottom_radius_m,
            bearing.dimensions().inner_groove_bottom_radius_m,
        ];
        let near = |found: FilmTraction, contact: LubricatedContact, load_n: f64, within: f64| {
            let expected = curve(bearing, &film, contact).at(load_n, 190.0, 0.0);
            for (a, b) in [
                (1.0 - found.asperity_share, 1.0 - expected.asperity_share),
                (found.limit, expected.limit),
                (found.stress_ratio, expected.stress_ratio),
                (found.inverse_speed, expected.inverse_speed),
            ] {
                assert!(
                    (a / b - 1.0).abs() < within,
                    "{load_n}: {found:?} {expected:?}"
                );
            }
        };
        for k in 0..=20 {
            let share = f64::from(k) / 20.0;
            for load_n in [1.0, 20.0, 470.0] {
                let [at_outer, at_inner] = bottoms_m.map(|bottom_m| share / bottom_m);
                let flank = LubricatedContact::outer_curved(bearing, at_outer);
                near(outer.at(load_n, 190.0, at_outer), flank, load_n, 4e-3);
                let contact = LubricatedContact::inner_curved(bearing, at_inner);
                near(inner.at(load_n, 190.0, at_inner), contact, load_n, 4e-3);
                let ring = slot.merged_curvatures_per_m(share);
                let merged = share;
                let at_edge = outer.at_edge(load_n, 190.0, SlotEdge { slot: 0, merged });
                near(
                    at_edge.unwrap(),
                    LubricatedContact::of_ring(bearing, ring),
                    load_n,
                    2e-2,
                );
            }
        }
        let middle = SlotEdge {
            slot: 0,
            merged: 0.5,
        };
        assert!(inner.at_edge(20.0, 190.0, middle).is_none());
    }
}
