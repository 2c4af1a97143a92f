//! A rotor with linear lateral motion on the inner rings of several bearings.
//!
//! The state holds each bearing as if it were alone, with the motion of its journal in the place of
//! a rotor, then the rotor itself: normal coordinates u and θ, their rates, and the energy ledger
//! of the rotor. The motion of a journal follows from u linearly, and every method here keeps
//! linear relations, so that the journals stay those of the rotor.

use super::Model;
use super::coordinates::{DROP, DropCoordinate};
use super::energy::EnergyTerm;
use super::layout::Layout;
use super::right_hand_side::{JournalLoad, RightHandSide, mix};
use super::rotor::JournalCompliance;
use crate::integrator::{SecondOrderBlock, System};
use crate::linear_rotor::{Clearance, DVector, LinearRotor};

/// Term of the energy ledger of the rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotorEnergyTerm {
    /// Work of the inner rings on the journals.
    Journals,
    /// Work of gravity.
    Weight,
    /// Work of the drive.
    Drive,
    /// Energy that the damping of the rotor, its cross-coupled stiffness and Ksdt take out.
    Loss,
}

const TERMS: usize = RotorEnergyTerm::Loss as usize + 1;

/// What acts on the rotor beside the bearings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotorLoads {
    /// g, m/s², along −Y.
    pub gravity: f64,
    /// Torque of the drive, N·m.
    pub drive_torque: f64,
}

/// The equations of motion of a rotor and all of its bearings.
pub(crate) struct RotorOnBearings<'m> {
    rotor: &'m LinearRotor,
    loads: RotorLoads,
    bearings: Vec<RightHandSide<'m>>,
    /// Places of each bearing.
    layouts: Vec<Layout>,
    /// First place of the rotor.
    start: usize,
    blocks: Vec<SecondOrderBlock>,
    /// Largest squared displacement of each plane of the rotor so far, m².
    displaced_squared: Vec<f64>,
}

/// Largest displacement of a rotor in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneDisplacement {
    /// The plane.
    pub clearance: Clearance,
    /// Largest distance of the axis of the rotor from the centre of the stator, m.
    pub displacement_max_m: f64,
}

/// Motion of the rotor at one instant.
struct Motion {
    u: DVector<f64>,
    rates: DVector<f64>,
    angle: f64,
    speed: f64,
}

/// Coupling of bending and spin at one instant.
struct Coupling {
    /// b = Σ Uj·i·e^(i(θ+φj)) at the places of the unbalances, over u.
    unbalance: DVector<f64>,
    /// b + Ksdt·u.
    spin_up: DVector<f64>,
    /// Ip − bᵀ·(b + Ksdt·u): what a torque turns where bending follows freely.
    inertia: f64,
}

/// Acceleration of the rotor.
struct Acceleration {
    u: DVector<f64>,
    speed: f64,
}

impl<'m> RotorOnBearings<'m> {
    /// The rotor on the bearings of `models`, one for each of its journals.
    pub fn new(rotor: &'m LinearRotor, loads: RotorLoads, models: &'m [Model]) -> Self {
        let mut start = 0;
        let mut layouts = vec![];
        for model in models {
            layouts.push(model.layout.at(start));
            start += model.layout.len();
        }
        let n = rotor.coordinates();
        let mut blocks: Vec<_> = (layouts.iter())
            .flat_map(Layout::second_order_blocks)
            .collect();
        blocks.push(SecondOrderBlock {
            positions: start,
            rates: start + n + 1,
            count: n + 1,
        });
        Self {
            rotor,
            loads,
            bearings: models.iter().map(RightHandSide::new).collect(),
            layouts,
            start,
            blocks,
            displaced_squared: vec![0.0; rotor.planes.len()],
        }
    }

    /// Places of bearing `k`.
    pub fn layout(&self, k: usize) -> Layout {
        self.layouts[k]
    }

    /// Sets the rotor in a state: journals at these places with these velocities, in the shape
    /// that needs no force elsewhere.
    pub fn set_rotor(&self, y: &mut [f64], places: &[f64], velocities: &[f64], speed: f64) {
        let n = self.rotor.coordinates();
        let shapes = &self.rotor.shapes;
        let u = shapes * DVector::from_column_slice(places);
        let rates = shapes * DVector::from_column_slice(velocities);
        let own = &mut y[self.start..];
        own[..n].copy_from_slice(u.as_slice());
        own[n] = 0.0;
        own[n + 1..=2 * n].copy_from_slice(rates.as_slice());
        own[2 * n + 1] = speed;
        self.place_journals(y);
    }

    fn motion(&self, y: &[f64]) -> Motion {
        let (n, own) = (self.rotor.coordinates(), &y[self.start..]);
        Motion {
            u: DVector::from_column_slice(&own[..n]),
            rates: DVector::from_column_slice(&own[n + 1..=2 * n]),
            angle: own[n],
            speed: own[2 * n + 1],
        }
    }

