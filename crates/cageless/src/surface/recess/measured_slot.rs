//! A slot from points of its measured surface.

use super::edge_fit::{Covariance, DIMENSIONS, Touched, fit_edges};
use super::recess_frame::RecessFrame;
use crate::case::Case;
use crate::error::InputError;
use crate::numerics::angle::wrap_angle_rad;
use crate::surface::measured_value::MeasuredValue;
use crate::surface::point_deviation::PointDeviation;
use crate::surface::section_frame::SectionFrame;

/// Fewest points on the edges, and around each end.
const POINTS_MIN: usize = 50;
const END_POINTS_MIN: usize = 10;
/// Least part of the arc over which nine tenths of the points are spread.
const SPREAD_MIN: f64 = 0.3;
/// Largest root-mean-square distance of the points, in parts of re.
const DEVIATION_MAX: f64 = 0.1;
/// Fewest points of the floor.
const FLOOR_POINTS_MIN: usize = 10;
/// Lengths are given to the nanometre.
const LENGTH_M: f64 = 1e-9;

/// A slot fitted to points that a measuring machine has touched, in the frame of the bearing: the axis is Z,
/// the middle of the plain groove of a radial bearing at Z = 0, ψ = 0 at −Y.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredSlot {
    /// re.
    pub edge_radius_m: MeasuredValue,
    /// lC.
    pub axial_span_m: MeasuredValue,
    /// θ.
    pub half_angle_rad: MeasuredValue,
    /// ψ of the middle.
    pub centre_angle_rad: MeasuredValue,
    /// Width between the walls below the edges, m.
    pub width_m: f64,
    /// How much farther out than in a slot of these dimensions a ball on both edges sits in the middle, along the
    /// normals at its contacts, m.
    pub depth_error_m: MeasuredValue,
    /// Depth of the floor below the bottom of the plain groove, m; `None` if it has fewer than 10 points.
    pub slot_depth_m: Option<f64>,
    /// Distances of the points on the edges from the fit.
    pub deviation: PointDeviation,
}

/// Standard uncertainties of the dimensions of a slot, from the scatter of the points on its edges.
struct SlotUncertainty {
    /// Uncertainty of the edge radius re.
    edge_radius_m: f64,
    /// Uncertainty of the axial span lC.
    axial_span_m: f64,
    /// Uncertainty of the half angle θ.
    half_angle_rad: f64,
    /// Uncertainty of the angular position ψ of the middle.
    centre_angle_rad: f64,
    /// Uncertainty of the depth error.
    depth_error_m: f64,
}

impl SlotUncertainty {
    /// Uncertainties of a slot with this covariance of the fitted quantities: re, ze, straight half and middle along
    /// the bottom, and depth.
    fn of(frame: &RecessFrame, ball_radius_m: f64, covariance: &Covariance) -> Self {
        let (reach, bottom) = (frame.ball_reach_m, frame.groove_bottom_radius_m);
        let sine = frame.half_span_m / reach;
        // lC = 2 Rw ze/(Rw + re), θ = (straight + ze)/Ro, and the place of a ball on both edges.
        let span = 2.0 * ball_radius_m / reach;
        let of = |slopes: [f64; DIMENSIONS]| {
            let row =
                |i: usize| (0..DIMENSIONS).map(move |j| slopes[i] * covariance[i][j] * slopes[j]);
            (0..DIMENSIONS).flat_map(row).sum::<f64>().max(0.0).sqrt()
        };
        Self {
            edge_radius_m: of([1.0, 0.0, 0.0, 0.0, 0.0]),
            axial_span_m: of([-span * sine, span, 0.0, 0.0, 0.0]),
            half_angle_rad: of([0.0, 1.0, 1.0, 0.0, 0.0]) / bottom,
            centre_angle_rad: of([0.0, 0.0, 0.0, 1.0, 0.0]) / bottom,
            depth_error_m: of([0.0, 0.0, 0.0, 0.0, 1.0]),
        }
    }
}

