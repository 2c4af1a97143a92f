//! A raceway of the shape of a drawing with the dimensions that it was made with.

use super::Meridian;
use super::section_frame::SectionFrame;
use crate::bearing::Bearing;
use crate::error::InputError;
use crate::raceway::{Raceway, RacewayDimensions};

/// A raceway of the drawing with other dimensions and another place.
#[derive(Debug, Clone)]
pub(super) struct MadeRaceway {
    /// The raceway where it was made.
    pub raceway: Raceway,
    /// Depth error of its middle, along the normals of its flanks, m.
    pub depth_error_m: f64,
}

impl MadeRaceway {
    /// The raceway with changes of lC, θ, ψ of its middle and depth error.
    ///
    /// # Errors
    /// No raceway has such dimensions.
    pub(super) fn moved(&self, bearing: &Bearing, step: [f64; 4]) -> Result<Self, InputError> {
        let [span, angle, turn, depth] = step;
        let d = self.raceway.dimensions();
        let dimensions = RacewayDimensions {
            axial_span_m: d.axial_span_m + span,
            half_angle_rad: d.half_angle_rad + angle,
            centre_angle_rad: d.centre_angle_rad + turn,
        };
        // The section is turned about the ball whatever the bearing allows.
        let made = Raceway::formed(dimensions, self.raceway.form(), bearing)?;
        Ok(Self {
            raceway: made,
            depth_error_m: self.depth_error_m + depth,
        })
    }

    /// Section at ψ in a groove of this frame; `None` outside the raceway.
    pub(super) fn meridian(&self, frame: &SectionFrame, angle_rad: f64) -> Option<Meridian> {
        let local = self.raceway.local_angle_rad(angle_rad);
        (local.abs() < self.raceway.half_angle_rad()).then(|| {
            let mut frame = frame.deeper(self.raceway.depth_at_m(angle_rad));
            frame.curvature_radius_m += self.depth_error_m * self.raceway.depth_share(angle_rad)[0];
            Meridian::new(&frame, angle_rad, self.raceway.contact_angle_rad(local))
        })
    }
}
