//! The lowest minimum of the potential energy over the two coordinates of the ring.
//!
//! Newton's method within a trust region. The Hessian holds the geometric stiffness −F/L of
//! a ring that rests on a ball as on a pendulum upside down, and is indefinite where a
//! single ball carries: the energy leads off such saddles. Steps are accepted by the energy
//! while it tells them from rounding, then by the decrement gᵀH⁻¹g.

use super::error::EquilibriumError;
use super::potential::{Local, Problem};

const ITERATIONS: usize = 500;
/// Fraction of all forces that may be left on the ring.
const FORCE_TOLERANCE: f64 = 1e-10;

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// A step within the trust region.
struct TrustStep {
    step: [f64; 2],
    /// Decrease of the energy that the quadratic model has.
    predicted: f64,
    /// Whether it ends inside, at the minimum of the model.
    inside: bool,
}

impl Local {
    /// Eigenvalues of the Hessian, the smaller first, half the difference of its diagonal
    /// entries, and the other one.
    pub fn eigenvalues(&self) -> ([f64; 2], f64, f64) {
        let [xx, xy, yy] = self.hessian;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = half.hypot(xy);
        let steep = mean + spread;
        // The smaller eigenvalue by the determinant, which cancels less.
        let flat = if mean > 0.0 {
            (xx * yy - xy * xy) / steep
        } else {
            mean - spread
        };
        ([flat, steep], half, xy)
    }

    /// Whether the ring is held sideways as well: by several balls, not on top of one.
    pub fn held(&self) -> bool {
        let [flat, steep] = self.eigenvalues().0;
        flat > 1e-3 * steep
    }

    /// Minimum of the quadratic model within `radius`. On a saddle that is symmetric to
    /// rounding it leads towards +X.
    fn trust_step(&self, radius: f64) -> TrustStep {
        let ([flat, steep], half, xy) = self.eigenvalues();
        // Half the angle of (half, xy) is the direction of the larger eigenvalue.
        let (sin, cos) = (0.5 * xy.atan2(half)).sin_cos();
        let axes = [[cos, sin], [-sin, cos]];
        let along = axes.map(|a| a[0] * self.gradient[0] + a[1] * self.gradient[1]);
        let moved = |shift: f64| [-along[0] / (steep + shift), -along[1] / (flat + shift)];
        let newton = moved(0.0);
        let inside = flat > 0.0 && length(newton) <= radius;
        let parts = if inside {
            newton
        } else {
            let mut low = (-flat).max(0.0);
            let mut high = low.max(length(self.gradient) / radius - flat);
            for _ in 0..60 {
                let shift = 0.5 * (low + high);
                if length(moved(shift)) > radius {
                    low = shift;
                } else {
                    high = shift;
                }
            }
            let mut parts = if high + flat > 0.0 {
                moved(high)
            } else {
                [0.0; 2]
            };
            let rest = (radius * radius - parts[0] * parts[0]).max(0.0).sqrt();
            if parts[1].abs() < 0.5 * rest && flat <= 0.0 {
                // The gradient has next to nothing along the direction of descent.
                let towards = if along[1] != 0.0 {
                    -along[1].signum()
                } else if axes[1][0] < 0.0 {
                    -1.0
                } else {
                    1.0
                };
                parts[1] = towards * rest;
            }
            parts
        };
        let predicted = -(along[0] * parts[0]
            + along[1] * parts[1]
            + 0.5 * (steep * parts[0] * parts[0] + flat * parts[1] * parts[1]));
        TrustStep {
            step: [0, 1].map(|k| parts[0] * axes[0][k] + parts[1] * axes[1][k]),
            predicted,
            inside,
        }
    }

    fn rounding(&self) -> f64 {
        16.0 * f64::EPSILON * self.magnitude
    }
}

/// Minimum that is reached from `start`; no step is longer than `longest`.
fn minimum_from(
    problem: &Problem<'_>,
    start: [f64; 2],
    longest: f64,
) -> Result<Local, EquilibriumError> {
    let forces = problem.forces();
    let room = problem
        .balls
        .iter()
        .map(|b| b.outer_orbit_radius)
        .fold(f64::INFINITY, f64::min);
    let mut here = problem.at(start);
    let mut radius = longest.min(length(start).max(1e-3 * longest));
    let mut iterations = 0;
    while iterations < ITERATIONS {
        iterations += 1;
        if length(here.gradient) <= 1e-16 * forces {
            break;
        }
        if length(here.ring) > 0.9 * room {
            return Err(EquilibriumError::Unsupported);
        }
        let trust = here.trust_step(radius);
        let span = length(trust.step);
        if span <= f64::EPSILON * length(here.ring) {
            break;
        }
        let there = problem.at([here.ring[0] + trust.step[0], here.ring[1] + trust.step[1]]);
        if trust.predicted > here.rounding() {
            let ratio = (here.energy - there.energy) / trust.predicted;
            if ratio < 0.25 {
                radius = 0.25 * span;
            } else if ratio > 0.75 && !trust.inside {
                radius = (2.0 * radius).min(longest);
            }
            if ratio > 1e-4 {
                here = there;
            }
        } else if trust.inside {
            let next = there.trust_step(radius);
            if !(next.inside && next.predicted < 0.5 * trust.predicted) {
                break;
            }
            here = there;
        } else if radius < longest {
            // A saddle or a plateau that is flat to rounding within this radius.
            radius = (4.0 * radius).min(longest);
        } else {
            break;
        }
    }
    let residual_n = length(here.gradient);
    if residual_n <= FORCE_TOLERANCE * forces {
        Ok(here)
    } else {
        Err(EquilibriumError::NotConverged {
            residual_n,
            iterations,
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
) -> Result<Local, EquilibriumError> {
    if problem.down == 0.0 {
        return minimum_from(problem, [0.0; 2], longest);
    }
    let mut lowest: Result<Local, EquilibriumError> = Err(EquilibriumError::Unsupported);
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
