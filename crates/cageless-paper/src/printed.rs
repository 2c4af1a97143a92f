//! Numbers that the paper's text prints; those of Table 2 are in [`crate::PUBLISHED`].

/// Numbers of Sections 2 to 6 on which claims rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printed {
    /// β0 of 14 balls, degrees: Section 4.3.
    pub nominal_gap_deg: f64,
    /// 2(ε + β0), degrees: Section 4.3.
    pub three_balls_deg: f64,
    /// Least 2θ of the recommended range, degrees: Sections 4.3 and 6.
    pub span_min_deg: f64,
    /// 2θ of the sample, degrees: Section 5.
    pub sample_span_deg: f64,
    /// Change of the gap in the unloaded zone, degrees, which the paper neglects: Section 4.3.
    pub neglected_deg: f64,
    /// Differences of Table 2, degrees.
    pub differences_deg: [f64; 10],
}

/// Numbers as the paper prints them.
pub const PRINTED: Printed = Printed {
    nominal_gap_deg: 1.8161,
    three_balls_deg: 51.17,
    span_min_deg: 44.0,
    sample_span_deg: 2.0 * 25.2,
    neglected_deg: 0.033,
    differences_deg: [
        -0.0022, 0.0105, 0.0138, 0.0019, -0.0251, -0.0604, -0.1572, -0.1567, -0.2645, -0.3622,
    ],
};
