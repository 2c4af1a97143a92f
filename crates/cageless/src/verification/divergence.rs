//! Divergence of runs from perturbed initial states, and predictability of point values.

use super::replica::Record;
use crate::case::Case;
use crate::dynamics::{Model, RightHandSide};
use crate::error::InputError;
use crate::integrator::System;

/// Distance of two states, in the scales of the reference trajectories, above which they count as
/// decorrelated: 0.1 µm in position, 1 cm/s in speed.
pub const DECORRELATED: f64 = 1e-2;
/// Least growth of a distance that counts as divergence rather than phase drift.
const DIVERGES: f64 = 1e3;
/// Growth within the first transient, before an exponential is fitted.
const LEAD_IN: f64 = 10.0;
/// Least number of samples of a fit.
const FIT_LEAST: usize = 8;

/// Distances from the run at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Time.
    pub time_s: f64,
    /// Distance of the perturbed runs at the same step, geometric mean.
    pub perturbed: f64,
    /// Distance of the run from the same start at half the step.
    pub half_step: f64,
}

/// Cause that limits the predictability.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loss {
    /// Integration error.
    Step,
    /// Perturbation of the initial state, smaller than the uncertainty of any initial state.
    Start,
}

/// Distances of the replicas from the run, as the root mean square over positions,
/// velocities and spins in the scales 10 µm, 1 m/s (0.1 m/s of the ring) and 200 rad/s.
#[derive(Debug, Clone, PartialEq)]
pub struct Divergence {
    /// Distances over time.
    pub distances: Vec<Distance>,
    /// Largest distance of the perturbed runs over the first.
    pub growth: f64,
    /// Lyapunov time, s: the distance of perturbed runs grows by a factor e; `None` if the run
    /// does not diverge.
    pub divergence_time_s: Option<f64>,
    /// Interval of the fit, s.
    pub fitted_over_s: Option<[f64; 2]>,
    /// Time after which trajectories are unpredictable, s; `None` if not within the run.
    pub predictability_time_s: Option<f64>,
    /// Cause of the limit.
    pub loss: Option<Loss>,
}

impl Divergence {
    /// Compares the run with those from perturbed starts, which follow it, and with the run at
    /// half the step.
    pub(super) fn new(
        case: &Case,
        perturbed: &[&Record],
        half_step: &Record,
    ) -> Result<Self, InputError> {
        let model = Model::new(case)?;
        let rhs = RightHandSide::new(&model);
        let base = &perturbed[0].trajectory;
        let distance = |a: &[f64], b: &[f64]| {
            let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
            rhs.error_norm(&difference)
        };
        let mut distances = vec![];
        for (k, &time_s) in base.times_s().iter().enumerate() {
            let Some(state) = base.state(k) else { break };
            let logs: f64 = perturbed[1..]
                .iter()
                .filter_map(|r| r.trajectory.state(k))
                .map(|other| distance(state, other).max(f64::MIN_POSITIVE).ln())
                .sum();
            let half = half_step.trajectory.state(k);
            distances.push(Distance {
                time_s,
                perturbed: (logs / (perturbed.len() - 1) as f64).exp(),
                half_step: half.map_or(f64::NAN, |other| distance(state, other)),
            });
        }
        Ok(Self::from_distances(distances))
    }

    fn from_distances(distances: Vec<Distance>) -> Self {
        let first = distances.first().map_or(f64::NAN, |d| d.perturbed);
        let largest = distances.iter().fold(0.0, |m: f64, d| m.max(d.perturbed));
        let growth = largest / first;
        // NaN counts as decorrelated.
        let lost = distances
            .iter()
            .find(|d| !(d.perturbed < DECORRELATED && d.half_step < DECORRELATED));
        let fit = if growth >= DIVERGES {
            fit_growth(&distances, first, largest)
        } else {
            None
        };
        Self {
            growth,
            divergence_time_s: fit.map(|(time, _)| time),
            fitted_over_s: fit.map(|(_, window)| window),
            predictability_time_s: lost.map(|d| d.time_s),
            loss: lost.map(|d| {
                if d.half_step < DECORRELATED {
                    Loss::Start
                } else {
                    Loss::Step
                }
            }),
            distances,
        }
    }
}

/// e-folding time of the perturbed runs by least squares of ln d over t, from the last
/// time at which d was within [`LEAD_IN`] of the first to the first at which it reaches
/// [`DECORRELATED`] or a tenth of the largest.
fn fit_growth(distances: &[Distance], first: f64, largest: f64) -> Option<(f64, [f64; 2])> {
    let top = DECORRELATED.min(0.1 * largest);
    let end = distances.iter().position(|d| d.perturbed >= top)?;
    let start = distances[..end]
        .iter()
        .rposition(|d| d.perturbed <= LEAD_IN * first)?;
    let window = &distances[start..=end];
    if window.len() < FIT_LEAST {
        return None;
    }
    let n = window.len() as f64;
    let mean_t = window.iter().map(|d| d.time_s).sum::<f64>() / n;
    let mean_l = window.iter().map(|d| d.perturbed.ln()).sum::<f64>() / n;
    let (mut tt, mut tl) = (0.0, 0.0);
    for d in window {
        tt += (d.time_s - mean_t).powi(2);
        tl += (d.time_s - mean_t) * (d.perturbed.ln() - mean_l);
    }
    let rate = tl / tt;
    (rate > 0.0).then(|| {
        (
            1.0 / rate,
            [window[0].time_s, window[window.len() - 1].time_s],
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distances(perturbed: impl Fn(f64) -> f64, half_step: impl Fn(f64) -> f64) -> Vec<Distance> {
        (1..=1000)
            .map(|k| {
                let time_s = 1e-4 * k as f64;
                Distance {
                    time_s,
                    perturbed: perturbed(time_s),
                    half_step: half_step(time_s),
                }
            })
            .collect()
    }

    #[test]
    fn exponential_growth_is_measured() {
        let grow = |from: f64| move |t: f64| (from * (t / 3e-3).exp()).min(5.0);
        let d = Divergence::from_distances(distances(grow(1e-8), grow(1e-6)));
        let time = d.divergence_time_s.unwrap();
        assert!((time / 3e-3 - 1.0).abs() < 1e-6, "{time}");
        // ln(1e4) e-foldings from 1e-6.
        let lost = d.predictability_time_s.unwrap();
        assert!((lost - 0.0277).abs() < 1e-9, "{lost}");
        assert_eq!(d.loss, Some(Loss::Step));
    }

    #[test]
    fn a_drift_is_no_divergence() {
        let d = Divergence::from_distances(distances(|t| 1e-8 * (1.0 + 100.0 * t), |_| 1e-6));
        assert_eq!((d.divergence_time_s, d.predictability_time_s), (None, None));
    }
}
