//! The equations of motion as one writes them down first: scalar, ball by ball, contact by contact,
//! in the order of Zhao 2022, Eq. (12) to (22), `physical` formulation and smooth friction; of a drop
//! with the bodies of [`BodyKind::ALL`](crate::world::body::BodyKind::ALL).
//!
//! Not slowed down on purpose: contacts that carry nothing are skipped, each pair of neighbours is
//! looked at once, and the effective radius takes a few Newton steps on the contact path, Eq. (4),
//! and no general root finder.

use std::iter::repeat_n;

use crate::case::Case;
use crate::contact::restitution_damping;
use crate::dynamics::coordinates::{BALL, BallCoordinate, RingCoordinate};
use crate::dynamics::layout::Layout;
use crate::numerics::vector::PlaneVector;
use crate::raceway::Raceway;
use crate::rotor::{Rotor, Support};
use crate::world::body::{BodyKind, Freedoms};

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
    regularisation_speed: f64,
    falling: Option<Falling>,
}

/// Constants of a rotor above the bearing.
#[derive(Debug, Clone)]
struct Falling {
    rotor: Rotor,
    support: Support,
    ring_inertia: f64,
    bore_radius: f64,
}

/// Newton steps until the abscissa stands still; three or four are usual.
const NEWTON_MAX: u32 = 20;

/// Force on the first of two bodies, and the friction in it.
struct Contact {
    force: PlaneVector,
    friction: f64,
}

/// Force and torque on the inner ring, and force on the outer ring.
#[derive(Default)]
struct RingLoads {
    inner: PlaneVector,
    inner_torque: f64,
    outer: PlaneVector,
}

/// Forces and torques on the balls.
struct BallLoads<'a> {
    fx: &'a mut [f64],
    fy: &'a mut [f64],
    torque: &'a mut [f64],
}

impl BallLoads<'_> {
    fn add(&mut self, j: usize, force: PlaneVector, torque: f64) {
        self.fx[j] += force.x;
        self.fy[j] += force.y;
        self.torque[j] += torque;
    }
}

/// Places, velocities and spins of the balls, of the inner ring and of the outer one.
struct Bodies<'a> {
    x: &'a [f64],
    y: &'a [f64],
    vx: &'a [f64],
    vy: &'a [f64],
    spin: &'a [f64],
    ring: &'a [f64],
    ring_speed: f64,
    outer: &'a [f64],
}

/// Motion of a body from another one.
struct Relative {
    place: PlaneVector,
    velocity: PlaneVector,
}

impl Bodies<'_> {
    /// Motion of a ball from the centre of a ring.
    fn from(&self, centre: &[f64], j: usize) -> Relative {
        Relative {
            place: PlaneVector {
                x: self.x[j] - centre[0],
                y: self.y[j] - centre[1],
            },
            velocity: PlaneVector {
                x: self.vx[j] - centre[2],
                y: self.vy[j] - centre[3],
            },
        }
    }

    /// Place of a ball from another one, and velocity of that one from the ball.
    fn neighbours(&self, one: usize, next: usize) -> Relative {
        Relative {
            place: PlaneVector {
                x: self.x[next] - self.x[one],
                y: self.y[next] - self.y[one],
            },
            velocity: PlaneVector {
                x: self.vx[one] - self.vx[next],
                y: self.vy[one] - self.vy[next],
            },
        }
    }
}

/// Scales of the errors of the coordinates of the bodies that move in the plane.
fn body_scales(layout: Layout) -> impl Iterator<Item = f64> {
    let in_plane = Freedoms {
        in_space: false,
        ..layout.freedoms()
    };
    let rows = BodyKind::ALL.into_iter().flat_map(BodyKind::table);
    let rows = rows.filter(move |row| row.moves(in_plane));
    rows.map(|row| row.coordinate.error_scale)
}

impl Textbook {
    /// The vector of these equations of values in a layout: x of every ball, then y, vx, vy and spin, then the
    /// bodies that move in the plane.
    pub fn motion(layout: Layout, values: &[f64]) -> Vec<f64> {
        let bodies = layout.ring(RingCoordinate::X);
        BallCoordinate::ALL
            .into_iter()
            .map(|coordinate| layout.array(coordinate))
            .flat_map(|start| &values[start..start + layout.balls])
            .chain(&values[bodies..bodies + body_scales(layout).count()])
            .copied()
            .collect()
    }

