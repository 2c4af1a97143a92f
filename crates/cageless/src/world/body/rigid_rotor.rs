//! A rigid rotor above one bearing.

use super::rotor::{RotorCompliance, RotorMotion};
use crate::case::Case;
use crate::rotor::Rotor;
use crate::world::joint::TouchLoads;

/// Constants of the rotor.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RigidRotor {
    /// m, kg.
    pub mass: f64,
    /// Ip, kg·m².
    pub polar_inertia: f64,
    /// Weight, N.
    pub weight: [f64; 3],
    /// Force along +Z, N.
    pub axial_load: f64,
    /// Torque of the drive, N·m.
    pub drive_torque: f64,
}

/// Accelerations of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotorAcceleration {
    /// Acceleration of the mass centre, m/s².
    pub linear: [f64; 3],
    /// Angular acceleration, rad/s².
    pub spin: f64,
}

impl RigidRotor {
    /// The rotor of a case.
    pub(crate) fn of_case(rotor: &Rotor, case: &Case) -> Self {
        let upward = match case.moves_in_space() {
            true => case.upward(),
            false => 1,
        };
        Self::new(rotor, upward, case.operation.gravity_m_s2)
    }

    /// A rotor whose weight acts against an axis: 1 for Y, 2 for Z.
    pub(crate) fn new(rotor: &Rotor, upward: usize, gravity_m_s2: f64) -> Self {
        let mut weight = [0.0; 3];
        weight[upward] = -rotor.mass_kg * gravity_m_s2;
        Self {
            mass: rotor.mass_kg,
            polar_inertia: rotor.polar_inertia_kg_m2,
            weight,
            axial_load: rotor.axial_load_n,
            drive_torque: rotor.drive_torque_n_m,
        }
    }

    /// Acceleration under the loads of the inner ring: m z̈g = F + weight and Ip Ω̇ = moment of F +
    /// torque of the drive.
    #[inline(always)]
    pub(crate) fn acceleration(&self, loads: &TouchLoads) -> RotorAcceleration {
        let ([x, y, z], [wx, wy, wz]) = (loads.force, self.weight);
        RotorAcceleration {
            linear: [
                (x + wx) / self.mass,
                (y + wy) / self.mass,
                (z + (wz + self.axial_load)) / self.mass,
            ],
            spin: (loads.moment + self.drive_torque) / self.polar_inertia,
        }
    }

    /// Acceleration that loads of the inner ring add.
    #[inline(always)]
    pub(crate) fn response(&self, loads: &TouchLoads) -> RotorAcceleration {
        RotorAcceleration {
            linear: loads.force.map(|force| force / self.mass),
            spin: loads.moment / self.polar_inertia,
        }
    }

    /// Accelerations of the mass centre and of the rotation under a unit of each load.
    pub(crate) fn compliance(&self) -> RotorCompliance {
        RotorCompliance::Rigid {
            mass: self.mass,
            polar_inertia: self.polar_inertia,
        }
    }

    /// Power of weight and given load, W.
    #[inline(always)]
    pub(crate) fn weight_power(&self, motion: &RotorMotion) -> f64 {
        let [x, y, z] = self.weight;
        x * motion.vx + y * motion.vy + (z + self.axial_load) * motion.vz
    }

    /// Kinetic energy, J.
    pub(crate) fn energy_j(&self, motion: &RotorMotion) -> f64 {
        let square = motion.vx * motion.vx + motion.vy * motion.vy + motion.vz * motion.vz;
        0.5 * self.mass * square + 0.5 * self.polar_inertia * motion.speed * motion.speed
    }
}
