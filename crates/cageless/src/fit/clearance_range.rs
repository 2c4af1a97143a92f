//! Range of the radial internal clearance in operation.

/// Least and largest radial internal clearance in operation, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClearanceRange {
    /// Three standard deviations from the mean: 99.7 % of the bearings lie within.
    pub probable_m: [f64; 2],
    /// All tolerances at their worst limits together.
    pub extreme_m: [f64; 2],
}
