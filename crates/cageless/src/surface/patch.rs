//! A part of the ring's surface as a bicubic B-spline.

use std::ops::Range;

use super::sheet::{Fibre, Sheet};
use crate::numerics::bspline::{Vec3, basis, interpolate, interval};

/// C² bicubic B-spline surface. The first parameter is an angle, the second runs from 0 to 1: on one side
/// of a sector's groove ψ, and equal steps of η from the ridge to the shoulder.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// Breakpoints over the angle, ascending; the first and the last are fourfold knots.
    pub along_rad: Vec<f64>,
    /// Breakpoints across; the first and the last are fourfold knots.
    pub across: Vec<f64>,
    /// Control points, `[along][across]`, two more than breakpoints each way.
    pub control_m: Vec<Vec<Vec3>>,
}

/// The tolerance is out of reach.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "a B-spline of {INTERVALS_MAX} intervals each way is still {reached_m:.3e} m off the surface, \
     more than {tolerance_m:e} m"
)]
pub struct PatchError {
    /// Value requested.
    pub tolerance_m: f64,
    /// Deviation reached.
    pub reached_m: f64,
}

/// Most intervals each way, give or take a third.
const INTERVALS_MAX: usize = 500;

impl Patch {
    /// Sheets side by side over a range of angles. All interpolate their surfaces, with their own
    /// tangents at the ends, at as many points as they need to stay within the tolerance, and
    /// share the points of common lines.
    pub(in crate::surface) fn of<S: Sheet, const N: usize>(
        sheets: &[S; N],
        range_rad: Range<f64>,
        tolerance_m: f64,
    ) -> Result<[Self; N], PatchError> {
        let (mut along, mut across) = (4, 4);
        loop {
            let patches = sheets.each_ref().map(|sheet| {
                let along_rad = equal_parts(range_rad.start, range_rad.end, along);
                Self::interpolated(sheet, along_rad, equal_parts(0.0, 1.0, across))
            });
            let worst = |measure: fn(&Self, &S) -> f64| {
                let pairs = patches.iter().zip(sheets);
                pairs.map(|(p, s)| measure(p, s)).fold(0.0, f64::max)
            };
            let reached_m = worst(Self::off_m);
            if reached_m <= tolerance_m {
                return Ok(patches);
            }
            if along.max(across) > INTERVALS_MAX {
                return Err(PatchError {
                    tolerance_m,
                    reached_m,
                });
            }
            // At its sites a direction is exact: what is off there is the other's.
            let half = tolerance_m / 2.0;
            let off_along = worst(Self::off_along_m) > half;
            if off_along {
                along = finer(along);
            }
            if !off_along || worst(Self::off_across_m) > half {
                across = finer(across);
            }
        }
    }

    fn interpolated(sheet: &impl Sheet, along_rad: Vec<f64>, across: Vec<f64>) -> Self {
        let rows: Vec<Vec<Vec3>> = (along_rad.iter())
            .map(|&angle| {
                let fibre = sheet.fibre(angle);
                let points: Vec<Vec3> = across.iter().map(|&u| fibre.point(u)).collect();
                interpolate(&across, &points, [fibre.across(0.0), fibre.across(1.0)])
            })
            .collect();
        let slopes = [along_rad[0], along_rad[along_rad.len() - 1]].map(|angle| {
            let fibre = sheet.fibre(angle);
            let slopes: Vec<Vec3> = across.iter().map(|&u| fibre.along(u)).collect();
            interpolate(&across, &slopes, [fibre.twist(0.0), fibre.twist(1.0)])
        });
        let columns: Vec<Vec<Vec3>> = (0..across.len() + 2)
            .map(|k| {
                let values: Vec<Vec3> = rows.iter().map(|row| row[k]).collect();
                interpolate(&along_rad, &values, [slopes[0][k], slopes[1][k]])
            })
            .collect();
        let control_m = (0..along_rad.len() + 2)
            .map(|i| columns.iter().map(|column| column[i]).collect())
            .collect();
        Self {
            along_rad,
            across,
            control_m,
        }
    }

    /// Point of the B-spline.
    pub(crate) fn point_m(&self, angle_rad: f64, across: f64) -> Vec3 {
        let (i, j) = (
            interval(&self.along_rad, angle_rad),
            interval(&self.across, across),
        );
        let (b, c) = (
            basis(&self.along_rad, i, angle_rad),
            basis(&self.across, j, across),
        );
        let mut point = [0.0; 3];
        for (k, along) in b.iter().enumerate() {
            for (l, across) in c.iter().enumerate() {
                for (sum, value) in point.iter_mut().zip(self.control_m[i + k][j + l]) {
                    *sum += along * across * value;
                }
            }
        }
        point
    }

    /// Largest distance from a sheet, at nine points of each interval each way and on both edges.
    pub(in crate::surface) fn off_m<S: Sheet>(&self, sheet: &S) -> f64 {
        let along = between(&self.along_rad);
        let mut across = between(&self.across);
        across.extend([0.0, 1.0]);
        self.worst_m(sheet, &along, &across)
    }

    fn off_along_m<S: Sheet>(&self, sheet: &S) -> f64 {
        let across = [0.0, self.across[self.across.len() / 2], 1.0];
        self.worst_m(sheet, &between(&self.along_rad), &across)
    }

    fn off_across_m<S: Sheet>(&self, sheet: &S) -> f64 {
        let sites = &self.along_rad;
        let along = [sites[0], sites[sites.len() / 2]];
        self.worst_m(sheet, &along, &between(&self.across))
    }

    fn worst_m<S: Sheet>(&self, sheet: &S, along: &[f64], across: &[f64]) -> f64 {
        let mut worst = 0.0f64;
        for &angle in along {
            for &u in across {
                let off = sheet.off_m(self.point_m(angle, u), angle, u);
                worst = worst.max(off.abs());
            }
        }
        worst
    }
}

fn finer(count: usize) -> usize {
    count + count.div_ceil(3)
}

/// The ends of so many equal parts.
pub(super) fn equal_parts(start: f64, end: f64, count: usize) -> Vec<f64> {
    let inner = (0..count).map(|k| start + (end - start) * k as f64 / count as f64);
    inner.chain([end]).collect()
}

/// Nine points of each interval.
fn between(sites: &[f64]) -> Vec<f64> {
    let points = |ends: &[f64]| {
        let (start, length) = (ends[0], ends[1] - ends[0]);
        (1..10).map(move |k| start + length * f64::from(k) / 10.0)
    };
    sites.windows(2).flat_map(points).collect()
}