    /// Place of a term of the rotor's energy ledger.
    fn term(&self, term: RotorEnergyTerm) -> usize {
        self.start + 2 * self.rotor.coordinates() + 2 + term as usize
    }

    /// Writes the motion of the journals to the places of the bearings.
    fn place_journals(&self, y: &mut [f64]) {
        let motion = self.motion(y);
        for (layout, rows) in self.layouts.iter().zip(&self.rotor.journals) {
            let (place, rate) = (rows * &motion.u, rows * &motion.rates);
            for (coordinate, value) in [
                (DropCoordinate::RotorX, place[0]),
                (DropCoordinate::RotorY, place[1]),
                (DropCoordinate::RotorAngle, motion.angle),
            ] {
                y[layout.drop(coordinate)] = value;
            }
            self.set_rates(layout, &rate, motion.speed, y);
        }
    }

    /// Writes velocities to the places of one journal in a state, or accelerations in its rate.
    fn set_rates(&self, layout: &Layout, lateral: &DVector<f64>, spin: f64, y: &mut [f64]) {
        for (coordinate, value) in [
            (DropCoordinate::RotorVx, lateral[0]),
            (DropCoordinate::RotorVy, lateral[1]),
            (DropCoordinate::RotorSpeed, spin),
        ] {
            y[layout.drop(coordinate)] = value;
        }
    }

    fn coupling(&self, motion: &Motion) -> Coupling {
        let mut unbalance_coupling = DVector::zeros(motion.u.len());
        for unbalance in &self.rotor.unbalances {
            let (sin, cos) = (motion.angle + unbalance.phase).sin_cos();
            let direction = DVector::from_vec(vec![-sin, cos]) * unbalance.moment;
            unbalance_coupling.gemv_tr(1.0, &unbalance.place, &direction, 1.0);
        }
        let spin_up = &unbalance_coupling + &self.rotor.spin_up * &motion.u;
        Coupling {
            inertia: self.rotor.polar_inertia - unbalance_coupling.dot(&spin_up),
            unbalance: unbalance_coupling,
            spin_up,
        }
    }

    /// Acceleration under forces over u and a torque:
    /// ü + (b + Ksdt·u)·Ω̇ = f and Ip·Ω̇ + bᵀ·ü = τ.
    fn respond(coupling: &Coupling, forces: DVector<f64>, torque: f64) -> Acceleration {
        let speed = (torque - coupling.unbalance.dot(&forces)) / coupling.inertia;
        Acceleration {
            u: forces - &coupling.spin_up * speed,
            speed,
        }
    }

    /// Acceleration under a load on journal `k` alone.
    fn respond_at(&self, k: usize, coupling: &Coupling, load: &JournalLoad) -> Acceleration {
        let (mut forces, mut torque) = (DVector::zeros(self.rotor.coordinates()), 0.0);
        self.add_load(k, load, &mut forces, &mut torque);
        Self::respond(coupling, forces, torque)
    }

    /// Acceleration by everything but the bearings.
    fn own_forces(&self, motion: &Motion) -> (DVector<f64>, f64) {
        let (r, loads) = (self.rotor, &self.loads);
        let mut forces = &r.lift * -loads.gravity;
        forces.gemv(-1.0, &r.damping, &motion.rates, 1.0);
        forces.gemv(-motion.speed, &r.gyroscopic, &motion.rates, 1.0);
        forces.gemv(-1.0, &r.stiffness, &motion.u, 1.0);
        let mut torque = loads.drive_torque;
        for unbalance in &r.unbalances {
            let (sin, cos) = (motion.angle + unbalance.phase).sin_cos();
            let outwards = DVector::from_vec(vec![cos, sin])
                * (unbalance.moment * motion.speed * motion.speed);
            forces.gemv_tr(1.0, &unbalance.place, &outwards, 1.0);
            torque -= unbalance.moment * loads.gravity * cos;
        }
        (forces, torque)
    }

    /// Adds a load on journal `k` to forces over u and the torque.
    fn add_load(
        &self,
        k: usize,
        [x, y, moment]: &JournalLoad,
        forces: &mut DVector<f64>,
        torque: &mut f64,
    ) {
        let force = DVector::from_vec(vec![*x, *y]);
        forces.gemv_tr(1.0, &self.rotor.journals[k], &force, 1.0);
        *torque += moment;
    }

