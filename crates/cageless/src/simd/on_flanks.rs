//! Which balls of a block are on elastic flanks.

use crate::numerics::lanes::LANES;

/// The lanes of a block whose balls are on flanks, a bit each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct OnFlanks(u32);

impl OnFlanks {
    pub const NONE: Self = Self(0);

    /// Those that are inside.
    #[inline(always)]
    pub fn of(inside: &[bool; LANES]) -> Self {
        let mut bits = 0;
        for lane in 0..LANES {
            bits |= u32::from(inside[lane]) << lane;
        }
        Self(bits)
    }

    /// Adds others.
    #[inline(always)]
    pub fn add(&mut self, others: Self) {
        self.0 |= others.0;
    }

    /// Whether a lane is one of them.
    #[inline(always)]
    pub fn has(self, lane: usize) -> bool {
        self.0 >> lane & 1 == 1
    }
}

impl Iterator for OnFlanks {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    }
}