    /// Scale of the error of each entry of [`Self::motion`].
    pub fn scales(layout: Layout) -> Vec<f64> {
        let balls = BALL.iter();
        let balls = balls.flat_map(|c| repeat_n(c.error_scale, layout.balls));
        balls.chain(body_scales(layout)).collect()
    }

    /// The system of a case in the `physical` formulation with the smooth law of friction.
    pub fn new(case: &Case) -> Self {
        let (bearing, contact) = (&case.bearing, &case.contact);
        let d = bearing.dimensions();
        let stiffness = case.stiffness_n_m1_5();
        let ball_mass = bearing.ball_mass_kg();
        let bodies = (
            case.rotor.clone(),
            case.support.clone(),
            bearing.inner_ring_bore(),
        );
        Self {
            raceways: case.raceways.clone(),
            balls: d.balls,
            ball_radius: d.ball_radius_m,
            outer_orbit_radius: bearing.outer_orbit_radius_m(),
            inner_radius: d.inner_groove_bottom_radius_m,
            ball_mass,
            ball_inertia: bearing.ball_inertia_kg_m2(),
            ring_mass: d.inner_ring_mass_kg,
            ring_drag: d.inner_ring_damping_n_s_m,
            inner_speed: case.operation.inner_speed_rad_s,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            stiffness,
            damping: contact.damping_n_s_m1_5,
            ball_damping: restitution_damping(contact.ball_restitution)
                * (ball_mass / 2.0 * stiffness[2]).sqrt(),
            friction: contact.friction.coefficient,
            regularisation_speed: contact.friction.regularisation_speed_m_s,
            falling: match bodies {
                (Some(rotor), Some(support), Some(bore)) => Some(Falling {
                    rotor,
                    support,
                    ring_inertia: bore.polar_inertia_kg_m2,
                    bore_radius: bore.radius_m,
                }),
                _ => None,
            },
        }
    }

