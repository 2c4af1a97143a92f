//! Parts of the ring along which its sections are alike.

use std::f64::consts::FRAC_PI_2;

use super::recess::{Edge, EdgePlace};
use super::{OuterRing, Recess, RingSector};

/// A part of the ring whose sections are alike.
#[derive(Clone, Copy)]
pub(super) enum Stretch<'a> {
    /// Groove, over ψ.
    Groove(&'a OuterRing, &'a RingSector),
    /// End of a slot, 1 or −1 along ψ, over |χ|.
    End(&'a OuterRing, &'a Recess, f64),
    /// Straight edges of a slot, over ψ from its middle.
    Straight(&'a OuterRing, &'a Recess),
}

impl<'a> Stretch<'a> {
    /// Stretches of a sector in the order of ψ, each with the range of its parameter.
    pub(super) fn of(ring: &'a OuterRing, sector: &'a RingSector) -> Vec<(Self, [f64; 2])> {
        let groove = Self::Groove(ring, sector);
        let Some(recess) = sector.slot.map(|k| &ring.recesses[k]) else {
            return vec![(groove, [sector.start_rad, sector.end_rad])];
        };
        let tips = [-1.0, 1.0].map(|end| sector.middle_rad() + end * recess.half_angle_rad);
        let straight = recess.straight_rad;
        let straight = straight.map(|half| (Self::Straight(ring, recess), [-half, half]));
        let first = [
            (groove, [sector.start_rad, tips[0]]),
            (Self::End(ring, recess, -1.0), [0.0, FRAC_PI_2]),
        ];
        let last = [
            (Self::End(ring, recess, 1.0), [FRAC_PI_2, 0.0]),
            (groove, [tips[1], sector.end_rad]),
        ];
        first.into_iter().chain(straight).chain(last).collect()
    }

    /// Whether its last row is the tip of a slot.
    pub(super) fn ends_in_tip(self) -> bool {
        matches!(self, Self::End(_, _, end) if end > 0.0)
    }

    /// Place of the edge of a slot on a side, 1 or −1.
    pub(super) fn place(self, side: f64, at: f64) -> EdgePlace {
        match self {
            Self::End(_, _, end) => EdgePlace::End(end, side * at),
            _ => EdgePlace::Straight(side, at),
        }
    }

    /// Both edges of a slot, lower and upper.
    pub(super) fn edges(self, recess: &Recess, at: f64) -> [Edge; 2] {
        [-1.0, 1.0].map(|side| recess.edge(self.place(side, at)))
    }
}
