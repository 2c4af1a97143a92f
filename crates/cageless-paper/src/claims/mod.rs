//! The claims of the paper one by one, with what we find, and its errata. Every status and every
//! sentence follows from numbers, see [`cageless_report::claim`].

mod equations;
mod recommendation;
mod section5;
mod simulation;
mod structures;
#[cfg(test)]
mod tests;
mod theory;

use cageless_report::{Claim, RingComparison};

use crate::experiment::Bearing;
use crate::extra::Extra;
use crate::histories::Stages;
use crate::mechanics::Mechanics;
use crate::printed::Printed;
use crate::structures::{Between, Found};
use crate::table2::Computed;

/// Numbers on which the claims rest. What exists per reading is in the order of
/// [`crate::READINGS`]: `paper`, `physical`.
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
    /// The rest.
    pub extra: Extra,
}

/// Names of the readings.
const NAMES: [&str; 2] = ["`paper`", "`physical`"];

/// All claims, in the order of the paper.
pub fn claims(e: &Evidence) -> Vec<Claim> {
    let chapters = [
        theory::claims(e),
        simulation::claims(e),
        structures::claims(e),
        recommendation::claims(e),
        section5::claims(e),
        equations::claims(e),
    ];
    chapters.into_iter().flatten().collect()
}

/// First paragraph of the report.
pub fn lead(e: &Evidence) -> String {
    let t = &e.table2;
    let [published, consistent] = [0, 3].map(|column| {
        format!(
            "{:.3}° on nine of the ten structures and by {:.3}° at lC = 5.60 mm",
            t.largest_difference_deg(column),
            t.odd_difference_deg(column)
        )
    });
    let slide = (3..10).all(|row| t.gap_deg(3, row) < t.gap_deg(0, row));
    format!(
        "The critical gaps of the equations exactly as published, with Coulomb friction, differ \
         from the paper's simulated column by up to {published}. Those of mechanically consistent \
         equations differ by up to {consistent}{}.",
        if slide {
            "; they are smaller from structure (d) on, because balls slide earlier"
        } else {
            ""
        }
    )
}

/// Largest of `values`; NaN if there is none or one is not a number.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    let greater = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
    values.into_iter().reduce(greater).unwrap_or(f64::NAN)
}

/// Least of `values`, like [`largest`].
fn least(values: impl IntoIterator<Item = f64>) -> f64 {
    -largest(values.into_iter().map(|v| -v))
}

/// Root of the mean of the squares.
fn rms(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values
        .into_iter()
        .fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
    f64::sqrt(sum / count)
}
