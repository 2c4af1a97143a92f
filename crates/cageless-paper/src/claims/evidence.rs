//! Numbers on which the claims rest.

use cageless_report::{Requirement, RingComparison};
use cageless_study::comparison::RingComparison as Steady;

use crate::experiment::Bearing;
use crate::extra::Extra;
use crate::histories::Stages;
use crate::mechanics::Mechanics;
use crate::printed::Printed;
use crate::structures::{Between, Found};
use crate::table2::Computed;

/// Numbers on which the claims rest. What exists per reading is in the order of
/// [`crate::cases::READINGS`]: `paper`, `physical`.
#[derive(Debug, Clone)]
pub struct Evidence {
    /// Numbers of the paper's text.
    pub printed: Printed,
    /// Closed forms of structure (d).
    pub mechanics: Mechanics,
    /// Frequency at which rolling balls of structure (d) pass a point of the outer ring, Hz.
    pub ball_pass_hz: f64,
    /// θ over lC by Eq. (11), degrees.
    pub half_angles_deg: Vec<f64>,
    /// Table 2.
    pub table2: Computed,
    /// Ten structures per reading.
    pub structures: [Vec<Found>; 2],
    /// Structures between those of Table 2.
    pub between: Vec<Between>,
    /// Fig. 6 and 7 per reading.
    pub stages: [Stages; 2],
    /// Fig. 12 to 14: conventional, discrete.
    pub bearings: [Bearing; 2],
    /// Section 5 with lots of balls.
    pub comparison: RingComparison,
    /// Conventional ring and structure (d) in steady operation.
    pub steady: Steady,
    /// The rest.
    pub extra: Extra,
}

/// Names of the readings.
pub(super) const NAMES: [&str; 2] = ["`paper`", "`physical`"];

/// A requirement under each reading, of its name and what was found; where both hold alike, one sentence says so.
pub(super) fn of_both<'e, T>(
    found: &'e [T; 2],
    requirement: impl Fn(&'static str, &'e T) -> Requirement,
) -> Vec<Requirement> {
    let [paper, physical] = NAMES;
    let each = [
        requirement(paper, &found[0]),
        requirement(physical, &found[1]),
    ];
    let [first, second] = match each[0].holds() == each[1].holds() {
        true => [
            requirement("both readings", &found[0]),
            each[1].clone().says("", ""),
        ],
        false => each,
    };
    vec![first.on(paper), second.on(physical)]
}

/// Largest of `values`; NaN if there is none or one is not a number.
pub(super) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    let greater = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    values.into_iter().reduce(greater).unwrap_or(f64::NAN)
}

/// Least of `values`, like [`largest`].
pub(super) fn least(values: impl IntoIterator<Item = f64>) -> f64 {
    -largest(values.into_iter().map(|v| -v))
}

/// Root of the mean of the squares.
pub(super) fn rms(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values
        .into_iter()
        .fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
    f64::sqrt(sum / count)
}
