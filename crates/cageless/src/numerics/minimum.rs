//! Minimum of an energy over a few coordinates: Newton's method with a shift of the Hessian.

use std::convert::Infallible;

use super::cholesky::solve;
use super::taylor::Taylor;

/// An energy with its derivatives at a place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Local<const N: usize> {
    pub place: [f64; N],
    /// J.
    pub energy: f64,
    /// Sum of the absolute terms of the energy, to which its rounding is proportional.
    pub magnitude: f64,
    pub gradient: [f64; N],
    pub hessian: [[f64; N]; N],
}

impl<const N: usize> Local<N> {
    /// No energy.
    pub(crate) fn nothing(place: [f64; N]) -> Self {
        Self {
            place,
            energy: 0.0,
            magnitude: 0.0,
            gradient: [0.0; N],
            hessian: [[0.0; N]; N],
        }
    }

    /// Sum of terms of the energy.
    pub(crate) fn sum(place: [f64; N], terms: impl IntoIterator<Item = Taylor<N>>) -> Self {
        let (mut sum, mut magnitude) = (Taylor::constant(0.0), 0.0);
        for term in terms {
            sum = sum + term;
            magnitude += term.value.abs();
        }
        Self {
            place,
            energy: sum.value,
            magnitude,
            gradient: sum.gradient,
            hessian: sum.hessian,
        }
    }

    /// Rounding of the energy.
    pub(crate) fn rounding(&self) -> f64 {
        16.0 * f64::EPSILON * self.magnitude
    }
}

pub(crate) const ITERATIONS: usize = 400;
/// Newton steps after the energy no longer tells them from rounding.
const POLISHING: usize = 4;

/// Length of a vector.
pub(crate) fn norm<const N: usize>(vector: [f64; N]) -> f64 {
    vector.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// The minimum that is reached from `start`; no step is longer than `longest`. Whether it is one,
/// what is left of the gradient tells.
pub(crate) fn minimum<const N: usize>(
    at: impl Fn([f64; N]) -> Local<N>,
    start: [f64; N],
    longest: f64,
) -> Local<N> {
    let Ok(found) = try_minimum(|place| Ok::<_, Infallible>(at(place)), start, longest);
    found
}

/// [`minimum`] of an energy that may refuse to be evaluated.
///
/// # Errors
/// The first one of `at`.
pub(crate) fn try_minimum<const N: usize, E>(
    mut at: impl FnMut([f64; N]) -> Result<Local<N>, E>,
    start: [f64; N],
    longest: f64,
) -> Result<Local<N>, E> {
    let mut here = at(start)?;
    let mut shift = 0.0;
    let mut polished = 0;
    for _ in 0..ITERATIONS {
        let size = (0..N).map(|k| here.hessian[k][k].abs()).fold(0.0, f64::max);
        let least = (1e-12 * size).max(f64::MIN_POSITIVE);
        let mut used = shift;
        let step = loop {
            let step = solve(&here.hessian, used, here.gradient.map(|g| -g));
            match step {
                Some(step) if norm(step) <= longest => break step,
                _ if used > 1e30 * (size + norm(here.gradient) / longest) => return Ok(here),
                _ => used = (4.0 * used).max(least),
            }
        };
        let curved: f64 = (0..N)
            .map(|i| {
                (0..N)
                    .map(|j| step[i] * here.hessian[i][j] * step[j])
                    .sum::<f64>()
            })
            .sum();
        let along: f64 = (0..N).map(|k| here.gradient[k] * step[k]).sum();
        let predicted = -along - 0.5 * curved;
        let there = at(std::array::from_fn(|k| here.place[k] + step[k]))?;
        if predicted <= here.rounding() {
            if norm(there.gradient) < norm(here.gradient) {
                here = there;
                shift = if used > least { 0.1 * used } else { 0.0 };
                polished += usize::from(used == 0.0);
            } else if used > 0.0 && shift > 0.0 {
                shift = 0.0;
            } else {
                break;
            }
            if polished >= POLISHING {
                break;
            }
            continue;
        }
        let ratio = (here.energy - there.energy) / predicted;
        if ratio < 0.25 {
            shift = (4.0 * used).max(1e-4 * size);
        } else if ratio > 0.75 {
            shift = if used > least { used / 8.0 } else { 0.0 };
        } else {
            shift = used;
        }
        if ratio > 1e-4 {
            here = there;
        }
    }
    Ok(here)
}
