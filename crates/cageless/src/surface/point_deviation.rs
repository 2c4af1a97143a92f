//! How far measured points are from a surface that is fitted to them.

/// Distances of points from a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointDeviation {
    /// Number of points.
    pub points: usize,
    /// Root mean square, m.
    pub mean_m: f64,
    /// Largest, m.
    pub largest_m: f64,
}

impl PointDeviation {
    /// Deviation of points at these signed distances, m; the mean is NaN without points.
    pub(super) fn of(errors_m: impl Iterator<Item = f64>) -> Self {
        let (mut points, mut squares, mut largest_m) = (0, 0.0, 0.0f64);
        for error in errors_m {
            points += 1;
            squares += error * error;
            largest_m = largest_m.max(error.abs());
        }
        Self {
            points,
            mean_m: (squares / points as f64).sqrt(),
            largest_m,
        }
    }
}
