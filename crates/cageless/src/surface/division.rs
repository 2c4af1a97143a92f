//! Division of the ring into sectors within which its surface is smooth: plain ones, discrete raceways and
//! their blends, and plain ones around slots.

use std::f64::consts::{PI, TAU};

use super::OuterRing;
use super::sector::RingSector;
use crate::numerics::angle::wrap_angle_rad;

/// Raceways closer than this touch: it is rounding of their angles.
const TOUCHING_RAD: f64 = 1e-9;

impl OuterRing {
    /// The sectors in the order of ψ, all round, none of more than 180°.
    pub fn sectors(&self) -> Vec<RingSector> {
        let raceways = (0..self.raceways.len()).filter(|&k| self.raceways[k].slot().is_none());
        let slots = (0..self.recesses.len()).map(|k| vec![self.around_slot(k)]);
        let mut zones: Vec<_> = raceways.map(|k| self.parts(k)).chain(slots).collect();
        zones.sort_by(|a, b| a[0].start_rad.total_cmp(&b[0].start_rad));
        let Some(first) = zones.first().map(|zone| zone[0].start_rad) else {
            return plain(-PI, PI);
        };
        let starts = zones[1..].iter().map(|zone| zone[0].start_rad);
        let next: Vec<f64> = starts.chain([first + TAU]).collect();
        zones
            .into_iter()
            .zip(next)
            .flat_map(|(mut sectors, next)| {
                let end = sectors[sectors.len() - 1].end_rad;
                if next - end > TOUCHING_RAD {
                    sectors.extend(plain(end, next));
                }
                sectors
            })
            .collect()
    }

    /// The plain groove around a slot, up to half the way to the next raceway.
    fn around_slot(&self, index: usize) -> RingSector {
        let recess = &self.recesses[index];
        let (half, middle) = (recess.half_angle_rad, wrap_angle_rad(recess.middle_rad));
        let others = self.others(recess).map(|other| {
            let apart = wrap_angle_rad(other.dimensions().centre_angle_rad - middle).abs();
            apart - half - other.half_angle_rad()
        });
        let room = others.fold(PI - 2.0 * half, f64::min) / 2.0;
        let reach = half + room.min(recess.end_rad());
        RingSector {
            start_rad: middle - reach,
            end_rad: middle + reach,
            raceway: None,
            slot: Some(index),
            blend: false,
        }
    }

    /// A discrete raceway: its middle, and on both sides what is smooth from there to the end.
    fn parts(&self, index: usize) -> Vec<RingSector> {
        let raceway = &self.raceways[index];
        let d = raceway.dimensions();
        let middle = wrap_angle_rad(d.centre_angle_rad);
        let pieces = raceway.pieces().iter();
        let right: Vec<f64> = pieces.map(|piece| piece.range_rad().end).collect();
        let left = right.iter().rev().map(|end| -end);
        let ends: Vec<f64> = left.chain(right.iter().copied()).collect();
        let (parts, blended) = (ends.len() - 1, raceway.blend_start_rad().is_some());
        (0..parts)
            .map(|k| RingSector {
                start_rad: middle + ends[k],
                end_rad: middle + ends[k + 1],
                raceway: Some(index),
                slot: None,
                blend: blended && (k == 0 || k == parts - 1),
            })
            .collect()
    }
}

/// A plain stretch in equal parts of at most 180°.
fn plain(start_rad: f64, end_rad: f64) -> Vec<RingSector> {
    let count = ((end_rad - start_rad) / PI - 1e-12).ceil().max(1.0);
    let angle = |k: f64| start_rad + (end_rad - start_rad) * k / count;
    (0..count as usize)
        .map(|k| RingSector {
            start_rad: angle(k as f64),
            end_rad: angle(k as f64 + 1.0),
            raceway: None,
            slot: None,
            blend: false,
        })
        .collect()
}
