//! The solid as a closed mesh of triangles.

use std::f64::consts::FRAC_PI_2;

use super::grid::widest_arc_rad;
use super::mesh_row::{Row, Steps, off_m};
use super::patch::equal_parts;
use super::stretch::Stretch;
use super::{OuterRing, Recess};
use crate::error::InputError;
use crate::limits::from_to;
use crate::numerics::bspline::Vec3;
use crate::numerics::vector::{cross, dot};

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
        let wall = ring.dimensions.outer_ring_outer_radius_m - ring.deepest_radius_m();
        let least = CHORD_MIN_M.max(ROUNDINGS * rounding_m);
        let most = CHORD_MAX_M.min(wall / 2.0);
        let why = "ten times the rounding of coordinates or 0.05 µm; half the wall behind the groove \
                   or 100 µm";
        from_to("chord_m", chord_m, least..=most, why)?;
        let mut mesh = Self::within(ring, chord_m - rounding_m);
        mesh.deviation_m += rounding_m;
        Ok(mesh)
    }

    fn within(ring: &OuterRing, chord_m: f64) -> Self {
        let steps_of = |angle_rad: f64, radius_m: f64| {
            let step = (8.0 * ACROSS_FRACTION * chord_m / radius_m).sqrt();
            (angle_rad / step).ceil().max(2.0) as usize
        };
        let edges = ring.recesses.iter().map(|recess| recess.edge_radius_m);
        let steps = Steps {
            groove: steps_of(widest_arc_rad(ring), ring.curvature_radius_m),
            edge: steps_of(FRAC_PI_2, edges.fold(0.0, f64::max)),
        };
        let mut rows = Vec::new();
        let mut deviation_m = 0.0f64;
        let outside = ring.dimensions.outer_ring_outer_radius_m;
        // Sagitta of the cylinder outside: R(1 − cos Δ/2).
        let widest = 2.0 * (1.0 - 0.99 * chord_m / outside).acos();
        let sectors = ring.sectors();
        let mut tip = false;
        for (stretch, [start, end]) in sectors.iter().flat_map(|s| Stretch::of(ring, s)) {
            let length = (end - start).abs();
            let mut count = (length / widest).ceil().max(2.0) as usize;
            loop {
                let places = equal_parts(start, end, count);
                let part: Vec<Row> = places
                    .iter()
                    .map(|&at| Row::new(stretch, at, steps))
                    .collect();
                let off = worst_m(stretch, &places, &part, steps);
                if off <= chord_m {
                    let angles = part.windows(2).map(|p| p[1].angle_rad - p[0].angle_rad);
                    let most = angles.fold(0.0, f64::max);
                    let sagitta = outside * (1.0 - (most / 2.0).cos());
                    deviation_m = deviation_m.max(off).max(sagitta);
                    // The last row is the first of the next stretch, unless it is a tip.
                    let first = usize::from(tip);
                    tip = stretch.ends_in_tip();
                    let kept = count + usize::from(tip) - first;
                    rows.extend(part.into_iter().skip(first).take(kept));
                    break;
                }
                let more = (off / chord_m).sqrt().clamp(1.05, 4.0);
                count = (count as f64 * more).ceil() as usize;
            }
        }
        Self::closed(ring, &rows, deviation_m)
    }

    /// Joins the rows, each continued around the section of the ring.
    fn closed(ring: &OuterRing, rows: &[Row], deviation_m: f64) -> Self {
        let d = ring.dimensions;
        let (outside, half) = (d.outer_ring_outer_radius_m, d.outer_ring_width_m / 2.0);
        let shoulder = ring.shoulder_radius_m;
        let corners = [
            (shoulder, half),
            (outside, half),
            (outside, -half),
            (shoulder, -half),
        ];
        let mut vertices_m = Vec::new();
        let mut starts = Vec::new();
        for row in rows {
            starts.push(vertices_m.len());
            vertices_m.extend_from_slice(&row.points);
            let (sin, cos) = row.angle_rad.sin_cos();
            vertices_m.extend(corners.map(|(rho, z)| [rho * sin, -rho * cos, z]));
        }
        let mut triangles = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            let next = (i + 1) % rows.len();
            let around = |row: usize, order: &[usize]| -> Vec<u32> {
                let corners = rows[row].points.len()..;
                let order = order.iter().copied().chain(corners.take(4));
                order.map(|k| (starts[row] + k) as u32).collect()
            };
            let (here, there) = (around(i, &row.after), around(next, &rows[next].before));
            for k in 0..here.len() {
                let after = (k + 1) % here.len();
                let (a, b, c, d) = (here[k], here[after], there[after], there[k]);
                // Rows go along +z in the groove, where the outside is towards the axis. At a tip the
                // floor is a line.
                triangles.extend(
                    [[a, b, c], [a, c, d]]
                        .iter()
                        .filter(|[a, b, c]| a != b && b != c && c != a),
                );
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
                dot(a, cross(b, c))
            })
            .sum();
        six / 6.0
    }
}

impl OuterRing {
    /// Radius at the bottom of the groove or of a slot at its deepest.
    pub(crate) fn deepest_radius_m(&self) -> f64 {
        let middles = self.sectors();
        let radii =
            (middles.iter()).map(|s| self.meridian_in(s, s.middle_rad()).deepest_radius_m());
        let floors = self.recesses.iter().map(Recess::deepest_radius_m);
        radii.chain(floors).fold(0.0, f64::max)
    }
}

/// Largest distance of the quadrilaterals between rows from the surface.
fn worst_m(stretch: Stretch<'_>, places: &[f64], rows: &[Row], steps: Steps) -> f64 {
    let mut worst = 0.0f64;
    for (pair, at) in rows.windows(2).zip(places.windows(2)) {
        let (after, before) = (&pair[0].after, &pair[1].before);
        for k in 0..after.len() - 1 {
            let [a, b] = [k, k + 1].map(|k| pair[0].points[after[k]]);
            let [c, d] = [k + 1, k].map(|k| pair[1].points[before[k]]);
            for points in [&[a, b][..], &[a, c], &[a, d], &[a, b, c], &[a, c, d]] {
                let mean =
                    |c: usize| points.iter().map(|p| p[c]).sum::<f64>() / points.len() as f64;
                let off = off_m(stretch, [0, 1, 2].map(mean), [at[0], at[1]], k, steps);
                worst = worst.max(off.abs());
            }
        }
    }
    worst
}