    /// Response of journal `k` to unit loads on it.
    fn compliance(&self, k: usize, coupling: &Coupling) -> JournalCompliance {
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let columns = units.map(|unit| {
            let answer = self.respond_at(k, coupling, &unit);
            let lateral = &self.rotor.journals[k] * answer.u;
            [lateral[0], lateral[1], answer.speed]
        });
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row]))
    }

    /// Adds an acceleration of the rotor over `h_s` to a state, or with 1 to its rate.
    fn add(&self, answer: &Acceleration, h_s: f64, y: &mut [f64]) {
        let n = self.rotor.coordinates();
        let rates = &mut y[self.start + n + 1..];
        for (rate, a) in rates.iter_mut().zip(answer.u.iter()) {
            *rate += h_s * a;
        }
        rates[n] += h_s * answer.speed;
    }

    fn evaluate(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64], stiff_too: bool) {
        for (bearing, layout) in self.bearings.iter_mut().zip(&self.layouts) {
            let places = span(layout);
            let (own, rate) = (&y[places.clone()], &mut dydt[places]);
            if stiff_too {
                bearing.derivative(time_s, own, rate);
            } else {
                bearing.nonstiff_derivative(time_s, own, rate);
            }
        }
        let motion = self.motion(y);
        let loads: Vec<JournalLoad> = self.bearings.iter().map(|b| b.journal_load()).collect();
        let (mut forces, mut torque) = self.own_forces(&motion);
        for (k, load) in loads.iter().enumerate() {
            self.add_load(k, load, &mut forces, &mut torque);
        }
        let answer = Self::respond(&self.coupling(&motion), forces, torque);
        let n = self.rotor.coordinates();
        let own = &mut dydt[self.start..];
        own[..n].copy_from_slice(motion.rates.as_slice());
        own[n] = motion.speed;
        own[n + 1..=2 * n].copy_from_slice(answer.u.as_slice());
        own[2 * n + 1] = answer.speed;
        self.journal_accelerations(&answer.u, answer.speed, dydt);
        for (term, power) in self.powers(&motion, &loads, answer.speed) {
            dydt[self.term(term)] = power;
        }
    }

    /// Writes the accelerations of the journals to the rates of the bearings.
    fn journal_accelerations(&self, u: &DVector<f64>, spin: f64, dydt: &mut [f64]) {
        for (layout, rows) in self.layouts.iter().zip(&self.rotor.journals) {
            self.set_rates(layout, &(rows * u), spin, dydt);
        }
    }

    /// Powers of the rotor's energy ledger.
    fn powers(
        &self,
        motion: &Motion,
        loads: &[JournalLoad],
        spin: f64,
    ) -> [(RotorEnergyTerm, f64); TERMS] {
        let r = self.rotor;
        let journals = loads.iter().enumerate();
        let mut weight = -self.loads.gravity * r.lift.dot(&motion.rates);
        for unbalance in &r.unbalances {
            let cos = (motion.angle + unbalance.phase).cos();
            weight -= unbalance.moment * self.loads.gravity * cos * motion.speed;
        }
        // Of K the antisymmetric part alone: the symmetric one stores what it takes.
        let circulatory = 0.5
            * (motion.rates.dot(&(&r.stiffness * &motion.u))
                - motion.u.dot(&(&r.stiffness * &motion.rates)));
        let resisting = &r.damping * &motion.rates + &r.spin_up * &motion.u * spin;
        [
            (
                RotorEnergyTerm::Journals,
                journals.map(|(k, load)| self.power(k, motion, load)).sum(),
            ),
            (RotorEnergyTerm::Weight, weight),
            (
                RotorEnergyTerm::Drive,
                self.loads.drive_torque * motion.speed,
            ),
            (
                RotorEnergyTerm::Loss,
                resisting.dot(&motion.rates) + circulatory,
            ),
        ]
    }

    /// Power of a load on journal `k`, W.
    fn power(&self, k: usize, motion: &Motion, [x, y, moment]: &JournalLoad) -> f64 {
        let rate = &self.rotor.journals[k] * &motion.rates;
        x * rate[0] + y * rate[1] + moment * motion.speed
    }

    /// Kinetic and elastic energy of the rotor, J.
    pub fn rotor_energy_j(&self, y: &[f64]) -> f64 {
        let motion = self.motion(y);
        let coupling = self.coupling(&motion).unbalance.dot(&motion.rates);
        0.5 * motion.rates.norm_squared()
            + motion.speed * coupling
            + 0.5 * self.rotor.polar_inertia * motion.speed * motion.speed
            + 0.5 * motion.u.dot(&(&self.rotor.stiffness * &motion.u))
    }

    /// What the rotor lacks to balance its ledger, and the sum of the absolute terms, J.
    pub fn rotor_residual_j(&self, start_energy_j: f64, y: &[f64]) -> (f64, f64) {
        let change = self.rotor_energy_j(y) - start_energy_j;
        let at = |term: RotorEnergyTerm| y[self.term(term)];
        let flows = [
            at(RotorEnergyTerm::Journals),
            at(RotorEnergyTerm::Weight),
            at(RotorEnergyTerm::Drive),
            -at(RotorEnergyTerm::Loss),
        ];
        let sum = flows.iter().fold(change.abs(), |sum, f| sum + f.abs());
        (change - flows.iter().sum::<f64>(), sum)
    }

    /// Takes the displacements of the planes of the rotor from the centre of the stator.
    pub fn look_at_planes(&mut self, y: &[f64]) {
        if self.rotor.planes.is_empty() {
            return;
        }
        let u = self.motion(y).u;
        for (plane, most) in self.rotor.planes.iter().zip(&mut self.displaced_squared) {
            *most = most.max((&plane.place * &u).norm_squared());
        }
    }

    /// The planes of the rotor with their largest displacements so far.
    pub fn planes(&self) -> Vec<PlaneDisplacement> {
        let planes = self.rotor.planes.iter().zip(&self.displaced_squared);
        planes
            .map(|(plane, squared)| PlaneDisplacement {
                clearance: plane.clearance.clone(),
                displacement_max_m: squared.sqrt(),
            })
            .collect()
    }

    /// The equations of bearing `k`.
    pub fn bearing(&self, k: usize) -> &RightHandSide<'m> {
        &self.bearings[k]
    }
}

