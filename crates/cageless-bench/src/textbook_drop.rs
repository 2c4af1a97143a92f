//! The equations of a drop as one writes them down first: scalar, ball by ball, contact by
//! contact, smooth friction, linear contact of rotor and inner ring; and the classical
//! Runge–Kutta method.
//!
//! Not slowed down on purpose, see [`crate::textbook`].

use anyhow::{Context, Result};
use cageless::contact::restitution_damping;
use cageless::dynamics::ball::BallMotion;
use cageless::dynamics::state::State;
use cageless::{Case, Raceway, Rotor, Support};

/// Constants of one drop.
#[derive(Debug, Clone)]
pub struct TextbookDrop {
    raceways: Vec<Raceway>,
    balls: usize,
    ball_radius: f64,
    outer_orbit_radius: f64,
    inner_radius: f64,
    ball_mass: f64,
    ball_inertia: f64,
    ring_mass: f64,
    ring_inertia: f64,
    bore_radius: f64,
    gravity: f64,
    stiffness: [f64; 3],
    damping: f64,
    ball_damping: f64,
    friction: f64,
    slip_scale: f64,
    rotor: Rotor,
    support: Support,
}

/// Scales of errors: of a ball, and of ring, outer ring and rotor as in [`TextbookDrop::state`].
const BALL_SCALES: [f64; 5] = [1e-5, 1e-5, 1.0, 1.0, 200.0];
const BODY_SCALES: [f64; 15] = [
    1e-5, 1e-5, 0.1, 0.1, 1.0, 1e-5, 1e-5, 0.1, 0.1, 1e-5, 1e-5, 0.1, 0.1, 1e-3, 1.0,
];

impl TextbookDrop {
    /// Model of `case`, which has a rotor and a support.
    ///
    /// # Errors
    /// The case has none.
    pub fn new(case: &Case) -> Result<Self> {
        let (bearing, contact) = (&case.bearing, &case.contact);
        let d = bearing.dimensions();
        let bore = bearing.inner_ring_bore().context("a bore")?;
        let stiffness = case.stiffness_n_m1_5();
        let ball_mass = bearing.ball_mass_kg();
        Ok(Self {
            raceways: case.raceways.clone(),
            balls: d.balls,
            ball_radius: d.ball_radius_m,
            outer_orbit_radius: bearing.outer_orbit_radius_m(),
            inner_radius: d.inner_groove_bottom_radius_m,
            ball_mass,
            ball_inertia: bearing.ball_inertia_kg_m2(),
            ring_mass: d.inner_ring_mass_kg,
            ring_inertia: bore.polar_inertia_kg_m2,
            bore_radius: bore.radius_m,
            gravity: case.operation.gravity_m_s2,
            stiffness,
            damping: contact.damping_n_s_m1_5,
            ball_damping: restitution_damping(contact.ball_restitution)
                * (ball_mass / 2.0 * stiffness[2]).sqrt(),
            friction: contact.friction_coefficient,
            slip_scale: contact.slip_scale_m_s,
            rotor: case.rotor.clone().context("a rotor")?,
            support: case.support.clone().context("a support")?,
        })
    }

    /// x of every ball, y, vx, vy, spin; ring x, y, vx, vy, speed; outer ring x, y, vx, vy; rotor
    /// x, y, vx, vy, angle, speed.
    pub fn state(&self, state: &State) -> Result<Vec<f64>> {
        let n = self.balls;
        let mut values = vec![0.0; 5 * n];
        for k in 0..n {
            let BallMotion { x, y, vx, vy, spin } = state.ball_motion(k);
            for (group, value) in [x, y, vx, vy, spin].into_iter().enumerate() {
                values[group * n + k] = value;
            }
        }
        let (ring, outer) = (state.ring_motion(), state.outer_ring_motion());
        let rotor = state.rotor_motion().context("a rotor")?;
        let speed = state.ring_speed_rad_s().context("a rotor")?;
        values.extend([ring.x, ring.y, ring.vx, ring.vy, speed]);
        values.extend([outer.x, outer.y, outer.vx, outer.vy]);
        values.extend([
            rotor.x,
            rotor.y,
            rotor.vx,
            rotor.vy,
            rotor.angle,
            rotor.speed,
        ]);
        Ok(values)
    }

    /// RMS over the states of a difference in the scales of the coordinates.
    pub fn error(&self, one: &[f64], other: &[f64]) -> f64 {
        let n = self.balls;
        let scale = |k: usize| {
            if k < 5 * n {
                BALL_SCALES[k / n]
            } else {
                BODY_SCALES[k - 5 * n]
            }
        };
        let squares = one.iter().zip(other).enumerate();
        let sum: f64 = squares
            .map(|(k, (a, b))| ((a - b) / scale(k)).powi(2))
            .sum();
        (sum / one.len() as f64).sqrt()
    }

