//! Rigid rotors, each in the plane of its only bearing, side by side.

use super::rigid_rotor::RigidRotor;
use super::rotor::{ROTOR, RotorCompliance, RotorCoordinate, RotorMotion};
use super::rotor_body::{RotorBody, RotorEnergyTerm};
use crate::integrator::SecondOrderBlock;
use crate::world::joint::TouchLoads;

/// The rotors, one for each bearing side by side.
#[derive(Debug, Clone)]
pub(crate) struct RigidRotors(pub Vec<RigidRotor>);

impl RigidRotors {
    /// Place of a coordinate of rotor `k`.
    #[inline(always)]
    fn place(&self, coordinate: RotorCoordinate, k: usize) -> usize {
        coordinate as usize * self.0.len() + k
    }

    /// Motion of rotor `k`.
    #[inline(always)]
    fn motion(&self, y: &[f64], k: usize) -> RotorMotion {
        RotorMotion::new(|coordinate| y[self.place(coordinate, k)])
    }
}

impl RotorBody for RigidRotors {
    fn dimension(&self) -> usize {
        (ROTOR + RotorEnergyTerm::ALL.len()) * self.0.len()
    }

    fn places(&self, _k: usize) -> [usize; ROTOR] {
        std::array::from_fn(|c| c * self.0.len())
    }

    fn energy_term(&self, term: RotorEnergyTerm, k: usize) -> usize {
        (ROTOR + term as usize) * self.0.len() + k
    }

    fn second_order_block(&self) -> SecondOrderBlock {
        let count = ROTOR / 2 * self.0.len();
        SecondOrderBlock {
            positions: 0,
            rates: count,
            count,
        }
    }

    fn set_rates(&mut self, y: &[f64], loads: &[TouchLoads], dydt: &mut [f64]) {
        for (k, (rotor, loads)) in self.0.iter().zip(loads).enumerate() {
            let motion = self.motion(y, k);
            let answer = rotor.acceleration(loads);
            let [ax, ay, az] = answer.linear;
            for (coordinate, rate) in [
                (RotorCoordinate::X, motion.vx),
                (RotorCoordinate::Y, motion.vy),
                (RotorCoordinate::Z, motion.vz),
                (RotorCoordinate::Angle, motion.speed),
                (RotorCoordinate::Vx, ax),
                (RotorCoordinate::Vy, ay),
                (RotorCoordinate::Vz, az),
                (RotorCoordinate::Speed, answer.spin),
            ] {
                dydt[self.place(coordinate, k)] = rate;
            }
            for (term, power) in [
                (RotorEnergyTerm::Journals, motion.power(loads)),
                (RotorEnergyTerm::Weight, rotor.weight_power(&motion)),
                (RotorEnergyTerm::Drive, rotor.drive_torque * motion.speed),
                (RotorEnergyTerm::Loss, 0.0),
            ] {
                dydt[self.energy_term(term, k)] = power;
            }
        }
    }

    fn compliance(&mut self, _y: &[f64], k: usize) -> RotorCompliance {
        self.0[k].compliance()
    }

    fn add_loads(
        &mut self,
        k: usize,
        loads: &TouchLoads,
        h_s: f64,
        y: &mut [f64],
        dydt: &mut [f64],
    ) {
        let answer = self.0[k].response(loads);
        let [ax, ay, az] = answer.linear;
        for (coordinate, rate) in [
            (RotorCoordinate::Vx, ax),
            (RotorCoordinate::Vy, ay),
            (RotorCoordinate::Vz, az),
            (RotorCoordinate::Speed, answer.spin),
        ] {
            let place = self.place(coordinate, k);
            dydt[place] += rate;
            y[place] += h_s * rate;
        }
    }

    fn energy_j(&self, y: &[f64], k: usize) -> f64 {
        self.0[k].energy_j(&self.motion(y, k))
    }

    fn set_drive_torque(&mut self, torque_n_m: f64) {
        for rotor in &mut self.0 {
            rotor.drive_torque = torque_n_m;
        }
    }
}
