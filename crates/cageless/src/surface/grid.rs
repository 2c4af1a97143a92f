//! Points of the groove in rows: one row per ψ, from shoulder to shoulder.

use std::f64::consts::PI;

use super::{Arc, Meridian, OuterRing};
use crate::numerics::angle::wrap_angle_rad;

/// Rows of the groove all round.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Section of each row, ascending in ψ from −π.
    pub meridians: Vec<Meridian>,
    /// Steps from the ridge to a shoulder; a row has 2·(steps + 1) points, two of them at
    /// the ridge, with the normals of either half.
    pub steps: usize,
}

impl Grid {
    /// Lays rows no further apart than `spacing_m` at the bottom of the groove, and points
    /// in them no further apart along the arc. The ends of raceways and blends are rows.
    pub fn new(ring: &OuterRing, spacing_m: f64) -> Self {
        let step = spacing_m / ring.groove_bottom_radius_m();
        let sectors = ring.sectors();
        let mut meridians: Vec<Meridian> = sectors
            .iter()
            .flat_map(|sector| {
                let (start, length) = (sector.start_rad, sector.end_rad - sector.start_rad);
                let count = (length / step).ceil().max(1.0);
                (0..count as usize)
                    .map(move |k| ring.meridian_in(sector, start + length * k as f64 / count))
            })
            .map(|m| Meridian {
                angle_rad: wrap_angle_rad(m.angle_rad),
                ..m
            })
            .collect();
        meridians.sort_by(|a, b| a.angle_rad.total_cmp(&b.angle_rad));
        let steps = (widest_arc_rad(ring) * ring.curvature_radius_m() / spacing_m).ceil();
        Self {
            meridians,
            steps: steps.max(1.0) as usize,
        }
    }

    /// η of the points of a row from the lower shoulder to the upper one, from the outward radius
    /// towards +z.
    pub fn row_rad(&self, meridian: &Meridian) -> Vec<f64> {
        row_rad(meridian, self.steps)
    }

    /// Largest distance of neighbouring rows at the bottom of the groove.
    pub fn row_distance_m(&self, ring: &OuterRing) -> f64 {
        let angles = self.meridians.iter().map(|m| m.angle_rad);
        let next = angles
            .clone()
            .skip(1)
            .chain(angles.clone().take(1).map(|a| a + 2.0 * PI));
        let widest = angles.zip(next).map(|(a, b)| b - a).fold(0.0, f64::max);
        widest * ring.groove_bottom_radius_m()
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
