//! A rotor with linear lateral motion in several bearings, rigid along its axis.
//!
//! Its coordinates q are the places of its journals, x and y of each in turn, then what moves no journal, θ and the
//! displacement along the axis. With the rows J of the journals over the normal coordinates u, their shapes H (J·H = 1)
//! and an orthonormal basis N of what moves no journal, u = S·q with S = [H, N], and q = T·u with
//! T = [J; Nᵀ·(1 − H·J)].

use nalgebra::DVectorView;

use super::linear_rotor_equations::{LinearRotorEquations, Motion, RotorLoads, at};
use super::rotor::{ROTOR, RotorCompliance, RotorCoordinate, TABLE};
use super::rotor_body::{RotorBody, RotorEnergyTerm};
use crate::dynamics::plane_path::{PlaneDisplacement, PlanePath};
use crate::integrator::SecondOrderBlock;
use crate::linear_rotor::{DMatrix, DVector, LinearRotor};
use crate::world::joint::TouchLoads;

/// A linear rotor in motion.
#[derive(Debug, Clone)]
pub(crate) struct LinearRotorBody {
    equations: LinearRotorEquations,
    /// S.
    to_normal: DMatrix<f64>,
    /// T.
    from_normal: DMatrix<f64>,
    /// u of the last state.
    u: DVector<f64>,
    /// u̇ of the last state.
    rates: DVector<f64>,
    /// Acceleration of q.
    acceleration: DVector<f64>,
    /// Path of the rotor in each of its planes so far.
    paths: Vec<PlanePath>,
}

/// Motion of the journals at the start.
#[derive(Debug, Clone, Default)]
pub(crate) struct JournalStart {
    /// x and y of each journal, m.
    pub places_m: Vec<f64>,
    /// ẋ and ẏ of each journal, m/s.
    pub velocities_m_s: Vec<f64>,
    /// z of the rotor, m.
    pub z_m: f64,
    /// Ω, rad/s.
    pub speed_rad_s: f64,
    /// ż of the rotor, m/s.
    pub axial_speed_m_s: f64,
}

/// S and T.
fn bases(rotor: &LinearRotor) -> [DMatrix<f64>; 2] {
    let (n, held) = (rotor.coordinates(), 2 * rotor.journals.len());
    let (mut to_normal, mut from_normal) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    let mut journals = from_normal.view_mut((0, 0), (held, n));
    for (k, rows) in rotor.journals.iter().enumerate() {
        journals.view_mut((2 * k, 0), (2, n)).copy_from(rows);
    }
    let journals = journals.clone_owned();
    let square = (journals.transpose() * &journals).symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| square.eigenvalues[*a].total_cmp(&square.eigenvalues[*b]));
    let beside = square.eigenvectors.select_columns(&order[..n - held]);
    let others = DMatrix::identity(n, n) - &rotor.shapes * &journals;
    to_normal.columns_mut(0, held).copy_from(&rotor.shapes);
    to_normal.columns_mut(held, n - held).copy_from(&beside);
    let rows = beside.transpose() * others;
    from_normal.rows_mut(held, n - held).copy_from(&rows);
    [to_normal, from_normal]
}

/// Motion at a state with these normal coordinates.
fn motion<'u>(u: &'u DVector<f64>, rates: &'u DVector<f64>, y: &[f64]) -> Motion<'u> {
    let n = u.len();
    Motion {
        u: u.as_view(),
        rates: rates.as_view(),
        angle: y[n],
        speed: y[2 * n + 2],
        axial_speed: y[2 * n + 3],
    }
}

impl LinearRotorBody {
    /// The rotor under loads beside those of its bearings.
    pub(crate) fn new(rotor: &LinearRotor, loads: RotorLoads) -> Self {
        let [to_normal, from_normal] = bases(rotor);
        let zeros = || DVector::zeros(rotor.coordinates());
        Self {
            to_normal,
            from_normal,
            u: zeros(),
            rates: zeros(),
            acceleration: zeros(),
            paths: vec![PlanePath::default(); rotor.planes.len()],
            equations: LinearRotorEquations::new(rotor.clone(), loads),
        }
    }

    fn coordinates(&self) -> usize {
        self.u.len()
    }

    /// First place of the rates.
    fn rates_start(&self) -> usize {
        self.coordinates() + 2
    }

    /// State with journals at given places and velocities, in the shape that needs no force elsewhere.
    pub(crate) fn at_start(&self, start: &JournalStart) -> Vec<f64> {
        let (n, rates, held) = (self.coordinates(), self.rates_start(), start.places_m.len());
        let mut y = vec![0.0; self.dimension()];
        y[..held].copy_from_slice(&start.places_m);
        y[n + 1] = start.z_m;
        y[rates..rates + held].copy_from_slice(&start.velocities_m_s);
        y[rates + n..2 * rates].copy_from_slice(&[start.speed_rad_s, start.axial_speed_m_s]);
        y
    }

    /// Changes to normal coordinates.
    fn normal(&mut self, y: &[f64]) {
        let (n, rates) = (self.coordinates(), self.rates_start());
        let of = |from: usize| DVectorView::from_slice(&y[from..from + n], n);
        self.u.gemv(1.0, &self.to_normal, &of(0), 0.0);
        self.rates.gemv(1.0, &self.to_normal, &of(rates), 0.0);
    }
}

