//! Flanks of a discrete raceway from points of its measured surface.

use std::f64::consts::FRAC_PI_2;

use super::point_deviation::PointDeviation;
use super::section_frame::SectionFrame;
use crate::case::Case;
use crate::error::InputError;
use crate::raceway::{Linearised, PowerAngle, Raceway, fit_flanks};

/// Fewest points of a raceway.
const POINTS_MIN: usize = 50;
/// Largest root-mean-square distance of the points, in parts of Re − Rw.
const DEVIATION_MAX: f64 = 0.03;
/// Depth errors, in parts of the largest, of which the best is the first guess.
const GUESSES: [f64; 7] = [-0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9];
/// Depth errors on both sides of the best one so far between which the next is found, m.
const STEPS_M: [f64; 3] = [2e-6, 5e-7, 1e-7];
/// Smallest depth error that is significant, m and in standard errors of the fit.
const DEPTH_ERROR_MIN_M: f64 = 1e-7;
const STANDARD_ERRORS: f64 = 4.0;

/// Flanks fitted to points of the groove that a measuring machine has touched, in the frame of the
/// bearing: the axis is Z, the middle of the plain groove of a radial bearing at Z = 0, ψ = 0 at −Y.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeasuredGroove {
    flanks: PowerAngle,
    /// Depth error of the middle, along the normals of its flanks, m: above 0 too deep.
    pub(crate) depth_error_m: f64,
    /// Distances of the points within ±θ from the fitted groove.
    pub(crate) deviation: PointDeviation,
}

/// A point as seen from the ball that rests in its section: ψ from the middle of the raceway, and
/// place along the axis of the section and across it, towards the flank that it lies on; with the share of the
/// depth error there.
struct Seen {
    local_rad: f64,
    share: f64,
    along_m: f64,
    across_m: f64,
}

impl Seen {
    fn of(frame: &SectionFrame, raceway: &Raceway, [x, y, z]: [f64; 3]) -> Self {
        let (sin, cos) = frame.axis_rad.sin_cos();
        let [radial, axial] = [x.hypot(y) - frame.ball_m[0], z - frame.ball_m[1]];
        let angle_rad = x.atan2(-y);
        Self {
            local_rad: raceway.local_angle_rad(angle_rad),
            share: raceway.depth_share(angle_rad)[0],
            along_m: radial * cos + axial * sin - raceway.depth_at_m(angle_rad)[0],
            across_m: (axial * cos - radial * sin).abs(),
        }
    }

    /// Distance from flanks of this angle with this depth error in the middle, and its slope over the angle.
    fn error(&self, frame: &SectionFrame, angle_rad: f64, depth_error_m: f64) -> [f64; 2] {
        let (sin, cos) = angle_rad.sin_cos();
        let along = self.along_m + frame.offset_m * cos;
        let across = self.across_m + frame.offset_m * sin;
        let distance = (along * along + across * across).sqrt();
        let slope = frame.offset_m * (across * cos - along * sin) / distance;
        [
            distance - frame.curvature_radius_m - depth_error_m * self.share,
            slope,
        ]
    }
}

/// Rule that points of no groove break, with how far off the nearest fit is.
fn misfit(nearest: Option<&MeasuredGroove>, frame: &SectionFrame) -> String {
    let nearest = nearest.map_or_else(String::new, |found| {
        let percent = 100.0 * found.deviation.mean_m / frame.offset_m;
        format!(", which the nearest misses by {percent:.0} % of Re − Rw in the mean")
    });
    format!(
        "of the groove of this ring, in its frame, with flanks whose angle falls steadily from the \
         middle to 0 at the ends{nearest}"
    )
}

