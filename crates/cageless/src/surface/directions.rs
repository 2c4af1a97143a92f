//! Directions of the ring at ψ.

use crate::numerics::bspline::Vec3;

/// Vector from its components outwards, along ψ and along z.
pub(super) fn vector(angle_rad: f64, [radial, tangential, axial]: Vec3) -> Vec3 {
    let (sin, cos) = angle_rad.sin_cos();
    [
        radial * sin + tangential * cos,
        -radial * cos + tangential * sin,
        axial,
    ]
}
