//! Least squares of a made ring to points, with a robust loss and without outliers.
//!
//! Shift, tilt and radii of the groove and lC, θ, ψ and depth error of its raceways are fitted together. Points
//! count by the inverse square of the scatter of their part of the groove, plain or a raceway. First those that are farther off than
//! the rest weigh less (Huber 1964, Annals of Mathematical Statistics 35, 73–101), then those beyond five robust
//! standard deviations are left out. The covariance is (JᵀWJ)⁻¹.

use super::made_ring::{GROOVE, MadeRing, Observed, RACEWAY};
use super::measured_value::MeasuredValue;
use crate::case::Case;
use crate::numerics::bspline::Vec3;
use crate::numerics::normal_equations::NormalEquations;

/// Standard deviation over the median of the absolute values of normal errors.
const MEDIAN_TO_DEVIATION: f64 = 1.4826;
/// Distance up to which all points weigh the same, in standard deviations.
const HUBER: f64 = 1.345;
/// Distance of an outlier, in robust standard deviations.
pub(super) const OUTLIER: f64 = 5.0;
/// Least standard deviation of outliers: no machine measures better.
const DEVIATION_MIN_M: f64 = 1e-7;
/// Least scatter, which rounding of coordinates has, m.
const ROUNDING_M: f64 = 1e-13;
/// Rounds of weights, and of outliers.
const ROUNDS: usize = 30;
const OUTLIER_ROUNDS: usize = 8;
/// Step of the groove after which there is no other, m and rad.
const CONVERGED: f64 = 1e-10;
/// Points on which the first rounds rest.
const FIRST_POINTS: usize = 20_000;
/// Largest change of lC and θ in a round, in parts of them.
const STEP: f64 = 0.2;
/// Largest change of ψ and of the place of the ring in a round, rad and m.
const TURN_MAX_RAD: f64 = 0.05;
const SHIFT_MAX_M: f64 = 1e-3;

/// A ring that fits points.
#[derive(Debug, Clone)]
pub(super) struct RingFit {
    /// The ring.
    pub ring: MadeRing,
    /// Standard uncertainty of each unknown.
    uncertainties: Vec<f64>,
    /// Robust standard deviation of the points of the plain groove and of each raceway, m.
    pub deviations_m: Vec<f64>,
}

/// How points weigh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Loss {
    Huber,
    Outliers,
}

impl RingFit {
    /// The ring that fits points of a groove best, from a first guess; `None` if they leave it open.
    pub(super) fn of(case: &Case, guess: MadeRing, points_m: &[Vec3]) -> Option<Self> {
        let stride = points_m.len().div_ceil(FIRST_POINTS).max(1);
        let first: Vec<Vec3> = points_m.iter().step_by(stride).copied().collect();
        let mut ring = guess;
        for _ in 0..ROUNDS {
            let round = Round::of(case, &ring, &first, Loss::Huber)?;
            ring = round.ring;
            if round.size < CONVERGED {
                break;
            }
        }
        let mut last = None;
        for _ in 0..OUTLIER_ROUNDS {
            let round = Round::of(case, &ring, points_m, Loss::Outliers)?;
            ring = round.ring;
            last = Some((round.uncertainties, round.deviations_m));
            if round.size < CONVERGED {
                break;
            }
        }
        let (uncertainties, deviations_m) = last?;
        Some(Self {
            ring,
            uncertainties,
            deviations_m,
        })
    }

    fn measured(&self, unknown: usize, value: f64) -> MeasuredValue {
        MeasuredValue {
            value,
            standard_uncertainty: self.uncertainties[unknown],
        }
    }

    /// Shift, m.
    pub(super) fn shift_m(&self) -> [MeasuredValue; 3] {
        [0, 1, 2].map(|k| self.measured(k, self.ring.pose.shift_m[k]))
    }

    /// Tilt about x and y, rad.
    pub(super) fn tilt_rad(&self) -> [MeasuredValue; 2] {
        [0, 1].map(|k| self.measured(3 + k, self.ring.pose.tilt_rad[k]))
    }

    /// Changes of Ro and Re, m.
    pub(super) fn sizes_m(&self) -> [MeasuredValue; 2] {
        [0, 1].map(|k| self.measured(5 + k, self.ring.sizes_m[k]))
    }

    /// lC, θ, ψ of the middle and depth error of a raceway; `None` if it is none.
    pub(super) fn raceway(&self, index: usize) -> Option<[MeasuredValue; RACEWAY]> {
        let made = self.ring.raceways[index].as_ref()?;
        let d = made.raceway.dimensions();
        let values = [
            d.axial_span_m,
            d.half_angle_rad,
            d.centre_angle_rad,
            made.depth_error_m,
        ];
        let first = GROOVE + RACEWAY * index;
        Some(std::array::from_fn(|k| self.measured(first + k, values[k])))
    }

    /// Largest distance of a point of the plain groove that is no outlier, m.
    pub(super) fn gate_m(&self, raceway: Option<usize>) -> f64 {
        gate_m(self.deviations_m[raceway.map_or(0, |k| k + 1)])
    }
}

/// Largest distance of points of this robust standard deviation that are no outliers, m.
pub(super) fn gate_m(deviation_m: f64) -> f64 {
    OUTLIER * deviation_m.max(DEVIATION_MIN_M)
}

