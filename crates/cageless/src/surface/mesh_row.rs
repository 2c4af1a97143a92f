//! Points of the ring's inside in one row of a mesh, from shoulder to shoulder.

use super::grid::row_rad;
use super::recess::Edge;
use super::stretch::Stretch;
use super::{Meridian, Side};
use crate::numerics::bspline::Vec3;

/// A row, and the order of its points towards the rows before and after it. Both are the same but at the
/// tip of a slot, where its two edges are one line: towards the slot that is passed twice.
pub(super) struct Row {
    /// ψ of its ends.
    pub angle_rad: f64,
    pub points: Vec<Vec3>,
    pub before: Vec<usize>,
    pub after: Vec<usize>,
}

/// How many parts a row has.
#[derive(Clone, Copy)]
pub(super) struct Steps {
    /// From the bottom of the groove, or from a slot, to a shoulder.
    pub groove: usize,
    /// Across the rounded edge of a slot.
    pub edge: usize,
}

impl Row {
    /// Row of a stretch at a place.
    pub(super) fn new(stretch: Stretch<'_>, at: f64, steps: Steps) -> Self {
        let (ring, recess) = match stretch {
            Stretch::Groove(ring, sector) => {
                return Self::groove(ring.meridian_in(sector, at), steps.groove);
            }
            Stretch::End(ring, recess, _) | Stretch::Straight(ring, recess) => (ring, recess),
        };
        let edges = stretch.edges(recess, at);
        let section = ring.plain_meridian(edges[0].angle_rad);
        match stretch {
            Stretch::End(_, _, end) if at == 0.0 => Self::tip(section, &edges[0], end, steps),
            _ => Self::across(section, &edges, steps),
        }
    }

    fn alike(angle_rad: f64, points: Vec<Vec3>) -> Self {
        let order: Vec<usize> = (0..points.len()).collect();
        Self {
            angle_rad,
            points,
            before: order.clone(),
            after: order,
        }
    }

    fn groove(meridian: Meridian, steps: usize) -> Self {
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
        Self::alike(meridian.angle_rad, points)
    }

    /// Through a slot, past its lower edge and its upper one.
    fn across(section: Meridian, edges: &[Edge; 2], steps: Steps) -> Self {
        let [mut points, mut upper] = [Side::Lower, Side::Upper].map(|side| {
            let edge = &edges[usize::from(side == Side::Upper)];
            let mut points = up_to(&section, side, edge, steps.groove);
            points.extend(down_from(edge, steps.edge));
            points
        });
        upper.reverse();
        points.extend(upper);
        Self::alike(section.angle_rad, points)
    }

    /// At the tip of the end of a slot: the row of the groove, and what lies below it.
    fn tip(section: Meridian, edge: &Edge, end: f64, steps: Steps) -> Self {
        let mut row = Self::groove(section, steps.groove);
        let groove = row.points.len();
        row.points.extend(down_from(edge, steps.edge));
        let (middle, all) = (steps.groove, row.points.len());
        let down = (0..=middle).chain(groove..all);
        let up = (groove..all).rev().chain(middle..groove);
        let folded: Vec<usize> = down.chain(up).collect();
        if end > 0.0 {
            row.before = folded;
        } else {
            row.after = folded;
        }
        row
    }
}

/// Points of the plain groove from a shoulder to an edge.
fn up_to(section: &Meridian, side: Side, edge: &Edge, steps: usize) -> Vec<Vec3> {
    let arc = section.arc(side);
    let (shoulder, end) = (arc.shoulder_rad(), side.sign() * edge.groove_rad);
    let eta = |k: usize| shoulder + (end - shoulder) * k as f64 / steps as f64;
    let point = |k: usize| arc.point(section.angle_rad, eta(k)).position_m;
    (0..steps).map(point).chain([edge.arc_m(0.0)]).collect()
}

/// Points of an edge below the groove, and the foot of its wall.
fn down_from(edge: &Edge, steps: usize) -> impl Iterator<Item = Vec3> {
    let arc = (1..=steps).map(move |k| edge.arc_m(k as f64 / steps as f64));
    arc.chain([edge.wall_m(1.0)])
}

/// Distance from the surface of a point between the places `at` of a stretch and the points k and k + 1 of
/// its rows.
pub(super) fn off_m(
    stretch: Stretch<'_>,
    [x, y, z]: Vec3,
    at: [f64; 2],
    k: usize,
    steps: Steps,
) -> f64 {
    let middle = (at[0] + at[1]) / 2.0;
    let (ring, recess) = match stretch {
        Stretch::Groove(ring, sector) => {
            // The angle from the middle of the pair, so that it does not wrap around.
            let (sin, cos) = middle.sin_cos();
            let off = (x * cos + y * sin).atan2(x * sin - y * cos);
            let meridian = ring.meridian_in(sector, middle + off);
            return meridian.distance_m(x.hypot(y), z);
        }
        Stretch::End(ring, recess, _) | Stretch::Straight(ring, recess) => (ring, recess),
    };
    // From the near shoulder.
    let last = 2 * (steps.groove + steps.edge) + 2;
    let (side, k) = if k <= last / 2 {
        (-1.0, k)
    } else {
        (1.0, last - k)
    };
    let (point, near) = ([x, y, z], stretch.place(side, middle));
    if k < steps.groove {
        ring.plain_meridian(0.0).distance_m(x.hypot(y), z)
    } else if k < steps.groove + steps.edge {
        recess.below_edge_m(point, near)
    } else if k == steps.groove + steps.edge {
        recess.below_wall_m(point, near)
    } else {
        recess.below_floor_m(point)
    }
}
