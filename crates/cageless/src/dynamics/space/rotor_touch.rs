//! Contacts of a rotor with the inner ring in space: its journal in the bore and its shoulders at the
//! faces of the ring.
//!
//! The rotor keeps its axis along Z. Friction acts at the journal along the bore and along the axis, and
//! at the shoulder at places spread evenly round the mean radius of the face, so that turning and
//! translation share it. With **u** = (ẋ, ẏ, ż of the journal relative to the ring, Ω, ωi), the sliding
//! velocities **s** = J **u** and the loads Jᵀ **f**, friction over a step is
//!
//!   **u** = **u*** + h C Σ Jᵀ ((1 − θ) **f**₀ + θ **f**(J **u**)),
//!
//! C being the compliance of rotor and ring.

use nalgebra::{Matrix2, Matrix2x5, Matrix5, Vector2, Vector5};

use crate::contact::{MAX_ITERATIONS, end_weights};
use crate::dynamics::coordinates::{DropCoordinate, RingCoordinate};
use crate::dynamics::layout::Layout;
use crate::dynamics::rotor::{RotorBody, RotorContact};
use crate::rotor::Rotor;

/// Places of friction round a face.
const ROUND_FACE: usize = 8;
/// Places of friction of a rotor: the journal comes first.
const PLACES: usize = 1 + ROUND_FACE;

/// No step of Newton's method follows one that changes no sliding velocity by more than this, in the
/// regularisation speed,
const LAST_STEP: f64 = 0.05;
/// or, where it slides in so many of them,
const SLIDING: f64 = 4.0;
/// than by this fraction of the sliding velocity.
const LAST_TURN: f64 = 0.03;
/// Iterations after which the matrix is one that no step overshoots.
const PATIENCE: u32 = 6;

/// Constants of a rotor along its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotorAlongAxis {
    /// Clearance of either shoulder to its face of the inner ring, and the mean radius of the faces, m;
    /// `None` without shoulders.
    pub faces: Option<[f64; 2]>,
    /// Force along +Z, N.
    pub load: f64,
    /// m of all that moves along the axis with the rotor, kg.
    pub mass: f64,
}

impl RotorAlongAxis {
    /// Those of a rotor over a ring with this mean radius between its bore and its raceway.
    pub(crate) fn new(rotor: &Rotor, mean_radius_m: f64) -> Self {
        Self {
            faces: (rotor.axial_clearance_m)
                .map(|clearance| [clearance, rotor.shoulder_radius_m.unwrap_or(mean_radius_m)]),
            load: rotor.axial_load_n,
            mass: rotor.mass_kg,
        }
    }

    /// Those of a rotor of this mass that rests on other bearings as well, whose load acts on it alone.
    pub(crate) fn guided(self, mass: f64) -> Self {
        Self {
            load: 0.0,
            mass,
            ..self
        }
    }
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

/// Motion of the rotor against the ring.
#[derive(Debug, Clone, Copy)]
struct Relative {
    /// Z of the rotor from that of the ring, m.
    z: f64,
    /// **u**.
    rates: Vector5<f64>,
}

/// Contacts of a rotor as of the last evaluation and the friction of the last step.
#[derive(Debug, Clone, Default)]
pub(crate) struct RotorTouch {
    pub face: FaceContact,
    /// Loads of its contacts, with the friction at the end of the last step.
    pub loads: Loads,
    /// Those of the friction that changed velocities over the last step.
    pub mean_friction: Loads,
    face_radius: Option<f64>,
    /// J of each place; those round the face stay.
    rows: [Matrix2x5<f64>; PLACES],
    /// Normal force of each place, N.
    normal: [f64; PLACES],
    /// Friction on the rotor at the end of the last step, N, and |f|/|s| there, N·s/m.
    known: [(Vector2<f64>, f64); PLACES],
}

/// Force on the rotor and moments about the axes of journal and ring: (Fx, Fy, Fz, M, Mi).
pub(crate) type Loads = Vector5<f64>;

fn relative(body: &RotorBody, layout: Layout, y: &[f64], offset: [f64; 2]) -> Relative {
    let motion = layout.rotor_motion(y).unwrap_or_default();
    let (journal, ring) = (body.journal_motion(&motion, offset), layout.ring_motion(y));
    let axial = |rotor, ring| y[layout.drop(rotor)] - y[layout.ring(ring)];
    Relative {
        z: axial(DropCoordinate::RotorZ, RingCoordinate::Z),
        rates: Vector5::new(
            journal.vx - ring.vx,
            journal.vy - ring.vy,
            axial(DropCoordinate::RotorVz, RingCoordinate::Vz),
            motion.speed,
            y[layout.drop(DropCoordinate::RingSpeed)],
        ),
    }
}

impl RotorTouch {
    /// Contacts that nothing has closed yet.
    pub(crate) fn new(along_axis: Option<&RotorAlongAxis>) -> Self {
        let mut touch = Self::default();
        let Some([_, radius]) = along_axis.and_then(|along_axis| along_axis.faces) else {
            return touch;
        };
        touch.face_radius = Some(radius);
        for (k, row) in touch.rows[1..].iter_mut().enumerate() {
            let angle = std::f64::consts::TAU * k as f64 / ROUND_FACE as f64;
            let (sin, cos) = (radius * angle.sin(), radius * angle.cos());
            *row = Matrix2x5::new(1.0, 0.0, 0.0, -sin, sin, 0.0, 1.0, 0.0, cos, -cos);
        }
        touch
    }