/// Standard deviation of errors by the median of their absolute values, m; 0 without any.
pub(super) fn robust_deviation_m(errors_m: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = errors_m.map(f64::abs).collect();
    let middle = sizes.len() / 2;
    match sizes.is_empty() {
        true => 0.0,
        false => MEDIAN_TO_DEVIATION * *sizes.select_nth_unstable_by(middle, f64::total_cmp).1,
    }
}

/// Part of the ring on which a point lies: 0 the plain groove, else its raceway, from 1.
fn part(point: &Observed) -> usize {
    point.raceway.map_or(0, |k| k + 1)
}

/// Points of a ring in one round, by their parts.
struct Seen {
    points: Vec<Observed>,
    loss: Loss,
    /// Robust standard deviation of each part, m.
    deviations_m: Vec<f64>,
}

impl Seen {
    fn new(points: Vec<Observed>, parts: usize, loss: Loss) -> Self {
        let deviations_m = (0..parts).map(|k| {
            let errors = points.iter().filter(|point| part(point) == k);
            robust_deviation_m(errors.map(|point| point.error_m))
        });
        Self {
            deviations_m: deviations_m.collect(),
            points,
            loss,
        }
    }

    /// Points that are no outliers.
    fn used(&self) -> impl Iterator<Item = &Observed> {
        self.points.iter().filter(|point| {
            self.loss == Loss::Huber
                || point.error_m.abs() <= gate_m(self.deviations_m[part(point)])
        })
    }

    /// Scatter of a part, of which its own unknowns take some.
    fn scatter_m(&self, k: usize) -> f64 {
        let own = self.used().filter(|point| part(point) == k);
        let errors = own.map(|point| point.error_m.powi(2));
        let (count, squares) = errors.fold((0.0, 0.0), |(n, sum), e| (n + 1.0, sum + e));
        let unknowns = if k == 0 { GROOVE } else { RACEWAY };
        let free = (count - unknowns as f64).max(1.0);
        let scatter = match self.loss {
            Loss::Huber => self.deviations_m[k],
            Loss::Outliers => f64::sqrt(squares / free),
        };
        scatter.max(ROUNDING_M)
    }

    /// Normal equations of the unknowns of all parts.
    fn equations(&self) -> NormalEquations {
        let parts = self.deviations_m.len();
        let scatter_m: Vec<f64> = (0..parts).map(|k| self.scatter_m(k)).collect();
        let mut equations = NormalEquations::new(GROOVE + RACEWAY * (parts - 1));
        for point in self.used() {
            let scatter = scatter_m[part(point)];
            let robust = match self.loss {
                Loss::Huber => (HUBER * scatter / point.error_m.abs()).min(1.0),
                Loss::Outliers => 1.0,
            };
            let weight = robust / (scatter * scatter);
            let groove = point.groove.iter().copied().enumerate();
            let first = point.raceway.map(|k| GROOVE + RACEWAY * k);
            let own = point.dimensions.iter().copied().enumerate();
            let own = own.filter_map(move |(k, slope)| Some((first? + k, slope)));
            equations.add(groove.chain(own), point.error_m, weight);
        }
        equations
    }
}

/// A step of Gauss and Newton.
struct Round {
    /// The ring after it.
    ring: MadeRing,
    /// Standard uncertainty of each unknown.
    uncertainties: Vec<f64>,
    /// Robust standard deviation of each part before it, m.
    deviations_m: Vec<f64>,
    /// Largest change of an unknown.
    size: f64,
}

impl Round {
    fn of(case: &Case, ring: &MadeRing, points_m: &[Vec3], loss: Loss) -> Option<Self> {
        let neighbours = ring.neighbours(case).ok()?;
        let observe = |point: &Vec3| ring.observed(&neighbours, *point);
        let points = points_m.iter().map(observe).collect();
        let seen = Seen::new(points, ring.raceways.len() + 1, loss);
        let unknowns = GROOVE + RACEWAY * ring.raceways.len();
        let held: Vec<bool> = (0..unknowns)
            .map(|k| k >= GROOVE && ring.raceways[(k - GROOVE) / RACEWAY].is_none())
            .collect();
        let (mut step, inverse) = seen.equations().solve(&held)?;
        let share = allowed_share(ring, &step);
        step.iter_mut().for_each(|s| *s *= share);
        let size = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
        let mut next = ring.moved(case, &step);
        // A shape may refuse what is halfway to what it takes.
        for _ in 0..6 {
            if next.is_err() {
                step.iter_mut().for_each(|s| *s *= 0.5);
                next = ring.moved(case, &step);
            }
        }
        Some(Self {
            ring: next.ok()?,
            uncertainties: (0..unknowns).map(|k| inverse[k][k].sqrt()).collect(),
            deviations_m: seen.deviations_m,
            size,
        })
    }
}

/// Part of a step that is not too long.
fn allowed_share(ring: &MadeRing, step: &[f64]) -> f64 {
    let limit = |share: f64, step: f64, most: f64| match step.abs() > most {
        true => share.min(most / step.abs()),
        false => share,
    };
    let groove = step[..GROOVE].iter();
    let share = groove.fold(1.0, |share, step| limit(share, *step, SHIFT_MAX_M));
    let raceways = ring.raceways.iter().zip(step[GROOVE..].chunks(RACEWAY));
    raceways.fold(share, |share, (made, step)| {
        let Some(made) = made else { return share };
        let d = made.raceway.dimensions();
        let share = limit(share, step[0], STEP * d.axial_span_m);
        let share = limit(share, step[1], STEP * d.half_angle_rad);
        limit(share, step[2], TURN_MAX_RAD)
    })
}