impl MeasuredSlot {
    /// Fit to the points on the rounded edges of a slot of the case; others on groove, walls and floor do
    /// not matter, but for the depth of the floor.
    ///
    /// # Errors
    /// An [`InputError`] of `points` if there are fewer than 50 on the edges or 10 around an end, if they lie on
    /// a narrow strip of them, or are not near a slot.
    ///
    /// # Panics
    /// If raceway `index` of the case is no slot.
    pub(crate) fn fit(
        case: &Case,
        index: usize,
        points_m: &[[f64; 3]],
    ) -> Result<Self, InputError> {
        let raceway = &case.raceways[index];
        let slot = raceway.slot().expect("a slot");
        let section = SectionFrame::of(case, raceway);
        let designed = RecessFrame::new(&section, raceway, slot)?;
        let refuse = |count: usize, rule: &str| InputError::rule("points", count as f64, rule);
        let strange = "of the edges of this slot, in the frame of its ring, and their radius, width, length and \
                       place near those of the case";
        let fitted = fit_edges(&designed, points_m);
        let (frame, touched, covariance) = fitted.ok_or_else(|| refuse(0, FEW))?;
        let count = touched.len();
        let around = |end: f64| touched.iter().filter(|point| point.end == end).count();
        if count < POINTS_MIN || around(1.0).min(around(-1.0)) < END_POINTS_MIN {
            return Err(refuse(count, FEW));
        }
        if spread(&touched) < SPREAD_MIN {
            let rule =
                "spread over the rounding from the groove to the wall, or its radius is open";
            return Err(refuse(count, rule));
        }
        let deviation = PointDeviation::of(touched.iter().map(|point| point.error_m));
        if !(deviation.mean_m <= DEVIATION_MAX * frame.edge_radius_m) {
            return Err(refuse(count, strange));
        }
        let to_length = |length: f64| (length / LENGTH_M).round() * LENGTH_M;
        let rw = case.bearing.ball_radius_m();
        let edge_radius_m = to_length(frame.edge_radius_m);
        let axial_span_m = to_length(2.0 * rw * frame.half_span_m / frame.ball_reach_m);
        let half_span_m = (rw + edge_radius_m) * axial_span_m / (2.0 * rw);
        let sine = frame.half_span_m / frame.ball_reach_m;
        let depth = |reach: f64| (reach * reach - frame.half_span_m.powi(2)).sqrt();
        let reach = frame.curvature_radius_m + frame.edge_radius_m;
        let own = designed.curvature_radius_m + frame.edge_radius_m;
        let half_angle_rad = frame.straight_rad + half_span_m / frame.groove_bottom_radius_m;
        let depth_error_m = (depth(reach) - depth(own)) * (1.0 - sine * sine).sqrt();
        let u = SlotUncertainty::of(&frame, rw, &covariance);
        let measured = |value, standard_uncertainty| MeasuredValue {
            value,
            standard_uncertainty,
        };
        Ok(Self {
            edge_radius_m: measured(edge_radius_m, u.edge_radius_m),
            axial_span_m: measured(axial_span_m, u.axial_span_m),
            half_angle_rad: measured(half_angle_rad, u.half_angle_rad),
            centre_angle_rad: measured(frame.middle_rad, u.centre_angle_rad),
            width_m: 2.0 * (half_span_m - edge_radius_m),
            depth_error_m: measured(depth_error_m, u.depth_error_m),
            slot_depth_m: floor_depth_m(&designed, &frame, points_m),
            deviation,
        })
    }
}

/// Points required for the fit of a slot.
const FEW: &str = "50 or more on the rounded edges of the slot, 10 of them around each of its ends, or nothing is fitted";

/// Part of the arc over which the middle nine tenths of the points are spread.
fn spread(touched: &[Touched]) -> f64 {
    let mut shares: Vec<f64> = touched.iter().map(|point| point.share).collect();
    shares.sort_unstable_by(f64::total_cmp);
    let at = |tenths: f64| shares[(tenths * (shares.len() - 1) as f64) as usize];
    at(0.95) - at(0.05)
}

/// Median depth of the points between the straight walls, farther than re from them and below the centres of the edges.
fn floor_depth_m(
    designed: &RecessFrame,
    frame: &RecessFrame,
    points_m: &[[f64; 3]],
) -> Option<f64> {
    let half_m = frame.half_span_m - 2.0 * frame.edge_radius_m;
    let along = |point: &[f64; 3]| designed.floor_m - designed.above_floor_m(*point);
    let floor = points_m.iter().filter(|point| {
        let [x, y, _] = **point;
        let local = wrap_angle_rad(x.atan2(-y) - frame.middle_rad);
        local.abs() < frame.straight_rad
            && frame.across_m(**point).abs() < half_m
            && along(point) > frame.curvature_radius_m + frame.edge_radius_m
    });
    let mut depths: Vec<f64> = floor.map(along).collect();
    let middle = depths.len() / 2;
    (depths.len() >= FLOOR_POINTS_MIN).then(|| {
        let (_, median, _) = depths.select_nth_unstable_by(middle, f64::total_cmp);
        *median - designed.curvature_radius_m
    })
}
