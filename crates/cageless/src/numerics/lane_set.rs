//! Some lanes of a block.

use super::lanes::{BATCH_WIDTH, LANES};

/// Some lanes of a block, a bit each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LaneSet(u32);

impl LaneSet {
    pub(crate) const NONE: Self = Self(0);
    pub(crate) const ALL: Self = Self(u32::MAX);

    /// Lanes that pass a test.
    #[inline(always)]
    pub(crate) fn of(test: impl Fn(usize) -> bool) -> Self {
        // In a loop of its own, or the test does not become vector code.
        let mut bits = [0; LANES];
        for lane in 0..LANES {
            bits[lane] = u32::from(test(lane)) << lane;
        }
        Self(bits.iter().fold(0, |all, bit| all | bit))
    }

    /// Lanes of the bearing of this index, alone or one of [`BATCH_WIDTH`], among the first `entries`.
    #[inline]
    pub(crate) fn of_bearing(self, bearing: usize, alone: bool, entries: usize) -> Self {
        const EVERY: u32 = u32::MAX / ((1 << BATCH_WIDTH) - 1);
        let own = if alone { u32::MAX } else { EVERY << bearing };
        Self(self.0 & own & ((1 << entries.min(LANES)) - 1))
    }

    /// These and others.
    #[inline(always)]
    pub(crate) fn or(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether a lane is one of them.
    #[inline(always)]
    pub(crate) fn has(self, lane: usize) -> bool {
        self.0 >> lane & 1 == 1
    }
}

impl Iterator for LaneSet {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    }
}
