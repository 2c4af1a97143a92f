//! Flanks along the contact path of Zhao 2022.

use std::sync::Arc;

use crate::error::InputError;
use crate::raceway::contact_path::ContactPath;
use crate::raceway::flank_angle::{FlankAngle, Flanks};
use crate::raceway::outline::Outline;

/// Flanks of an outline along the quartic contact path.
pub(super) fn flanks(outline: &Outline<'_>) -> Result<Flanks, InputError> {
    let (span, theta) = (outline.axial_span_m, outline.half_angle_rad);
    Ok(Arc::new(ContactPath::new(span, theta, outline.bearing)?))
}

impl FlankAngle for ContactPath {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        self.contact_angle_rad(local_angle_rad)
    }

    fn radius_m(&self, local_angle_rad: f64, _ball_radius_m: f64) -> f64 {
        self.radius_by_root(local_angle_rad)
    }

    fn contact_path(&self) -> Option<&ContactPath> {
        Some(self)
    }
}
