//! A smooth part of the ring's surface over two parameters.

use crate::numerics::bspline::Vec3;

/// A surface over an angle and a share from 0 to 1 across it.
pub(super) trait Sheet {
    /// Line across the sheet at one angle.
    type Fibre: Fibre;

    /// At an angle.
    fn fibre(&self, along_rad: f64) -> Self::Fibre;

    /// Distance from the surface of a point that is to be that of the parameters.
    fn off_m(&self, point: Vec3, along_rad: f64, across: f64) -> f64;
}

/// A line across a sheet, with derivatives over both parameters.
pub(super) trait Fibre {
    /// Point.
    fn point(&self, across: f64) -> Vec3;
    /// Derivative of the point along the line.
    fn across(&self, across: f64) -> Vec3;
    /// Derivative of the point over the angle.
    fn along(&self, across: f64) -> Vec3;
    /// The derivative over both.
    fn twist(&self, across: f64) -> Vec3;
}
