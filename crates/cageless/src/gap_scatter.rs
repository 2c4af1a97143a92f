//! Scatter of the gaps between neighbouring balls over time: what a discrete raceway is there to
//! reduce.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//! use cageless::{Gaps, Start, StartState};
//!
//! // Zhao 2022, Table 2, structure (d), every second gap 1° wider than the others.
//! let mut case = Structure::D.case();
//! let gap = case.bearing.nominal_gap_rad();
//! let wider = |k| gap + 0.5f64.to_radians() * if k % 2 == 0 { 1.0 } else { -1.0 };
//! let gaps = Gaps::List((0..14).map(wider).collect());
//! case.start = Start::new(StartState::Settled, gaps, 0.0);
//! // Before the raceway has changed them.
//! case.solver.duration_s = 2e-5;
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! let deviation = recorder.summary().unwrap().gap_deviation_rad;
//! assert!((deviation.to_degrees() - 0.5).abs() < 0.01);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::TAU;

use crate::dynamics::Model;
use crate::dynamics::layout::Balls;
use crate::gap::Direction;
use crate::numerics::moments::Moments;
use crate::numerics::vector::PlaneVector;

/// Variance of the gaps between the balls of a model at one instant.
#[derive(Debug, Clone, Default)]
pub(crate) struct GapVariance {
    /// Angle between the balls of each pair that touch less the mean of all pairs, rad.
    sizes_rad: Vec<f64>,
    /// Direction from ball to ball of equal gaps, and its angle.
    pitch: Direction,
    pitch_rad: f64,
}

impl GapVariance {
    /// Variance for the balls of a model.
    pub(crate) fn new(model: &Model) -> Self {
        let (balls, pitch_rad) = (model.balls(), TAU / model.layout().row as f64);
        let touching = (0..balls).map(|k| model.pair_angle_rad(k));
        let mean_rad = touching.sum::<f64>() / balls as f64;
        Self {
            pitch: Direction::of(pitch_rad),
            pitch_rad,
            sizes_rad: (0..balls)
                .map(|k| model.pair_angle_rad(k) - mean_rad)
                .collect(),
        }
    }

    /// Variance at these positions of the balls and of the centre of the outer ring, rad².
    pub(crate) fn of(&self, balls_m: PlaneVector<Balls<'_>>, centre_m: PlaneVector) -> f64 {
        // The gaps of a row leave what its balls leave of a turn: their mean is known.
        let from_mean_rad = |(k, size_rad): (usize, &f64)| {
            let direction = Direction::to_next(balls_m, centre_m, k);
            let angle_rad = direction.small_angle_from(self.pitch);
            angle_rad.unwrap_or_else(|| direction.gap_rad(self.pitch_rad)) - size_rad
        };
        let gaps = self.sizes_rad.iter().enumerate().map(from_mean_rad);
        gaps.map(|gap| gap * gap).sum::<f64>() / self.sizes_rad.len() as f64
    }
}

/// Variance of the gaps, averaged over each half of a stretch of time.
#[derive(Debug, Clone, Default)]
pub(crate) struct GapScatter {
    instant: GapVariance,
    last_s: f64,
    half_s: f64,
    variance: [Moments; 2],
}

impl GapScatter {
    /// Scatter of the balls of a model from `from_s` to `to_s`.
    pub(crate) fn new(model: &Model, from_s: f64, to_s: f64) -> Self {
        Self {
            instant: GapVariance::new(model),
            last_s: from_s,
            half_s: 0.5 * (from_s + to_s),
            variance: [Moments::default(); 2],
        }
    }

    /// Takes the positions of the balls and of the centre of the outer ring at `time_s`, for the
    /// time since the last look.
    pub(crate) fn look(
        &mut self,
        time_s: f64,
        balls_m: PlaneVector<Balls<'_>>,
        centre_m: PlaneVector,
    ) {
        let variance = self.instant.of(balls_m, centre_m);
        let half = usize::from(time_s > self.half_s);
        self.variance[half].add(variance, time_s - self.last_s);
        self.last_s = time_s;
    }

    /// Standard deviation of the gaps: root of their mean variance, rad; NaN before the first look.
    pub(crate) fn deviation_rad(&self) -> f64 {
        let [first, second] = self.variance;
        let weight = first.weight + second.weight;
        ((first.mean * first.weight + second.mean * second.weight) / weight).sqrt()
    }

    /// Standard deviation in the second half less that in the first, rad; NaN if either is empty.
    pub(crate) fn change_rad(&self) -> f64 {
        let [first, second] = self.variance.map(|half| {
            if half.weight > 0.0 {
                half.mean.sqrt()
            } else {
                f64::NAN
            }
        });
        second - first
    }
}