    /// Contact of the rotor of a state with the ring, and its loads; friction only if asked for.
    pub(crate) fn evaluate(
        &mut self,
        (body, along_axis): (&RotorBody, &RotorAlongAxis),
        layout: Layout,
        y: &[f64],
        with_friction: bool,
    ) -> (RotorContact, Loads, f64) {
        let ring_speed = y[layout.drop(DropCoordinate::RingSpeed)];
        let motion = layout.rotor_motion(y).unwrap_or_default();
        let mut contact = body.contact(&motion, &layout.ring_motion(y), ring_speed);
        let relative = relative(body, layout, y, contact.offset);
        let c = &contact.contact;
        self.face = FaceContact::default();
        if let Some([clearance, radius]) = along_axis.faces {
            let side = relative.z.signum();
            let deflection = side * relative.z - clearance;
            let [force, damping_power] = body.journal.normal(deflection, side * relative.rates.z);
            self.face = FaceContact {
                deflection,
                axial_force: -side * force,
                damping_power,
                slip: radius * (relative.rates[3] - relative.rates[4]),
            };
            self.normal[1..].fill(force / ROUND_FACE as f64);
        }
        let (rj, rb) = (body.journal.radius, body.journal.bore_radius);
        self.rows[0] = Matrix2x5::new(-c.ny, c.nx, 0.0, rj, -rb, 0.0, 0.0, 1.0, 0.0, 0.0);
        self.normal[0] = c.force;
        let [x, y] = c.force_on_journal(0.0);
        let mut loads = Loads::new(x, y, self.face.axial_force, 0.0, 0.0);
        let mut heat = 0.0;
        if with_friction {
            for place in 0..PLACES {
                let slip = self.rows[place] * relative.rates;
                let (force, secant, _) = self.friction(body, place, slip);
                self.known[place] = (force, secant);
                heat -= force.dot(&slip);
                loads += self.rows[place].transpose() * force;
            }
            contact.friction = -self.known[0].0.x;
        }
        self.loads = loads;
        (contact, loads, heat)
    }

    /// Friction on the rotor at a place that slides with `slip`, |f|/|s|, and −∂f/∂s, no less than 0
    /// along s.
    fn friction(
        &self,
        body: &RotorBody,
        place: usize,
        slip: Vector2<f64>,
    ) -> (Vector2<f64>, f64, Matrix2<f64>) {
        let speed = slip.norm();
        let [size, steepness] = body.friction.force(speed, self.normal[place]);
        let slides = speed * body.friction.inverse_regularisation_speed() > 1e-9;
        let secant = if slides { size / speed } else { steepness };
        let direction = if slides {
            slip / speed
        } else {
            Vector2::zeros()
        };
        let along = direction * direction.transpose() * (steepness.max(0.0) - secant);
        (-secant * slip, secant, Matrix2::identity() * secant + along)
    }

