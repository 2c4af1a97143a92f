//! The solid as a closed mesh of triangles.

use super::grid::{row_rad, widest_arc_rad};
use super::patch::equal_parts;
use super::{Meridian, OuterRing};
use crate::error::InputError;
use crate::limits::from_to;
use crate::numerics::bspline::Vec3;

/// Triangles that share their corners. Seen from outside the ring's material, corners go
/// counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Corners.
    pub vertices_m: Vec<Vec3>,
    /// Indices of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Largest distance from the analytic surface, measured in the middle of edges and of
    /// triangles, and the rounding allowed for.
    pub deviation_m: f64,
}

/// Finest chord error: millions of triangles.
const CHORD_MIN_M: f64 = 5e-8;
/// Least chord error in units of what writing moves a corner.
const ROUNDINGS: f64 = 10.0;
/// Coarsest chord error.
const CHORD_MAX_M: f64 = 1e-4;
/// Fraction of the chord error that the arcs across the groove take up.
const ACROSS_FRACTION: f64 = 0.4;

impl Mesh {
    /// Meshes the ring so that no triangle is further than `chord_m` from its surface, even
    /// if each corner is moved by `rounding_m`.
    ///
    /// # Errors
    /// An [`InputError`] if `chord_m` is below 0.05 µm or ten times the rounding, or above
    /// 100 µm or half the wall behind the groove.
    pub fn new(ring: &OuterRing, chord_m: f64, rounding_m: f64) -> Result<Self, InputError> {
        let wall = ring.dimensions().outer_ring_outer_radius_m - ring.deepest_radius_m();
        let least = CHORD_MIN_M.max(ROUNDINGS * rounding_m);
        let most = CHORD_MAX_M.min(wall / 2.0);
        let why = "ten times the rounding of coordinates or 0.05 µm; half the wall behind the groove \
                   or 100 µm";
        from_to("chord_m", chord_m, [least, most], why)?;
        let mut mesh = Self::within(ring, chord_m - rounding_m);
        mesh.deviation_m += rounding_m;
        Ok(mesh)
    }

    fn within(ring: &OuterRing, chord_m: f64) -> Self {
        let re = ring.curvature_radius_m();
        let arc = (8.0 * ACROSS_FRACTION * chord_m / re).sqrt();
        let steps = (widest_arc_rad(ring) / arc).ceil().max(2.0) as usize;
        let mut rows = Vec::new();
        let mut deviation_m = 0.0f64;
        let outside = ring.dimensions().outer_ring_outer_radius_m;
        // Sagitta of the cylinder outside: R(1 − cos Δ/2).
        let widest = 2.0 * (1.0 - 0.99 * chord_m / outside).acos();
        for sector in ring.sectors() {
            let length = sector.end_rad - sector.start_rad;
            let mut count = (length / widest).ceil().max(2.0) as usize;
            loop {
                let part: Vec<Row> = equal_parts(sector.start_rad, sector.end_rad, count)
                    .into_iter()
                    .map(|psi| Row::new(ring.meridian_in(&sector, psi), steps))
                    .collect();
                let groove = worst_m(&part, |angle| ring.meridian_in(&sector, angle));
                if groove <= chord_m {
                    let sagitta = outside * (1.0 - (length / count as f64 / 2.0).cos());
                    deviation_m = deviation_m.max(groove).max(sagitta);
                    // The last row is the first of the next sector.
                    rows.extend(part.into_iter().take(count));
                    break;
                }
                let more = (groove / chord_m).sqrt().clamp(1.05, 4.0);
                count = (count as f64 * more).ceil() as usize;
            }
        }
        Self::closed(ring, &rows, deviation_m)
    }

    /// Joins the rows, each continued around the section of the ring.
    fn closed(ring: &OuterRing, rows: &[Row], deviation_m: f64) -> Self {
        let d = ring.dimensions();
        let (outside, half) = (d.outer_ring_outer_radius_m, d.outer_ring_width_m / 2.0);
        let shoulder = ring.shoulder_radius_m();
        let corners = [
            (shoulder, half),
            (outside, half),
            (outside, -half),
            (shoulder, -half),
        ];
        let mut vertices_m = Vec::new();
        for row in rows {
            vertices_m.extend_from_slice(&row.points);
            let (sin, cos) = row.angle_rad.sin_cos();
            vertices_m.extend(corners.map(|(rho, z)| [rho * sin, -rho * cos, z]));
        }
        let around = vertices_m.len() / rows.len();
        let mut triangles = Vec::new();
        for i in 0..rows.len() {
            let next = (i + 1) % rows.len();
            for k in 0..around {
                let index = |row: usize, k: usize| (row * around + k % around) as u32;
                let (a, b) = (index(i, k), index(i, k + 1));
                let (c, d) = (index(next, k + 1), index(next, k));
                // Rows go along +z in the groove, where the outside is towards the axis.
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        Self {
            vertices_m,
            triangles,
            deviation_m,
        }
    }

    /// Volume that the triangles enclose.
    pub fn volume_m3(&self) -> f64 {
        let six: f64 = (self.triangles.iter())
            .map(|t| {
                let [a, b, c] = t.map(|k| self.vertices_m[k as usize]);
                a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        six / 6.0
    }
}

impl OuterRing {
    /// Radius at the bottom of the groove at its deepest.
    pub fn deepest_radius_m(&self) -> f64 {
        let middles = self.sectors();
        let radii =
            (middles.iter()).map(|s| self.meridian_in(s, s.middle_rad()).deepest_radius_m());
        radii.fold(0.0, f64::max)
    }
}

/// Points of the groove in one meridian plane, from shoulder to shoulder along +z.
struct Row {
    angle_rad: f64,
    points: Vec<Vec3>,
}

impl Row {
    fn new(meridian: Meridian, steps: usize) -> Self {
        let mut etas = row_rad(&meridian, steps);
        // The two points of the ridge are one.
        etas.remove(steps);
        let ridge = meridian.arcs[0].ridge_height_m();
        let points = (etas.iter().enumerate())
            .map(|(k, &eta)| {
                let [x, y, z] = meridian.point(eta).position_m;
                [x, y, if k == steps { ridge } else { z }]
            })
            .collect();
        Self {
            angle_rad: meridian.angle_rad,
            points,
        }
    }
}

/// Largest distance of the quadrilaterals between rows from the surface.
fn worst_m(rows: &[Row], meridian: impl Fn(f64) -> Meridian) -> f64 {
    let mut worst = 0.0f64;
    for pair in rows.windows(2) {
        let middle = (pair[0].angle_rad + pair[1].angle_rad) / 2.0;
        let mut measure = |points: &[Vec3]| {
            let mean = |c: usize| points.iter().map(|p| p[c]).sum::<f64>() / points.len() as f64;
            let [x, y, z] = [0, 1, 2].map(mean);
            // The angle from the middle of the pair, so that it does not wrap around.
            let (sin, cos) = middle.sin_cos();
            let off = (x * cos + y * sin).atan2(x * sin - y * cos);
            let distance = meridian(middle + off).distance_m(x.hypot(y), z);
            worst = worst.max(distance.abs());
        };
        for k in 0..pair[0].points.len() - 1 {
            let (a, b) = (pair[0].points[k], pair[0].points[k + 1]);
            let (c, d) = (pair[1].points[k + 1], pair[1].points[k]);
            for points in [&[a, b][..], &[a, c], &[a, d], &[a, b, c], &[a, c, d]] {
                measure(points);
            }
        }
    }
    worst
}
