//! A ring from points of its measured surface.
//!
//! The groove gives the frame: the ring is fitted where it lies in the machine, see the module of the fit. Raceways
//! are sought where the drawing has them, all turned by the same angle.

use std::f64::consts::PI;

use super::made_ring::MadeRing;
use super::measured_groove::MeasuredGroove;
use super::measured_raceway::{MeasuredFlank, MeasuredRaceway};
use super::measured_value::MeasuredValue;
use super::points_error::PointsError;
use super::recess::MeasuredSlot;
use super::ring_fit::{RingFit, gate_m, robust_deviation_m};
use crate::case::Case;
use crate::error::InputError;
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::bspline::Vec3;
use crate::raceway::{Raceway, RacewayDimensions};

/// A plain groove where the drawing has a raceway.
#[derive(Clone, Copy)]
struct NoRaceway {
    axial_span_m: Option<MeasuredValue>,
}

/// Fewest points of the groove, and of a raceway.
const POINTS_MIN: usize = 50;
/// Largest robust standard deviation of the plain groove, in parts of Re − Rw.
const DEVIATION_MAX: f64 = 0.03;
/// Largest error of the radii of the groove, in parts of Re − Rw.
const RADIUS_ERROR_MAX: f64 = 0.5;
/// Largest share of outliers.
const OUTLIERS_MAX: f64 = 0.25;
/// Points of a coarse search, and steps of the turn over half a raceway.
const COARSE_POINTS: usize = 3000;
const COARSE_STEPS: f64 = 8.0;
/// Distance at which a point counts as any farther one in that search, in parts of Re − Rw.
const COARSE_CAP: f64 = 0.25;
/// A turn is another only if its distances are less by this part of their range.
const COARSE_TIE: f64 = 0.02;
/// Distance of a point that is near a groove, in parts of Re − Rw.
const NEAR: f64 = 0.1;
/// Spans that are tried, in parts of that drawn.
const SPANS: [f64; 8] = [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0, 1.15];
/// Least span of a raceway, in standard uncertainties and in parts of that drawn.
const SPAN_UNCERTAINTIES: f64 = 6.0;
const SPAN_MIN: f64 = 0.02;
/// Distance from the shape of the drawing up to which a point may be of another shape, in parts of Re − Rw.
const FORM_MAX: f64 = 0.15;
/// Rounds of outliers of a raceway, and points on which they rest.
const ROUNDS: usize = 6;
const ROUND_POINTS: usize = 4000;

/// A ring fitted to points that a measuring machine has touched.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredRing {
    /// Shift of its centre in the frame of the machine, m.
    pub shift_m: [MeasuredValue; 3],
    /// Tilt of its axis about x and y, rad.
    pub tilt_rad: [MeasuredValue; 2],
    /// Turn about its axis against the drawing, mean of its raceways, rad; `None` without one.
    pub turn_rad: Option<MeasuredValue>,
    /// How much larger than drawn the radius of the groove's bottom is, m.
    pub bottom_radius_error_m: MeasuredValue,
    /// How much larger than drawn the radius of its curvature is, m.
    pub curvature_radius_error_m: MeasuredValue,
    /// Raceways in the order of the case.
    pub raceways: Vec<MeasuredRaceway>,
    /// Robust standard deviation of the points from the plain groove, m.
    pub deviation_m: f64,
    /// Points of the groove that were used.
    pub used: usize,
    /// Indices of points of the groove that are beyond five robust standard deviations.
    pub outliers: Vec<usize>,
    /// Number of points of other faces, and of slots.
    pub elsewhere: usize,
    /// Deviations of the points that were used from the drawn surface.
    pub deviations: Vec<PointOff>,
}

/// A point with its deviation from the surface of the drawing, in the frame of the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointOff {
    /// ψ, turned as drawn.
    pub angle_rad: f64,
    /// z, m.
    pub axial_m: f64,
    /// Deviation, positive where material is left, m.
    pub deviation_m: f64,
}

