//! A rotor of another kind: one whose second disc hangs on a spring, all of it in this file.

use std::sync::Arc;

use cageless::IntegrationMethod;
use cageless::dynamics::Model;
use cageless::dynamics::coordinates::RotorCoordinate;
use cageless::dynamics::state::State;
use cageless::dynamics::world::World;
use cageless::initial_conditions::initial_state;
use cageless::integrator::{CaseMethod, Integrator, SecondOrderBlock};
use cageless::numerics::vector::PlaneVector;
use cageless::world::body::rigid_rotor::RigidRotor;
use cageless::world::body::rotor::{ROTOR, RotorCompliance, RotorMotion};
use cageless::world::body::rotor_body::{RotorBody, RotorEnergyTerm};
use cageless::world::joint::TouchLoads;
use cageless::{Case, Motion};

use crate::common::drop_case;

/// A rigid rotor with a disc on a spring and a damper across the axis; along it and about it both move as one.
struct TwoDiscs {
    rotor: RigidRotor,
    disc_kg: f64,
    stiffness_n_m: f64,
    damping_n_s_m: f64,
}

/// Positions: four of the rotor, then x and y of the disc.
const POSITIONS: usize = ROTOR / 2 + 2;

/// The disc from the rotor.
struct Stretch {
    place_m: [f64; 2],
    rate_m_s: [f64; 2],
}

impl TwoDiscs {
    fn place(coordinate: RotorCoordinate) -> usize {
        let index = coordinate as usize;
        if index < ROTOR / 2 { index } else { index + 2 }
    }

    fn motion(y: &[f64]) -> RotorMotion {
        RotorMotion::new(|coordinate| y[Self::place(coordinate)])
    }

    fn stretch(y: &[f64]) -> Stretch {
        let (disc, rates) = (POSITIONS - 2, POSITIONS);
        let between = |of: usize, rotor: usize| [y[of] - y[rotor], y[of + 1] - y[rotor + 1]];
        Stretch {
            place_m: between(disc, 0),
            rate_m_s: between(rates + disc, rates),
        }
    }

    fn mass_kg(&self) -> f64 {
        self.rotor.mass + self.disc_kg
    }
}

impl RotorBody for TwoDiscs {
    fn dimension(&self) -> usize {
        2 * POSITIONS + RotorEnergyTerm::ALL.len()
    }

    fn places(&self, _k: usize) -> [usize; ROTOR] {
        std::array::from_fn(|index| if index < ROTOR / 2 { index } else { index + 2 })
    }

    fn energy_term(&self, term: RotorEnergyTerm, _k: usize) -> usize {
        2 * POSITIONS + term as usize
    }

    fn second_order_block(&self) -> SecondOrderBlock {
        SecondOrderBlock {
            positions: 0,
            rates: POSITIONS,
            count: POSITIONS,
        }
    }

    fn set_rates(&mut self, y: &[f64], loads: &[TouchLoads], dydt: &mut [f64]) {
        let (motion, stretch) = (Self::motion(y), Self::stretch(y));
        let pull = [0, 1].map(|k| {
            self.stiffness_n_m * stretch.place_m[k] + self.damping_n_s_m * stretch.rate_m_s[k]
        });
        let [x, y_n, z] = loads[0].force;
        let pulled = TouchLoads {
            force: [x + pull[0], y_n + pull[1], z],
            ..loads[0]
        };
        let answer = self.rotor.acceleration(&pulled);
        let weight_m_s2 = self.rotor.weight.map(|weight| weight / self.rotor.mass);
        let along = (z + self.rotor.axial_load) / self.mass_kg() + weight_m_s2[2];
        dydt[..POSITIONS].copy_from_slice(&y[POSITIONS..2 * POSITIONS]);
        let [ax, ay, _] = answer.linear;
        let disc = [0, 1].map(|k| weight_m_s2[k] - pull[k] / self.disc_kg);
        dydt[POSITIONS..2 * POSITIONS].copy_from_slice(&[
            ax,
            ay,
            answer.spin,
            along,
            disc[0],
            disc[1],
        ]);
        let [vx, vy] = [0, 1].map(|k| y[2 * POSITIONS - 2 + k]);
        let of_disc =
            self.disc_kg * (weight_m_s2[0] * vx + weight_m_s2[1] * vy + weight_m_s2[2] * motion.vz);
        let damped = stretch.rate_m_s.iter().map(|rate| rate * rate).sum::<f64>();
        for (term, power) in [
            (RotorEnergyTerm::Journals, motion.power(&loads[0])),
            (
                RotorEnergyTerm::Weight,
                self.rotor.weight_power(&motion) + of_disc,
            ),
            (
                RotorEnergyTerm::Drive,
                self.rotor.drive_torque * motion.speed,
            ),
            (RotorEnergyTerm::Loss, self.damping_n_s_m * damped),
        ] {
            dydt[self.energy_term(term, 0)] = power;
        }
    }

    fn compliance(&mut self, _y: &[f64], _k: usize) -> RotorCompliance {
        RotorCompliance::Bending {
            lateral: self.rotor.compliance().about(PlaneVector::default()),
            axial: 1.0 / self.mass_kg(),
        }
    }

