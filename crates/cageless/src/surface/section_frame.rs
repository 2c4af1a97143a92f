//! What all sections of a ring share.

/// Groove, ball and shoulder of all sections, turned by the contact angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SectionFrame {
    /// αg by which the sections are turned about the centre of the ball.
    pub(super) axis_rad: f64,
    /// ρ and z of the centre of the nominal ball that rests in the groove.
    pub(super) ball_m: [f64; 2],
    /// Re − Rw.
    pub(super) offset_m: f64,
    /// Re.
    pub(super) curvature_radius_m: f64,
    /// Ros.
    pub(super) shoulder_radius_m: f64,
}

impl SectionFrame {
    /// Its mirror image in z = 0.
    pub(super) fn mirrored(self) -> Self {
        let [radius, height] = self.ball_m;
        Self {
            axis_rad: -self.axis_rad,
            ball_m: [radius, -height],
            ..self
        }
    }
}
