//! Equations of motion of a linear rotor in its normal coordinates u.

use nalgebra::{DVectorView, Vector2};

use super::rotor::RotorCompliance;
use crate::linear_rotor::{DMatrix, DVector, LinearRotor};
use crate::world::joint::TouchLoads;

/// Loads on a linear rotor beside those of its bearings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotorLoads {
    /// g, m/s², along −Y.
    pub gravity: f64,
    /// Weight and given load along +Z, N.
    pub axial: f64,
    /// Torque of the drive, N·m.
    pub drive_torque: f64,
}

/// Motion of the rotor at one instant.
pub(super) struct Motion<'y> {
    pub u: DVectorView<'y, f64>,
    pub rates: DVectorView<'y, f64>,
    pub angle: f64,
    pub speed: f64,
    pub axial_speed: f64,
}

/// Acceleration of u, of the spin, and along the axis.
pub(super) type Response<'r> = (&'r DVector<f64>, [f64; 2]);

/// The equations with what they were evaluated to last:
/// ü + (b + Ksdt·u)·Ω̇ = f, Ip·Ω̇ + bᵀ·ü = τ and m·z̈ = Fz.
#[derive(Debug, Clone)]
pub(super) struct LinearRotorEquations {
    pub rotor: LinearRotor,
    pub loads: RotorLoads,
    /// b = Σ Uj·i·e^(i(θ+φj)) at the places of the unbalances, over u.
    unbalance: DVector<f64>,
    /// b + Ksdt·u.
    spin_up: DVector<f64>,
    /// Ip − bᵀ·(b + Ksdt·u): what a torque turns where bending follows freely.
    inertia: f64,
    /// f, τ and Fz.
    forces: DVector<f64>,
    torque: f64,
    axial: f64,
    products: [DVector<f64>; 2],
}

/// x and y of a place on the rotor, or of its velocity.
pub(super) fn at(rows: &DMatrix<f64>, u: &[f64]) -> [f64; 2] {
    let parts = rows.as_slice().chunks_exact(2).zip(u);
    let parts = parts.map(|(row, u)| [row[0] * u, row[1] * u]);
    parts
        .reduce(|[x, y], [dx, dy]| [x + dx, y + dy])
        .unwrap_or_default()
}

impl LinearRotorEquations {
    /// The equations of a rotor under loads.
    pub(super) fn new(rotor: LinearRotor, loads: RotorLoads) -> Self {
        let n = rotor.coordinates();
        let zeros = || DVector::zeros(n);
        Self {
            rotor,
            loads,
            unbalance: zeros(),
            spin_up: zeros(),
            inertia: 0.0,
            forces: zeros(),
            torque: 0.0,
            axial: 0.0,
            products: [zeros(), zeros()],
        }
    }

    /// Sets the coupling of bending and spin.
    pub(super) fn couple(&mut self, motion: &Motion<'_>) {
        self.unbalance.fill(0.0);
        for unbalance in &self.rotor.unbalances {
            let (sin, cos) = (motion.angle + unbalance.phase_rad).sin_cos();
            let direction = Vector2::new(-sin, cos) * unbalance.moment_kg_m;
            self.unbalance
                .gemv_tr(1.0, &unbalance.place, &direction, 1.0);
        }
        self.spin_up.gemv(1.0, &self.rotor.spin_up, &motion.u, 0.0);
        self.spin_up += &self.unbalance;
        self.inertia = self.rotor.polar_inertia_kg_m2 - self.unbalance.dot(&self.spin_up);
    }

    /// Sets forces and torque to those of everything but the bearings.
    pub(super) fn load(&mut self, motion: &Motion<'_>) {
        let (r, loads, forces) = (&self.rotor, &self.loads, &mut self.forces);
        forces.copy_from(&r.lift);
        *forces *= -loads.gravity;
        forces.gemv(-1.0, &r.damping, &motion.rates, 1.0);
        forces.gemv(-motion.speed, &r.gyroscopic, &motion.rates, 1.0);
        forces.gemv(-1.0, &r.stiffness, &motion.u, 1.0);
        (self.torque, self.axial) = (loads.drive_torque, loads.axial);
        for unbalance in &r.unbalances {
            let (sin, cos) = (motion.angle + unbalance.phase_rad).sin_cos();
            let outwards =
                Vector2::new(cos, sin) * (unbalance.moment_kg_m * motion.speed * motion.speed);
            forces.gemv_tr(1.0, &unbalance.place, &outwards, 1.0);
            self.torque -= unbalance.moment_kg_m * loads.gravity * cos;
        }
    }

