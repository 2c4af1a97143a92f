//! Interference of a ring with its seat.

/// Effective interference of a ring with its seat on the diameter, m; below 0 a gap.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Interference {
    /// That of the middles of both tolerances.
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

    /// That of an inner part in an outer one by the limit deviations of their common nominal diameter.
    pub(super) fn of_limits(inner_m: [f64; 2], outer_m: [f64; 2], smoothing_m: f64) -> Self {
        let middle = |[lower, upper]: [f64; 2]| 0.5 * (lower + upper);
        let half = |[lower, upper]: [f64; 2]| 0.5 * (upper - lower);
        Self {
            mean_m: middle(inner_m) - middle(outer_m) - smoothing_m,
            probable_m: half(inner_m).hypot(half(outer_m)),
            extreme_m: half(inner_m) + half(outer_m),
        }
    }
}
