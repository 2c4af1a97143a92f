//! Contacts of a rotor with the inner ring in space: its journal in the bore and its shoulders at the
//! faces of the ring.
//!
//! The rotor keeps its axis along Z. Friction acts at the journal along the bore and along the axis, and
//! at the shoulder at places spread evenly round the mean radius of the face, so that turning and
//! translation share it. **u** of the [`FrictionStep`] is (ẋ, ẏ, ż of the journal relative to the ring, Ω,
//! ωi).

use nalgebra::{Matrix2x5, Matrix5, Vector5};

use super::TouchLoads;
use super::journal::RotorContact;
use super::shoulder::{FaceContact, Shoulder, ShoulderMotion};
use crate::contact::friction_step::{FrictionStep, SlidingPlace, StepEnds};
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::layout::Layout;
use crate::numerics::vector::PlaneVector;
use crate::world::body::rotor::RotorCompliance;
use crate::world::under_rotor::{Touch, UnderRotor};

/// Places of friction round a face.
const ROUND_FACE: usize = 8;
/// Places of friction of a rotor: the journal comes first.
const PLACES: usize = 1 + ROUND_FACE;

/// Force on the rotor and moments about the axes of journal and ring: (Fx, Fy, Fz, M, Mi).
pub(crate) type Loads = Vector5<f64>;

/// Contacts of a rotor as of the last evaluation and the friction of the last step.
#[derive(Debug, Clone, Default)]
pub(crate) struct RotorTouch {
    pub face: FaceContact,
    /// Loads of its contacts, with the friction at the end of the last step.
    pub loads: Loads,
    /// Loads of the friction that changed velocities over the last step.
    pub mean_friction: Loads,
    /// Places of friction; J of those round the face stays.
    places: [SlidingPlace<5>; PLACES],
}

/// A step of the friction of the rotor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TouchStep<'y> {
    /// h, s.
    pub h_s: f64,
    /// Whether the friction at the start is known.
    pub is_known: bool,
    /// State at the start.
    pub start: &'y [f64],
    /// State to which all else leads.
    pub free: &'y [f64],
}

/// **u** of a state.
fn velocities(under: &UnderRotor, layout: Layout, y: &[f64], offset: PlaneVector) -> Vector5<f64> {
    let motion = layout.rotor_motion(y).unwrap_or_default();
    let (journal, ring) = (
        under.joint.seat.journal_motion(&motion, offset),
        layout.ring_motion(y),
    );
    Vector5::new(
        journal.vx - ring.vx,
        journal.vy - ring.vy,
        motion.vz - layout.at(y, RingCoordinate::Vz),
        motion.speed,
        layout.at(y, RingCoordinate::Speed),
    )
}

/// Loads of the contacts of a rotor with this offset of its mass centre.
fn touch_loads(loads: &Loads, offset: PlaneVector) -> TouchLoads {
    TouchLoads {
        force: [loads.x, loads.y, loads.z],
        // That about the journal less offset × force.
        moment: loads[3] + offset.y * loads.x - offset.x * loads.y,
        ring_torque: loads[4],
    }
}

impl RotorTouch {
    /// Loads as of the last evaluation, with the friction at the end of the last step.
    pub(crate) fn loads(&self, contact: &RotorContact) -> TouchLoads {
        touch_loads(&self.loads, contact.offset)
    }

    /// Loads of the friction that changed velocities over the last step.
    pub(crate) fn friction(&self, contact: &RotorContact) -> TouchLoads {
        touch_loads(&self.mean_friction, contact.offset)
    }

    /// Contacts that nothing has closed yet.
    pub(crate) fn new(shoulder: Option<&Shoulder>) -> Self {
        let mut touch = Self::default();
        let Some(shoulder) = shoulder else {
            return touch;
        };
        for (k, place) in touch.places[1..].iter_mut().enumerate() {
            let angle = std::f64::consts::TAU * k as f64 / ROUND_FACE as f64;
            let [sin, cos] = [angle.sin(), angle.cos()].map(|part| shoulder.radius * part);
            place.rows = Matrix2x5::new(1.0, 0.0, 0.0, -sin, sin, 0.0, 1.0, 0.0, cos, -cos);
        }
        touch
    }

