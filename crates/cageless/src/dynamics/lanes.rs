//! Blocks of numbers in which the right-hand side works: neighbouring balls of one bearing, or
//! two balls of several bearings.

use crate::state::{LANES, MEMBERS};

/// One quantity of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub(super) struct Block(pub [f64; LANES]);

impl Block {
    pub const ZERO: Self = Self([0.0; LANES]);

    pub fn all(value: f64) -> Self {
        Self([value; LANES])
    }
}

/// What one evaluation leaves behind of a block. Fields of one struct, so that the compiler
/// knows that they do not overlap.
#[derive(Clone)]
pub(super) struct Entry {
    /// Unit vector from the centre of the bearing to the ball.
    pub ex: Block,
    pub ey: Block,
    /// Tangential velocity over distance from the centre.
    pub orbit: Block,
    /// Spin, absolute.
    pub absolute: Block,
    /// r.
    pub radius: Block,
    /// `paper` profile: direction of friction at the outer raceway.
    pub dir_x: Block,
    pub dir_y: Block,
    /// `paper` profile: 1 within a discrete raceway.
    pub inside: Block,
    pub outer_deflection: Block,
    pub outer_force: Block,
    pub outer_slip: Block,
    pub outer_friction: Block,
    /// Part of the outer force along ψ, where the seat of a ball rises.
    pub uphill: Block,
    pub inner_deflection: Block,
    pub inner_force: Block,
    pub inner_slip: Block,
    /// Deflection, its rate and force of the contact with the ball ahead.
    pub pair_deflection: Block,
    pub pair_rate: Block,
    pub pair_force: Block,
    /// Sums over the contacts of the ball.
    pub fx: Block,
    pub fy: Block,
    pub torque: Block,
}

impl Entry {
    pub const ZERO: Self = Self {
        ex: Block::ZERO,
        ey: Block::ZERO,
        orbit: Block::ZERO,
        absolute: Block::ZERO,
        radius: Block::ZERO,
        dir_x: Block::ZERO,
        dir_y: Block::ZERO,
        inside: Block::ZERO,
        outer_deflection: Block::ZERO,
        outer_force: Block::ZERO,
        outer_slip: Block::ZERO,
        outer_friction: Block::ZERO,
        uphill: Block::ZERO,
        inner_deflection: Block::ZERO,
        inner_force: Block::ZERO,
        inner_slip: Block::ZERO,
        pair_deflection: Block::ZERO,
        pair_rate: Block::ZERO,
        pair_force: Block::ZERO,
        fx: Block::ZERO,
        fy: Block::ZERO,
        torque: Block::ZERO,
    };
}

/// What is needed only while one block is computed.
pub(super) struct Scratch {
    pub rho: Block,
    pub vt: Block,
    /// dδo/dt.
    pub approach: Block,
    /// Ro − Rw, or where a ball of another radius sits.
    pub touching: Block,
    /// d(touching)/dψ; 0 for nominal balls.
    pub incline: Block,
    /// sin²ψ from the middle of a raceway, mapped.
    pub u: Block,
    pub sine: Block,
    pub cosine: Block,
    /// Values of polynomials.
    pub p: Block,
    pub q: Block,
    pub slope: Block,
}

impl Scratch {
    pub const ZERO: Self = Self {
        rho: Block::ZERO,
        vt: Block::ZERO,
        approach: Block::ZERO,
        touching: Block::ZERO,
        incline: Block::ZERO,
        u: Block::ZERO,
        sine: Block::ZERO,
        cosine: Block::ZERO,
        p: Block::ZERO,
        q: Block::ZERO,
        slope: Block::ZERO,
    };
}

/// What is summed over the balls: the force on the inner ring and the powers of the energy
/// ledger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sum {
    RingX,
    RingY,
    Drive,
    Weight,
    InnerLoss,
    OuterLoss,
    DampingLoss,
    /// Of contacts between balls.
    BallLoss,
    PairDamping,
    /// In the `paper` profile.
    Centrifugal,
    Direction,
    Frame,
    PairFrame,
}

impl Sum {
    pub const COUNT: usize = 13;
    pub const ALWAYS: [Self; 7] = [
        Self::RingX,
        Self::RingY,
        Self::Drive,
        Self::Weight,
        Self::InnerLoss,
        Self::OuterLoss,
        Self::DampingLoss,
    ];
    pub const PAPER: [Self; 3] = [Self::Centrifugal, Self::Direction, Self::Frame];
    pub const TOUCHING: [Self; 2] = [Self::BallLoss, Self::PairDamping];
}

/// Partial sums: ball k adds to number k mod 4 and the four are added in one order, whether
/// the lanes of a block are balls or bearings. A bearing has the same bits alone and beside
/// others.
const PARTS: usize = 4;

/// Shares of a block in the sums.
pub(super) type Shares = [Block; Sum::COUNT];

/// Sums over the balls of one bearing, or of each of the bearings side by side.
#[derive(Clone)]
pub(super) struct Sums {
    /// Of the only bearing.
    alone: [[f64; PARTS]; Sum::COUNT],
    beside: [[[f64; MEMBERS]; Sum::COUNT]; PARTS],
}

impl Sums {
    pub const ZERO: Self = Self {
        alone: [[0.0; PARTS]; Sum::COUNT],
        beside: [[[0.0; MEMBERS]; Sum::COUNT]; PARTS],
    };

    #[inline(always)]
    pub fn clear(&mut self, alone: bool) {
        if alone {
            self.alone = Self::ZERO.alone;
        } else {
            self.beside = Self::ZERO.beside;
        }
    }

    /// Adds the shares of the balls of one block of the only bearing.
    #[inline(always)]
    pub fn add_alone(&mut self, sums: &[Sum], shares: &Shares) {
        for &sum in sums {
            let (total, share) = (&mut self.alone[sum as usize], &shares[sum as usize].0);
            for four in share.chunks_exact(PARTS) {
                for part in 0..PARTS {
                    total[part] += four[part];
                }
            }
        }
    }

    /// Adds the shares of a block of the bearings side by side.
    #[inline(always)]
    pub fn add_beside(&mut self, sums: &[Sum], shares: &Shares, block: usize) {
        const BALLS: usize = LANES / MEMBERS;
        for &sum in sums {
            let share = &shares[sum as usize].0;
            for ball in 0..BALLS {
                let part = (block * BALLS + ball) % PARTS;
                let total = &mut self.beside[part][sum as usize];
                for member in 0..MEMBERS {
                    total[member] += share[ball * MEMBERS + member];
                }
            }
        }
    }

    /// Total of the only bearing.
    #[inline(always)]
    pub fn alone(&self, sum: Sum) -> f64 {
        let p = &self.alone[sum as usize];
        (p[0] + p[2]) + (p[1] + p[3])
    }

    /// Total of one of the bearings side by side.
    #[inline(always)]
    pub fn beside(&self, sum: Sum, member: usize) -> f64 {
        let p = |part: usize| self.beside[part][sum as usize][member];
        (p(0) + p(2)) + (p(1) + p(3))
    }
}
