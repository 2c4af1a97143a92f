//! The groove in one meridian plane: on each side of z = 0 an arc, from the ridge at
//! z = 0 to the shoulder.

use crate::raceway::{SurfacePoint, surface_point};

/// Section of the groove at one ψ. The side z < 0 is the mirror image of z > 0, for which
/// the numbers stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meridian {
    /// ψ.
    pub angle_rad: f64,
    /// α, 0 on the plain raceway.
    pub contact_angle_rad: f64,
    /// Distance of the arc's centre Oe from the bearing axis.
    pub centre_radius_m: f64,
    /// z of Oe, 0 or less.
    pub centre_height_m: f64,
    /// d/dψ of [`Self::centre_radius_m`].
    pub radius_slope_m: f64,
    /// d/dψ of [`Self::centre_height_m`].
    pub height_slope_m: f64,
    /// Re.
    pub curvature_radius_m: f64,
    /// Ros.
    pub shoulder_radius_m: f64,
}

impl Meridian {
    /// η where the two halves meet, at z = 0; 0 or more.
    pub fn valley_rad(&self) -> f64 {
        (-self.centre_height_m / self.curvature_radius_m).asin()
    }

    /// η where the arc reaches the shoulder.
    pub fn shoulder_rad(&self) -> f64 {
        ((self.shoulder_radius_m - self.centre_radius_m) / self.curvature_radius_m).acos()
    }

    /// dη/dψ of [`Self::valley_rad`] and of [`Self::shoulder_rad`].
    pub fn limit_slopes(&self) -> [f64; 2] {
        let re = self.curvature_radius_m;
        [
            -self.height_slope_m / (re * self.valley_rad().cos()),
            self.radius_slope_m / (re * self.shoulder_rad().sin()),
        ]
    }

    /// Distance from the axis at η ≥ 0.
    pub fn radius_at_m(&self, meridian_rad: f64) -> f64 {
        self.centre_radius_m + self.curvature_radius_m * meridian_rad.cos()
    }

    /// z at η ≥ 0.
    pub fn height_m(&self, meridian_rad: f64) -> f64 {
        self.centre_height_m + self.curvature_radius_m * meridian_rad.sin()
    }

    /// Distance of the groove from the axis at height z, NaN beyond the arc.
    pub fn radius_m(&self, z_m: f64) -> f64 {
        let rise = z_m.abs() - self.centre_height_m;
        self.centre_radius_m + (self.curvature_radius_m.powi(2) - rise * rise).sqrt()
    }

    /// Point of the surface at η; η < 0 is the side z < 0.
    pub fn point(&self, meridian_rad: f64) -> SurfacePoint {
        let curve = [
            self.centre_radius_m,
            self.centre_height_m,
            self.radius_slope_m,
            self.height_slope_m,
        ];
        surface_point(curve, self.curvature_radius_m, self.angle_rad, meridian_rad)
    }

    /// Angle by which the change along ψ tilts the normal at η out of that of the plain
    /// raceway, where the centre moves along z alone.
    pub(super) fn tilt_rad(&self, meridian_rad: f64) -> f64 {
        (self.height_slope_m.abs() * meridian_rad.sin()).atan2(self.radius_at_m(meridian_rad))
    }

    /// Distance of the point (ρ, z) of this plane from the surface along its normal,
    /// positive inside the material.
    pub(super) fn distance_m(&self, radius_m: f64, z_m: f64) -> f64 {
        let re = self.curvature_radius_m;
        let (out, up) = (
            radius_m - self.centre_radius_m,
            z_m.abs() - self.centre_height_m,
        );
        let within = out.hypot(up) - re;
        // The normal leans out of the meridian plane where Oe moves along ψ.
        let (sin, cos) = (up / (within + re), out / (within + re));
        let lean = (self.radius_slope_m * cos + self.height_slope_m * sin) / radius_m;
        within / (1.0 + lean * lean).sqrt()
    }

    /// ∫ ρ² dz from z = 0 to the shoulder: twice the area moment of the hollow about the
    /// axis on one side, so that it is that of both sides.
    pub(super) fn hollow_moment_m3(&self) -> f64 {
        let (c, re) = (self.centre_radius_m, self.curvature_radius_m);
        let primitive = |eta: f64| {
            let (sin, cos) = eta.sin_cos();
            c * c * re * sin
                + c * re * re * (eta + sin * cos)
                + re.powi(3) * (sin - sin.powi(3) / 3.0)
        };
        primitive(self.shoulder_rad()) - primitive(self.valley_rad())
    }
}
