//! One side of the groove in a sector, from the ridge to the shoulder.

use super::directions::vector;
use super::patch::{Patch, PatchError};
use super::sheet::{Fibre, Sheet};
use super::{Arc, OuterRing, RingSector, Side};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::bspline::Vec3;

/// The surface over ψ and the share of η from the ridge on.
struct Flank<'a> {
    ring: &'a OuterRing,
    sector: &'a RingSector,
    side: Side,
}

impl Patch {
    /// Upper and lower side of a sector's groove, [`Self::deviation_m`] of both below `tolerance_m`.
    ///
    /// # Errors
    /// A [`PatchError`] if the points would become too many.
    pub fn pair(
        ring: &OuterRing,
        sector: &RingSector,
        tolerance_m: f64,
    ) -> Result<[Self; 2], PatchError> {
        let flanks = Side::BOTH.map(|side| Flank { ring, sector, side });
        Self::of(&flanks, sector.start_rad..sector.end_rad, tolerance_m)
    }

    /// Largest distance of the patch of one side of a sector's groove from the analytic surface, and
    /// of its last row from the shoulder's cylinder, at nine points of each interval each way that are
    /// not sites.
    pub fn deviation_m(&self, ring: &OuterRing, sector: &RingSector, side: Side) -> f64 {
        self.off_m(&Flank { ring, sector, side })
    }
}

impl Sheet for Flank<'_> {
    type Fibre = Section;

    fn fibre(&self, along_rad: f64) -> Section {
        let meridian = self.ring.meridian_in(self.sector, along_rad);
        Section::new(*meridian.arc(self.side), along_rad)
    }

    /// That from the groove, at the shoulder also from the cylinder of the shoulder.
    fn off_m(&self, [x, y, z]: Vec3, _: f64, across: f64) -> f64 {
        let rho = x.hypot(y);
        let middle = self.sector.middle_rad();
        let own = middle + wrap_angle_rad(x.atan2(-y) - middle);
        let meridian = self.ring.meridian_in(self.sector, own);
        let arc = meridian.arc(self.side);
        let off = arc.distance_m(rho, self.side.sign() * z).abs();
        if across == 1.0 {
            off.max((rho - self.ring.shoulder_radius_m).abs())
        } else {
            off
        }
    }
}

/// The arc at one ψ.
struct Section {
    arc: Arc,
    angle_rad: f64,
    valley: f64,
    range: f64,
    /// dη/dψ at fixed parameter: at the ridge, and how much more at the shoulder.
    drift: [f64; 2],
}

impl Section {
    fn new(arc: Arc, angle_rad: f64) -> Self {
        let valley = arc.valley_rad();
        let [valley_slope, shoulder_slope] = arc.limit_slopes();
        Self {
            valley,
            range: arc.shoulder_rad() - valley,
            drift: [valley_slope, shoulder_slope - valley_slope],
            arc,
            angle_rad,
        }
    }

    fn eta(&self, u: f64) -> f64 {
        self.valley + u * self.range
    }

    /// Vector from its components outwards, along ψ and towards the shoulder.
    fn vector(&self, [radial, tangential, axial]: Vec3) -> Vec3 {
        let axial = self.arc.side.sign() * axial;
        vector(self.angle_rad, [radial, tangential, axial])
    }
}

impl Fibre for Section {
    fn point(&self, u: f64) -> Vec3 {
        let (arc, eta) = (&self.arc, self.eta(u));
        // Exactly 0 where the section is not turned.
        let height = if u == 0.0 {
            arc.ridge_height_m()
        } else {
            arc.height_m(eta)
        };
        self.vector([arc.radius_at_m(eta), 0.0, height])
    }

    fn across(&self, u: f64) -> Vec3 {
        let (sin, cos) = self.eta(u).sin_cos();
        let arc = self.arc.curvature_radius_m * self.range;
        self.vector([-arc * sin, 0.0, arc * cos])
    }

    fn along(&self, u: f64) -> Vec3 {
        let (arc, eta) = (&self.arc, self.eta(u));
        let (sin, cos) = eta.sin_cos();
        let drift = arc.curvature_radius_m * (self.drift[0] + u * self.drift[1]);
        let radial = arc.radius_slope_m - drift * sin;
        let axial = if u == 0.0 {
            // The ridge stays on the axis of the section.
            radial * arc.axis_slope()
        } else {
            arc.height_slope_m + drift * cos
        };
        self.vector([radial, arc.radius_at_m(eta), axial])
    }

    fn twist(&self, u: f64) -> Vec3 {
        let (sin, cos) = self.eta(u).sin_cos();
        let re = self.arc.curvature_radius_m;
        let (arc, change) = (re * self.range, re * self.drift[1]);
        let drift = self.drift[0] + u * self.drift[1];
        self.vector([
            -change * sin - arc * cos * drift,
            -arc * sin,
            change * cos - arc * sin * drift,
        ])
    }
}
