//! Interference of a ring with its seat.

/// Effective interference of a ring with its seat on the diameter, m; below 0 a gap.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Interference {
    /// Interference at the middles of both tolerances, m.
    pub mean_m: f64,
    /// Three standard deviations, each diameter with a standard deviation of a sixth of its tolerance
    /// (NTN 2203/E, Eq. (8.3)).
    pub probable_m: f64,
    /// Half the sum of both tolerances.
    pub extreme_m: f64,
}

impl Interference {
    /// A known one.
    pub(super) fn exact(mean_m: f64) -> Self {
        Self {
            mean_m,
            ..Self::default()
        }
    }

    /// Interference of an inner part in an outer one by the limit deviations of their common nominal diameter.
    pub(super) fn of_limits(inner_m: [f64; 2], outer_m: [f64; 2], smoothing_m: f64) -> Self {
        let [inner, outer] =
            [inner_m, outer_m].map(|[lower_m, upper_m]| Deviations { lower_m, upper_m });
        Self {
            mean_m: inner.middle_m() - outer.middle_m() - smoothing_m,
            probable_m: inner.half_m().hypot(outer.half_m()),
            extreme_m: inner.half_m() + outer.half_m(),
        }
    }
}

/// Limit deviations of a diameter from its nominal size, m.
struct Deviations {
    lower_m: f64,
    upper_m: f64,
}

impl Deviations {
    /// Middle of the tolerance, m.
    fn middle_m(&self) -> f64 {
        0.5 * (self.lower_m + self.upper_m)
    }

    /// Half the tolerance, m.
    fn half_m(&self) -> f64 {
        0.5 * (self.upper_m - self.lower_m)
    }
}
