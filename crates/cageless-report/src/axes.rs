//! A pair of axes of a plot.

/// Names of a pair of axes, as marks and traces give them: `x2` and `y2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axes<'a> {
    /// Name of the axis along x.
    pub x: &'a str,
    /// Name of the axis along y.
    pub y: &'a str,
}

impl Axes<'static> {
    /// First pair of a plot.
    pub const FIRST: Self = Self { x: "x", y: "y" };
}
