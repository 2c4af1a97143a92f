//! Least squares of a slot's rounded edges to points of its surface.
//!
//! A point belongs to an edge where the direction to it from the nearest place of the line of centres is that
//! of the arc, away from where the arc runs into groove and wall, and its distance from the arc is small against the
//! radius. Of groove, wall, floor and far edge one of the two is different, so that only what lies on the edges
//! decides. Points farther off than the rest weigh less, as Huber has it.

use super::centre_line::CentreLine;
use super::edge::Edge;
use super::edge_place::EdgePlace;
use super::recess_frame::RecessFrame;
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::bspline::Vec3;
use crate::numerics::cholesky;
use crate::numerics::vector::{dot, plus};

/// Share of the arc at the groove and at the wall that is left out.
const MARGIN: f64 = 0.15;
/// Largest distance of a point from the arc, in parts of re.
const GATE: f64 = 0.5;
/// Largest step of a dimension in a round, in parts of re.
const STEP: f64 = 0.25;
/// Most rounds, and the step after which there is no other, m.
const ROUNDS: usize = 60;
const CONVERGED_M: f64 = 1e-11;
/// Steps to the nearest place, and the one after which there is no other, rad.
const PLACE_STEPS: usize = 12;
const PLACE_TOLERANCE_RAD: f64 = 1e-12;
/// Standard deviation over the median of the absolute values of normal errors.
const MEDIAN_TO_DEVIATION: f64 = 1.4826;
/// Distance up to which all points weigh the same, in standard deviations (Huber 1964, Annals of Mathematical
/// Statistics 35, 73–101).
const HUBER: f64 = 1.345;
/// Least standard deviation: no machine measures better.
const DEVIATION_MIN_M: f64 = 1e-7;
/// Half of the difference of dimensions for derivatives, m.
const DIFFERENCE_M: f64 = 1e-6;

/// Dimensions that are fitted: re, ze in the middle, straight half of the slot and ψ of its middle as lengths
/// along the bottom, and how much deeper than that of the case the groove is from which the edges go.
pub(super) const DIMENSIONS: usize = 5;
/// Their covariance, m².
pub(super) type Covariance = [[f64; DIMENSIONS]; DIMENSIONS];
/// The straight half among them, which is not negative.
const STRAIGHT: usize = 2;

/// A point on an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touched {
    /// Distance from the arc, positive out of the material.
    pub error_m: f64,
    /// Share of the arc, from the groove on.
    pub share: f64,
    /// 1 or −1 around the end along ψ, 0 on a straight edge.
    pub end: f64,
    /// Derivatives of the distance.
    slopes: [f64; DIMENSIONS],
}

/// The edges that fit points best, the points on them and the covariance of the dimensions; `None` if there are fewer than dimensions, or they
/// leave one open.
pub(super) fn fit_edges(
    designed: &RecessFrame,
    points_m: &[Vec3],
) -> Option<(RecessFrame, Vec<Touched>, Covariance)> {
    let mut frame = *designed;
    let mut touched = on_edges(&frame, points_m);
    for _ in 0..ROUNDS {
        let step = step_m(&frame, &touched)?;
        frame = moved(&frame, step);
        touched = on_edges(&frame, points_m);
        if step.iter().all(|s| s.abs() < CONVERGED_M) {
            break;
        }
    }
    let covariance = covariance(&touched)?;
    Some((frame, touched, covariance))
}

/// s² (JᵀWJ)⁻¹ with the scatter s of the errors as they weigh.
fn covariance(touched: &[Touched]) -> Option<Covariance> {
    let scale_m = HUBER * deviation_m(touched)?;
    let (normal, _) = normal_equations(touched, scale_m);
    let weighted = |point: &Touched| weight(point, scale_m) * point.error_m.powi(2);
    let squares: f64 = touched.iter().map(weighted).sum();
    let scatter = squares / (touched.len() - DIMENSIONS) as f64;
    let mut inverse = Covariance::default();
    for (k, row) in inverse.iter_mut().enumerate() {
        let mut unit = [0.0; DIMENSIONS];
        unit[k] = scatter;
        *row = cholesky::solve(&normal, 0.0, unit)?;
    }
    Some(inverse)
}

/// Weight of a point: less than 1 beyond this distance.
fn weight(point: &Touched, scale_m: f64) -> f64 {
    (scale_m / point.error_m.abs()).min(1.0)
}

/// JᵀWJ, its lower half, and −JᵀW ε.
fn normal_equations(touched: &[Touched], scale_m: f64) -> (Covariance, [f64; DIMENSIONS]) {
    let mut normal = Covariance::default();
    let mut right = [0.0; DIMENSIONS];
    for point in touched {
        let weight = weight(point, scale_m);
        for i in 0..DIMENSIONS {
            let slope = weight * point.slopes[i];
            right[i] -= slope * point.error_m;
            (0..=i).for_each(|j| normal[i][j] += slope * point.slopes[j]);
        }
    }
    (normal, right)
}

