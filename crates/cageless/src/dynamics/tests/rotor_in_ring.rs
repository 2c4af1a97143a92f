//! A rotor in a ring without balls: what is left of a drop when the bearing is rigid. Its closed
//! forms (fall, pendulum, climb, spin-up, whirl) check the contact and the motion of the rotor,
//! which are those of the bearing.

use crate::ball::{AxialMotion, Centre};
use crate::bearing::InnerRingBore;
use crate::contact::journal_energy_j;
use crate::integrator::System;
use crate::rotor::{Rotor, Support};
use crate::world::body::outer_ring::OuterRing;
use crate::world::body::rigid_rotor::RigidRotor;
use crate::world::body::rotor::RotorMotion;
use crate::world::joint::journal::{JournalJoint, RotorContact, TurningRing};

/// What holds the ring.
#[derive(Debug, Clone, PartialEq)]
pub enum RingMount {
    /// It neither moves nor turns.
    Fixed,
    /// Its centre stays, it turns freely.
    Turning,
    /// Its centre moves with a support, whose mass includes the ring; it does not turn.
    Supported(Support),
}

/// Index of a coordinate of [`RotorInRing`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// x of the rotor's mass centre, m.
    X,
    /// y of the rotor's mass centre, m.
    Y,
    /// ẋ of the rotor's mass centre, m/s.
    Vx,
    /// ẏ of the rotor's mass centre, m/s.
    Vy,
    /// θ of the rotor, rad.
    Angle,
    /// Ω of the rotor, rad/s.
    Speed,
    /// ωi of the ring, rad/s.
    RingSpeed,
    /// x of the ring, m.
    RingX,
    /// y of the ring, m.
    RingY,
    /// ẋ of the ring, m/s.
    RingVx,
    /// ẏ of the ring, m/s.
    RingVy,
    /// Heat of friction, J.
    FrictionHeat,
    /// Heat of the damping of contact and support, J.
    DampingHeat,
}

/// Number of coordinates.
const SIZE: usize = Coordinate::DampingHeat as usize + 1;

/// Scale of the errors of every coordinate.
const SCALES: [f64; SIZE] = [
    1e-5, 1e-5, 0.1, 0.1, 1e-3, 1.0, 1.0, 1e-5, 1e-5, 0.1, 0.1, 1.0, 1.0,
];

/// Equations of motion of a rotor in a ring without balls.
#[derive(Debug, Clone)]
pub struct RotorInRing {
    body: RigidRotor,
    joint: JournalJoint,
    ring_inertia: f64,
    ring: OuterRing,
    turns: bool,
    contact: RotorContact,
}

impl RotorInRing {
    /// The rotor in a ring of this bore.
    pub fn new(rotor: &Rotor, bore: InnerRingBore, gravity_m_s2: f64, mount: RingMount) -> Self {
        let (support, turns) = match &mount {
            RingMount::Fixed => (None, false),
            RingMount::Turning => (None, true),
            RingMount::Supported(support) => (Some(support), false),
        };
        Self {
            body: RigidRotor::new(rotor, 1, gravity_m_s2),
            joint: JournalJoint::in_bore(rotor, bore),
            ring_inertia: bore.polar_inertia_kg_m2,
            ring: OuterRing::new(support, 0.0),
            turns,
            contact: RotorContact::default(),
        }
    }

    /// State in which the rotor starts and the ring rests at the centre.
    pub fn start(&self, rotor: &Rotor) -> Vec<f64> {
        let mut state = vec![0.0; SIZE];
        for (coordinate, value) in [
            (Coordinate::X, rotor.x_m),
            (Coordinate::Y, rotor.y_m),
            (Coordinate::Vx, rotor.vx_m_s),
            (Coordinate::Vy, rotor.vy_m_s),
            (Coordinate::Speed, rotor.speed_rad_s),
        ] {
            state[coordinate as usize] = value;
        }
        state
    }

    /// Contact as of the last evaluation.
    pub fn contact(&self) -> &RotorContact {
        &self.contact
    }

    /// Kinetic, elastic and potential energy, J.
    pub fn energy_j(&self, state: &[f64]) -> f64 {
        let (m, ring) = motions(state);
        let contact = self.joint.contact(&m, &ring);
        let [_, weight, _] = self.body.weight;
        self.body.energy_j(&m) + 0.5 * self.ring_inertia * ring.speed * ring.speed - weight * m.y
            + journal_energy_j(&self.joint.journal, contact.contact.deflection)
            + self.ring.energy_j(&ring.centre, &AxialMotion::default())
    }
}

/// Motion of rotor and ring.
fn motions(state: &[f64]) -> (RotorMotion, TurningRing) {
    let at = |coordinate: Coordinate| state[coordinate as usize];
    let rotor = RotorMotion {
        x: at(Coordinate::X),
        y: at(Coordinate::Y),
        vx: at(Coordinate::Vx),
        vy: at(Coordinate::Vy),
        angle: at(Coordinate::Angle),
        speed: at(Coordinate::Speed),
        ..RotorMotion::default()
    };
    let centre = Centre {
        x: at(Coordinate::RingX),
        y: at(Coordinate::RingY),
        vx: at(Coordinate::RingVx),
        vy: at(Coordinate::RingVy),
    };
    let speed = at(Coordinate::RingSpeed);
    (rotor, TurningRing { centre, speed })
}

impl System for RotorInRing {
    fn dimension(&self) -> usize {
        SIZE
    }

    fn derivative(&mut self, _time_s: f64, y: &[f64], dydt: &mut [f64]) {
        let (rotor, ring) = motions(y);
        let mut contact = self.joint.contact(&rotor, &ring);
        let c = contact.contact;
        [contact.friction, _] = self.joint.friction.force(c.slip, c.force);
        let loads = self.joint.loads(&contact, c.force, contact.friction);
        let answer = self.body.acceleration(&loads);
        let ([ax, ay, _], spin) = (answer.linear, answer.spin);
        let turning = if self.turns {
            loads.ring_torque / self.ring_inertia
        } else {
            0.0
        };
        let (ring, force) = (ring.centre, loads.force);
        let [rx, ry, _] =
            (self.ring).acceleration(&ring, &AxialMotion::default(), force.map(|f| -f));
        for (coordinate, rate) in [
            (Coordinate::X, rotor.vx),
            (Coordinate::Y, rotor.vy),
            (Coordinate::Vx, ax),
            (Coordinate::Vy, ay),
            (Coordinate::Angle, rotor.speed),
            (Coordinate::Speed, spin),
            (Coordinate::RingSpeed, turning),
            (Coordinate::RingX, ring.vx),
            (Coordinate::RingY, ring.vy),
            (Coordinate::RingVx, rx),
            (Coordinate::RingVy, ry),
            (Coordinate::FrictionHeat, contact.friction * c.slip),
            (
                Coordinate::DampingHeat,
                c.damping_power + self.ring.support.damping_power(&ring, 0.0),
            ),
        ] {
            dydt[coordinate as usize] = rate;
        }
        self.contact = contact;
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        let squares = difference.iter().zip(SCALES).map(|(d, s)| (d / s).powi(2));
        (squares.sum::<f64>() / SIZE as f64).sqrt()
    }
}
