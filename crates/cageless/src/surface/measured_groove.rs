//! Flanks of a discrete raceway from points of its measured surface.

use std::f64::consts::FRAC_PI_2;

use super::point_deviation::PointDeviation;
use super::section_frame::SectionFrame;
use crate::case::Case;
use crate::error::InputError;
use crate::raceway::{Linearised, PowerAngle, fit_flanks};

/// Fewest points of a raceway.
const POINTS_MIN: usize = 50;
/// Largest root-mean-square distance of the points, in parts of Re − Rw.
const DEVIATION_MAX: f64 = 0.1;

/// Flanks fitted to points of the groove that a measuring machine has touched, in the frame of the
/// bearing: the axis is Z, the middle of the plain groove of a radial bearing at Z = 0, ψ = 0 at −Y.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGroove {
    flanks: PowerAngle,
    deviation: PointDeviation,
}

/// A point as seen from the ball that rests in its section: ψ from the middle of the raceway, and
/// place along the axis of the section and across it, towards the flank that it lies on.
struct Seen {
    local_rad: f64,
    along_m: f64,
    across_m: f64,
}

impl MeasuredGroove {
    /// Fit to the points within ±θ of a raceway of the case. In each section the flank is an arc of
    /// radius Re whose centre is Re − Rw behind that of the ball, at the angle αc(ψ); the squares of
    /// the distances from it are least.
    ///
    /// # Errors
    /// An [`InputError`] of `points` if there are fewer than 50 within ±θ, or they are not near a
    /// groove whose flank angle falls steadily to 0 at the ends.
    ///
    /// # Panics
    /// If the case has no raceway `index`.
    pub fn fit(case: &Case, index: usize, points_m: &[[f64; 3]]) -> Result<Self, InputError> {
        let raceway = &case.raceways[index];
        let frame = SectionFrame::of(case, raceway);
        let (sin, cos) = frame.axis_rad.sin_cos();
        let theta = raceway.half_angle_rad();
        let seen = points_m.iter().map(|[x, y, z]| {
            let [radial, axial] = [x.hypot(*y) - frame.ball_m[0], z - frame.ball_m[1]];
            let angle_rad = x.atan2(-y);
            Seen {
                local_rad: raceway.local_angle_rad(angle_rad),
                along_m: radial * cos + axial * sin - raceway.depth_at_m(angle_rad)[0],
                across_m: (axial * cos - radial * sin).abs(),
            }
        });
        let seen: Vec<_> = seen.filter(|point| point.local_rad.abs() < theta).collect();
        let count = seen.len();
        let refuse = |rule: &str| Err(InputError::rule("points", count as f64, rule));
        if raceway.slot().is_some() {
            return refuse("those of another shape: MeasuredSlot fits the edges of a slot");
        }
        if count < POINTS_MIN {
            return refuse("50 or more within the half angle of the raceway, or nothing is fitted");
        }
        let observed = |flanks: &PowerAngle| -> Linearised {
            let row = |point: &Seen| {
                let [angle, _] = flanks.at(point.local_rad);
                let (sin, cos) = angle.sin_cos();
                let along = point.along_m + frame.offset_m * cos;
                let across = point.across_m + frame.offset_m * sin;
                let distance = along.hypot(across);
                let slope = frame.offset_m * (across * cos - along * sin) / distance;
                let error = distance - frame.curvature_radius_m;
                [point.local_rad, slope, slope * angle - error]
            };
            seen.iter().map(row).collect()
        };
        match fit_flanks(theta, &observed) {
            Some((flanks, deviation_m)) if deviation_m[0] <= DEVIATION_MAX * frame.offset_m => {
                let [mean_m, largest_m] = deviation_m;
                let deviation = PointDeviation {
                    points: count,
                    mean_m,
                    largest_m,
                };
                Ok(Self { flanks, deviation })
            }
            _ => refuse(
                "of the groove of this ring, in its frame, with flanks whose angle falls steadily \
                 from the middle to 0 at the ends",
            ),
        }
    }

    /// αc at ψ from the middle of the raceway, within ±θ.
    pub fn flank_angle_rad(&self, local_angle_rad: f64) -> f64 {
        self.flanks.at(local_angle_rad)[0]
    }

    /// Rows of ψ from the middle of the raceway and αc, in `intervals` from there to the end and denser
    /// there.
    pub fn rows(&self, intervals: usize) -> Vec<[f64; 2]> {
        let row = |k: usize| {
            let share = k as f64 / intervals as f64;
            let local = self.flanks.half_angle_rad() * (share * FRAC_PI_2).sin();
            [local, self.flank_angle_rad(local)]
        };
        (0..=intervals).map(row).collect()
    }

    /// Distances of the points within ±θ from the fitted groove.
    pub fn deviation(&self) -> PointDeviation {
        self.deviation
    }
}
