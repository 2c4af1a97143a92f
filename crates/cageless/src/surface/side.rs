//! The two sides of a section.

/// Side of the ridge between the flanks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Towards +z.
    Upper,
    /// Towards −z.
    Lower,
}

impl Side {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::Upper, Self::Lower];

    /// 1 or −1, the sign of z towards the shoulder.
    pub fn sign(self) -> f64 {
        match self {
            Self::Upper => 1.0,
            Self::Lower => -1.0,
        }
    }
}