    /// Friction over a step of `h_s` from the first to the second state, to which all else leads: the
    /// loads that change the velocities, its heat, W, and friction and sliding speed of the journal along
    /// the bore at the end.
    pub(crate) fn implicit_friction(
        &mut self,
        (body, along_axis, ring_mass): (&RotorBody, &RotorAlongAxis, f64),
        contact: &RotorContact,
        (h_s, was_known): (f64, bool),
        layout: Layout,
        [y0, y]: [&[f64]; 2],
    ) -> (Loads, f64, [f64; 2]) {
        let mut compliance = Matrix5::zeros();
        let of_journal = body.compliance(contact.offset);
        for (i, row) in [0, 1, 3].into_iter().zip(of_journal) {
            for (j, value) in [0, 1, 3].into_iter().zip(row) {
                compliance[(i, j)] = value;
            }
        }
        compliance[(2, 2)] = 1.0 / along_axis.mass;
        for axis in 0..3 {
            compliance[(axis, axis)] += 1.0 / ring_mass;
        }
        compliance[(4, 4)] = 1.0 / body.ring_inertia;
        let [start, free] = [y0, y].map(|y| relative(body, layout, y, contact.offset).rates);
        // The places round the face slow the rotor together.
        let round_face: f64 = self.known[1..].iter().map(|(_, secant)| secant).sum();
        let slowing = [self.known[0].1, round_face];
        let mut weights = [1.0; PLACES];
        let mut rest = free;
        for place in 0..PLACES {
            let rows = self.rows[place];
            let gain = h_s * (rows * compliance * rows.transpose()).diagonal().max();
            if self.normal[place] == 0.0 {
                self.known[place] = Default::default();
            } else if was_known {
                [weights[place], _] = end_weights([gain * slowing[place.min(1)], 0.0]);
            }
            let share = h_s * (1.0 - weights[place]);
            rest += compliance * rows.transpose() * self.known[place].0 * share;
        }
        let mut now = free;
        let mut ends = [Vector2::zeros(); PLACES];
        for iteration in 0..MAX_ITERATIONS {
            let mut matrix = Matrix5::identity();
            let mut missing = rest - now;
            let mut tangents = [Matrix2::zeros(); PLACES];
            for place in 0..PLACES {
                let rows = self.rows[place];
                let (force, secant, mut tangent) = self.friction(body, place, rows * now);
                if iteration > PATIENCE {
                    tangent = Matrix2::identity() * secant;
                }
                let answer = compliance * rows.transpose() * (h_s * weights[place]);
                missing += answer * force;
                matrix += answer * tangent * rows;
                (ends[place], tangents[place]) = (force, tangent);
            }
            let change = matrix.lu().solve(&missing).unwrap_or(missing);
            let knee = 1.0 / body.friction.inverse_regularisation_speed();
            let mut done = true;
            for place in 0..PLACES {
                let (slip, turn) = (self.rows[place] * now, self.rows[place] * change);
                let (speed, moved) = (slip.norm(), turn.norm());
                let slides = speed > SLIDING * knee && moved <= LAST_TURN * speed;
                done &= self.normal[place] == 0.0 || moved <= LAST_STEP * knee || slides;
                // Linear about the last iterate, so that the equations hold exactly.
                ends[place] -= tangents[place] * turn;
            }
            now += change;
            if done {
                break;
            }
        }
        let (mut loads, mut heat) = (Loads::zeros(), 0.0);
        for place in 0..PLACES {
            let (rows, end) = (self.rows[place], ends[place]);
            let mean = self.known[place].0 * (1.0 - weights[place]) + end * weights[place];
            let (_, secant, _) = self.friction(body, place, rows * now);
            self.known[place] = (end, secant);
            loads += rows.transpose() * mean;
            heat -= 0.5 * mean.dot(&(rows * (start + now)));
        }
        for (row, end) in self.rows.iter().zip(&ends) {
            self.loads += row.transpose() * end;
        }
        self.mean_friction = loads;
        if let Some(radius) = self.face_radius {
            self.face.slip = radius * (now[3] - now[4]);
        }
        (loads, heat, [-ends[0].x, (self.rows[0] * now).x])
    }
}
