//! The groove of one sector as a bicubic B-spline.

use super::{Arc, OuterRing, RingSector, Side};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::bspline::{Vec3, basis, interpolate, interval};

/// C² bicubic B-spline surface of one side of a sector's groove. The first parameter is ψ, the
/// second runs from 0 at the ridge to 1 at the shoulder, in equal steps of η.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// Side of the ridge.
    pub side: Side,
    /// Breakpoints over ψ, ascending; the first and the last are fourfold knots.
    pub along_rad: Vec<f64>,
    /// Breakpoints from ridge to shoulder; the first and the last are fourfold knots.
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
    /// Upper and lower side of a sector. Both interpolate the surface, with its own tangents at the
    /// ends, at as many points as [`Patch::deviation_m`] of both needs to stay below `tolerance_m`,
    /// and share the points of the ridge.
    ///
    /// # Errors
    /// A [`PatchError`] if the points would become too many.
    pub fn pair(
        ring: &OuterRing,
        sector: &RingSector,
        tolerance_m: f64,
    ) -> Result<[Self; 2], PatchError> {
        let (mut along, mut across) = (4, 4);
        loop {
            let pair = Side::BOTH.map(|side| {
                let along_rad = equal_parts(sector.start_rad, sector.end_rad, along);
                Self::interpolated(ring, sector, side, along_rad, equal_parts(0.0, 1.0, across))
            });
            let worst = |measure: fn(&Self, &OuterRing, &RingSector) -> f64| {
                let [upper, lower] = pair.each_ref().map(|patch| measure(patch, ring, sector));
                upper.max(lower)
            };
            let reached_m = worst(Self::deviation_m);
            if reached_m <= tolerance_m {
                return Ok(pair);
            }
            if along.max(across) > INTERVALS_MAX {
                return Err(PatchError {
                    tolerance_m,
                    reached_m,
                });
            }
            // At its sites a direction is exact: what is off there is the other's.
            let half = tolerance_m / 2.0;
            let off_along = worst(Self::deviation_along_m) > half;
            if off_along {
                along = finer(along);
            }
            if !off_along || worst(Self::deviation_across_m) > half {
                across = finer(across);
            }
        }
    }

    fn interpolated(
        ring: &OuterRing,
        sector: &RingSector,
        side: Side,
        along_rad: Vec<f64>,
        across: Vec<f64>,
    ) -> Self {
        let fibre = |psi: f64| Fibre::new(*ring.meridian_in(sector, psi).arc(side), psi);
        let rows: Vec<Vec<Vec3>> = (along_rad.iter())
            .map(|&psi| {
                let fibre = fibre(psi);
                let points: Vec<Vec3> = across.iter().map(|&u| fibre.point(u)).collect();
                interpolate(&across, &points, [fibre.across(0.0), fibre.across(1.0)])
            })
            .collect();
        let slopes = [along_rad[0], along_rad[along_rad.len() - 1]].map(|psi| {
            let fibre = fibre(psi);
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
            side,
            along_rad,
            across,
            control_m,
        }
    }

    /// Point of the B-spline.
    pub fn point_m(&self, angle_rad: f64, across: f64) -> Vec3 {
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

    /// Largest distance from the analytic surface, and of the last row from the shoulder's
    /// cylinder, at nine points of each interval each way that are not sites.
    pub fn deviation_m(&self, ring: &OuterRing, sector: &RingSector) -> f64 {
        let along = between(&self.along_rad);
        let mut across = between(&self.across);
        across.extend([0.0, 1.0]);
        self.worst_m(ring, sector, &along, &across)
    }

    fn deviation_along_m(&self, ring: &OuterRing, sector: &RingSector) -> f64 {
        let across = [0.0, self.across[self.across.len() / 2], 1.0];
        self.worst_m(ring, sector, &between(&self.along_rad), &across)
    }

    fn deviation_across_m(&self, ring: &OuterRing, sector: &RingSector) -> f64 {
        let sites = &self.along_rad;
        let along = [sites[0], sites[sites.len() / 2]];
        self.worst_m(ring, sector, &along, &between(&self.across))
    }

    fn worst_m(&self, ring: &OuterRing, sector: &RingSector, along: &[f64], across: &[f64]) -> f64 {
        let mut worst = 0.0f64;
        for &psi in along {
            for &u in across {
                let [x, y, z] = self.point_m(psi, u);
                let rho = x.hypot(y);
                let middle = sector.middle_rad();
                let own = middle + wrap_angle_rad(x.atan2(-y) - middle);
                let meridian = ring.meridian_in(sector, own);
                let arc = meridian.arc(self.side);
                worst = worst.max(arc.distance_m(rho, self.side.sign() * z).abs());
                if u == 1.0 {
                    worst = worst.max((rho - ring.shoulder_radius_m()).abs());
                }
            }
        }
        worst
    }
}

/// One section of the surface over the second parameter, with its derivatives.
struct Fibre {
    arc: Arc,
    angle_rad: f64,
    valley: f64,
    range: f64,
    /// dη/dψ at fixed parameter: at the ridge, and how much more at the shoulder.
    drift: [f64; 2],
}

impl Fibre {
    fn new(arc: Arc, angle_rad: f64) -> Self {
        let valley = arc.valley_rad();
        let [valley_slope, shoulder_slope] = arc.limit_slopes();
        Self {
            valley,
            range: arc.shoulder_rad() - valley,
            drift: [valley_slope, shoulder_slope - valley_slope],
            arc,
            angle_rad,
        }
    }

    fn eta(&self, u: f64) -> f64 {
        self.valley + u * self.range
    }

    /// Vector from its components along e, t and, towards the shoulder, k.
    fn vector(&self, [radial, tangential, axial]: Vec3) -> Vec3 {
        let (sin, cos) = self.angle_rad.sin_cos();
        [
            radial * sin + tangential * cos,
            -radial * cos + tangential * sin,
            self.arc.side.sign() * axial,
        ]
    }

    fn point(&self, u: f64) -> Vec3 {
        let (arc, eta) = (&self.arc, self.eta(u));
        // Exactly 0 where the section is not turned.
        let height = if u == 0.0 {
            arc.ridge_height_m()
        } else {
            arc.height_m(eta)
        };
        self.vector([arc.radius_at_m(eta), 0.0, height])
    }

    /// ∂S/∂u.
    fn across(&self, u: f64) -> Vec3 {
        let (sin, cos) = self.eta(u).sin_cos();
        let arc = self.arc.curvature_radius_m * self.range;
        self.vector([-arc * sin, 0.0, arc * cos])
    }

    /// ∂S/∂ψ at fixed u.
    fn along(&self, u: f64) -> Vec3 {
        let (arc, eta) = (&self.arc, self.eta(u));
        let (sin, cos) = eta.sin_cos();
        let drift = arc.curvature_radius_m * (self.drift[0] + u * self.drift[1]);
        let radial = arc.radius_slope_m - drift * sin;
        let axial = if u == 0.0 {
            // The ridge stays on the axis of the section.
            radial * arc.axis_slope()
        } else {
            arc.height_slope_m + drift * cos
        };
        self.vector([radial, arc.radius_at_m(eta), axial])
    }

    /// ∂²S/∂u∂ψ.
    fn twist(&self, u: f64) -> Vec3 {
        let (sin, cos) = self.eta(u).sin_cos();
        let re = self.arc.curvature_radius_m;
        let (arc, change) = (re * self.range, re * self.drift[1]);
        let drift = self.drift[0] + u * self.drift[1];
        self.vector([
            -change * sin - arc * cos * drift,
            -arc * sin,
            change * cos - arc * sin * drift,
        ])
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