/// The points that lie on the edges.
fn on_edges(frame: &RecessFrame, points_m: &[Vec3]) -> Vec<Touched> {
    let near = [1.0, -1.0].map(|sign| {
        std::array::from_fn(|k| {
            let mut step = [0.0; DIMENSIONS];
            step[k] = sign * DIFFERENCE_M;
            moved(frame, step)
        })
    });
    let points = points_m.iter();
    points
        .filter_map(|point| Touched::of(frame, &near, *point))
        .collect()
}

impl Touched {
    fn of(
        frame: &RecessFrame,
        [more, less]: &[[RecessFrame; DIMENSIONS]; 2],
        point: Vec3,
    ) -> Option<Self> {
        let [x, y, _] = point;
        let local = wrap_angle_rad(x.atan2(-y) - frame.middle_rad);
        let beyond_m = (local.abs() - frame.straight_rad) * frame.groove_bottom_radius_m;
        if beyond_m > frame.half_span_m + frame.edge_radius_m {
            return None;
        }
        let across = frame.across_m(point);
        let end = if beyond_m > 0.0 { local.signum() } else { 0.0 };
        let mut place = match beyond_m > 0.0 {
            true => EdgePlace::End(end, across.atan2(beyond_m)),
            false => EdgePlace::Straight(across.signum(), local),
        };
        let mut line = CentreLine::new(frame, place);
        let mut from = plus(point, -1.0, line.centre_m);
        for _ in 0..PLACE_STEPS {
            let step = dot(from, line.along_m) / dot(line.along_m, line.along_m);
            place = place.moved(step);
            line = CentreLine::new(frame, place);
            from = plus(point, -1.0, line.centre_m);
            if step.abs() < PLACE_TOLERANCE_RAD {
                break;
            }
        }
        let distance_m = dot(from, from).sqrt();
        let error_m = distance_m - frame.edge_radius_m;
        let share = Edge::without_wall(frame, &line).share_towards(from);
        let on_edge =
            error_m.abs() < GATE * frame.edge_radius_m && (MARGIN..=1.0 - MARGIN).contains(&share);
        let slopes = || {
            std::array::from_fn(|k| {
                let [to, back] = [&more[k], &less[k]].map(|near| {
                    let centre_m = CentreLine::new(near, place).centre_m;
                    dot(from, centre_m) / distance_m + near.edge_radius_m
                });
                (back - to) / (2.0 * DIFFERENCE_M)
            })
        };
        on_edge.then(|| Self {
            error_m,
            share,
            end,
            slopes: slopes(),
        })
    }
}

/// The frame with other dimensions.
fn moved(frame: &RecessFrame, step_m: [f64; DIMENSIONS]) -> RecessFrame {
    let [edge, span, straight, middle, depth] = step_m;
    let bottom_m = frame.groove_bottom_radius_m;
    RecessFrame {
        edge_radius_m: frame.edge_radius_m + edge,
        ball_reach_m: frame.ball_reach_m + edge,
        half_span_m: frame.half_span_m + span,
        straight_rad: frame.straight_rad + straight / bottom_m,
        middle_rad: frame.middle_rad + middle / bottom_m,
        curvature_radius_m: frame.curvature_radius_m + depth,
        ..*frame
    }
}

/// Step of Gauss and Newton; one that would make the straight half negative ends where it is 0.
fn step_m(frame: &RecessFrame, touched: &[Touched]) -> Option<[f64; DIMENSIONS]> {
    let scale_m = HUBER * deviation_m(touched)?;
    let (mut normal, mut right) = normal_equations(touched, scale_m);
    let straight_m = frame.straight_rad * frame.groove_bottom_radius_m;
    let mut step = cholesky::solve(&normal, 0.0, right)?;
    if straight_m + step[STRAIGHT] < 0.0 {
        for k in 0..DIMENSIONS {
            let coupled = &mut normal[k.max(STRAIGHT)][k.min(STRAIGHT)];
            right[k] += *coupled * straight_m;
            *coupled = 0.0;
        }
        normal[STRAIGHT][STRAIGHT] = 1.0;
        right[STRAIGHT] = -straight_m;
        step = cholesky::solve(&normal, 0.0, right)?;
    }
    let longest = step.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
    let allowed = STEP * frame.edge_radius_m;
    Some(match longest > allowed {
        true => step.map(|s| s * (allowed / longest)),
        false => step,
    })
}

/// Standard deviation of the errors, by their median.
fn deviation_m(touched: &[Touched]) -> Option<f64> {
    let mut sizes: Vec<f64> = touched.iter().map(|point| point.error_m.abs()).collect();
    let middle = sizes.len() / 2;
    (sizes.len() > DIMENSIONS).then(|| {
        let (_, median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
        (MEDIAN_TO_DEVIATION * *median).max(DEVIATION_MIN_M)
    })
}