impl RotorBody for LinearRotorBody {
    fn dimension(&self) -> usize {
        2 * self.rates_start() + RotorEnergyTerm::ALL.len()
    }

    fn places(&self, k: usize) -> [usize; ROTOR] {
        let (n, rates) = (self.coordinates(), self.rates_start());
        let positions = [2 * k, 2 * k + 1, n, n + 1];
        std::array::from_fn(|c| match positions.get(c) {
            Some(place) => *place,
            None => rates + positions[c - positions.len()],
        })
    }

    fn energy_term(&self, term: RotorEnergyTerm, _k: usize) -> usize {
        2 * self.rates_start() + term as usize
    }

    fn second_order_block(&self) -> SecondOrderBlock {
        let count = self.rates_start();
        SecondOrderBlock {
            positions: 0,
            rates: count,
            count,
        }
    }

    fn set_rates(&mut self, y: &[f64], loads: &[TouchLoads], dydt: &mut [f64]) {
        let (n, rates) = (self.coordinates(), self.rates_start());
        self.normal(y);
        let motion = motion(&self.u, &self.rates, y);
        self.equations.couple(&motion);
        self.equations.load(&motion);
        let mut journals = 0.0;
        for (k, loads) in loads.iter().enumerate() {
            self.equations.add_load(k, loads);
            journals += self.equations.power(k, &motion, loads);
        }
        dydt[..rates].copy_from_slice(&y[rates..2 * rates]);
        let (u, [spin, axial]) = self.equations.respond();
        self.acceleration.gemv(1.0, &self.from_normal, u, 0.0);
        dydt[rates..rates + n].copy_from_slice(self.acceleration.as_slice());
        dydt[rates + n..2 * rates].copy_from_slice(&[spin, axial]);
        let [weight, drive, loss] = self.equations.powers(&motion, spin);
        for (term, power) in [
            (RotorEnergyTerm::Journals, journals),
            (RotorEnergyTerm::Weight, weight),
            (RotorEnergyTerm::Drive, drive),
            (RotorEnergyTerm::Loss, loss),
        ] {
            dydt[self.energy_term(term, 0)] = power;
        }
    }

    fn compliance(&mut self, y: &[f64], k: usize) -> RotorCompliance {
        self.normal(y);
        self.equations.couple(&motion(&self.u, &self.rates, y));
        self.equations.compliance(k)
    }

    fn add_loads(
        &mut self,
        k: usize,
        loads: &TouchLoads,
        h_s: f64,
        y: &mut [f64],
        dydt: &mut [f64],
    ) {
        let rates = self.rates_start();
        let (u, others) = self.equations.respond_at(k, loads);
        self.acceleration.gemv(1.0, &self.from_normal, u, 0.0);
        for (place, a) in (rates..).zip(self.acceleration.iter().chain(&others)) {
            y[place] += h_s * a;
            dydt[place] += a;
        }
    }

    fn energy_j(&self, y: &[f64], _k: usize) -> f64 {
        let (n, rates) = (self.coordinates(), self.rates_start());
        let normal = |from: usize| &self.to_normal * DVectorView::from_slice(&y[from..from + n], n);
        self.equations
            .energy_j(&motion(&normal(0), &normal(rates), y))
    }

    fn set_drive_torque(&mut self, torque_n_m: f64) {
        self.equations.loads.drive_torque = torque_n_m;
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        let (n, rates) = (self.coordinates(), self.rates_start());
        let scale = |c: RotorCoordinate| TABLE[c as usize].coordinate.error_scale;
        // A normal coordinate is a displacement times √m.
        let root = self.equations.rotor.mass_kg.sqrt();
        let normal = |from: usize, c: RotorCoordinate| {
            let own = DVectorView::from_slice(&difference[from..from + n], n);
            (&self.to_normal * own).norm_squared() / (root * scale(c)).powi(2)
        };
        let of = |place: usize, c: RotorCoordinate| (difference[place] / scale(c)).powi(2);
        let sum = normal(0, RotorCoordinate::X)
            + normal(rates, RotorCoordinate::Vx)
            + of(n, RotorCoordinate::Angle)
            + of(rates + n, RotorCoordinate::Speed)
            + of(n + 1, RotorCoordinate::Z)
            + of(rates + n + 1, RotorCoordinate::Vz);
        (sum / (2 * rates) as f64).sqrt()
    }

    fn look(&mut self, y: &[f64]) {
        self.normal(y);
        for (plane, path) in self.equations.rotor.planes.iter().zip(&mut self.paths) {
            path.look(at(&plane.place, self.u.as_slice()));
        }
    }

    fn planes(&self) -> Vec<PlaneDisplacement> {
        let planes = self.equations.rotor.planes.iter().zip(&self.paths);
        planes
            .map(|(plane, path)| PlaneDisplacement {
                clearance: plane.clearance.clone(),
                displacement_max_m: path.farthest_distance_m(),
                path_m: path.points_m.clone(),
                farthest_m: path.farthest_m,
            })
            .collect()
    }
}