    fn effective_radius(&self, x: f64, y: f64) -> f64 {
        let angle = x.atan2(-y);
        for raceway in &self.raceways {
            let local = raceway.local_angle_rad(angle);
            if local.abs() >= raceway.half_angle_rad() {
                continue;
            }
            let (sin, cos) = local.sin_cos();
            let mut path_x = (self.outer_orbit_radius + self.ball_radius) * sin;
            for _ in 0..20 {
                let value = path_x * cos + raceway.path_y_m(path_x) * sin;
                let step = value / (cos + raceway.path_slope(path_x) * sin);
                path_x -= step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            return raceway.effective_radius_at_x_m(path_x);
        }
        self.ball_radius
    }

    fn friction(&self, slip: f64, normal: f64) -> f64 {
        self.friction * (slip / self.slip_scale).tanh() * normal
    }

    /// f(y).
    pub fn derivative(&self, state: &[f64], rate: &mut [f64]) {
        let n = self.balls;
        let [x, y, vx, vy, spin] = std::array::from_fn(|group| &state[group * n..][..n]);
        let bodies = &state[5 * n..];
        let (ring, ring_speed, outer, rotor) =
            (&bodies[..4], bodies[4], &bodies[5..9], &bodies[9..]);
        let (velocities, rest) = rate.split_at_mut(2 * n);
        velocities[..n].copy_from_slice(vx);
        velocities[n..].copy_from_slice(vy);
        let (fx, rest) = rest.split_at_mut(n);
        let (fy, rest) = rest.split_at_mut(n);
        let (torque, body_rate) = rest.split_at_mut(n);
        let (mut ring_force, mut outer_force, mut ring_torque) = ([0.0; 2], [0.0; 2], 0.0);
        for j in 0..n {
            fx[j] = 0.0;
            fy[j] = -self.ball_mass * self.gravity;
            torque[j] = 0.0;
            let (dx, dy) = (x[j] - outer[0], y[j] - outer[1]);
            let rho = (dx * dx + dy * dy).sqrt();
            let deflection = rho - self.outer_orbit_radius;
            if deflection > 0.0 {
                let (ex, ey) = (dx / rho, dy / rho);
                let (ux, uy) = (vx[j] - outer[2], vy[j] - outer[3]);
                let tangential = uy * ex - ux * ey;
                let root = deflection.sqrt();
                let approach = ux * ex + uy * ey;
                let force = (self.stiffness[1] * deflection * root
                    + self.damping * root * approach)
                    .max(0.0);
                let r = self.effective_radius(dx, dy);
                let friction =
                    self.friction(tangential - spin[j] * r, force * self.ball_radius / r);
                let (px, py) = (-force * ex + friction * ey, -force * ey - friction * ex);
                fx[j] += px;
                fy[j] += py;
                torque[j] += r * friction;
                outer_force[0] -= px;
                outer_force[1] -= py;
            }
            let (dx, dy) = (x[j] - ring[0], y[j] - ring[1]);
            let distance = (dx * dx + dy * dy).sqrt();
            let deflection = self.inner_radius + self.ball_radius - distance;
            if deflection > 0.0 {
                let (ex, ey) = (dx / distance, dy / distance);
                let (ux, uy) = (vx[j] - ring[2], vy[j] - ring[3]);
                let tangential = uy * ex - ux * ey;
                let root = deflection.sqrt();
                let approach = -(ux * ex + uy * ey);
                let force = (self.stiffness[0] * deflection * root
                    + self.damping * root * approach)
                    .max(0.0);
                let slip =
                    ring_speed * self.inner_radius - (tangential + spin[j] * self.ball_radius);
                let friction = self.friction(slip, force);
                let (px, py) = (force * ex - friction * ey, force * ey + friction * ex);
                fx[j] += px;
                fy[j] += py;
                torque[j] += self.ball_radius * friction;
                ring_force[0] -= px;
                ring_force[1] -= py;
                ring_torque -= self.inner_radius * friction;
            }
        }
        for j in 0..n {
            let k = (j + 1) % n;
            let (dx, dy) = (x[k] - x[j], y[k] - y[j]);
            let distance = (dx * dx + dy * dy).sqrt();
            let deflection = 2.0 * self.ball_radius - distance;
            if deflection > 0.0 {
                let (ux, uy) = (dx / distance, dy / distance);
                let (wx, wy) = (vx[j] - vx[k], vy[j] - vy[k]);
                let root = deflection.sqrt();
                let approach = wx * ux + wy * uy;
                let force = (self.stiffness[2] * deflection * root
                    + self.ball_damping * root.sqrt() * approach)
                    .max(0.0);
                let slip = wy * ux - wx * uy - (spin[j] + spin[k]) * self.ball_radius;
                let friction = self.friction(slip, force);
                let (px, py) = (-force * ux + friction * uy, -force * uy - friction * ux);
                fx[j] += px;
                fy[j] += py;
                fx[k] -= px;
                fy[k] -= py;
                torque[j] += self.ball_radius * friction;
                torque[k] += self.ball_radius * friction;
            }
        }
        for j in 0..n {
            fx[j] /= self.ball_mass;
            fy[j] /= self.ball_mass;
            torque[j] /= self.ball_inertia;
        }
        let [force, moment, friction_torque] = self.journal(ring, ring_speed, rotor);
        let (mass, support) = (self.ring_mass, &self.support);
        body_rate.copy_from_slice(&[
            ring[2],
            ring[3],
            (ring_force[0] - force[0]) / mass,
            (ring_force[1] - force[1]) / mass - self.gravity,
            (ring_torque + friction_torque[0]) / self.ring_inertia,
            outer[2],
            outer[3],
            (outer_force[0] - support.stiffness_n_m * outer[0] - support.damping_n_s_m * outer[2])
                / support.mass_kg,
            (outer_force[1] - support.stiffness_n_m * outer[1] - support.damping_n_s_m * outer[3])
                / support.mass_kg,
            rotor[2],
            rotor[3],
            force[0] / self.rotor.mass_kg,
            force[1] / self.rotor.mass_kg - self.gravity,
            rotor[5],
            (moment[0] + self.rotor.drive_torque_n_m) / self.rotor.polar_inertia_kg_m2,
        ]);
    }

    /// Force on the rotor, its moment about the mass centre, and the torque on the inner ring.
    fn journal(&self, ring: &[f64], ring_speed: f64, rotor: &[f64]) -> [[f64; 2]; 3] {
        let r = &self.rotor;
        let (sin, cos) = (rotor[4] + r.eccentricity_phase_rad).sin_cos();
        let (ex, ey) = (r.eccentricity_m * cos, r.eccentricity_m * sin);
        let (dx, dy) = (rotor[0] - ex - ring[0], rotor[1] - ey - ring[1]);
        let distance = (dx * dx + dy * dy).sqrt();
        let depth = distance - r.air_gap_m;
        if depth <= 0.0 {
            return [[0.0; 2]; 3];
        }
        let (nx, ny) = (dx / distance, dy / distance);
        let (ux, uy) = (
            rotor[2] + rotor[5] * ey - ring[2],
            rotor[3] - rotor[5] * ex - ring[3],
        );
        let approach = ux * nx + uy * ny;
        let normal = (r.contact_stiffness
            * depth.powf(r.contact_exponent)
            * (1.0 + 1.5 * r.contact_damping_s_m * approach))
            .max(0.0);
        let journal = self.bore_radius - r.air_gap_m;
        let slip = uy * nx - ux * ny + rotor[5] * journal - ring_speed * self.bore_radius;
        let friction = r.friction_coefficient * (slip / r.slip_scale_m_s).tanh() * normal;
        let force = [-normal * nx + friction * ny, -normal * ny - friction * nx];
        let (ax, ay) = (journal * nx - ex, journal * ny - ey);
        let moment = ax * force[1] - ay * force[0];
        [force, [moment; 2], [friction * self.bore_radius; 2]]
    }

    /// The classical Runge–Kutta method of order 4 from `state` over `steps` steps of `step_s`.
    pub fn runge_kutta(&self, state: &mut [f64], step_s: f64, steps: u64) {
        let size = state.len();
        let mut stages = vec![vec![0.0; size]; 4];
        let mut trial = vec![0.0; size];
        for _ in 0..steps {
            self.derivative(state, &mut stages[0]);
            for (stage, part) in [(1, 0.5), (2, 0.5), (3, 1.0)] {
                for k in 0..size {
                    trial[k] = state[k] + part * step_s * stages[stage - 1][k];
                }
                self.derivative(&trial, &mut stages[stage]);
            }
            for k in 0..size {
                let slope = stages[0][k] + 2.0 * (stages[1][k] + stages[2][k]) + stages[3][k];
                state[k] += step_s / 6.0 * slope;
            }
        }
    }
}