    /// Contact of the rotor of a state with the ring, and its loads; friction only if asked for.
    pub(crate) fn evaluate(
        &mut self,
        under: &UnderRotor,
        layout: Layout,
        y: &[f64],
        with_friction: bool,
    ) -> Touch {
        let mut contact = under.contact(layout, y);
        let rates = velocities(under, layout, y, contact.offset);
        let (c, journal) = (&contact.contact, &under.joint.journal);
        self.face = FaceContact::default();
        if let Some(shoulder) = &under.shoulder {
            let motion = ShoulderMotion {
                z: under.axial_distance(layout, y),
                vz: rates.z,
                turning: rates[3] - rates[4],
            };
            self.face = shoulder.contact(journal, &motion);
            for place in &mut self.places[1..] {
                place.normal_n = self.face.axial_force.abs() / ROUND_FACE as f64;
            }
        }
        let (rj, rb) = (journal.radius, journal.bore_radius);
        self.places[0].rows = Matrix2x5::new(-c.ny, c.nx, 0.0, rj, -rb, 0.0, 0.0, 1.0, 0.0, 0.0);
        self.places[0].normal_n = c.force;
        let [x, y] = c.force_on_journal(0.0);
        let mut loads = Loads::new(x, y, self.face.axial_force, 0.0, 0.0);
        let mut heat = 0.0;
        if with_friction {
            for place in &mut self.places {
                heat += place.slide(&under.joint.friction, &rates, &mut loads);
            }
            contact.friction = -self.places[0].force().x;
        }
        self.loads = loads;
        Touch {
            contact,
            loads: touch_loads(&loads, contact.offset),
            heat,
            damping_power: contact.contact.damping_power + self.face.damping_power,
        }
    }

    /// Loads of friction over a step, and its heat, W; sets friction and sliding speed of the journal along
    /// the bore to those at its end.
    pub(crate) fn implicit_friction(
        &mut self,
        under: &UnderRotor,
        rotor: &RotorCompliance,
        contact: &mut RotorContact,
        layout: Layout,
        step: &TouchStep<'_>,
    ) -> (TouchLoads, f64) {
        // The places round the face slow the rotor together.
        let round_face: f64 = self.places[1..].iter().map(SlidingPlace::secant).sum();
        let [journal, face @ ..] = &mut self.places;
        journal.slowing = journal.secant();
        face.iter_mut().for_each(|place| place.slowing = round_face);
        let [start, free] =
            [step.start, step.free].map(|y| velocities(under, layout, y, contact.offset));
        let solver = FrictionStep {
            law: &under.joint.friction,
            compliance: compliance(under, rotor, contact.offset),
            h_s: step.h_s,
            is_known: step.is_known,
        };
        let found = solver.solve(&mut self.places, &StepEnds { start, free });
        self.loads += found.end;
        self.mean_friction = found.mean;
        if let Some(shoulder) = &under.shoulder {
            self.face.slip = shoulder.radius * (found.velocities[3] - found.velocities[4]);
        }
        contact.friction = -self.places[0].force().x;
        contact.contact.slip = (self.places[0].rows * found.velocities).x;
        (touch_loads(&found.mean, contact.offset), found.heat)
    }
}

/// C of rotor and ring.
fn compliance(under: &UnderRotor, rotor: &RotorCompliance, offset: PlaneVector) -> Matrix5<f64> {
    let mut compliance = Matrix5::zeros();
    let of_journal = rotor.about(offset);
    for (i, row) in [0, 1, 3].into_iter().zip(of_journal) {
        for (j, value) in [0, 1, 3].into_iter().zip(row) {
            compliance[(i, j)] = value;
        }
    }
    compliance[(2, 2)] = rotor.axial();
    for axis in 0..3 {
        compliance[(axis, axis)] += 1.0 / under.ring.mass;
    }
    compliance[(4, 4)] = 1.0 / under.ring.polar_inertia;
    compliance
}