    /// r, Eq. (6): x from tan ψ = x/(−y) with y = a x⁴ + b x² + c.
    fn effective_radius(&self, x: f64, y: f64) -> f64 {
        let angle = x.atan2(-y);
        for raceway in &self.raceways {
            let local = raceway.local_angle_rad(angle);
            if local.abs() >= raceway.half_angle_rad() {
                continue;
            }
            let Some(path) = raceway.contact_path() else {
                return raceway.effective_radius_m(angle);
            };
            let (sin, cos) = local.sin_cos();
            let mut path_x = (self.outer_orbit_radius + self.ball_radius) * sin;
            for _ in 0..NEWTON_MAX {
                let value = path_x * cos + path.y_m(path_x) * sin;
                let step = value / (cos + path.slope(path_x) * sin);
                path_x -= step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            return path.effective_radius_at_x_m(path_x);
        }
        self.ball_radius
    }

    /// μ·tanh(ΔV/scale)·N.
    fn friction(&self, slip: f64, normal: f64) -> f64 {
        self.friction * (slip / self.regularisation_speed).tanh() * normal
    }

    /// Outer raceway, Eq. (18), (19), (22): motion from the ring's centre.
    fn outer(&self, motion: &Relative, spin: f64) -> Option<(Contact, f64)> {
        let PlaneVector { x, y } = motion.place;
        let PlaneVector { x: vx, y: vy } = motion.velocity;
        let rho = (x * x + y * y).sqrt();
        let deflection = rho - self.outer_orbit_radius;
        if deflection <= 0.0 {
            return None;
        }
        let (ex, ey) = (x / rho, y / rho);
        let root = deflection.sqrt();
        let approach = vx * ex + vy * ey;
        let force =
            (self.stiffness[1] * deflection * root + self.damping * root * approach).max(0.0);
        let r = self.effective_radius(x, y);
        let slip = vy * ex - vx * ey - spin * r;
        let friction = self.friction(slip, force * self.ball_radius / r);
        let contact = Contact {
            force: PlaneVector {
                x: -force * ex + friction * ey,
                y: -force * ey - friction * ex,
            },
            friction,
        };
        Some((contact, r * friction))
    }

    /// Inner raceway, Eq. (16), (20): motion from the ring's centre, its speed.
    fn inner(&self, motion: &Relative, spin: f64, ring_speed: f64) -> Option<Contact> {
        let PlaneVector { x, y } = motion.place;
        let PlaneVector { x: vx, y: vy } = motion.velocity;
        let distance = (x * x + y * y).sqrt();
        let deflection = self.inner_radius + self.ball_radius - distance;
        if deflection <= 0.0 {
            return None;
        }
        let (ex, ey) = (x / distance, y / distance);
        let root = deflection.sqrt();
        let approach = -(vx * ex + vy * ey);
        let force =
            (self.stiffness[0] * deflection * root + self.damping * root * approach).max(0.0);
        let tangential = vy * ex - vx * ey;
        let slip = ring_speed * self.inner_radius - (tangential + spin * self.ball_radius);
        let friction = self.friction(slip, force);
        Some(Contact {
            force: PlaneVector {
                x: force * ex - friction * ey,
                y: force * ey + friction * ex,
            },
            friction,
        })
    }

    /// A ball and the next, Eq. (17), (21): place of the next and velocity of the first, each
    /// from the other's, sum of their spins.
    fn neighbours(&self, motion: &Relative, spins: f64) -> Option<Contact> {
        let PlaneVector { x, y } = motion.place;
        let PlaneVector { x: vx, y: vy } = motion.velocity;
        let distance = (x * x + y * y).sqrt();
        let deflection = 2.0 * self.ball_radius - distance;
        if deflection <= 0.0 {
            return None;
        }
        let (ex, ey) = (x / distance, y / distance);
        let root = deflection.sqrt();
        let approach = vx * ex + vy * ey;
        let force = (self.stiffness[2] * deflection * root
            + self.ball_damping * root.sqrt() * approach)
            .max(0.0);
        let slip = vy * ex - vx * ey - spins * self.ball_radius;
        let friction = self.friction(slip, force);
        Some(Contact {
            force: PlaneVector {
                x: -force * ex + friction * ey,
                y: -force * ey - friction * ex,
            },
            friction,
        })
    }

    /// Loads between balls and raceways, with gravity.
    fn at_raceways(&self, bodies: &Bodies<'_>, balls: &mut BallLoads<'_>) -> RingLoads {
        let mut rings = RingLoads::default();
        for j in 0..self.balls {
            (balls.fx[j], balls.fy[j], balls.torque[j]) =
                (0.0, -self.ball_mass * self.gravity, 0.0);
            let motion = bodies.from(bodies.outer, j);
            if let Some((contact, moment)) = self.outer(&motion, bodies.spin[j]) {
                balls.add(j, contact.force, moment);
                rings.outer.x -= contact.force.x;
                rings.outer.y -= contact.force.y;
            }
            let motion = bodies.from(bodies.ring, j);
            let contact = self.inner(&motion, bodies.spin[j], bodies.ring_speed);
            if let Some(Contact { force, friction }) = contact {
                balls.add(j, force, self.ball_radius * friction);
                rings.inner.x -= force.x;
                rings.inner.y -= force.y;
                rings.inner_torque -= self.inner_radius * friction;
            }
        }
        rings
    }

    /// Adds the loads of the balls on each other.
    fn between_balls(&self, bodies: &Bodies<'_>, balls: &mut BallLoads<'_>) {
        for j in 0..self.balls {
            let k = (j + 1) % self.balls;
            let spins = bodies.spin[j] + bodies.spin[k];
            let contact = self.neighbours(&bodies.neighbours(j, k), spins);
            if let Some(Contact { force, friction }) = contact {
                let torque = self.ball_radius * friction;
                balls.add(j, force, torque);
                let back = PlaneVector {
                    x: -force.x,
                    y: -force.y,
                };
                balls.add(k, back, torque);
            }
        }
    }

    /// f(y) in SI units: x of every ball, y, vx, vy, spin, then the bodies.
    pub fn derivative(&self, state: &[f64], rate: &mut [f64]) {
        let n = self.balls;
        let [x, y, vx, vy, spin] = std::array::from_fn(|group| &state[group * n..][..n]);
        let coordinates = &state[5 * n..];
        let (ring, resting) = (&coordinates[..4], [0.0; 4]);
        let (ring_speed, outer) = match self.falling {
            Some(_) => (coordinates[4], &coordinates[5..9]),
            None => (self.inner_speed, &resting[..]),
        };
        let bodies = Bodies {
            x,
            y,
            vx,
            vy,
            spin,
            ring,
            ring_speed,
            outer,
        };
        let (velocities, rest) = rate.split_at_mut(2 * n);
        velocities[..n].copy_from_slice(vx);
        velocities[n..].copy_from_slice(vy);
        let (fx, rest) = rest.split_at_mut(n);
        let (fy, rest) = rest.split_at_mut(n);
        let (torque, body_rate) = rest.split_at_mut(n);
        let mut balls = BallLoads { fx, fy, torque };
        let rings = self.at_raceways(&bodies, &mut balls);
        self.between_balls(&bodies, &mut balls);
        for j in 0..n {
            balls.fx[j] /= self.ball_mass;
            balls.fy[j] /= self.ball_mass;
            balls.torque[j] /= self.ball_inertia;
        }
        body_rate[..2].copy_from_slice(&ring[2..]);
        match &self.falling {
            Some(falling) => {
                body_rate[2..].copy_from_slice(&self.falling_rates(falling, &rings, coordinates));
            }
            None => {
                body_rate[2] = (rings.inner.x - self.ring_drag * ring[2]) / self.ring_mass;
                body_rate[3] = (rings.inner.y - self.ring_drag * ring[3] - self.radial_load)
                    / self.ring_mass
                    - self.gravity;
            }
        }
    }

    /// Rates of rings and rotor of a drop, after the velocity of the inner ring.
    fn falling_rates(
        &self,
        falling: &Falling,
        rings: &RingLoads,
        coordinates: &[f64],
    ) -> [f64; 13] {
        let (ring, ring_speed, outer) = (&coordinates[..4], coordinates[4], &coordinates[5..9]);
        let (rotor, support, motion) = (&falling.rotor, &falling.support, &coordinates[9..]);
        let journal = falling.journal(ring, ring_speed, motion);
        let PlaneVector { x: px, y: py } = journal.force;
        let (stiffness, damping) = (support.stiffness_n_m, support.damping_n_s_m);
        [
            (rings.inner.x - px) / self.ring_mass,
            (rings.inner.y - py) / self.ring_mass - self.gravity,
            (rings.inner_torque + journal.ring_torque) / falling.ring_inertia,
            outer[2],
            outer[3],
            (rings.outer.x - stiffness * outer[0] - damping * outer[2]) / support.mass_kg,
            (rings.outer.y - stiffness * outer[1] - damping * outer[3]) / support.mass_kg,
            motion[3],
            motion[4],
            motion[5],
            px / rotor.mass_kg,
            py / rotor.mass_kg - self.gravity,
            (journal.moment + rotor.drive_torque_n_m) / rotor.polar_inertia_kg_m2,
        ]
    }
}

/// Loads between the journal of a rotor and the bore of the inner ring.
#[derive(Default)]
struct JournalLoads {
    /// On the rotor.
    force: PlaneVector,
    /// About the mass centre of the rotor.
    moment: f64,
    /// On the inner ring.
    ring_torque: f64,
}

impl Falling {
    fn journal(&self, ring: &[f64], ring_speed: f64, motion: &[f64]) -> JournalLoads {
        let &[x, y, angle, vx, vy, speed] = motion else {
            unreachable!("a rotor has six coordinates");
        };
        let r = &self.rotor;
        let (sin, cos) = (angle + r.eccentricity_phase_rad).sin_cos();
        let (ex, ey) = (r.eccentricity_m * cos, r.eccentricity_m * sin);
        let (dx, dy) = (x - ex - ring[0], y - ey - ring[1]);
        let distance = (dx * dx + dy * dy).sqrt();
        let depth = distance - r.radial_clearance_m;
        if depth <= 0.0 {
            return JournalLoads::default();
        }
        let (nx, ny) = (dx / distance, dy / distance);
        let (ux, uy) = (vx + speed * ey - ring[2], vy - speed * ex - ring[3]);
        let approach = ux * nx + uy * ny;
        let normal = (r.contact_stiffness_n_mp
            * depth.powf(r.contact_exponent)
            * (1.0 + 1.5 * r.contact_damping_s_m * approach))
            .max(0.0);
        let journal = self.bore_radius - r.radial_clearance_m;
        let slip = uy * nx - ux * ny + speed * journal - ring_speed * self.bore_radius;
        let friction =
            r.friction.coefficient * (slip / r.friction.regularisation_speed_m_s).tanh() * normal;
        let force = PlaneVector {
            x: -normal * nx + friction * ny,
            y: -normal * ny - friction * nx,
        };
        let (ax, ay) = (journal * nx - ex, journal * ny - ey);
        JournalLoads {
            force,
            moment: ax * force.y - ay * force.x,
            ring_torque: friction * self.bore_radius,
        }
    }
}
