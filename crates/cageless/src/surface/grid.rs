//! Points of the surface in rows: one row per ψ, from shoulder to shoulder.

use std::f64::consts::PI;

use super::patch::equal_parts;
use super::recess::Edge;
use super::stretch::Stretch;
use super::{Arc, Meridian, OuterRing, Recess, Side, SurfacePoint};
use crate::numerics::angle::wrap_angle_rad;

/// Rows all round.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Ascending in ψ from −π.
    pub rows: Vec<GridRow>,
    /// Steps from the ridge or from a slot to a shoulder.
    pub steps: usize,
    spacing_m: f64,
}

/// One row.
#[derive(Debug, Clone, PartialEq)]
pub struct GridRow {
    /// ψ.
    pub angle_rad: f64,
    section: Meridian,
    slot: Option<(Recess, [Edge; 2])>,
}

/// Kind of a point of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PointKind {
    /// Where a ball that rests in the groove touches.
    Contact,
    /// The groove.
    Surface,
    /// The rounded edge of a slot.
    Edge,
    /// The wall of the slot.
    Wall,
    /// The floor of the slot.
    Floor,
}

/// A point of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridPoint {
    /// Kind of the point.
    pub(crate) kind: PointKind,
    /// Side of the ridge or of the middle of the slot.
    pub side: Side,
    /// η, angle of the normal in the section from the inward radius, towards −z: at the centre of an arc of
    /// the groove from the outward radius towards +z.
    pub meridian_rad: f64,
    /// ψ: that of the row but at rounded ends of slots.
    pub angle_rad: f64,
    /// Place and normal.
    pub point: SurfacePoint,
}

impl GridPoint {
    /// Part of the surface that it lies on, by name: `contact`, `surface`, `edge`, `wall` or `floor`.
    pub fn kind_name(&self) -> &'static str {
        match self.kind {
            PointKind::Contact => "contact",
            PointKind::Surface => "surface",
            PointKind::Edge => "edge",
            PointKind::Wall => "wall",
            PointKind::Floor => "floor",
        }
    }
}

impl Grid {
    /// Lays rows no further apart than `spacing_m` at the bottom of the groove and around the ends of slots,
    /// and points in them no further apart along the row. The ends of raceways, blends and slots are rows.
    pub fn new(ring: &OuterRing, spacing_m: f64) -> Self {
        let bottom_m = ring.groove_bottom_radius_m;
        let sectors = ring.sectors();
        let (mut rows, mut tip) = (vec![], false);
        for (stretch, [start, end]) in sectors.iter().flat_map(|s| Stretch::of(ring, s)) {
            let radius_m = match stretch {
                Stretch::End(_, recess, _) => recess.end_rad() * bottom_m,
                _ => bottom_m,
            };
            let count = ((end - start).abs() * radius_m / spacing_m).ceil().max(1.0) as usize;
            // The last row is the first of the next stretch, unless it is the tip of a slot.
            let first = usize::from(tip);
            tip = stretch.ends_in_tip();
            let places = equal_parts(start, end, count);
            let places = &places[first..count + usize::from(tip)];
            rows.extend(places.iter().map(|&at| GridRow::new(stretch, at)));
        }
        rows.sort_by(|a: &GridRow, b| a.angle_rad.total_cmp(&b.angle_rad));
        let steps = (widest_arc_rad(ring) * ring.curvature_radius_m / spacing_m).ceil();
        Self {
            rows,
            steps: steps.max(1.0) as usize,
            spacing_m,
        }
    }

    /// Points of a row from the lower shoulder to the upper one; at the ridge, in the middle of the floor of a
    /// slot and where its faces meet there are two, with the normals of either side.
    pub fn points(&self, row: &GridRow) -> Vec<GridPoint> {
        let Some((recess, edges)) = &row.slot else {
            let etas = row_rad(&row.section, self.steps).into_iter().enumerate();
            let point = |(k, eta): (usize, f64)| {
                let side = if k <= self.steps {
                    Side::Lower
                } else {
                    Side::Upper
                };
                row.groove(PointKind::Surface, side, side.sign() * eta)
            };
            return etas.map(point).collect();
        };
        let half = |side: Side| {
            let edge = &edges[usize::from(side == Side::Upper)];
            let (shoulder, end) = (
                row.section.arc(side).shoulder_rad(),
                side.sign() * edge.groove_rad,
            );
            let etas = equal_parts(shoulder, end, self.steps);
            let mut points: Vec<GridPoint> = (etas.into_iter())
                .map(|eta| row.groove(PointKind::Surface, side, eta))
                .collect();
            let shares = |length_m: f64| {
                let count = (length_m / self.spacing_m).ceil().max(1.0) as usize;
                equal_parts(0.0, 1.0, count).into_iter()
            };
            let arc = shares(edge.arc_rad * edge.radius_m);
            points.extend(arc.map(|share| {
                GridPoint::new(PointKind::Edge, side, edge.arc_m(share), edge.normal(share))
            }));
            let wall = shares(edge.wall_length_m);
            points.extend(wall.map(|share| {
                GridPoint::new(PointKind::Wall, side, edge.wall_m(share), edge.normal(1.0))
            }));
            points.extend(shares(recess.width_m / 2.0).map(|share| {
                let at = recess.floor_m(edges, share / 2.0, side);
                GridPoint::new(PointKind::Floor, side, at, recess.floor_normal(at))
            }));
            points
        };
        let mut upper = half(Side::Upper);
        upper.reverse();
        let mut points = half(Side::Lower);
        points.extend(upper);
        points
    }

