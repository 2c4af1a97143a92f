//! The equations of motion as one writes them down first: scalar, ball by ball, contact
//! by contact, in the order of Zhao 2022, Eq. (12) to (22), `physical` profile and smooth
//! law.
//!
//! Not slowed down on purpose: contacts that carry nothing are skipped, each pair of
//! neighbours is looked at once, and the effective radius takes a few Newton steps on
//! the contact path, Eq. (4), and no general root finder.

use cageless::contact::restitution_damping;
use cageless::{Case, Raceway};

/// Constants of one case.
#[derive(Debug, Clone)]
pub struct Textbook {
    raceways: Vec<Raceway>,
    balls: usize,
    ball_radius: f64,
    outer_orbit_radius: f64,
    inner_radius: f64,
    ball_mass: f64,
    ball_inertia: f64,
    ring_mass: f64,
    ring_drag: f64,
    inner_speed: f64,
    radial_load: f64,
    gravity: f64,
    /// K at the inner raceway, at the outer raceway, between balls.
    stiffness: [f64; 3],
    damping: f64,
    ball_damping: f64,
    friction: f64,
    slip_scale: f64,
}

/// Newton steps until the abscissa stands still; three or four are usual.
const NEWTON_MAX: u32 = 20;

impl Textbook {
    /// Of a case in the `physical` profile with the smooth law of friction.
    pub fn new(case: &Case) -> Self {
        let (bearing, contact) = (&case.bearing, &case.contact);
        let d = bearing.dimensions();
        let stiffness = case.stiffness_n_m1_5();
        let ball_mass = bearing.ball_mass_kg();
        Self {
            raceways: case.raceways.clone(),
            balls: d.balls,
            ball_radius: d.ball_radius_m,
            outer_orbit_radius: bearing.outer_orbit_radius_m(),
            inner_radius: d.inner_groove_bottom_radius_m,
            ball_mass,
            ball_inertia: bearing.ball_inertia_kg_m2(),
            ring_mass: d.inner_ring_mass_kg,
            ring_drag: d.inner_ring_drag_n_s_m,
            inner_speed: case.operation.inner_speed_rad_s,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            stiffness,
            damping: contact.damping_n_s_m1_5,
            ball_damping: restitution_damping(contact.ball_restitution)
                * (ball_mass / 2.0 * stiffness[2]).sqrt(),
            friction: contact.friction_coefficient,
            slip_scale: contact.slip_scale_m_s,
        }
    }

    /// N.
    pub fn balls(&self) -> usize {
        self.balls
    }

    /// r, Eq. (6): x from tan ψ = x/(−y) with y = a x⁴ + b x² + c.
    fn effective_radius(&self, x: f64, y: f64) -> f64 {
        let angle = x.atan2(-y);
        for raceway in &self.raceways {
            let local = raceway.local_angle_rad(angle);
            if local.abs() >= raceway.half_angle_rad() {
                continue;
            }
            let (sin, cos) = local.sin_cos();
            let mut path_x = (self.outer_orbit_radius + self.ball_radius) * sin;
            for _ in 0..NEWTON_MAX {
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

    /// μ·tanh(ΔV/scale)·N.
    fn friction(&self, slip: f64, normal: f64) -> f64 {
        self.friction * (slip / self.slip_scale).tanh() * normal
    }

    /// f(y) in SI units: x of every ball, y, vx, vy, spin, then the ring.
    pub fn derivative(&self, state: &[f64], rate: &mut [f64]) {
        let n = self.balls;
        let [x, y, vx, vy, spin] = std::array::from_fn(|group| &state[group * n..][..n]);
        let ring = &state[5 * n..5 * n + 4];
        let (velocities, rest) = rate.split_at_mut(2 * n);
        velocities[..n].copy_from_slice(vx);
        velocities[n..].copy_from_slice(vy);
        let (fx, rest) = rest.split_at_mut(n);
        let (fy, rest) = rest.split_at_mut(n);
        let (torque, ring_rate) = rest.split_at_mut(n);
        let (mut ring_fx, mut ring_fy) = (0.0, 0.0);
        for j in 0..n {
            fx[j] = 0.0;
            fy[j] = -self.ball_mass * self.gravity;
            torque[j] = 0.0;
            // Outer raceway, Eq. (18), (19), (22).
            let rho = (x[j] * x[j] + y[j] * y[j]).sqrt();
            let deflection = rho - self.outer_orbit_radius;
            if deflection > 0.0 {
                let (ex, ey) = (x[j] / rho, y[j] / rho);
                let tangential = vy[j] * ex - vx[j] * ey;
                let root = deflection.sqrt();
                let rate = vx[j] * ex + vy[j] * ey;
                let force =
                    (self.stiffness[1] * deflection * root + self.damping * root * rate).max(0.0);
                let r = self.effective_radius(x[j], y[j]);
                let slip = tangential - spin[j] * r;
                let friction = self.friction(slip, force * self.ball_radius / r);
                fx[j] += -force * ex + friction * ey;
                fy[j] += -force * ey - friction * ex;
                torque[j] += r * friction;
            }
            // Inner raceway, Eq. (16), (20).
            let (dx, dy) = (x[j] - ring[0], y[j] - ring[1]);
            let distance = (dx * dx + dy * dy).sqrt();
            let deflection = self.inner_radius + self.ball_radius - distance;
            if deflection > 0.0 {
                let (ex, ey) = (dx / distance, dy / distance);
                let (ux, uy) = (vx[j] - ring[2], vy[j] - ring[3]);
                let tangential = uy * ex - ux * ey;
                let root = deflection.sqrt();
                let rate = -(ux * ex + uy * ey);
                let force =
                    (self.stiffness[0] * deflection * root + self.damping * root * rate).max(0.0);
                let slip = self.inner_speed * self.inner_radius
                    - (tangential + spin[j] * self.ball_radius);
                let friction = self.friction(slip, force);
                let (px, py) = (force * ex - friction * ey, force * ey + friction * ex);
                fx[j] += px;
                fy[j] += py;
                torque[j] += self.ball_radius * friction;
                ring_fx -= px;
                ring_fy -= py;
            }
        }
        // Neighbours, Eq. (17), (21).
        for j in 0..n {
            let k = (j + 1) % n;
            let (dx, dy) = (x[k] - x[j], y[k] - y[j]);
            let distance = (dx * dx + dy * dy).sqrt();
            let deflection = 2.0 * self.ball_radius - distance;
            if deflection > 0.0 {
                let (ux, uy) = (dx / distance, dy / distance);
                let (wx, wy) = (vx[j] - vx[k], vy[j] - vy[k]);
                let root = deflection.sqrt();
                let rate = wx * ux + wy * uy;
                let force = (self.stiffness[2] * deflection * root
                    + self.ball_damping * root.sqrt() * rate)
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
        ring_rate[0] = ring[2];
        ring_rate[1] = ring[3];
        ring_rate[2] = (ring_fx - self.ring_drag * ring[2]) / self.ring_mass;
        ring_rate[3] =
            (ring_fy - self.ring_drag * ring[3] - self.radial_load) / self.ring_mass - self.gravity;
    }
}
