//! A stretch of a raceway over which the angle of its flanks is smooth.

use std::ops::Range;

use super::flank_angle::{FlankAngle, Flanks};
use crate::numerics::chebyshev::Polynomial;

/// A stretch of half a raceway, and its mirror image.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    flanks: Flanks,
    /// Local ψ at which it begins and ends.
    range_rad: [f64; 2],
    /// sin²ψ over which polynomials are fitted.
    domain: [f64; 2],
    /// r over sin²ψ.
    radius: Polynomial,
}

/// r over sin²ψ has the flanks.
impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        let parts = |p: &Self| (p.range_rad, p.domain);
        parts(self) == parts(other) && self.radius == other.radius
    }
}

/// Error of r(sin²ψ), m: a few roundings of Ro.
const RADIUS_TOLERANCE_M: f64 = 1e-17;
/// Error of αc/(sin²θ − sin²ψ)ⁿ.
const ANGLE_TOLERANCE: f64 = 1e-13;

impl Piece {
    /// Flanks from the middle to an end, a piece from each of their junctions to the next.
    pub(super) fn all(flanks: &Flanks, end_rad: f64, ball_radius_m: f64) -> Vec<Self> {
        let junctions = flanks.junctions_rad();
        let from = std::iter::once(0.0).chain(junctions.iter().copied());
        let to = junctions.iter().copied().chain([end_rad]);
        let piece = |range: (f64, f64)| Self::new(flanks.clone(), range.into(), ball_radius_m);
        from.zip(to).map(piece).collect()
    }

    /// Flanks from one local ψ to another, fitted over this range.
    pub(super) fn new(flanks: Flanks, range_rad: [f64; 2], ball_radius_m: f64) -> Self {
        let domain = range_rad.map(|angle| angle.sin().powi(2));
        let radius = |s: f64| flanks.radius_m(s.sqrt().asin(), ball_radius_m);
        let radius = Polynomial::fit(radius, domain[0], domain[1], RADIUS_TOLERANCE_M);
        Self {
            flanks,
            range_rad,
            domain,
            radius,
        }
    }

    /// Ends it before, if it goes on so far.
    pub(super) fn end_at(&mut self, end_rad: f64) {
        self.range_rad[1] = self.range_rad[1].min(end_rad);
    }

    /// Flanks of the piece, for another piece.
    pub(super) fn shared_flanks(&self) -> Flanks {
        self.flanks.clone()
    }

    /// Flanks of the piece, also beyond its end.
    pub(super) fn flanks(&self) -> &dyn FlankAngle {
        &*self.flanks
    }

    /// Local ψ at which it begins and ends.
    pub(crate) fn range_rad(&self) -> Range<f64> {
        let [start, end] = self.range_rad;
        start..end
    }

    /// sin²ψ where it begins and where it ends.
    pub(crate) fn squares(&self) -> [f64; 2] {
        self.range_rad.map(|angle| angle.sin().powi(2))
    }

    /// sin²ψ over which its polynomials are fitted.
    pub(crate) fn domain(&self) -> [f64; 2] {
        self.domain
    }

    /// r as a polynomial in sin²ψ.
    pub(crate) fn radius(&self) -> &Polynomial {
        &self.radius
    }

    /// n and the polynomial P in sin²ψ of αc = (sin²θ − sin²ψ)ⁿ P, with sin²θ = `end`.
    pub(crate) fn angle(&self, end: f64) -> (f64, Polynomial) {
        let regular = |s: f64| self.flanks.regular(s, end);
        let [lo, hi] = self.domain;
        let polynomial = Polynomial::fit(regular, lo, hi, ANGLE_TOLERANCE);
        (self.flanks.order(), polynomial)
    }
}
