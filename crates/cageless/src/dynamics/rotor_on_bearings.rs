//! A rotor with linear lateral motion on the inner rings of several bearings, rigid along its axis.
//!
//! The state holds each bearing as if it were alone, with the motion of its journal in the place of
//! a rotor, then the rotor itself: normal coordinates u, θ and the displacement along the axis, their
//! rates, and the energy ledger of the rotor. Along the axis bearings in space alone act on it. The motion of a journal follows from u linearly, and every method here keeps
//! linear relations, so that the journals stay those of the rotor.

use std::sync::Arc;

use nalgebra::DVectorView;

use super::Model;
use super::coordinates::RotorCoordinate;
use super::energy::EnergyTerm;
use super::layout::Layout;
use super::plane_path::PlanePath;
use super::right_hand_side::{RightHandSide, mix};
use super::rotor_equations::{Motion, RotorEquations, RotorLoads, at};
use crate::integrator::{SecondOrderBlock, System};
use crate::linear_rotor::{Clearance, DVector, LinearRotor};
use crate::world::body::rotor::TABLE;

/// Term of the energy ledger of the rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotorEnergyTerm {
    /// Work of the inner rings on the journals.
    Journals,
    /// Work of gravity and of given loads along the axis.
    Weight,
    /// Work of the drive.
    Drive,
    /// Energy that the damping of the rotor, its cross-coupled stiffness and Ksdt take out.
    Loss,
}

/// The equations of motion of a rotor and all of its bearings.
pub(crate) struct RotorOnBearings<'m> {
    rotor: &'m LinearRotor,
    equations: RotorEquations<'m>,
    bearings: Vec<RightHandSide>,
    /// Places of each bearing.
    layouts: Vec<Layout>,
    /// Z of the rotor in each bearing at the start, m.
    axial_start: Vec<f64>,
    /// First place of the rotor.
    start: usize,
    blocks: Vec<SecondOrderBlock>,
    /// Path of the rotor in each of its planes so far.
    paths: Vec<PlanePath>,
}

/// Largest displacement of a rotor in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneDisplacement {
    /// The plane.
    pub clearance: Clearance,
    /// Largest distance of the axis of the rotor from the centre of the stator, m.
    pub displacement_max_m: f64,
    /// Path of the axis.
    pub path: PlanePath,
}

impl<'m> RotorOnBearings<'m> {
    /// The rotor on the bearings of `models`, one for each of its journals.
    pub(crate) fn new(rotor: &'m LinearRotor, loads: RotorLoads, models: &[Arc<Model>]) -> Self {
        let mut start = 0;
        let mut layouts = vec![];
        for model in models {
            layouts.push(model.layout.starting_at(start));
            start += model.layout.len();
        }
        let count = rotor.coordinates() + 2;
        let mut blocks: Vec<_> = (layouts.iter())
            .flat_map(Layout::second_order_blocks)
            .collect();
        blocks.push(SecondOrderBlock {
            positions: start,
            rates: start + count,
            count,
        });
        Self {
            rotor,
            equations: RotorEquations::new(rotor, loads),
            bearings: models.iter().map(RightHandSide::new).collect(),
            axial_start: vec![0.0; layouts.len()],
            layouts,
            start,
            blocks,
            paths: vec![PlanePath::default(); rotor.planes.len()],
        }
    }

    /// Places of bearing `k`.
    pub(crate) fn layout(&self, k: usize) -> Layout {
        self.layouts[k]
    }

    /// Sets the rotor in a state that holds the bearings, with speed and velocity along the axis: journals
    /// at these places with these velocities, in the shape that needs no force elsewhere.
    pub(crate) fn set_rotor(
        &mut self,
        y: &mut [f64],
        places: &[f64],
        velocities: &[f64],
        [speed, axial_speed]: [f64; 2],
    ) {
        for (start, layout) in self.axial_start.iter_mut().zip(&self.layouts) {
            *start = layout.at(y, RotorCoordinate::Z);
        }
        let n = self.rotor.coordinates();
        let shapes = &self.rotor.shapes;
        let u = shapes * DVector::from_column_slice(places);
        let rates = shapes * DVector::from_column_slice(velocities);
        let own = &mut y[self.start..];
        own[..n].copy_from_slice(u.as_slice());
        own[n..n + 2].fill(0.0);
        own[n + 2..2 * n + 2].copy_from_slice(rates.as_slice());
        own[2 * n + 2..2 * n + 4].copy_from_slice(&[speed, axial_speed]);
        self.place_journals(y);
    }

