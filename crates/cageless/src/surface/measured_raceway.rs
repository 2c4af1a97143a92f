//! A raceway as it was measured.

use super::measured_groove::MeasuredGroove;
use super::measured_value::MeasuredValue;
use super::point_deviation::PointDeviation;
use super::recess::MeasuredSlot;

/// Measured counterpart of a raceway of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub enum MeasuredRaceway {
    /// Nothing: the groove is plain there.
    None {
        /// lC that points of the groove have there at most, with its uncertainty, m; `None` if none comes near them.
        axial_span_m: Option<MeasuredValue>,
    },
    /// Flanks.
    Flanks(Box<MeasuredFlank>),
    /// A slot.
    Slot(Box<MeasuredSlot>),
}

/// Dimensions and flanks of a raceway.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredFlank {
    /// lC, m.
    pub axial_span_m: MeasuredValue,
    /// θ, rad.
    pub half_angle_rad: MeasuredValue,
    /// ψ of the middle, rad.
    pub centre_angle_rad: MeasuredValue,
    /// Depth error of the middle, along the normals of its flanks, m: above 0 too deep.
    pub depth_error_m: MeasuredValue,
    /// Depth error beside [`Self::profile`], with which it was fitted, m; 0 where none is significant.
    pub profile_depth_error_m: f64,
    /// Distances of the points within ±θ from the profile.
    pub deviation: PointDeviation,
    /// Flanks of any shape.
    pub(crate) groove: MeasuredGroove,
}

impl MeasuredFlank {
    /// Rows of ψ from the middle of the raceway and αc, in `intervals` from there to the end and denser
    /// there.
    pub fn profile(&self, intervals: usize) -> Vec<[f64; 2]> {
        self.groove.rows(intervals)
    }
}