impl MeasuredRing {
    /// Fit to points in the frame of a machine, of a ring of this case.
    ///
    /// # Errors
    /// A [`PointsError`] if there are fewer than 50 of the groove, they are not near the groove of
    /// this ring, or those of a raceway or slot do not give it.
    ///
    /// # Panics
    /// If the case has no raceway.
    pub fn fit(case: &Case, points_m: &[Vec3]) -> Result<Self, PointsError> {
        let refuse = |count: usize, rule: &str| {
            PointsError::from(InputError::rule("points", count as f64, rule))
        };
        if points_m.len() < POINTS_MIN {
            return Err(refuse(points_m.len(), FEW));
        }
        let drawn = match plain_fit(case, points_m) {
            Some(plain) => MadeRing {
                pose: plain.ring.pose,
                sizes_m: plain.ring.sizes_m,
                ..MadeRing::drawn(case)
            },
            None => MadeRing::drawn(case),
        };
        let of_groove = indices(&drawn, points_m);
        if of_groove.len() < POINTS_MIN {
            return Err(refuse(of_groove.len(), FEW));
        }
        let places: Vec<Vec3> = of_groove.iter().map(|k| points_m[*k]).collect();
        let (fit, none) = Self::with_raceways(case, drawn, &places)
            .ok_or_else(|| refuse(places.len(), STRANGE))?;
        let largest = DEVIATION_MAX * fit.ring.offset_m();
        let radii = fit.ring.sizes_m;
        let near = |error_m: &f64| error_m.abs() <= RADIUS_ERROR_MAX * fit.ring.offset_m();
        if !(fit.deviations_m[0] <= largest && radii.iter().all(near)) {
            return Err(refuse(places.len(), STRANGE));
        }
        Self::of(case, &fit, &none, points_m)
    }

    /// The fit with those raceways that are there, and what is said of the others.
    fn with_raceways(
        case: &Case,
        drawn: MadeRing,
        places: &[Vec3],
    ) -> Option<(RingFit, Vec<Option<NoRaceway>>)> {
        let count = case.raceways.len();
        let mut none = vec![None; count];
        if drawn.raceways.iter().all(Option::is_none) {
            // Slots alone.
            return Some((RingFit::of(case, drawn, places)?, none));
        }
        let coarse = Coarse::new(places, &drawn);
        let turned = coarse.turned(case, &drawn);
        let Some(guess) = coarse.spanned(case, &turned) else {
            let absent = |made: &Option<_>| made.as_ref().map(|_| NoRaceway { axial_span_m: None });
            let none = drawn.raceways.iter().map(absent).collect();
            let plain = drawn.scaled(case, 0.0).ok()?;
            return Some((RingFit::of(case, plain, places)?, none));
        };
        let mut fit = RingFit::of(case, guess, places)?;
        let mut ring = fit.ring.clone();
        for (k, none) in none.iter_mut().enumerate() {
            let Some([span, ..]) = fit.raceway(k) else {
                continue;
            };
            let drawn_m = case.raceways[k].dimensions().axial_span_m;
            let least = (SPAN_UNCERTAINTIES * span.standard_uncertainty).max(SPAN_MIN * drawn_m);
            if !(span.value > least) {
                *none = Some(NoRaceway {
                    axial_span_m: Some(span),
                });
                ring.raceways[k] = None;
            }
        }
        if none.iter().any(Option::is_some) {
            fit = RingFit::of(case, ring, places)?;
        }
        Some((fit, none))
    }