    fn motion<'y>(&self, y: &'y [f64]) -> Motion<'y> {
        let (n, own) = (self.rotor.coordinates(), &y[self.start..]);
        Motion {
            u: DVectorView::from_slice(&own[..n], n),
            rates: DVectorView::from_slice(&own[n + 2..2 * n + 2], n),
            angle: own[n],
            speed: own[2 * n + 2],
            axial_speed: own[2 * n + 3],
        }
    }

    /// Place of a term of the rotor's energy ledger.
    fn term(&self, term: RotorEnergyTerm) -> usize {
        self.start + 2 * self.rotor.coordinates() + 4 + term as usize
    }

    /// Writes the motion of the journals to the places of the bearings.
    fn place_journals(&self, y: &mut [f64]) {
        let n = self.rotor.coordinates();
        let journals = self.layouts.iter().zip(&self.rotor.journals);
        for ((layout, rows), axial_start) in journals.zip(&self.axial_start) {
            let [x_m, y_m] = at(rows, &y[self.start..]);
            let [angle, z_m] = [y[self.start + n], axial_start + y[self.start + n + 1]];
            layout.set(y, RotorCoordinate::X, x_m);
            layout.set(y, RotorCoordinate::Y, y_m);
            layout.set(y, RotorCoordinate::Angle, angle);
            layout.set(y, RotorCoordinate::Z, z_m);
        }
        self.place_journal_rates(y);
    }

    /// Writes the velocities of the journals to the places of the bearings in a state, the
    /// accelerations in its rate.
    fn place_journal_rates(&self, y: &mut [f64]) {
        let n = self.rotor.coordinates();
        let rates = self.start + n + 2;
        for (layout, rows) in self.layouts.iter().zip(&self.rotor.journals) {
            let [vx, vy] = at(rows, &y[rates..]);
            let [speed, vz] = [y[rates + n], y[rates + n + 1]];
            layout.set(y, RotorCoordinate::Vx, vx);
            layout.set(y, RotorCoordinate::Vy, vy);
            layout.set(y, RotorCoordinate::Speed, speed);
            layout.set(y, RotorCoordinate::Vz, vz);
        }
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
        self.equations.couple(&motion);
        self.equations.load(&motion);
        let mut journals = 0.0;
        for (k, bearing) in self.bearings.iter().enumerate() {
            let load = bearing.journal_load();
            self.equations.add_load(k, &load);
            journals += self.equations.power(k, &motion, &load);
        }
        let n = self.rotor.coordinates();
        let own = &mut dydt[self.start..];
        own[..n].copy_from_slice(motion.rates.as_slice());
        own[n..n + 2].copy_from_slice(&[motion.speed, motion.axial_speed]);
        let (acceleration, others) = self.equations.respond();
        own[n + 2..2 * n + 2].copy_from_slice(acceleration);
        own[2 * n + 2..2 * n + 4].copy_from_slice(&others);
        self.place_journal_rates(dydt);
        let [weight, drive, loss] = self.equations.powers(&motion, others[0]);
        for (term, power) in [
            (RotorEnergyTerm::Journals, journals),
            (RotorEnergyTerm::Weight, weight),
            (RotorEnergyTerm::Drive, drive),
            (RotorEnergyTerm::Loss, loss),
        ] {
            dydt[self.term(term)] = power;
        }
    }

    /// Kinetic and elastic energy of the rotor, J.
    pub(crate) fn rotor_energy_j(&mut self, y: &[f64]) -> f64 {
        let motion = self.motion(y);
        self.equations.energy_j(&motion)
    }

    /// What the rotor lacks to balance its ledger, and the sum of the absolute terms, J.
    pub(crate) fn rotor_residual_j(&mut self, start_energy_j: f64, y: &[f64]) -> (f64, f64) {
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
    pub(crate) fn look_at_planes(&mut self, y: &[f64]) {
        for (plane, path) in self.rotor.planes.iter().zip(&mut self.paths) {
            path.look(at(&plane.place, &y[self.start..]));
        }
    }

    /// The planes of the rotor with their largest displacements so far.
    pub(crate) fn planes(&self) -> Vec<PlaneDisplacement> {
        let planes = self.rotor.planes.iter().zip(&self.paths);
        planes
            .map(|(plane, path)| PlaneDisplacement {
                clearance: plane.clearance.clone(),
                displacement_max_m: path.farthest_distance_m(),
                path: path.clone(),
            })
            .collect()
    }

    /// The equations of bearing `k`.
    pub(crate) fn bearing(&self, k: usize) -> &RightHandSide {
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
        let rates = self.start + self.rotor.coordinates() + 2;
        for k in 0..self.bearings.len() {
            self.place_journals(y);
            let motion = self.motion(y);
            self.equations.couple(&motion);
            let compliance = self.equations.compliance(k);
            let places = span(&self.layouts[k]);
            let bearing = &mut self.bearings[k];
            bearing.set_journal_compliance(compliance);
            let (own0, own, rate) = (
                &y0[places.clone()],
                &mut y[places.clone()],
                &mut dydt[places],
            );
            bearing.add_stiff_part(h_s, own0, own, rate);
            let (u, others) = self.equations.respond_at(k, &bearing.friction_load());
            for (place, a) in (rates..).zip(u.iter().chain(&others)) {
                y[place] += h_s * a;
                dydt[place] += a;
            }
        }
        self.place_journals(y);
        self.place_journal_rates(dydt);
        // Work of friction on the journals, by the mean of the velocities at both ends.
        for (k, bearing) in self.bearings.iter().enumerate() {
            let load = bearing.friction_load();
            let [before, after] =
                [y0, &*y].map(|y| self.equations.power(k, &self.motion(y), &load));
            let power = 0.5 * (before + after);
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
        let scale = |c: RotorCoordinate| TABLE[c as usize].coordinate.error_scale;
        // A normal coordinate is a displacement times √m.
        let root = self.rotor.mass_kg().sqrt();
        let [place, rate] = [RotorCoordinate::X, RotorCoordinate::Vx].map(|c| root * scale(c));
        let lateral = (0..n).map(|k| (own[k] / place).powi(2) + (own[n + 2 + k] / rate).powi(2));
        let turning = (own[n] / scale(RotorCoordinate::Angle)).powi(2)
            + (own[2 * n + 2] / scale(RotorCoordinate::Speed)).powi(2);
        let along = (own[n + 1] / scale(RotorCoordinate::X)).powi(2)
            + (own[2 * n + 3] / scale(RotorCoordinate::Vx)).powi(2);
        let moving = n + 1 + usize::from(self.layouts.iter().any(|l| l.moves(RotorCoordinate::Z)));
        let sum = lateral.sum::<f64>() + turning + along;
        let rotor = (sum / (2 * moving) as f64).sqrt();
        let bearings = self.layouts.iter().map(|l| l.scaled_rms(difference));
        bearings.fold(rotor, f64::max)
    }
}
