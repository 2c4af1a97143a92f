//! Sums over the balls of a bearing, the same bits whether it runs alone or beside others.

use crate::numerics::lanes::Lanes;
use crate::numerics::lanes::{BATCH_WIDTH, LANES};

/// A quantity that is summed over the balls: the force on the inner ring and the powers of the
/// energy ledger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sum {
    RingX,
    RingY,
    Drive,
    Weight,
    InnerFriction,
    OuterFriction,
    RacewayDamping,
    BallFriction,
    BallDamping,
    /// Power of the centrifugal force; this and the next three belong to the published equations.
    Centrifugal,
    FrictionDirection,
    RelativeSpin,
    BallRelativeSpin,
    /// Force on the outer ring; under a rotor only, as is the next.
    OuterX,
    OuterY,
    /// Torque of friction on the inner ring.
    RingTorque,
    /// Loss of the rolling force of films; with a film only, as is the next.
    RollingResistance,
    /// Power of the drive against it.
    RollingDrive,
}

impl Sum {
    pub(super) const COUNT: usize = 18;
    pub(super) const NORMAL: [Self; 4] =
        [Self::RingX, Self::RingY, Self::Weight, Self::RacewayDamping];
    pub(super) const FRICTION: [Self; 3] = [Self::Drive, Self::InnerFriction, Self::OuterFriction];
    pub(super) const RACEWAY_FRICTION: [Self; 5] = [
        Self::RingX,
        Self::RingY,
        Self::Drive,
        Self::InnerFriction,
        Self::OuterFriction,
    ];
    pub(super) const PUBLISHED: [Self; 3] = [
        Self::Centrifugal,
        Self::FrictionDirection,
        Self::RelativeSpin,
    ];
    pub(super) const ROLLING: [Self; 2] = [Self::RollingResistance, Self::RollingDrive];
    pub(super) const OUTER_RING: [Self; 2] = [Self::OuterX, Self::OuterY];
    pub(super) const RING_FRICTION: [Self; 5] = [
        Self::RingX,
        Self::RingY,
        Self::RingTorque,
        Self::OuterX,
        Self::OuterY,
    ];
    pub(super) const HEAT: [Self; 2] = [Self::InnerFriction, Self::OuterFriction];
    pub(super) const BALL_CONTACTS: [Self; 2] = [Self::BallFriction, Self::BallDamping];
}

/// Number of partial sums: ball k adds to number k mod 4 and the four are added in one order,
/// whether the lanes of a block are balls or bearings.
const PARTS: usize = 4;

/// Addends of the balls of one block to each sum.
pub(super) type Addends = [Lanes; Sum::COUNT];

/// Sums over the balls of one bearing, or of each of the bearings side by side.
#[derive(Clone)]
pub(super) struct Sums {
    /// Sums of the only bearing.
    alone: [[f64; PARTS]; Sum::COUNT],
    batch: [[[f64; BATCH_WIDTH]; Sum::COUNT]; PARTS],
}

impl Sums {
    pub(super) const ZERO: Self = Self {
        alone: [[0.0; PARTS]; Sum::COUNT],
        batch: [[[0.0; BATCH_WIDTH]; Sum::COUNT]; PARTS],
    };

    #[inline(always)]
    pub(super) fn clear(&mut self, alone: bool) {
        if alone {
            self.alone = [[0.0; PARTS]; Sum::COUNT];
        } else {
            self.batch = [[[0.0; BATCH_WIDTH]; Sum::COUNT]; PARTS];
        }
    }

    /// Adds what the balls of block number `block` contribute to the sums `which`.
    #[inline(always)]
    pub(super) fn add(&mut self, which: &[Sum], addends: &Addends, alone: bool, block: usize) {
        if alone {
            self.add_alone(which, addends);
        } else {
            self.add_batch(which, addends, block);
        }
    }

    #[inline(always)]
    fn add_alone(&mut self, which: &[Sum], addends: &Addends) {
        for &sum in which {
            let (total, addend) = (&mut self.alone[sum as usize], &addends[sum as usize].0);
            for four in addend.chunks_exact(PARTS) {
                for part in 0..PARTS {
                    total[part] += four[part];
                }
            }
        }
    }

    #[inline(always)]
    fn add_batch(&mut self, which: &[Sum], addends: &Addends, block: usize) {
        const BALLS: usize = LANES / BATCH_WIDTH;
        for &sum in which {
            let addend = &addends[sum as usize].0;
            for ball in 0..BALLS {
                let part = (block * BALLS + ball) % PARTS;
                let total = &mut self.batch[part][sum as usize];
                for bearing in 0..BATCH_WIDTH {
                    total[bearing] += addend[ball * BATCH_WIDTH + bearing];
                }
            }
        }
    }

    /// Total of one bearing; the only one has index 0.
    #[inline(always)]
    pub(super) fn total(&self, sum: Sum, alone: bool, bearing: usize) -> f64 {
        let part = |part: usize| {
            if alone {
                self.alone[sum as usize][part]
            } else {
                self.batch[part][sum as usize][bearing]
            }
        };
        (part(0) + part(2)) + (part(1) + part(3))
    }
}