    fn of(
        case: &Case,
        fit: &RingFit,
        none: &[Option<NoRaceway>],
        points_m: &[Vec3],
    ) -> Result<Self, PointsError> {
        let ring = &fit.ring;
        let of_groove = indices(ring, points_m);
        let seen = of_groove.iter().map(|k| PointSeen::of(ring, points_m, *k));
        let seen: Vec<PointSeen> = seen.collect();
        let plain = seen.iter().filter(|point| point.raceway.is_none());
        let beyond = plain.filter(|point| point.error_m.abs() > fit.gate_m(None));
        let mut outliers: Vec<usize> = beyond.map(|point| point.index).collect();
        let mut raceways = vec![];
        for (index, none) in none.iter().enumerate() {
            raceways.push(match none {
                Some(none) => MeasuredRaceway::None {
                    axial_span_m: none.axial_span_m,
                },
                None => {
                    let own = seen.iter().filter(|point| point.raceway == Some(index));
                    let own: Vec<_> = own.map(|point| (point.index, point.error_m)).collect();
                    let refused = |error| PointsError {
                        raceway: Some(index),
                        error,
                    };
                    measured_raceway(case, fit, index, points_m, &own, &mut outliers)
                        .map_err(refused)?
                }
            });
        }
        outliers.sort_unstable();
        let used = of_groove.len() - outliers.len();
        if outliers.len() as f64 > OUTLIERS_MAX * of_groove.len() as f64 {
            let error = InputError::rule("points", of_groove.len() as f64, STRANGE);
            return Err(error.into());
        }
        let turn_rad = turn_rad(case, &raceways);
        let kept = of_groove
            .iter()
            .filter(|k| outliers.binary_search(k).is_err());
        let kept: Vec<Vec3> = kept.map(|k| points_m[*k]).collect();
        let turn = turn_rad.map_or(0.0, |turn| turn.value);
        let [bottom_radius_error_m, curvature_radius_error_m] = fit.sizes_m();
        Ok(Self {
            shift_m: fit.shift_m(),
            tilt_rad: fit.tilt_rad(),
            turn_rad,
            bottom_radius_error_m,
            curvature_radius_error_m,
            raceways,
            deviation_m: fit.deviations_m[0],
            used,
            elsewhere: points_m.len() - of_groove.len(),
            outliers,
            deviations: points_off(case, ring, turn, &kept),
        })
    }
}

/// A point of the groove against a fit.
struct PointSeen {
    index: usize,
    error_m: f64,
    /// Raceway on which it lies.
    raceway: Option<usize>,
}

impl PointSeen {
    fn of(ring: &MadeRing, points_m: &[Vec3], index: usize) -> Self {
        let (error_m, raceway) = ring.distance_m(points_m[index]);
        Self {
            index,
            error_m,
            raceway,
        }
    }
}

/// Deviations of points from the drawing, turned about the axis as it was made.
fn points_off(case: &Case, ring: &MadeRing, turn_rad: f64, points_m: &[Vec3]) -> Vec<PointOff> {
    let drawn = MadeRing {
        pose: ring.pose,
        ..ring.as_drawn(case, turn_rad)
    };
    let off = |point: &Vec3| {
        let [x, y, z] = ring.pose.in_ring_m(*point);
        PointOff {
            angle_rad: wrap_angle_rad(x.atan2(-y) - turn_rad),
            axial_m: z,
            deviation_m: -drawn.distance_m(*point).0,
        }
    };
    points_m.iter().map(off).collect()
}

/// Raceway `index` by its `own` points with their distances from the fit, to which outliers are added.
fn measured_raceway(
    case: &Case,
    fit: &RingFit,
    index: usize,
    points_m: &[Vec3],
    own: &[(usize, f64)],
    outliers: &mut Vec<usize>,
) -> Result<MeasuredRaceway, InputError> {
    let Some(dimensions) = fit.raceway(index) else {
        let pose = &fit.ring.pose;
        let placed: Vec<Vec3> = points_m.iter().map(|p| pose.in_ring_m(*p)).collect();
        let slot = MeasuredSlot::fit(case, index, &placed)?;
        return Ok(MeasuredRaceway::Slot(Box::new(slot)));
    };
    let found = flanks(case, fit, index, points_m, own)?;
    outliers.extend(found.outliers);
    let [
        axial_span_m,
        half_angle_rad,
        centre_angle_rad,
        depth_error_m,
    ] = dimensions;
    Ok(MeasuredRaceway::Flanks(Box::new(MeasuredFlank {
        axial_span_m,
        half_angle_rad,
        centre_angle_rad,
        depth_error_m,
        profile_depth_error_m: found.groove.depth_error_m,
        deviation: found.groove.deviation,
        groove: found.groove,
    })))
}

const FEW: &str = "50 or more of the groove, or nothing is fitted";
const STRANGE: &str =
    "of the groove of this ring, with its axis along z, and its raceways those of the case";

