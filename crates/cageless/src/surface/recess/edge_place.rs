//! Places along the edge of a slot.

/// Place along the edge of a slot, which is closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EdgePlace {
    /// On the end that is 1 or −1 along ψ: χ of its half circle, −90° at the lower straight stretch, 0 at
    /// the tip and 90° at the upper one.
    End(f64, f64),
    /// On the straight stretch that is 1 or −1 towards +z: ψ from the middle of the slot.
    Straight(f64, f64),
}

impl EdgePlace {
    /// Another place on its stretch.
    #[must_use]
    pub(crate) fn moved(self, by_rad: f64) -> Self {
        match self {
            Self::End(end, turn) => Self::End(end, turn + by_rad),
            Self::Straight(side, local) => Self::Straight(side, local + by_rad),
        }
    }
}
