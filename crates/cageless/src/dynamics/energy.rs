//! Terms of the energy ledger.
//!
//! ```
//! use cageless::dynamics::energy::EnergyTerm;
//!
//! assert_eq!(EnergyTerm::Damping.name(), "damping");
//! assert!(EnergyTerm::Damping.is_loss());
//! ```

/// Terms of the energy ledger, carried in the state so that they are integrated
/// with the accuracy of the motion. All in joules since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnergyTerm {
    /// Work of the drive that turns the inner ring at ωi; with a rotor that of its drive.
    Drive,
    /// Work of the radial load.
    Load,
    /// Work of gravity on balls, inner ring and rotor.
    Weight,
    /// Heat of friction at the inner raceway.
    InnerFriction,
    /// Heat of friction at the outer raceway.
    OuterFriction,
    /// Heat of friction between balls.
    BallFriction,
    /// Heat of the damping of the contacts.
    Damping,
    /// Heat of the drag on the inner ring.
    Drag,
    /// `paper` profile: work of the centrifugal force added to Zhao 2022, Eq. (12).
    Centrifugal,
    /// `paper` profile: work of outer friction along the contact path that friction along the
    /// sliding velocity would not do.
    FrictionDirection,
    /// `paper` profile: work of the relative spin of Eq. (13) in place of the absolute one.
    RelativeSpin,
    /// Heat of friction between rotor and inner ring.
    RotorFriction,
    /// Heat of the damping of the contact between rotor and inner ring.
    RotorDamping,
    /// Heat of the damping of the support.
    SupportDamping,
}

/// One row of the table of terms.
struct Row {
    term: EnergyTerm,
    name: &'static str,
    is_loss: bool,
}

const fn row(term: EnergyTerm, name: &'static str, is_loss: bool) -> Row {
    Row {
        term,
        name,
        is_loss,
    }
}

/// The terms in the order of the state vector.
const TABLE: [Row; 14] = [
    row(EnergyTerm::Drive, "drive", false),
    row(EnergyTerm::Load, "radial_load", false),
    row(EnergyTerm::Weight, "weight", false),
    row(EnergyTerm::InnerFriction, "inner_friction", true),
    row(EnergyTerm::OuterFriction, "outer_friction", true),
    row(EnergyTerm::BallFriction, "ball_friction", true),
    row(EnergyTerm::Damping, "damping", true),
    row(EnergyTerm::Drag, "drag", true),
    row(EnergyTerm::Centrifugal, "centrifugal_force", false),
    row(EnergyTerm::FrictionDirection, "friction_direction", false),
    row(EnergyTerm::RelativeSpin, "relative_spin", false),
    row(EnergyTerm::RotorFriction, "rotor_friction", true),
    row(EnergyTerm::RotorDamping, "rotor_contact_damping", true),
    row(EnergyTerm::SupportDamping, "support_damping", true),
];

/// Number of terms of a bearing without a rotor; those of the rotor come after them.
const WITHOUT_ROTOR: usize = EnergyTerm::RotorFriction as usize;

impl EnergyTerm {
    /// All terms, in the order of the state vector.
    pub const ALL: [Self; TABLE.len()] = {
        let mut all = [Self::Drive; TABLE.len()];
        let mut k = 0;
        while k < TABLE.len() {
            all[k] = TABLE[k].term;
            k += 1;
        }
        all
    };

    /// The terms of a bearing without a rotor.
    pub const fn without_rotor() -> &'static [Self] {
        Self::ALL_TERMS.split_at(WITHOUT_ROTOR).0
    }

    const ALL_TERMS: &'static [Self] = &Self::ALL;

    /// Whether the term counts what leaves the bearing.
    pub fn is_loss(self) -> bool {
        TABLE[self as usize].is_loss
    }

    /// Name in tables and files.
    pub fn name(self) -> &'static str {
        TABLE[self as usize].name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_index_their_table() {
        for (k, term) in EnergyTerm::ALL.into_iter().enumerate() {
            assert_eq!(term as usize, k);
        }
    }
}
