//! Views of the state vector in lanes: the balls of a block, and the centres of the rings.

use crate::ball::{BallMotion, Centre};
use crate::dynamics::coordinates::{BallCoordinate, OuterRingCoordinate, RingCoordinate};
use crate::dynamics::layout::Layout;
use crate::numerics::lanes::Lanes;
use crate::numerics::lanes::{BATCH_WIDTH, LANES};

/// A block of neighbouring entries of a vector.
#[inline(always)]
pub(crate) fn block_at(values: &[f64], at: usize) -> &[f64; LANES] {
    values[at..]
        .first_chunk()
        .expect("arrays are padded to whole blocks")
}

#[inline(always)]
pub(crate) fn block_mut(values: &mut [f64], at: usize) -> &mut [f64; LANES] {
    values[at..]
        .first_chunk_mut()
        .expect("arrays are padded to whole blocks")
}

/// The balls of one block in the state vector.
#[derive(Clone, Copy)]
pub(crate) struct Motions<'a>([&'a [f64; LANES]; BallCoordinate::ALL.len()]);

impl<'a> Motions<'a> {
    #[inline(always)]
    pub(crate) fn new(layout: Layout, y: &'a [f64], block: usize) -> Self {
        // Not by `map`, which is not inlined into code for wider vectors.
        let mut arrays = [block_at(y, 0); BallCoordinate::ALL.len()];
        for (array, c) in arrays.iter_mut().zip(BallCoordinate::ALL) {
            *array = block_at(y, layout.array(c) + block * LANES);
        }
        Self(arrays)
    }

    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> BallMotion {
        let [x, y, vx, vy, spin] = self.0;
        BallMotion {
            x: x[lane],
            y: y[lane],
            vx: vx[lane],
            vy: vy[lane],
            spin: spin[lane],
        }
    }
}

/// Motion of the balls of a block and of a ring.
#[derive(Clone, Copy)]
pub(super) struct Moving<'a> {
    pub balls: Motions<'a>,
    pub ring: &'a CentreLanes,
}

/// A value of the bearing of each lane; that of the first stands at `start`.
#[inline(always)]
fn of_bearings(layout: Layout, y: &[f64], start: usize) -> Lanes {
    if layout.width() == 1 {
        return Lanes::all(y[start]);
    }
    let of = &y[start..][..BATCH_WIDTH];
    let mut lanes = Lanes::ZERO;
    for lane in 0..LANES {
        lanes.0[lane] = of[lane % BATCH_WIDTH];
    }
    lanes
}

/// Speed of the inner ring of each lane under a rotor, rad/s.
#[inline(always)]
pub(super) fn ring_speeds(layout: Layout, y: &[f64]) -> Lanes {
    let first = layout.of_bearing(0).ring(RingCoordinate::Speed);
    of_bearings(layout, y, first)
}

/// Centre of a ring of each lane.
#[derive(Clone)]
pub(super) struct CentreLanes([Lanes; RingCoordinate::ALL.len()]);

impl CentreLanes {
    pub(super) const ZERO: Self = Self([Lanes::ZERO; RingCoordinate::ALL.len()]);

    /// The inner ring.
    #[inline(always)]
    pub(super) fn inner_ring(layout: Layout, y: &[f64]) -> Self {
        let layout = layout.of_bearing(0);
        Self::new(layout, y, RingCoordinate::ALL.map(|c| layout.ring(c)))
    }

    /// The outer ring, where it moves.
    #[inline(always)]
    pub(super) fn outer_ring(layout: Layout, y: &[f64]) -> Self {
        let layout = layout.of_bearing(0);
        Self::new(layout, y, OuterRingCoordinate::ALL.map(|c| layout.body(c)))
    }

    /// The centre whose coordinates of the first bearing stand at `places`.
    #[inline(always)]
    fn new(layout: Layout, y: &[f64], places: [usize; 4]) -> Self {
        let mut lanes = [Lanes::ZERO; RingCoordinate::ALL.len()];
        for (lanes, start) in lanes.iter_mut().zip(places) {
            *lanes = of_bearings(layout, y, start);
        }
        Self(lanes)
    }

    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> Centre {
        let [x, y, vx, vy] = &self.0;
        Centre {
            x: x.0[lane],
            y: y.0[lane],
            vx: vx.0[lane],
            vy: vy.0[lane],
        }
    }
}
