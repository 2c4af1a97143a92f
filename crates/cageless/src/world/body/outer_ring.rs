//! The outer ring on its support: coordinates, constants and acceleration.

use super::row::{BodyRow, Freedom, row};
use super::{ContactStiffness, FastestRates};
use crate::ball::{AxialMotion, Centre};
use crate::case::Case;
use crate::dynamics::coordinates::Kind;
use crate::rotor::Support;
use crate::world::joint::support::SupportJoint;

/// Index of a coordinate of the outer ring, which moves under a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum OuterRingCoordinate {
    /// x, from its rest place.
    X,
    /// y, from its rest place.
    Y,
    /// ẋ.
    Vx,
    /// ẏ.
    Vy,
    /// In space: z, from its rest place.
    Z,
    /// In space: ż.
    Vz,
}

impl OuterRingCoordinate {
    /// Coordinates of the plane, in the order of the state vector.
    pub(crate) const ALL: [Self; 4] = [Self::X, Self::Y, Self::Vx, Self::Vy];
}

/// Coordinates of the outer ring with its housing.
pub(crate) const TABLE: [BodyRow; 6] = {
    use Freedom::{UnderRotor, UnderRotorInSpace};
    [
        row(UnderRotor, "housing_x_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "housing_y_m", "m", 1e-5, Kind::Position),
        row(
            UnderRotor,
            "housing_vx_m_s",
            "m/s",
            0.1,
            Kind::VelocityOf(0),
        ),
        row(
            UnderRotor,
            "housing_vy_m_s",
            "m/s",
            0.1,
            Kind::VelocityOf(1),
        ),
        row(UnderRotorInSpace, "housing_z_m", "m", 1e-5, Kind::Position),
        row(
            UnderRotorInSpace,
            "housing_vz_m_s",
            "m/s",
            0.1,
            Kind::VelocityOf(4),
        ),
    ]
};

/// Constants of the outer ring with its housing, which does not turn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct OuterRing {
    /// mo, kg; 0 if it is fixed.
    pub mass: f64,
    /// 1/mo, 1/kg; 0 if it is fixed.
    pub inverse_mass: f64,
    /// Mass that moves with the housing along the axis, kg: without outer rings that slide in it.
    pub axial_mass: f64,
    /// 1 over it, 1/kg; 0 if it is fixed.
    pub axial_inverse_mass: f64,
    /// Support of the ring.
    pub support: SupportJoint,
}

/// Contribution of the ring to the fastest rates of a case: between balls and support; nothing where it is fixed.
pub(super) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> FastestRates {
    // Without a rotor the support holds it.
    let (Some(_), Some(support)) = (&case.rotor, &case.support) else {
        return FastestRates::default();
    };
    let stop_n_m = support.stop.map_or(0.0, |stop| stop.stiffness_n_m);
    let stiffness_n_m = contacts.carrying * contacts.outer_n_m + (support.stiffness_n_m + stop_n_m);
    let damping_n_s_m = contacts.carrying * contacts.outer_n_s_m + support.damping_n_s_m;
    let inverse_mass = 1.0 / support.mass_kg;
    FastestRates {
        square_1_s2: stiffness_n_m * inverse_mass,
        decay_1_s: damping_n_s_m * inverse_mass,
    }
}

impl OuterRing {
    /// The outer ring on `support`, with rings of this mass that slide in it; fixed without a support.
    pub(crate) fn new(support: Option<&Support>, sliding_kg: f64) -> Self {
        let Some(support) = support else {
            return Self::default();
        };
        let axial_mass = support.mass_kg - sliding_kg;
        Self {
            mass: support.mass_kg,
            inverse_mass: 1.0 / support.mass_kg,
            axial_mass,
            axial_inverse_mass: 1.0 / axial_mass,
            support: SupportJoint::new(support),
        }
    }

    /// Acceleration under the sum of the balls' reactions: mo z̈o + cs żo + ks zo = Σ reactions.
    #[inline(always)]
    pub(crate) fn acceleration(
        &self,
        motion: &Centre,
        along_axis: &AxialMotion,
        reactions: [f64; 3],
    ) -> [f64; 3] {
        let [x, y] = self.support.force(motion);
        let z = self.support.force_along_axis(along_axis);
        [
            (reactions[0] + x) * self.inverse_mass,
            (reactions[1] + y) * self.inverse_mass,
            (reactions[2] + z) * self.axial_inverse_mass,
        ]
    }

    /// Kinetic energy of the ring and energy stored in the support, J.
    pub(crate) fn energy_j(&self, motion: &Centre, along_axis: &AxialMotion) -> f64 {
        let AxialMotion { z, vz } = *along_axis;
        0.5 * self.mass * (motion.vx.powi(2) + motion.vy.powi(2))
            + 0.5 * self.axial_mass * vz * vz
            + self.support.energy_j(motion, z)
    }
}
