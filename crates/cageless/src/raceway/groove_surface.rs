//! Surface of a discrete raceway: groove curve, normals and the kink at its ends (Zhao 2022,
//! Eq. (7)).

use super::Raceway;
use crate::bearing::Bearing;
use crate::numerics::vector::{cross, dot};

/// A point of the raceway surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Position in the frame of the bearing.
    pub position_m: [f64; 3],
    /// Unit normal, out of the ring's material.
    pub normal: [f64; 3],
}

impl Raceway {
    /// Distance of Oe from the bearing axis, its z, and the derivatives of both with
    /// respect to ψ, at local ψ (branch z > 0).
    fn groove_curve(&self, local_angle_rad: f64) -> [f64; 4] {
        let offset = self.groove_curvature_radius_m - self.ball_radius_m;
        let contact = if local_angle_rad.abs() < self.dimensions.half_angle_rad {
            self.contact_angle_rad(local_angle_rad)
        } else {
            [0.0; 2]
        };
        let [depth, depth_slope] =
            self.depth_at_m(self.dimensions.centre_angle_rad + local_angle_rad);
        let touching = self.outer_orbit_radius_m() + depth;
        let [radial, axial, radial_slope, axial_slope] = groove_centre(touching, offset, contact);
        [radial, axial, radial_slope + depth_slope, axial_slope]
    }

    /// Point of the raceway surface at ψ and meridian angle η, the angle at Oe between
    /// the outward radius and the point. η ≥ 0 lies on the side z ≥ 0, η < 0 on its
    /// mirror image. From the range of
    /// [`Self::meridian_range_rad`] upwards the surface is that of the groove; nearer to
    /// η = 0 the circle goes on beyond the plane z = 0. The section is not turned here, see
    /// [`crate::surface::OuterRing`].
    pub fn surface(&self, angle_rad: f64, meridian_rad: f64) -> SurfacePoint {
        let local = self.local_angle_rad(angle_rad);
        let (curve, re) = (self.groove_curve(local), self.groove_curvature_radius_m);
        let side = if meridian_rad < 0.0 { -1.0 } else { 1.0 };
        surface_point(curve, re, angle_rad, meridian_rad.abs(), side)
    }

    /// Range of |η| on one side at ψ: from the plane z = 0 to the shoulder.
    pub fn meridian_range_rad(&self, angle_rad: f64, bearing: &Bearing) -> [f64; 2] {
        let [radial, axial, ..] = self.groove_curve(self.local_angle_rad(angle_rad));
        let re = self.groove_curvature_radius_m;
        let shoulder = bearing.dimensions().outer_shoulder_radius_m;
        [
            (-axial / re).asin(),
            ((shoulder - radial) / re).clamp(-1.0, 1.0).acos(),
        ]
    }

    /// Angle between the normals of the discrete and the plain raceway where they
    /// meet, at meridian angle η. It is not zero because z′ is not.
    pub fn kink_angle_rad(&self, meridian_rad: f64) -> f64 {
        let end = self.dimensions.half_angle_rad;
        let re = self.groove_curvature_radius_m;
        let within = self.groove_curve(end * (1.0 - 1e-9));
        let plain = [self.groove_bottom_radius_m - re, 0.0, 0.0, 0.0];
        let normal = |curve| surface_point(curve, re, end, meridian_rad.abs(), 1.0).normal;
        let (n1, n2) = (normal(within), normal(plain));
        let cross = cross(n1, n2);
        dot(cross, cross).sqrt().asin()
    }
}

/// Eq. (7) in terms of α: Oe is Re − Rw behind the ball's centre on the line through the
/// contact point. Its distance from the axis, its z, and the derivatives of both with
/// respect to ψ, from α and dα/dψ.
pub(crate) fn groove_centre(
    touching_m: f64,
    offset_m: f64,
    [contact, slope]: [f64; 2],
) -> [f64; 4] {
    let (sin, cos) = contact.sin_cos();
    [
        touching_m - offset_m * cos,
        -offset_m * sin,
        offset_m * sin * slope,
        -offset_m * cos * slope,
    ]
}

/// Point at ψ and η of the arc of radius `re` about a centre of this curve; axial components of
/// curve, η and arc count towards `side`, 1 or −1.
pub(crate) fn surface_point(
    curve: [f64; 4],
    re: f64,
    angle: f64,
    meridian: f64,
    side: f64,
) -> SurfacePoint {
    let [radial, axial, radial_slope, axial_slope] = curve;
    let (sin_m, cos_m) = meridian.sin_cos();
    let (sin, cos) = angle.sin_cos();
    let (e, t) = ([sin, -cos], [cos, sin]);
    let rho = radial + re * cos_m;
    let z = axial + re * sin_m;
    // ∂S/∂ψ = ρ t + ρe′ e + ze′ k and ∂S/∂η = Re(−sin η e + cos η k); their cross
    // product, turned towards the axis, is normal to the surface.
    let along = [
        rho * t[0] + radial_slope * e[0],
        rho * t[1] + radial_slope * e[1],
        axial_slope,
    ];
    let across = [-sin_m * e[0], -sin_m * e[1], cos_m];
    let mut n = cross(across, along);
    let length = dot(n, n).sqrt();
    n = n.map(|c| c / length);
    if n[0] * e[0] + n[1] * e[1] > 0.0 {
        n = n.map(|c| -c);
    }
    SurfacePoint {
        position_m: [rho * e[0], rho * e[1], side * z],
        normal: [n[0], n[1], side * n[2]],
    }
}
