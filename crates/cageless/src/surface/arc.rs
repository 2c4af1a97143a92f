//! One side of the groove in a meridian plane: an arc from the ridge to a shoulder.

use super::section_frame::SectionFrame;
use super::side::Side;

/// A point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Position in the frame of the bearing.
    pub position_m: [f64; 3],
    /// Unit normal, out of the ring's material.
    pub normal: [f64; 3],
}

/// An arc of the groove. Its z and η count towards its own shoulder: those of the ring times the
/// sign of its side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Side of the ridge.
    pub side: Side,
    /// η at which it touches the ball, ±αg + α.
    pub contact_angle_rad: f64,
    /// Distance of the arc's centre Oe from the bearing axis.
    pub centre_radius_m: f64,
    /// z of Oe.
    pub centre_height_m: f64,
    /// d/dψ of [`Self::centre_radius_m`].
    pub radius_slope_m: f64,
    /// d/dψ of [`Self::centre_height_m`].
    pub height_slope_m: f64,
    /// Re.
    pub curvature_radius_m: f64,
    /// Ros.
    pub shoulder_radius_m: f64,
    /// ±αg: η of the axis of the section, on which ridge and centre of the ball are.
    pub(super) axis_rad: f64,
    /// ρ and z of the centre of the ball.
    ball_m: [f64; 2],
    /// Distance of Oe from the axis of the section, 0 or less, and its d/dψ.
    lateral_m: [f64; 2],
}