/// Indices of the points of a groove.
fn indices(ring: &MadeRing, points_m: &[Vec3]) -> Vec<usize> {
    let near = |k: &usize| {
        let point = points_m[*k];
        ring.has(point) && ring.distance_m(point).0.is_finite()
    };
    (0..points_m.len()).filter(near).collect()
}

/// The groove without raceways, to see where the ring lies: with the points near it as drawn, or with all.
fn plain_fit(case: &Case, points_m: &[Vec3]) -> Option<RingFit> {
    let mut plain = MadeRing::drawn(case);
    plain
        .raceways
        .iter_mut()
        .for_each(|raceway| *raceway = None);
    let stride = points_m.len().div_ceil(COARSE_POINTS);
    let points_m: Vec<Vec3> = points_m.iter().step_by(stride).copied().collect();
    let of_groove = |ring: &MadeRing| -> Vec<Vec3> {
        let found = indices(ring, &points_m);
        found.iter().map(|k| points_m[*k]).collect()
    };
    let fitted = |first: &[Vec3]| {
        // What belongs to the groove is seen once the ring is in place.
        let mut fit = RingFit::of(case, plain.clone(), first)?;
        for _ in 0..2 {
            let of_groove = of_groove(&fit.ring);
            fit = RingFit::of(case, fit.ring, &of_groove)?;
        }
        let close_m = NEAR * fit.ring.offset_m();
        let near =
            |point: &&Vec3| fit.ring.has(**point) && fit.ring.distance_m(**point).0.abs() < close_m;
        Some((points_m.iter().filter(near).count(), fit))
    };
    let tried = [fitted(&of_groove(&plain)), fitted(&points_m)];
    let best = tried.into_iter().flatten().max_by_key(|(near, _)| *near);
    best.map(|(_, fit)| fit)
}

/// A coarse search with few points.
struct Coarse {
    points_m: Vec<Vec3>,
    cap_m: f64,
}

impl Coarse {
    fn new(places: &[Vec3], ring: &MadeRing) -> Self {
        let stride = places.len().div_ceil(COARSE_POINTS).max(1);
        Self {
            points_m: places.iter().step_by(stride).copied().collect(),
            cap_m: COARSE_CAP * ring.offset_m(),
        }
    }

    /// Sum of the distances, none of which counts more than the cap.
    fn cost_m(&self, ring: &MadeRing) -> f64 {
        let distance = |point: &Vec3| ring.distance_m(*point).0.abs().min(self.cap_m);
        self.points_m.iter().map(distance).sum()
    }

    /// The ring with its raceways turned to where points have them.
    fn turned(&self, case: &Case, ring: &MadeRing) -> MadeRing {
        let raceways = ring.raceways.iter().flatten();
        let shortest = raceways.map(|made| made.raceway.half_angle_rad());
        let shortest = shortest.fold(PI, f64::min);
        let count = (COARSE_STEPS * PI / shortest).ceil().clamp(36.0, 720.0);
        let half = count as i32;
        let tried = (-half..=half).filter_map(|k| {
            let turn_rad = PI * f64::from(k) / count;
            let ring = ring.turned(case, turn_rad).ok()?;
            Some((self.cost_m(&ring), turn_rad.abs(), ring))
        });
        let tried: Vec<_> = tried.collect();
        let costs = || tried.iter().map(|(cost, ..)| *cost);
        let [least, most] = [
            costs().fold(f64::INFINITY, f64::min),
            costs().fold(0.0, f64::max),
        ];
        let limit = least + COARSE_TIE * (most - least);
        let near = tried.iter().filter(|(cost, ..)| *cost <= limit);
        let best = near.min_by(|a, b| a.1.total_cmp(&b.1));
        best.map_or_else(|| ring.clone(), |(.., ring)| ring.clone())
    }

