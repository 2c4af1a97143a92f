//! The plain groove in a sector as one sheet.

use super::directions::vector;
use super::patch::{Patch, PatchError};
use super::sheet::{Fibre, Sheet};
use super::{Arc, Meridian, OuterRing, RingSector};
use crate::numerics::bspline::Vec3;

/// The plain groove over ψ and the share of η from the lower shoulder to the upper one.
struct PlainGroove(Meridian);

/// Arc of the plain groove at one ψ.
struct Section {
    arc: Arc,
    angle_rad: f64,
    /// η of the shoulders.
    limits: [f64; 2],
}

impl Patch {
    /// The groove of a plain sector from the lower shoulder to the upper one, and its largest distance from the
    /// analytic surface.
    ///
    /// # Errors
    /// As [`Self::pair`].
    pub fn plain(
        ring: &OuterRing,
        sector: &RingSector,
        tolerance_m: f64,
    ) -> Result<(Self, f64), PatchError> {
        let sheets = [PlainGroove(ring.plain_meridian(0.0))];
        let range = sector.start_rad..sector.end_rad;
        let [patch] = Self::of(&sheets, range, tolerance_m)?;
        let off_m = patch.off_m(&sheets[0]);
        Ok((patch, off_m))
    }
}

impl Sheet for PlainGroove {
    type Fibre = Section;

    fn fibre(&self, along_rad: f64) -> Section {
        // Upper and lower arc are one.
        let [upper, lower] = self.0.arcs;
        Section {
            arc: upper,
            angle_rad: along_rad,
            limits: [-lower.shoulder_rad(), upper.shoulder_rad()],
        }
    }

    /// That from the groove, at the shoulders also from their cylinder.
    fn off_m(&self, [x, y, z]: Vec3, _: f64, across: f64) -> f64 {
        let rho = x.hypot(y);
        let off = self.0.distance_m(rho, z).abs();
        if across == 0.0 || across == 1.0 {
            off.max((rho - self.0.arcs[0].shoulder_radius_m).abs())
        } else {
            off
        }
    }
}

impl Section {
    /// η, and its derivative over the share.
    fn eta(&self, across: f64) -> [f64; 2] {
        let range = self.limits[1] - self.limits[0];
        [self.limits[0] + across * range, range]
    }
}

impl Fibre for Section {
    fn point(&self, across: f64) -> Vec3 {
        let [eta, _] = self.eta(across);
        let place = [self.arc.radius_at_m(eta), 0.0, self.arc.height_m(eta)];
        vector(self.angle_rad, place)
    }

    fn across(&self, across: f64) -> Vec3 {
        let [eta, range] = self.eta(across);
        let (sin, cos) = eta.sin_cos();
        let scale = self.arc.curvature_radius_m * range;
        vector(self.angle_rad, [-scale * sin, 0.0, scale * cos])
    }

    fn along(&self, across: f64) -> Vec3 {
        let [eta, _] = self.eta(across);
        vector(self.angle_rad, [0.0, self.arc.radius_at_m(eta), 0.0])
    }

    fn twist(&self, across: f64) -> Vec3 {
        let [eta, range] = self.eta(across);
        let scale = self.arc.curvature_radius_m * range;
        vector(self.angle_rad, [0.0, -scale * eta.sin(), 0.0])
    }
}