    /// Adds a load on journal `k`.
    pub(super) fn add_load(&mut self, k: usize, loads: &TouchLoads) {
        let [x, y, z] = loads.force;
        self.forces
            .gemv_tr(1.0, &self.rotor.journals[k], &Vector2::new(x, y), 1.0);
        self.torque += loads.moment;
        self.axial += z;
    }

    /// Accelerations under the loads.
    pub(super) fn respond(&mut self) -> Response<'_> {
        let speed = (self.torque - self.unbalance.dot(&self.forces)) / self.inertia;
        self.forces.axpy(-speed, &self.spin_up, 1.0);
        let axial = self.axial / self.rotor.mass_kg;
        (&self.forces, [speed, axial])
    }

    /// Accelerations under a load on journal `k` alone.
    pub(super) fn respond_at(&mut self, k: usize, load: &TouchLoads) -> Response<'_> {
        self.forces.fill(0.0);
        (self.torque, self.axial) = (0.0, 0.0);
        self.add_load(k, load);
        self.respond()
    }

    /// Response of journal `k` to unit loads across the axis, about it and along it.
    pub(super) fn compliance(&mut self, k: usize) -> RotorCompliance {
        let mut loads = [TouchLoads::default(); 3];
        (loads[0].force[0], loads[1].force[1], loads[2].moment) = (1.0, 1.0, 1.0);
        let mut lateral = [[0.0; 3]; 3];
        for (column, load) in loads.iter().enumerate() {
            let (_, [spin, _]) = self.respond_at(k, load);
            let [x, y] = at(&self.rotor.journals[k], self.forces.as_slice());
            for (row, value) in lateral.iter_mut().zip([x, y, spin]) {
                row[column] = value;
            }
        }
        RotorCompliance::Bending {
            lateral,
            axial: 1.0 / self.rotor.mass_kg,
        }
    }

    /// Power of a load on journal `k`, W.
    pub(super) fn power(&self, k: usize, motion: &Motion<'_>, loads: &TouchLoads) -> f64 {
        let rate = at(&self.rotor.journals[k], motion.rates.as_slice());
        let [x, y, z] = loads.force;
        x * rate[0] + y * rate[1] + loads.moment * motion.speed + z * motion.axial_speed
    }

    /// Powers of weight with given load and of the drive, and what damping, cross-coupled stiffness and Ksdt take out, W,
    /// with an acceleration of the spin.
    pub(super) fn powers(&mut self, motion: &Motion<'_>, spin: f64) -> [f64; 3] {
        let (r, gravity) = (&self.rotor, self.loads.gravity);
        let mut weight =
            -gravity * r.lift.dot(&motion.rates) + self.loads.axial * motion.axial_speed;
        for unbalance in &r.unbalances {
            let cos = (motion.angle + unbalance.phase_rad).cos();
            weight -= unbalance.moment_kg_m * gravity * cos * motion.speed;
        }
        // Of K the antisymmetric part alone: the symmetric one stores what it takes.
        let [first, second] = &mut self.products;
        first.gemv(1.0, &r.stiffness, &motion.u, 0.0);
        second.gemv(1.0, &r.stiffness, &motion.rates, 0.0);
        let circulatory = 0.5 * (motion.rates.dot(first) - motion.u.dot(second));
        first.gemv(1.0, &r.damping, &motion.rates, 0.0);
        second.gemv(1.0, &r.spin_up, &motion.u, 0.0);
        first.axpy(spin, second, 1.0);
        [
            weight,
            self.loads.drive_torque * motion.speed,
            first.dot(&motion.rates) + circulatory,
        ]
    }

    /// Kinetic and elastic energy, J.
    pub(super) fn energy_j(&self, motion: &Motion<'_>) -> f64 {
        let rates = motion.rates.as_slice();
        let coupling = self.rotor.unbalances.iter().map(|unbalance| {
            let (sin, cos) = (motion.angle + unbalance.phase_rad).sin_cos();
            let [vx, vy] = at(&unbalance.place, rates);
            unbalance.moment_kg_m * (cos * vy - sin * vx)
        });
        0.5 * motion.rates.norm_squared()
            + motion.speed * coupling.sum::<f64>()
            + 0.5 * self.rotor.polar_inertia_kg_m2 * motion.speed * motion.speed
            + 0.5 * self.rotor.mass_kg * motion.axial_speed * motion.axial_speed
            + 0.5 * motion.u.dot(&(&self.rotor.stiffness * motion.u))
    }
}
