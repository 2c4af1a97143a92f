//! Outline of a discrete raceway.

use super::{MeasuredFlanks, SplineFlanks};
use crate::bearing::Bearing;

/// Dimensions of a discrete raceway for the layout of its flanks.
pub(super) struct Outline<'a> {
    /// lC, m.
    pub axial_span_m: f64,
    /// θ.
    pub half_angle_rad: f64,
    /// The shape of a measured ring, if the raceway has it.
    pub measured: Option<MeasuredFlanks>,
    /// re of a slot, m.
    pub edge_radius_m: f64,
    /// The spline of the raceway, if it has one.
    pub spline: Option<SplineFlanks>,
    pub bearing: &'a Bearing,
}

impl Outline<'_> {
    /// α0, with sin α0 = lC/(2 Rw).
    pub(super) fn middle_rad(&self) -> f64 {
        (self.axial_span_m / (2.0 * self.bearing.ball_radius_m())).asin()
    }
}