/// Places of a bearing.
fn span(layout: &Layout) -> std::ops::Range<usize> {
    let start = layout.start();
    start..start + layout.len()
}

impl System for RotorOnBearings<'_> {
    fn dimension(&self) -> usize {
        self.term(RotorEnergyTerm::Loss) + 1
    }

    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, true);
    }

    fn mode(&self) -> u64 {
        let modes = self.bearings.iter().map(System::mode);
        modes.fold(0, mix)
    }

    fn edges(&self, y: &[f64], values: &mut Vec<f64>) {
        for (bearing, layout) in self.bearings.iter().zip(&self.layouts) {
            bearing.edges(&y[span(layout)], values);
        }
    }

    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &self.blocks
    }

    /// All bearings have a stiff part or none has.
    fn has_stiff_part(&self) -> bool {
        self.bearings[0].has_stiff_part()
    }

    fn nonstiff_derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, false);
    }

    /// The friction of one bearing after the other: each sees the journal move by its own friction
    /// within the step, and by that of the bearings before it.
    fn add_stiff_part(&mut self, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]) {
        let before = self.motion(y0);
        let mut loads = vec![];
        for k in 0..self.bearings.len() {
            self.place_journals(y);
            let motion = self.motion(y);
            let coupling = self.coupling(&motion);
            let compliance = self.compliance(k, &coupling);
            let places = span(&self.layouts[k]);
            let bearing = &mut self.bearings[k];
            bearing.set_journal_compliance(compliance);
            let (own0, own, rate) = (
                &y0[places.clone()],
                &mut y[places.clone()],
                &mut dydt[places],
            );
            bearing.add_stiff_part(h_s, own0, own, rate);
            let load = bearing.friction_load();
            let response = self.respond_at(k, &coupling, &load);
            self.add(&response, h_s, y);
            self.add(&response, 1.0, dydt);
            loads.push(load);
        }
        self.place_journals(y);
        let n = self.rotor.coordinates();
        let own = &dydt[self.start + n + 1..];
        let (u, spin) = (DVector::from_column_slice(&own[..n]), own[n]);
        self.journal_accelerations(&u, spin, dydt);
        // Work of friction on the journals, by the mean of the velocities at both ends.
        let after = self.motion(y);
        for (k, load) in loads.iter().enumerate() {
            let power = 0.5 * (self.power(k, &before, load) + self.power(k, &after, load));
            let rotor = self.term(RotorEnergyTerm::Journals);
            let bearing = self.layouts[k].energy_term(EnergyTerm::Drive);
            for (place, power) in [(rotor, power), (bearing, -power)] {
                dydt[place] += power;
                y[place] += h_s * power;
            }
        }
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        let n = self.rotor.coordinates();
        let own = &difference[self.start..];
        let scale = |c: DropCoordinate| DROP[c as usize].error_scale;
        // A normal coordinate is a displacement times √m.
        let root = self.rotor.mass_kg().sqrt();
        let [place, rate] =
            [DropCoordinate::RotorX, DropCoordinate::RotorVx].map(|c| root * scale(c));
        let lateral = (0..n).map(|k| (own[k] / place).powi(2) + (own[n + 1 + k] / rate).powi(2));
        let turning = (own[n] / scale(DropCoordinate::RotorAngle)).powi(2)
            + (own[2 * n + 1] / scale(DropCoordinate::RotorSpeed)).powi(2);
        let rotor = ((lateral.sum::<f64>() + turning) / (2 * n + 2) as f64).sqrt();
        let bearings = self.layouts.iter().map(|l| l.scaled_rms(difference));
        bearings.fold(rotor, f64::max)
    }
}
