//! The ring in sectors that are either a discrete raceway or plain.

use std::f64::consts::{PI, TAU};

use super::{OuterRing, wrapped};

/// A part of the ring between two meridian planes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    /// ψ of its start.
    pub start_rad: f64,
    /// ψ of its end, above the start; the start of the next sector, give or take a turn.
    pub end_rad: f64,
    /// Index of the discrete raceway that it is; `None` for a plain one.
    pub raceway: Option<usize>,
}

/// Raceways closer than this touch: it is rounding of their angles.
const TOUCHING_RAD: f64 = 1e-9;

impl Sector {
    /// ψ halfway.
    pub fn middle_rad(&self) -> f64 {
        (self.start_rad + self.end_rad) / 2.0
    }
}

impl OuterRing {
    /// The sectors in the order of ψ, all round, none of more than 180°.
    pub fn sectors(&self) -> Vec<Sector> {
        let mut zones: Vec<Sector> = (self.zones.iter().enumerate())
            .map(|(k, zone)| {
                let d = zone.raceway().dimensions();
                let middle = wrapped(d.centre_angle_rad);
                Sector {
                    start_rad: middle - d.half_angle_rad,
                    end_rad: middle + d.half_angle_rad,
                    raceway: Some(k),
                }
            })
            .collect();
        zones.sort_by(|a, b| a.start_rad.total_cmp(&b.start_rad));
        let Some(first) = zones.first().copied() else {
            return plain(-PI, PI);
        };
        let starts = zones[1..].iter().map(|z| z.start_rad);
        let next: Vec<f64> = starts.chain([first.start_rad + TAU]).collect();
        zones
            .iter()
            .zip(next)
            .flat_map(|(&zone, next)| {
                let mut sectors = vec![zone];
                if next - zone.end_rad > TOUCHING_RAD {
                    sectors.extend(plain(zone.end_rad, next));
                }
                sectors
            })
            .collect()
    }

    /// ψ between which a sector is smooth, its ends included.
    pub(super) fn smooth_parts(&self, sector: &Sector) -> Vec<f64> {
        let (start, end) = (sector.start_rad, sector.end_rad);
        let blend = sector.raceway.and_then(|k| {
            let zone = &self.zones[k];
            Some(zone.raceway().half_angle_rad() - zone.blend_start_rad()?)
        });
        match blend {
            Some(length) => vec![start, start + length, end - length, end],
            None => vec![start, end],
        }
    }
}

/// A plain stretch in equal parts of at most 180°.
fn plain(start_rad: f64, end_rad: f64) -> Vec<Sector> {
    let count = ((end_rad - start_rad) / PI - 1e-12).ceil().max(1.0);
    let angle = |k: f64| start_rad + (end_rad - start_rad) * k / count;
    (0..count as usize)
        .map(|k| Sector {
            start_rad: angle(k as f64),
            end_rad: angle(k as f64 + 1.0),
            raceway: None,
        })
        .collect()
}
