//! Lubricated point contact of a ball with a raceway.

use std::f64::consts::PI;

use crate::bearing::Bearing;
use crate::contact::creep::creep_stiffness_n1_3;
use crate::contact::hertz::{PointContact, modulus_of_pair_pa};
use crate::material::Material;
use crate::numerics::elliptic;

/// Dry constants of a lubricated point contact: radii, modulus and ellipse of Hertz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LubricatedContact {
    /// R_x, reduced radius along rolling, m.
    pub rolling_radius_m: f64,
    /// R_y, reduced radius across, m.
    pub cross_radius_m: f64,
    /// E′ with 2/E′ = Σ (1 − ν²)/E, Pa.
    pub modulus_pa: f64,
    /// κ, semi-axis of the ellipse along rolling over that across.
    pub axis_ratio: f64,
    /// β = (4/π) 𝓔/(1 + R_x/R_y), 𝓔 of m = 1 − κ².
    pub ellipse_factor: f64,
    /// Semi-axis across per N^(1/3), m.
    pub cross_axis_m_n1_3: f64,
}

impl LubricatedContact {
    /// Contact of two bodies with these curvatures, 1/m, along rolling and across.
    pub(crate) fn between(one: [f64; 2], other: [f64; 2], materials: [&Material; 2]) -> Self {
        let ellipse = PointContact::between(one, other, materials);
        let [along, across] = ellipse.semi_axes_m(1.0);
        let [rolling_radius_m, cross_radius_m] = [0, 1].map(|k| 1.0 / (one[k] + other[k]));
        let axis_ratio = along / across;
        let (_, second) = elliptic::complete(1.0 - axis_ratio * axis_ratio);
        Self {
            rolling_radius_m,
            cross_radius_m,
            modulus_pa: 2.0 * modulus_of_pair_pa(materials),
            axis_ratio,
            ellipse_factor: 4.0 / PI * second / (1.0 + rolling_radius_m / cross_radius_m),
            cross_axis_m_n1_3: across,
        }
    }

    /// Nominal ball at the plain inner raceway.
    pub(crate) fn inner(bearing: &Bearing) -> Self {
        Self::inner_curved(
            bearing,
            1.0 / bearing.dimensions().inner_groove_bottom_radius_m,
        )
    }

    /// Nominal ball at the inner raceway where its ring curves along rolling by this, 1/m: cos α over the distance of
    /// the contact from the axis.
    pub(crate) fn inner_curved(bearing: &Bearing, curvature: f64) -> Self {
        let groove_m = bearing.dimensions().inner_groove_curvature_radius_m;
        Self::of_ring(bearing, [curvature, -1.0 / groove_m])
    }

    /// Nominal ball at the outer raceway under the angle of this cosine: 1 on the plain raceway, less on either flank
    /// of a discrete one. The ring curves along rolling by −cos α/(Ro − Rw + Rw cos α).
    pub(crate) fn outer(bearing: &Bearing, cosine: f64) -> Self {
        let contact_radius_m = bearing.outer_orbit_radius_m() + bearing.ball_radius_m() * cosine;
        Self::outer_curved(bearing, cosine / contact_radius_m)
    }

    /// Nominal ball at the outer raceway where its ring curves along rolling by minus this, 1/m: cos α over the distance
    /// of the contact from the axis.
    pub(crate) fn outer_curved(bearing: &Bearing, curvature: f64) -> Self {
        let groove_m = bearing.dimensions().outer_groove_curvature_radius_m;
        Self::of_ring(bearing, [-curvature, -1.0 / groove_m])
    }

    /// Nominal ball at a ring with these curvatures along rolling and across, 1/m.
    pub(crate) fn of_ring(bearing: &Bearing, ring: [f64; 2]) -> Self {
        let materials = bearing.materials();
        let ball = [1.0 / bearing.ball_radius_m(); 2];
        Self::between(ball, ring, [&materials.ball, &materials.ring])
    }

    /// a, semi-axis across under a load, m.
    pub(crate) fn cross_axis_m(&self, load_n: f64) -> f64 {
        self.cross_axis_m_n1_3 * load_n.max(0.0).cbrt()
    }

    /// A = πab, area of the ellipse over Q^(2/3), m²/N^(2/3).
    pub(super) fn area_m2_n2_3(&self) -> f64 {
        PI * self.cross_axis_m_n1_3.powi(2) * self.axis_ratio
    }

    /// G ca cb C11 of this contact of a ball and a ring, N^(1/3).
    pub(super) fn creep_stiffness_n1_3(&self, bearing: &Bearing) -> f64 {
        let materials = bearing.materials();
        let across = self.cross_axis_m_n1_3;
        let axes = [self.axis_ratio * across, across];
        creep_stiffness_n1_3(axes, [&materials.ball, &materials.ring])
    }

    /// W = Q/(E′ R_x²).
    pub(super) fn load_parameter(&self, load_n: f64) -> f64 {
        load_n / (self.modulus_pa * self.rolling_radius_m.powi(2))
    }
}
