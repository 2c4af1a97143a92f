//! Terms of the energy ledger.
//!
//! ```
//! use cageless::dynamics::EnergyTerm;
//!
//! assert_eq!(EnergyTerm::Damping.name(), "damping");
//! assert!(EnergyTerm::Damping.is_loss());
//! ```

crate::named_enum! {
    /// Terms of the energy ledger in the order of the state vector, carried in the state so that they are
    /// integrated with the accuracy of the motion. All in joules since the start.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum EnergyTerm {
        /// Work of the drive that turns the inner ring at ωi; below a rotor that of its journal.
        Drive = "drive",
        /// Work of the radial load.
        Load = "radial_load",
        /// Work of gravity on balls and inner ring.
        Weight = "weight",
        /// Heat of friction at the inner raceway.
        InnerFriction = "inner_friction",
        /// Heat of friction at the outer raceway.
        OuterFriction = "outer_friction",
        /// Heat of friction between balls.
        BallFriction = "ball_friction",
        /// Heat of the damping of the contacts.
        Damping = "damping",
        /// Heat of the viscous damping of the inner ring and of outer rings that slide in their housing.
        Drag = "drag",
        /// `paper` formulation: work of the centrifugal force added to Zhao 2022, Eq. (12).
        Centrifugal = "centrifugal_force",
        /// `paper` formulation: work of outer friction along the contact path that friction along the
        /// sliding velocity would not do.
        FrictionDirection = "friction_direction",
        /// `paper` formulation: work of the relative spin of Eq. (13) in place of the absolute one.
        RelativeSpin = "relative_spin",
        /// Heat of the rolling force of films at both raceways.
        RollingResistance = "rolling_resistance",
        /// Heat of friction between rotor and inner ring.
        RotorFriction = "rotor_friction",
        /// Heat of the damping of the contact between rotor and inner ring.
        RotorDamping = "rotor_contact_damping",
        /// Heat of the damping of the support.
        SupportDamping = "support_damping",
    }
}

/// Number of terms of a bearing without a rotor; those of the rotor come after them.
const WITHOUT_ROTOR: usize = EnergyTerm::RotorFriction as usize;

impl EnergyTerm {
    /// The terms of a bearing without a rotor.
    pub(crate) const fn without_rotor() -> &'static [Self] {
        const ALL: &[EnergyTerm] = &EnergyTerm::ALL;
        ALL.split_at(WITHOUT_ROTOR).0
    }

    /// Whether the term counts what leaves the bearing.
    pub fn is_loss(self) -> bool {
        use EnergyTerm::{Centrifugal, Drive, FrictionDirection, Load, RelativeSpin, Weight};
        !matches!(
            self,
            Drive | Load | Weight | Centrifugal | FrictionDirection | RelativeSpin
        )
    }
}

/// Balance of an energy ledger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EnergyBalance {
    /// Energy at the start, J.
    pub start_j: f64,
    /// Energy now − energy at the start − net work, J.
    pub residual_j: f64,
    /// Sum of the absolute terms, the change of energy among them, to which the residual is to be compared, J.
    pub flows_j: f64,
}

impl EnergyBalance {
    /// Balance of an energy with what flowed in, J; what flowed out is negative.
    pub(crate) fn new(start_j: f64, now_j: f64, flows_j: impl IntoIterator<Item = f64>) -> Self {
        let change = now_j - start_j;
        let (mut net, mut sum) = (0.0, change.abs());
        for flow in flows_j {
            net += flow;
            sum += flow.abs();
        }
        Self {
            start_j,
            residual_j: change - net,
            flows_j: sum,
        }
    }
}