impl Arc {
    /// Arc at the flank angle α with dα/dψ.
    pub(super) fn new(frame: &SectionFrame, side: Side, [flank, slope]: [f64; 2]) -> Self {
        let frame = match side {
            Side::Upper => *frame,
            Side::Lower => frame.mirrored(),
        };
        let [ball_radius, ball_height] = frame.ball_m;
        // At an end α is −0.
        let flank = flank.abs();
        let contact_angle_rad = frame.axis_rad + flank;
        // Eq. (7) of Zhao 2022 in terms of the angle: Oe is Re − Rw behind the ball's centre on the line
        // through the contact point.
        let behind = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [sin, cos].map(|part| -frame.offset_m * part)
        };
        let [height, radius] = behind(contact_angle_rad);
        let [lateral, forward] = behind(flank);
        let (sin, cos) = frame.axis_rad.sin_cos();
        Self {
            side,
            contact_angle_rad,
            centre_radius_m: ball_radius + radius,
            centre_height_m: height + ball_height,
            radius_slope_m: frame.depth_slope_m * cos - height * slope,
            height_slope_m: frame.depth_slope_m * sin + radius * slope,
            curvature_radius_m: frame.curvature_radius_m,
            shoulder_radius_m: frame.shoulder_radius_m,
            axis_rad: frame.axis_rad,
            ball_m: frame.ball_m,
            lateral_m: [lateral, forward * slope],
        }
    }

    /// η of the ridge, where it meets the other arc.
    pub fn valley_rad(&self) -> f64 {
        self.axis_rad + (-self.lateral_m[0] / self.curvature_radius_m).asin()
    }

    /// η where the arc reaches the shoulder.
    pub fn shoulder_rad(&self) -> f64 {
        ((self.shoulder_radius_m - self.centre_radius_m) / self.curvature_radius_m).acos()
    }

    /// dη/dψ of [`Self::valley_rad`] and of [`Self::shoulder_rad`].
    pub(crate) fn limit_slopes(&self) -> [f64; 2] {
        let re = self.curvature_radius_m;
        [
            -self.lateral_m[1] / (re * (self.valley_rad() - self.axis_rad).cos()),
            self.radius_slope_m / (re * self.shoulder_rad().sin()),
        ]
    }

    /// Distance from the axis at η.
    pub fn radius_at_m(&self, meridian_rad: f64) -> f64 {
        self.centre_radius_m + self.curvature_radius_m * meridian_rad.cos()
    }

    /// z at η.
    pub fn height_m(&self, meridian_rad: f64) -> f64 {
        self.centre_height_m + self.curvature_radius_m * meridian_rad.sin()
    }

    /// z of the ridge, the opposite of that of the other arc; 0 where the section is not turned.
    pub fn ridge_height_m(&self) -> f64 {
        let [radius, height] = self.ball_m;
        height + self.axis_slope() * (self.radius_at_m(self.valley_rad()) - radius)
    }

    /// dz/dρ along the axis of the section.
    pub(super) fn axis_slope(&self) -> f64 {
        self.axis_rad.tan()
    }

    /// Distance from the axis at height z, NaN beyond the arc.
    pub fn radius_m(&self, z_m: f64) -> f64 {
        let rise = z_m - self.centre_height_m;
        self.centre_radius_m + (self.curvature_radius_m.powi(2) - rise * rise).sqrt()
    }

    /// Largest distance from the axis: at the ridge, or where it runs along z.
    pub(crate) fn deepest_radius_m(&self) -> f64 {
        if self.valley_rad() >= 0.0 {
            self.radius_m(self.ridge_height_m())
        } else {
            self.radius_at_m(0.0)
        }
    }

    /// Point of the surface at ψ and η, in the frame of the bearing: its normal is turned to ψ by what the
    /// arc climbs.
    pub fn point(&self, angle_rad: f64, meridian_rad: f64) -> SurfacePoint {
        let ((sin_m, cos_m), (sin, cos)) = (meridian_rad.sin_cos(), angle_rad.sin_cos());
        let (rho, climb) = (self.radius_at_m(meridian_rad), self.climb_m(meridian_rad));
        let length = rho.hypot(climb);
        let (radial, along) = (-rho * cos_m / length, climb / length);
        let axial = -rho * sin_m / length;
        SurfacePoint {
            position_m: [
                rho * sin,
                -rho * cos,
                self.side.sign() * self.height_m(meridian_rad),
            ],
            normal: [
                radial * sin + along * cos,
                along * sin - radial * cos,
                self.side.sign() * axial,
            ],
        }
    }

    /// How far the surface at η moves out along its normal in the meridian plane with ψ, m/rad.
    fn climb_m(&self, meridian_rad: f64) -> f64 {
        let (sin, cos) = meridian_rad.sin_cos();
        self.radius_slope_m * cos + self.height_slope_m * sin
    }

    /// Angle by which the change along ψ tilts the normal at η out of the meridian plane.
    pub(super) fn tilt_rad(&self, meridian_rad: f64) -> f64 {
        let climb = self.climb_m(meridian_rad);
        climb.abs().atan2(self.radius_at_m(meridian_rad))
    }

    /// Whether (ρ, z) is on this side of the axis of the section.
    pub(super) fn has(&self, radius_m: f64, z_m: f64) -> bool {
        let ([radius, height], (sin, cos)) = (self.ball_m, self.axis_rad.sin_cos());
        (z_m - height) * cos - (radius_m - radius) * sin >= 0.0
    }

    /// Distance of the point (ρ, z) of this plane from the surface along its normal,
    /// positive inside the material.
    pub(super) fn distance_m(&self, radius_m: f64, z_m: f64) -> f64 {
        let re = self.curvature_radius_m;
        let (out, up) = (radius_m - self.centre_radius_m, z_m - self.centre_height_m);
        let within = out.hypot(up) - re;
        // The normal leans out of the meridian plane where Oe moves along ψ.
        let (sin, cos) = (up / (within + re), out / (within + re));
        let lean = (self.radius_slope_m * cos + self.height_slope_m * sin) / radius_m;
        within / (1.0 + lean * lean).sqrt()
    }

    /// ∫ ρ² dz from the ridge to the shoulder: twice the area moment of the hollow about the axis
    /// on this side.
    pub(super) fn hollow_moment_m3(&self) -> f64 {
        let primitive = |eta: f64| moment_m3(self.centre_radius_m, self.curvature_radius_m, eta);
        primitive(self.shoulder_rad()) - primitive(self.valley_rad())
    }
}

/// ∫ ρ² dz from η = 0 along an arc of radius re whose centre is at the distance c from the axis.
pub(super) fn moment_m3(c: f64, re: f64, eta: f64) -> f64 {
    let (sin, cos) = eta.sin_cos();
    c * c * re * sin + c * re * re * (eta + sin * cos) + re.powi(3) * (sin - sin.powi(3) / 3.0)
}
