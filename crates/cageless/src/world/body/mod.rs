//! Bodies beside the balls: one file is one body.
//!
//! ```
//! use cageless::world::body::{BodyKind, RingCoordinate};
//!
//! let row = BodyKind::InnerRing.table()[RingCoordinate::TiltP as usize];
//! assert_eq!(row.coordinate.name, "tilt_p");
//! assert!(!row.freedom.moves(false, true)); // held in the plane
//! ```

pub(crate) mod inner_ring;
pub(crate) mod outer_ring;
pub(crate) mod rotor;
pub(crate) mod sliding_ring;

pub use inner_ring::RingCoordinate;
pub use outer_ring::OuterRingCoordinate;
pub use rotor::{RotorCoordinate, RotorMotion};
pub use sliding_ring::SlidingCoordinate;

use crate::case::Case;
use crate::dynamics::coordinates::{Coordinate, Kind};

/// Cases in which a coordinate of a body moves; in others it is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Freedom {
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
    /// Whether it moves.
    pub const fn moves(self, in_space: bool, under_rotor: bool) -> bool {
        match self {
            Self::Always => true,
            Self::InSpace => in_space,
            Self::UnderRotor => under_rotor,
            Self::UnderRotorInSpace => in_space && under_rotor,
        }
    }
}

/// Row of the table of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyRow {
    /// The coordinate; a velocity names the index of its position in the same table.
    pub coordinate: Coordinate,
    /// Cases in which it moves.
    pub freedom: Freedom,
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

/// Kind of a body of which a bearing has one, in the order of the state vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyKind {
    /// The inner ring.
    InnerRing,
    /// The outer ring on its support.
    OuterRing,
    /// The rotor.
    Rotor,
}

impl BodyKind {
    /// All, in the order of the state vector.
    pub const ALL: [Self; 3] = [Self::InnerRing, Self::OuterRing, Self::Rotor];

    /// Coordinates of the body in space.
    pub const fn table(self) -> &'static [BodyRow] {
        match self {
            Self::InnerRing => &inner_ring::TABLE,
            Self::OuterRing => &outer_ring::TABLE,
            Self::Rotor => &rotor::TABLE,
        }
    }
}

/// A coordinate of one of these bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BodyCoordinate {
    /// The body.
    pub body: BodyKind,
    /// Index in its table.
    pub index: usize,
}

impl From<RingCoordinate> for BodyCoordinate {
    #[inline(always)]
    fn from(coordinate: RingCoordinate) -> Self {
        let (body, index) = (BodyKind::InnerRing, coordinate as usize);
        Self { body, index }
    }
}

impl From<OuterRingCoordinate> for BodyCoordinate {
    #[inline(always)]
    fn from(coordinate: OuterRingCoordinate) -> Self {
        let (body, index) = (BodyKind::OuterRing, coordinate as usize);
        Self { body, index }
    }
}

impl From<RotorCoordinate> for BodyCoordinate {
    #[inline(always)]
    fn from(coordinate: RotorCoordinate) -> Self {
        let (body, index) = (BodyKind::Rotor, coordinate as usize);
        Self { body, index }
    }
}

/// Values of coordinates at the start; those that are left out are 0.
pub(crate) type Start = Vec<(BodyCoordinate, f64)>;

/// Place of the inner ring at rest, from which a run starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RestingRing {
    /// Centre, m.
    pub place_m: [f64; 3],
    /// p and q of its axis.
    pub axis: [f64; 2],
}

/// Coordinates of all bodies of a case at the start.
pub(crate) fn start(case: &Case, ring: &RestingRing) -> Start {
    let bodies = BodyKind::ALL.into_iter().map(|body| match body {
        BodyKind::InnerRing => inner_ring::start(ring),
        // It rests where its weight is carried already.
        BodyKind::OuterRing => vec![],
        BodyKind::Rotor => rotor::start(case, ring),
    });
    bodies.flatten().collect()
}

/// Largest stiffness and damping of the contacts of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactStiffness {
    /// Balls that together carry the inner ring.
    pub carrying: f64,
    /// dF/dδ of a ball at the inner raceway, N/m.
    pub inner_n_m: f64,
    /// dF/dδ of a ball at the outer raceway, N/m.
    pub outer_n_m: f64,
    /// dF/dδ of journal and bore, N/m.
    pub journal_n_m: f64,
    /// Damping of a ball at the inner raceway, N·s/m.
    pub inner_n_s_m: f64,
    /// Damping of a ball at the outer raceway, N·s/m.
    pub outer_n_s_m: f64,
    /// Damping of journal and bore, N·s/m.
    pub journal_n_s_m: f64,
}

/// What a body adds to the fastest rates of a case.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FastestRates {
    /// To ω², 1/s².
    pub square_1_s2: f64,
    /// To the decay of oscillations, 1/s.
    pub decay_1_s: f64,
}

/// What all bodies of a case add to its fastest rates.
pub(crate) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> [FastestRates; 4] {
    [
        inner_ring::fastest_rates(case, contacts),
        rotor::fastest_rates(case, contacts),
        outer_ring::fastest_rates(case, contacts),
        sliding_ring::fastest_rates(case, contacts),
    ]
}

/// Length of the longest table.
pub(crate) const LONGEST: usize = 11;

#[cfg(test)]
mod tests {
    use super::*;

    /// Every velocity comes after its position and moves with it.
    #[test]
    fn velocities_move_with_their_positions() {
        for body in BodyKind::ALL {
            let table = body.table();
            assert!(table.len() <= LONGEST);
            for (k, row) in table.iter().enumerate() {
                if let Kind::VelocityOf(position) = row.coordinate.kind {
                    assert!(position < k, "{}", row.coordinate.name);
                    assert_eq!(table[position].freedom, row.freedom);
                    assert_eq!(table[position].coordinate.kind, Kind::Position);
                }
            }
        }
    }

    /// The enumerations index the tables.
    #[test]
    fn indices_follow_the_tables() {
        for (coordinate, name) in [
            (RingCoordinate::TiltQRate.into(), "tilt_q_rate_per_s"),
            (RingCoordinate::Speed.into(), "ring_speed_rad_s"),
            (OuterRingCoordinate::Vz.into(), "housing_vz_m_s"),
            (RotorCoordinate::Speed.into(), "rotor_speed_rad_s"),
            (RotorCoordinate::Vz.into(), "rotor_vz_m_s"),
        ] {
            let BodyCoordinate { body, index } = coordinate;
            assert_eq!(body.table()[index].coordinate.name, name);
        }
    }
}
