//! Vectors of two and three numbers in loops over lanes, where every operation must be inlined.
//!
//! ```
//! use cageless::numerics::{cross, dot};
//!
//! let normal = cross([1.0, 2.0, 0.0], [0.0, 1.0, 3.0]);
//! assert_eq!(normal, [6.0, -3.0, 1.0]);
//! assert_eq!(dot(normal, [1.0, 2.0, 0.0]), 0.0);
//! ```

/// **a** · **b**.
#[inline(always)]
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

/// **a** × **b**.
#[inline(always)]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + s **b**.
#[inline(always)]
pub(crate) fn plus(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

/// Vector of the plane across the axis, or a place there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PlaneVector<T = f64> {
    /// Part along X.
    pub x: T,
    /// Part along Y.
    pub y: T,
}

impl PlaneVector {
    /// Vector to this place from an origin.
    #[inline(always)]
    pub(crate) fn from(self, origin: Self) -> Self {
        Self {
            x: self.x - origin.x,
            y: self.y - origin.y,
        }
    }

    /// |**v**|².
    #[inline(always)]
    pub(crate) fn square(self) -> f64 {
        self.x * self.x + self.y * self.y
    }
}

/// Vector of a section through the axis, or a place there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SectionVector<T = f64> {
    /// Part along the radius.
    pub radial: T,
    /// Part along the axis.
    pub axial: T,
}

impl<T> SectionVector<T> {
    /// Both parts by a function of either.
    #[inline(always)]
    pub(crate) fn map<U>(self, of: impl Fn(T) -> U) -> SectionVector<U> {
        SectionVector {
            radial: of(self.radial),
            axial: of(self.axial),
        }
    }
}

impl SectionVector {
    /// **a** · **b**.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.radial * other.radial + self.axial * other.axial
    }

    /// |**v**|.
    #[inline(always)]
    pub(crate) fn length(self) -> f64 {
        self.dot(self).sqrt()
    }
}
