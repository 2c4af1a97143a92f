//! Bodies beside the balls: one file is one body.

mod fastest_rates;
pub(crate) mod inner_ring;
pub(crate) mod linear_rotor;
mod linear_rotor_equations;
pub(crate) mod outer_ring;
mod resting_ring;
pub(crate) mod rigid_rotor;
pub(crate) mod rigid_rotors;
pub(crate) mod rotor;
pub(crate) mod rotor_body;
mod row;
pub(crate) mod sliding_ring;

pub(crate) use fastest_rates::{ContactStiffness, FastestRates};
pub use inner_ring::RingCoordinate;
pub(crate) use linear_rotor_equations::RotorLoads;
pub(crate) use outer_ring::OuterRingCoordinate;
pub(crate) use resting_ring::RestingRing;
pub(crate) use rotor::RotorCoordinate;
pub(crate) use rotor::RotorMotion;
pub(crate) use row::{BodyRow, Freedoms};
pub(crate) use sliding_ring::SlidingCoordinate;

use crate::case::Case;

/// Kind of a body of which a bearing has one, in the order of the state vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BodyKind {
    /// The inner ring.
    InnerRing,
    /// The outer ring on its support.
    OuterRing,
    /// The rotor.
    Rotor,
}

impl BodyKind {
    /// All, in the order of the state vector.
    pub(crate) const ALL: [Self; 3] = [Self::InnerRing, Self::OuterRing, Self::Rotor];
    /// Rings of the bearing itself.
    pub(crate) const RINGS: [Self; 2] = [Self::InnerRing, Self::OuterRing];

    /// Coordinates of the body in space.
    pub(crate) const fn table(self) -> &'static [BodyRow] {
        match self {
            Self::InnerRing => &inner_ring::TABLE,
            Self::OuterRing => &outer_ring::TABLE,
            Self::Rotor => &rotor::TABLE,
        }
    }
}

/// A coordinate of one of these bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct BodyCoordinate {
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

/// Coordinates of all bodies of a case at the start; those that are left out, as of the outer ring, are 0.
pub(crate) fn start(case: &Case, ring: &RestingRing) -> Vec<(BodyCoordinate, f64)> {
    let of_ring = inner_ring::start(ring).map(|(c, value)| (c.into(), value));
    let of_rotor = rotor::start(case, ring).into_iter().flatten();
    let of_rotor = of_rotor.map(|(c, value)| (c.into(), value));
    of_ring.into_iter().chain(of_rotor).collect()
}

/// Contributions of all bodies of a case to its fastest rates.
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
    use crate::dynamics::coordinates::Kind;

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
