//! The place of the ring with the least potential energy.
//!
//! The Hessian holds the geometric stiffness −F/L of a ring that rests on a ball as on a pendulum
//! upside down, and is indefinite where a single ball carries: the search starts from both sides of
//! such saddles.

use super::error::EquilibriumError;
use super::minimum::{ITERATIONS, Local, minimum, norm};
use super::potential::Problem;

/// Fraction of all forces that may be left on the ring.
const FORCE_TOLERANCE: f64 = 1e-10;

impl Local<2> {
    /// Eigenvalues of the Hessian, the smaller first.
    pub fn eigenvalues(&self) -> [f64; 2] {
        let [[xx, xy], [_, yy]] = self.hessian;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = half.hypot(xy);
        let steep = mean + spread;
        // The smaller eigenvalue by the determinant, which cancels less.
        let flat = if mean > 0.0 {
            (xx * yy - xy * xy) / steep
        } else {
            mean - spread
        };
        [flat, steep]
    }

    /// Whether the ring is held sideways as well: by several balls, not on top of one.
    pub fn held(&self) -> bool {
        let [flat, steep] = self.eigenvalues();
        flat > 1e-3 * steep
    }
}

/// Minimum that is reached from `start`; no step is longer than `longest`.
fn minimum_from(
    problem: &Problem<'_>,
    start: [f64; 2],
    longest: f64,
) -> Result<Local<2>, EquilibriumError> {
    let orbits = problem.balls.iter().map(|b| b.outer_orbit_radius);
    let room = 0.9 * orbits.fold(f64::INFINITY, f64::min);
    // No step leads to an energy that is no number.
    let within = |ring: [f64; 2]| match norm(ring) <= room {
        true => problem.at(ring),
        false => Local {
            energy: f64::NAN,
            ..Local::nothing(ring)
        },
    };
    let found = minimum(within, start, longest);
    let residual_n = norm(found.gradient);
    if residual_n <= FORCE_TOLERANCE * problem.forces() {
        Ok(found)
    } else if norm(found.place) > room - longest {
        Err(EquilibriumError::Unsupported)
    } else {
        Err(EquilibriumError::NotConverged {
            residual_n,
            iterations: ITERATIONS,
        })
    }
}

/// Lowest of the minima that are reached from the right, the left and below, at `depth`;
/// where two are level to rounding, the one on the right (+X). Without load and weight that
/// which is reached from the middle.
pub(super) fn lowest_minimum(
    problem: &Problem<'_>,
    depth: f64,
    longest: f64,
) -> Result<Local<2>, EquilibriumError> {
    if problem.down == 0.0 {
        return minimum_from(problem, [0.0; 2], longest);
    }
    let mut lowest: Result<Local<2>, EquilibriumError> = Err(EquilibriumError::Unsupported);
    for side in [1.0, -1.0, 0.0] {
        let found = minimum_from(problem, [side * depth, -depth], longest);
        lowest = match (lowest, found) {
            (Ok(best), Ok(found)) if found.energy < best.energy - best.rounding() => Ok(found),
            (Ok(best), _) => Ok(best),
            (Err(_), found) => found,
        };
    }
    lowest
}