    /// The ring with the span that comes nearest; `None` if that is no raceway at all.
    fn spanned(&self, case: &Case, ring: &MadeRing) -> Option<MadeRing> {
        let tried = SPANS.iter().filter_map(|factor| {
            let ring = ring.scaled(case, *factor).ok()?;
            Some((self.cost_m(&ring), *factor, ring))
        });
        let best = tried.min_by(|a, b| a.0.total_cmp(&b.0));
        best.filter(|(_, factor, _)| *factor > 0.0)
            .map(|(.., ring)| ring)
    }
}

/// Mean turn of the raceways against the drawing.
fn turn_rad(case: &Case, raceways: &[MeasuredRaceway]) -> Option<MeasuredValue> {
    let turns = case.raceways.iter().zip(raceways);
    let turns: Vec<MeasuredValue> = turns
        .filter_map(|(drawn, made)| {
            let centre = match made {
                MeasuredRaceway::None { .. } => return None,
                MeasuredRaceway::Flanks(made) => made.centre_angle_rad,
                MeasuredRaceway::Slot(made) => made.centre_angle_rad,
            };
            let value = wrap_angle_rad(centre.value - drawn.dimensions().centre_angle_rad);
            Some(MeasuredValue { value, ..centre })
        })
        .collect();
    let count = turns.len() as f64;
    let first = turns.first()?.value;
    let mean = turns
        .iter()
        .map(|t| wrap_angle_rad(t.value - first))
        .sum::<f64>()
        / count;
    let squares: f64 = turns.iter().map(|t| t.standard_uncertainty.powi(2)).sum();
    Some(MeasuredValue {
        value: wrap_angle_rad(first + mean),
        standard_uncertainty: squares.sqrt() / count,
    })
}

/// Flanks of any shape with the points that are not of them.
struct Flanks {
    groove: MeasuredGroove,
    outliers: Vec<usize>,
}

/// Flanks of a raceway by its points, given with their distances from the shape of the drawing.
fn flanks(
    case: &Case,
    fit: &RingFit,
    index: usize,
    points_m: &[Vec3],
    own: &[(usize, f64)],
) -> Result<Flanks, InputError> {
    let made = fit.ring.raceways[index].as_ref();
    let made = made.map_or(&case.raceways[index], |made| &made.raceway);
    let drawn = &case.raceways[index];
    let dimensions = RacewayDimensions {
        axial_span_m: drawn.dimensions().axial_span_m,
        ..*made.dimensions()
    };
    let placed = Raceway::formed(dimensions, drawn.form(), &case.bearing)?
        .with_section_angle(drawn.section_angle_rad(), &case.bearing)?;
    let mut turned = case.clone();
    turned.raceways[index] = placed;
    let gate = fit.gate_m(Some(index)).max(FORM_MAX * fit.ring.offset_m());
    let places: Vec<Vec3> = (own.iter())
        .map(|(k, _)| fit.ring.on_drawn_radii_m(points_m[*k]))
        .collect();
    let fitted = |kept: &[bool], most: usize| {
        let kept: Vec<Vec3> = (places.iter().zip(kept))
            .filter_map(|(place, kept)| kept.then_some(*place))
            .collect();
        let stride = kept.len().div_ceil(most).max(1);
        let few: Vec<Vec3> = kept.into_iter().step_by(stride).collect();
        MeasuredGroove::fit(&turned, index, &few)
    };
    let mut kept: Vec<bool> = own
        .iter()
        .map(|(_, error_m)| error_m.abs() <= gate)
        .collect();
    for _ in 0..ROUNDS {
        let groove = fitted(&kept, ROUND_POINTS)?;
        let errors = groove.errors_m(&turned, index, &places);
        let inner = errors.iter().zip(&kept).filter(|(_, kept)| **kept);
        let limit = gate_m(robust_deviation_m(inner.map(|(error_m, _)| *error_m)));
        let next: Vec<bool> = errors
            .iter()
            .map(|error_m| error_m.abs() <= limit)
            .collect();
        if next == kept {
            break;
        }
        kept = next;
    }
    let outliers = own.iter().zip(&kept).filter(|(_, kept)| !**kept);
    Ok(Flanks {
        groove: fitted(&kept, usize::MAX)?,
        outliers: outliers.map(|((k, _), _)| *k).collect(),
    })
}
