//! Rows of the tables of bodies.

use crate::dynamics::coordinates::{Coordinate, Kind};

/// Freedoms of a bearing beyond those of an inner ring in its plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Freedoms {
    /// Motion in space.
    pub in_space: bool,
    /// A rotor, an inner ring whose speed is a state, and an outer ring on a support.
    pub under_rotor: bool,
}

/// Cases in which a coordinate of a body moves; in others it is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Freedom {
    /// In every case.
    Always,
    /// In space.
    InSpace,
    /// Under a rotor.
    UnderRotor,
    /// Under a rotor in space.
    UnderRotorInSpace,
}

impl Freedom {
    /// Whether it moves in a bearing with these freedoms.
    pub(crate) const fn moves(self, bearing: Freedoms) -> bool {
        match self {
            Self::Always => true,
            Self::InSpace => bearing.in_space,
            Self::UnderRotor => bearing.under_rotor,
            Self::UnderRotorInSpace => bearing.in_space && bearing.under_rotor,
        }
    }
}

/// Row of the table of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BodyRow {
    /// The coordinate; a velocity names the index of its position in the same table.
    pub coordinate: Coordinate,
    /// Cases in which it moves.
    pub(crate) freedom: Freedom,
}

impl BodyRow {
    /// Whether the coordinate moves in a bearing with these freedoms.
    pub(crate) fn moves(&self, bearing: Freedoms) -> bool {
        self.freedom.moves(bearing)
    }
}

/// A position, or a velocity of the position with an index, by its name, unit and scale of errors.
pub(crate) const fn row(
    freedom: Freedom,
    name: &'static str,
    unit: &'static str,
    error_scale: f64,
    kind: Kind,
) -> BodyRow {
    let coordinate = Coordinate {
        name,
        unit,
        error_scale,
        kind,
    };
    BodyRow {
        coordinate,
        freedom,
    }
}