impl MeasuredGroove {
    /// Fit to the points within ±θ of a raceway of the case. In each section the flank is an arc of
    /// radius Re, larger by the depth error, whose centre is Re − Rw behind that of the ball, at the angle αc(ψ); the
    /// squares of the distances from it are least over αc and the depth error.
    ///
    /// # Errors
    /// An [`InputError`] of `points` if there are fewer than 50 within ±θ, or they are not near a
    /// groove whose flank angle falls steadily to 0 at the ends.
    ///
    /// # Panics
    /// If the case has no raceway `index`.
    pub(crate) fn fit(
        case: &Case,
        index: usize,
        points_m: &[[f64; 3]],
    ) -> Result<Self, InputError> {
        let raceway = &case.raceways[index];
        let frame = SectionFrame::of(case, raceway);
        let theta = raceway.half_angle_rad();
        let unit_m = raceway.depth_error_max_m();
        let seen = points_m
            .iter()
            .map(|point| Seen::of(&frame, raceway, *point));
        let seen: Vec<_> = seen.filter(|point| point.local_rad.abs() < theta).collect();
        let count = seen.len();
        let refuse = |rule: &str| Err(InputError::rule("points", count as f64, rule));
        if raceway.slot().is_some() {
            return refuse("those of another shape: MeasuredSlot fits the edges of a slot");
        }
        if count < POINTS_MIN {
            return refuse("50 or more within the half angle of the raceway, or nothing is fitted");
        }
        let fitted = |depth_error_m: f64| Self::with_depth(&seen, &frame, theta, depth_error_m);
        let square = |depth_error_m: f64| Some(fitted(depth_error_m)?.deviation.mean_m.powi(2));
        let guesses = GUESSES.map(|part| part * unit_m).into_iter();
        let guesses = guesses.filter_map(|guess_m| Some((square(guess_m)?, guess_m)));
        let guess = guesses.min_by(|a, b| a.0.total_cmp(&b.0));
        let first_m = guess.map_or(0.0, |(_, guess_m)| guess_m);
        // The squares are a parabola over the depth error but for the curvature of the flanks.
        let best_m = STEPS_M.iter().try_fold(first_m, |at_m, step_m| {
            let [low, middle, high] = [at_m - step_m, at_m, at_m + step_m].map(square);
            let (low, middle, high) = (low?, middle?, high?);
            let curvature = low - 2.0 * middle + high;
            let way = 0.5 * (low - high) / curvature;
            (curvature > 0.0).then_some(at_m + way * step_m)
        });
        let none = fitted(0.0);
        // One parameter more takes about 1/N of the squares by chance.
        let significant = |deep: &Self| {
            let less = none.as_ref().is_none_or(|none| {
                let ratio = none.deviation.mean_m / deep.deviation.mean_m;
                ratio.powi(2) - 1.0 > STANDARD_ERRORS.powi(2) / count as f64
            });
            less && deep.depth_error_m.abs() > DEPTH_ERROR_MIN_M
        };
        match best_m.and_then(fitted).filter(significant).or(none) {
            Some(found) if found.deviation.mean_m <= DEVIATION_MAX * frame.offset_m => Ok(found),
            other => refuse(&misfit(other.as_ref(), &frame)),
        }
    }

    /// Flanks with a depth error that fit points best; `None` where none do.
    fn with_depth(
        seen: &[Seen],
        frame: &SectionFrame,
        theta: f64,
        depth_error_m: f64,
    ) -> Option<Self> {
        let observed = |flanks: &PowerAngle| -> Linearised {
            let row = |point: &Seen| {
                let [angle, _] = flanks.at(point.local_rad);
                let [error, slope] = point.error(frame, angle, depth_error_m);
                [point.local_rad, slope, slope * angle - error]
            };
            seen.iter().map(row).collect()
        };
        let (flanks, [mean_m, largest_m]) = fit_flanks(theta, &observed)?;
        let deviation = PointDeviation {
            points: seen.len(),
            mean_m,
            largest_m,
        };
        Some(Self {
            flanks,
            depth_error_m,
            deviation,
        })
    }

    /// Distances of points of the raceway from the fitted flanks, m.
    pub(super) fn errors_m(&self, case: &Case, index: usize, points_m: &[[f64; 3]]) -> Vec<f64> {
        let raceway = &case.raceways[index];
        let frame = SectionFrame::of(case, raceway);
        let error = |point: &[f64; 3]| {
            let seen = Seen::of(&frame, raceway, *point);
            let angle = match seen.local_rad.abs() < self.flanks.half_angle_rad() {
                true => self.flank_angle_rad(seen.local_rad),
                false => 0.0,
            };
            seen.error(&frame, angle, self.depth_error_m)[0]
        };
        points_m.iter().map(error).collect()
    }

    /// αc at ψ from the middle of the raceway, within ±θ.
    pub(crate) fn flank_angle_rad(&self, local_angle_rad: f64) -> f64 {
        self.flanks.at(local_angle_rad)[0]
    }

    /// Rows of ψ from the middle of the raceway and αc, in `intervals` from there to the end and denser
    /// there.
    pub(super) fn rows(&self, intervals: usize) -> Vec<[f64; 2]> {
        let row = |k: usize| {
            let share = k as f64 / intervals as f64;
            let local = self.flanks.half_angle_rad() * (share * FRAC_PI_2).sin();
            [local, self.flank_angle_rad(local)]
        };
        (0..=intervals).map(row).collect()
    }
}