    /// Largest distance of neighbouring rows at the bottom of the groove.
    pub fn row_distance_m(&self, ring: &OuterRing) -> f64 {
        let angles = self.rows.iter().map(|row| row.angle_rad);
        let next = angles
            .clone()
            .skip(1)
            .chain(angles.clone().take(1).map(|a| a + 2.0 * PI));
        let widest = angles.zip(next).map(|(a, b)| b - a).fold(0.0, f64::max);
        widest * ring.groove_bottom_radius_m
    }
}

impl GridRow {
    fn new(stretch: Stretch<'_>, at: f64) -> Self {
        let (section, slot) = match stretch {
            Stretch::Groove(ring, sector) => (ring.meridian_in(sector, at), None),
            Stretch::End(ring, recess, _) | Stretch::Straight(ring, recess) => {
                let edges = stretch.edges(recess, at);
                let section = ring.plain_meridian(edges[0].angle_rad);
                (section, Some((*recess, edges)))
            }
        };
        let angle_rad = wrap_angle_rad(section.angle_rad);
        Self {
            angle_rad,
            section: Meridian {
                angle_rad,
                ..section
            },
            slot,
        }
    }

    /// Whether it goes through a slot.
    pub fn passes_slot(&self) -> bool {
        self.slot.is_some()
    }

    /// Where a ball that rests in the groove touches a side of it, or an edge of the slot.
    pub fn contact(&self, side: Side) -> GridPoint {
        let Some((_, edges)) = &self.slot else {
            let eta = self.section.arc(side).contact_angle_rad;
            return self.groove(PointKind::Contact, side, eta);
        };
        let edge = &edges[usize::from(side == Side::Upper)];
        let share = edge.share_towards(edge.ball);
        GridPoint::new(
            PointKind::Contact,
            side,
            edge.arc_m(share),
            edge.normal(share),
        )
    }

    /// η counts towards the shoulder of the side.
    fn groove(&self, kind: PointKind, side: Side, eta: f64) -> GridPoint {
        GridPoint {
            kind,
            side,
            meridian_rad: side.sign() * eta,
            angle_rad: self.angle_rad,
            point: self.section.arc(side).point(self.angle_rad, eta),
        }
    }
}

impl GridPoint {
    /// ψ and η of a point of a slot.
    fn new(kind: PointKind, side: Side, position_m: [f64; 3], normal: [f64; 3]) -> Self {
        let [x, y, _] = position_m;
        let inwards = -(normal[0] * x + normal[1] * y) / x.hypot(y);
        Self {
            kind,
            side,
            meridian_rad: (-normal[2]).atan2(inwards),
            angle_rad: x.atan2(-y),
            point: SurfacePoint { position_m, normal },
        }
    }
}

/// η of 2·(steps + 1) points from the lower shoulder to the upper one.
pub(super) fn row_rad(meridian: &Meridian, steps: usize) -> Vec<f64> {
    let eta = |arc: &Arc, k: usize| {
        let (valley, shoulder) = (arc.valley_rad(), arc.shoulder_rad());
        arc.side.sign() * (valley + (shoulder - valley) * k as f64 / steps as f64)
    };
    let [upper, lower] = &meridian.arcs;
    let below = (0..=steps).rev().map(|k| eta(lower, k));
    below.chain((0..=steps).map(|k| eta(upper, k))).collect()
}

/// Longest arc from the ridge to a shoulder.
pub(super) fn widest_arc_rad(ring: &OuterRing) -> f64 {
    let middles = ring.sectors();
    let arcs = middles.iter().flat_map(|s| {
        let ends = [s.start_rad, s.middle_rad()];
        ends.map(|psi| ring.meridian_in(s, psi).arcs)
    });
    let lengths = arcs
        .flatten()
        .map(|arc| arc.shoulder_rad() - arc.valley_rad());
    lengths.fold(0.0, f64::max)
}