    fn add_loads(
        &mut self,
        _k: usize,
        loads: &TouchLoads,
        h_s: f64,
        y: &mut [f64],
        dydt: &mut [f64],
    ) {
        let answer = self.rotor.response(loads);
        let [ax, ay, _] = answer.linear;
        let az = loads.force[2] / self.mass_kg();
        for (place, rate) in (POSITIONS..).zip([ax, ay, answer.spin, az]) {
            dydt[place] += rate;
            y[place] += h_s * rate;
        }
    }

    fn energy_j(&self, y: &[f64], _k: usize) -> f64 {
        let (motion, stretch) = (Self::motion(y), Self::stretch(y));
        let square = |values: [f64; 2]| values.iter().map(|v| v * v).sum::<f64>();
        let disc = [0, 1].map(|k| y[2 * POSITIONS - 2 + k]);
        self.rotor.energy_j(&motion)
            + 0.5 * self.disc_kg * (square(disc) + motion.vz * motion.vz)
            + 0.5 * self.stiffness_n_m * square(stretch.place_m)
    }

    fn set_drive_torque(&mut self, torque_n_m: f64) {
        self.rotor.drive_torque = torque_n_m;
    }
}

/// A world of the bearing of a case below such a rotor, and its state at the start.
fn below(case: &Case, damping_n_s_m: f64) -> (World, Vec<f64>, Arc<Model>, State) {
    let (state, _) = initial_state(case).unwrap();
    let model = Arc::new(Model::of_case(case).unwrap().of_common_rotor(0.0));
    let rotor = RigidRotor::of_case(case.rotor.as_ref().unwrap(), case);
    let two = TwoDiscs {
        rotor,
        disc_kg: 5.0,
        stiffness_n_m: 2e6,
        damping_n_s_m,
    };
    let mut world = World::below(two, &[Arc::clone(&model)]);
    let mut start = world.vector([&state]);
    let rotor = world.rotor_start();
    for from in [rotor, rotor + POSITIONS] {
        let disc = from + POSITIONS - 2;
        start.copy_within(from..from + 2, disc);
    }
    world.begin(&start);
    (world, start, model, state)
}

/// State at the end of a case.
fn moved(case: &Case, world: &mut World, start: &[f64]) -> Vec<f64> {
    let solver = &case.solver;
    let method = CaseMethod::new(solver.method, start.len(), solver.step_s, solver.tolerance);
    let mut integrator = Integrator::new(method, start.len());
    integrator.restart(world, 0.0, start);
    while integrator.step().t1_s < solver.duration_s {
        world.advance(&mut integrator, solver.duration_s).unwrap();
    }
    integrator.step().y1.to_vec()
}

fn falling(in_space: bool, step_s: f64) -> Case {
    let mut case = drop_case();
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-0.96 * rotor.radial_clearance_m, -0.0625);
    (rotor.contact_damping_s_m, case.contact.damping_n_s_m1_5) = (0.0, 0.0);
    if in_space {
        case.motion = Motion::Space;
    }
    case.set_method(IntegrationMethod::VelocityVerlet);
    (case.solver.step_s, case.solver.duration_s) = (step_s, 1.5e-3);
    case
}

/// Both ledgers close with the square of the step, in the plane and in space.
#[test]
fn its_ledgers_close_to_second_order() {
    for in_space in [false, true] {
        let residuals = |step_s: f64| {
            let case = falling(in_space, step_s);
            let (mut world, start, model, state) = below(&case, 300.0);
            let end = moved(&case, &mut world, &start);
            let of_rotor = world.rotor_balance(&end, 0).unwrap();
            let last = State::from_vector(world.layout(0), &end);
            assert!(last.ring_speed_rad_s().unwrap() > 1.0);
            let of_bearing = model.energy_balance(model.energy_j(&state), &last);
            [of_rotor, of_bearing].map(|balance| (balance.residual_j / balance.flows_j).abs())
        };
        let (coarse, fine) = (residuals(4e-7), residuals(1e-7));
        println!("{in_space}: {coarse:?} {fine:?}");
        for (coarse, fine) in coarse.iter().zip(fine) {
            assert!(
                *coarse < 1e-4 && fine < 0.12 * coarse + 1e-9,
                "{coarse:e} {fine:e}"
            );
        }
    }
}

/// Where nothing touches, the discs swing against each other at √(k·(1/m + 1/md)).
#[test]
fn its_discs_swing_at_their_frequency() {
    let mut case = falling(false, 1e-6);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s, rotor.speed_rad_s) = (0.0, 0.0, 0.0);
    let mass_kg = rotor.mass_kg;
    let (mut world, mut start, ..) = below(&case, 0.0);
    let at = world.rotor_start();
    let stretch_m = 1e-6;
    start[at + POSITIONS - 2] += stretch_m;
    world.begin(&start);
    let end = moved(&case, &mut world, &start);
    let frequency = (2e6 * (1.0 / mass_kg + 1.0 / 5.0_f64)).sqrt();
    let found = TwoDiscs::stretch(&end[at..]).place_m[0] / stretch_m;
    let expected = (frequency * case.solver.duration_s).cos();
    assert!((found - expected).abs() < 1e-6, "{found} {expected}");
}
