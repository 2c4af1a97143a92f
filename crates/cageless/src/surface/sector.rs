//! A part of the ring within which its surface is smooth.

/// A part of the ring between two meridian planes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingSector {
    /// ψ of its start.
    pub start_rad: f64,
    /// ψ of its end, above the start; the start of the next sector, give or take a turn.
    pub end_rad: f64,
    /// Index of the discrete raceway that it belongs to; `None` for a plain one, also around a slot.
    pub raceway: Option<usize>,
    /// Index of the slot of [`super::OuterRing::recesses`] that is cut through its middle.
    pub slot: Option<usize>,
    /// Whether it is a blend at an end of that raceway.
    pub blend: bool,
}

impl RingSector {
    /// ψ halfway.
    pub fn middle_rad(&self) -> f64 {
        (self.start_rad + self.end_rad) / 2.0
    }
}
