//! Frame of all sections of a ring.

use crate::bearing::Bearing;
use crate::case::Case;
use crate::raceway::Raceway;

/// Groove, ball and shoulder of all sections, turned by the contact angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SectionFrame {
    /// αg by which the sections are turned about the centre of the ball.
    pub(super) axis_rad: f64,
    /// ρ and z of the centre of the nominal ball that rests in the groove.
    pub(super) ball_m: [f64; 2],
    /// How much deeper it sits along αg with growing ψ, m/rad.
    pub(super) depth_slope_m: f64,
    /// Re − Rw.
    pub(super) offset_m: f64,
    /// Re.
    pub(super) curvature_radius_m: f64,
    /// Ros.
    pub(super) shoulder_radius_m: f64,
}

impl SectionFrame {
    /// Sections turned by αg in the outer ring of a bearing.
    pub(super) fn new(bearing: &Bearing, axis_rad: f64) -> Self {
        let d = bearing.dimensions();
        let offset_m = d.outer_groove_curvature_radius_m - d.ball_radius_m;
        let (sin, cos) = axis_rad.sin_cos();
        Self {
            axis_rad,
            ball_m: [
                bearing.outer_orbit_radius_m() - offset_m * (1.0 - cos),
                -bearing.groove_offset_m() + offset_m * sin,
            ],
            depth_slope_m: 0.0,
            offset_m,
            curvature_radius_m: d.outer_groove_curvature_radius_m,
            shoulder_radius_m: d.outer_shoulder_radius_m,
        }
    }

    /// Section frame of a raceway of a case, whose row may press its balls to −Z.
    pub(super) fn of(case: &Case, raceway: &Raceway) -> Self {
        let frame = Self::new(&case.bearing, raceway.section_angle_rad());
        match case.rows.as_slice() {
            [row] if row.contact_sign < 0.0 => frame.mirrored(),
            _ => frame,
        }
    }

    /// The frame where a ball sits deeper along αg, by m and m/rad.
    pub(super) fn deeper(self, [depth_m, depth_slope_m]: [f64; 2]) -> Self {
        let ([radius, height], (sin, cos)) = (self.ball_m, self.axis_rad.sin_cos());
        Self {
            ball_m: [radius + depth_m * cos, height + depth_m * sin],
            depth_slope_m,
            ..self
        }
    }

    /// Mirror image of the frame in z = 0.
    pub(super) fn mirrored(self) -> Self {
        let [radius, height] = self.ball_m;
        Self {
            axis_rad: -self.axis_rad,
            ball_m: [radius, -height],
            ..self
        }
    }
}
