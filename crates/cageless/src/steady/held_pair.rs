//! Contacts of two neighbours that a discrete raceway holds at its critical gap.

use std::f64::consts::TAU;

use crate::ball_grade::BallGrade;
use crate::bearing::Bearing;

/// Two neighbours whose gap a raceway on rigid flanks holds up in steady operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldPair {
    /// Critical gap of the raceway.
    pub critical_gap_rad: f64,
    /// Mean gap ahead of the raceway.
    pub steady_gap_rad: f64,
}

/// Gap reserve over the mean gap at which all but one in e of the pairs meet in an orbit.
const RESERVE: f64 = 0.18;
/// Part of the mean gap that a contact gives back to its pair, net of what it takes from the neighbours.
const GAIN: f64 = 0.015;

impl HeldPair {
    /// Contacts in an orbit of the balls, 1 at most: 1 − exp(−(r/0.18)²) + d/0.015, where r is the gap reserve and d the
    /// mean drift of neighbours of a lot in an orbit, both over the mean gap. Within a factor of two of runs with balls
    /// of grades G3 to G28 and mean gaps of half a degree or more; the two numbers come from such runs.
    pub fn contacts_per_orbit(&self, bearing: &Bearing, grade: BallGrade) -> f64 {
        // Of two radii drawn evenly from a width, the difference is a third of it in the mean.
        let difference_m = 2.0 * grade.radius_deviation_m() / 3.0;
        let drift = TAU * difference_m / bearing.outer_orbit_radius_m() / self.steady_gap_rad;
        let reserve = 1.0 - self.critical_gap_rad / self.steady_gap_rad;
        let own = 1.0 - (-(reserve.max(0.0) / RESERVE).powi(2)).exp();
        (own + drift / GAIN).min(1.0)
    }
}
