//! The joint of a shoulder of the rotor and a face of the inner ring.

use crate::contact::{Journal, journal_energy_j};
use crate::rotor::Rotor;

/// Constants of the shoulders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shoulder {
    /// Clearance of either shoulder to its face, m.
    pub clearance: f64,
    /// Mean radius of the faces, m.
    pub radius: f64,
}

/// Contact of a shoulder of the rotor with the face of the inner ring at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FaceContact {
    /// δ, m; negative: apart.
    pub deflection: f64,
    /// Force on the rotor along +Z, N: from the face at +Z it is negative.
    pub axial_force: f64,
    /// Power that damping takes out, W.
    pub damping_power: f64,
    /// Sliding speed of the shoulder on the face by rotation, m/s.
    pub slip: f64,
}

/// Motion of the rotor against the ring as the shoulders meet it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ShoulderMotion {
    /// Z of the rotor from that of the ring, m.
    pub z: f64,
    /// Axial velocity of the rotor against the ring, m/s.
    pub vz: f64,
    /// Ω − ωi, rad/s.
    pub turning: f64,
}

impl Shoulder {
    /// Shoulders of a rotor over a ring with this mean radius between its bore and its raceway; `None`
    /// without them.
    pub(crate) fn new(rotor: &Rotor, mean_radius_m: f64) -> Option<Self> {
        Some(Self {
            clearance: rotor.axial_clearance_m?,
            radius: rotor.shoulder_radius_m.unwrap_or(mean_radius_m),
        })
    }

    /// Contact of the shoulder on the side of the rotor, with the law of its journal.
    pub(crate) fn contact(&self, journal: &Journal, motion: &ShoulderMotion) -> FaceContact {
        let side = motion.z.signum();
        let deflection = side * motion.z - self.clearance;
        let [force, damping_power] = journal.normal(deflection, side * motion.vz);
        FaceContact {
            deflection,
            axial_force: -side * force,
            damping_power,
            slip: self.radius * motion.turning,
        }
    }

    /// Energy stored at a Z of the rotor from that of the ring, J.
    pub(crate) fn energy_j(&self, journal: &Journal, z: f64) -> f64 {
        journal_energy_j(journal, z.abs() - self.clearance)
    }
}
