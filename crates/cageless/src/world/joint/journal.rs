//! The joint of the journal of a rotor and the bore of the inner ring: contact and friction.

use super::TouchLoads;
use super::rotor_seat::RotorSeat;
use crate::ball::Centre;
use crate::bearing::InnerRingBore;
use crate::contact::friction::STICK_FRACTION;
use crate::contact::{
    Friction, Journal, JournalContact, JournalMotion, journal_contact, journal_slip,
};
use crate::numerics::vector::PlaneVector;
use crate::rotor::Rotor;
use crate::world::body::inner_ring::InnerRing;
use crate::world::body::rotor::{RotorCompliance, RotorMotion};

/// Constants of the joint.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JournalJoint {
    /// Place of the journal on the rotor.
    pub seat: RotorSeat,
    /// Contact of journal and bore.
    pub journal: Journal,
    /// Friction of that contact.
    pub friction: Friction,
}

/// Contact of the rotor with the inner ring at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RotorContact {
    /// Normal contact.
    pub contact: JournalContact,
    /// ε·e^(i(θ+φ)), from the centre of the journal to the mass centre, m.
    pub offset: PlaneVector,
    /// Friction on the rotor along −slip, N.
    pub friction: f64,
}

impl RotorContact {
    /// A contact at the bottom of the bore that nothing has closed.
    pub(crate) fn below() -> Self {
        let contact = JournalContact {
            ny: -1.0,
            ..JournalContact::default()
        };
        Self {
            contact,
            ..Self::default()
        }
    }
}

/// Motion of the inner ring as the journal meets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TurningRing {
    /// Motion of its centre.
    pub centre: Centre,
    /// ωi, rad/s.
    pub speed: f64,
}

impl TurningRing {
    /// Motion of its bore.
    #[inline(always)]
    fn bore(&self) -> JournalMotion {
        JournalMotion {
            x: self.centre.x,
            y: self.centre.y,
            vx: self.centre.vx,
            vy: self.centre.vy,
            speed: self.speed,
        }
    }
}

impl JournalJoint {
    /// The journal of a rotor in a bore. Coulomb's law slides only.
    pub(crate) fn in_bore(rotor: &Rotor, bore: InnerRingBore) -> Self {
        Self {
            seat: RotorSeat::of(rotor),
            journal: Journal {
                radius: bore.radius_m - rotor.radial_clearance_m,
                bore_radius: bore.radius_m,
                radial_clearance: rotor.radial_clearance_m,
                stiffness: rotor.contact_stiffness_n_mp,
                exponent: rotor.contact_exponent,
                damping: rotor.contact_damping_s_m,
            },
            friction: Friction::new(rotor.friction_law, &rotor.friction, f64::MAX),
        }
    }

    /// With the stick that explicit methods resolve at a step, between a rotor of this compliance and the ring.
    pub(crate) fn sticking(
        self,
        rotor: &Rotor,
        compliance: &RotorCompliance,
        ring: &InnerRing,
        step_s: f64,
    ) -> Self {
        let mobility = self.slip_mobility(compliance, ring, &RotorContact::below());
        let stick_gain = STICK_FRACTION / (mobility * step_s);
        Self {
            friction: Friction::new(rotor.friction_law, &rotor.friction, stick_gain),
            ..self
        }
    }

    /// Contact of the rotor with the inner ring, without friction.
    #[inline(always)]
    pub(crate) fn contact(&self, motion: &RotorMotion, ring: &TurningRing) -> RotorContact {
        let offset = self.seat.offset(motion.angle);
        let journal = self.seat.journal_motion(motion, offset);
        RotorContact {
            contact: journal_contact(&self.journal, &journal, &ring.bore()),
            offset,
            friction: 0.0,
        }
    }

    /// Sliding speed of the journal in the bore along the directions of a contact, m/s.
    #[inline(always)]
    pub(crate) fn slip(
        &self,
        contact: &RotorContact,
        motion: &RotorMotion,
        ring: &TurningRing,
    ) -> f64 {
        let journal = self.seat.journal_motion(motion, contact.offset);
        let normal = [contact.contact.nx, contact.contact.ny];
        journal_slip(&self.journal, normal, &journal, &ring.bore())
    }

    /// Loads under the normal force `normal_n` and the friction `friction_n` along −slip. The normal force
    /// acts at zr + Rj·n; the reaction of friction acts at the bore.
    #[inline(always)]
    pub(crate) fn loads(
        &self,
        contact: &RotorContact,
        normal_n: f64,
        friction_n: f64,
    ) -> TouchLoads {
        let (c, offset) = (&contact.contact, contact.offset);
        let pressed = JournalContact {
            force: normal_n,
            ..*c
        };
        let [x, y] = pressed.force_on_journal(friction_n);
        let ax = self.journal.radius * c.nx - offset.x;
        let ay = self.journal.radius * c.ny - offset.y;
        TouchLoads {
            force: [x, y, 0.0],
            moment: ax * y - ay * x,
            ring_torque: friction_n * self.journal.bore_radius,
        }
    }

    /// Change of the sliding speed by a unit of friction, 1/kg: that of the rotor at Rj·n − ε·e^(i(θ+φ)) from its mass
    /// centre, 1/mi and Rb²/Ji.
    #[inline(always)]
    pub(crate) fn slip_mobility(
        &self,
        rotor: &RotorCompliance,
        ring: &InnerRing,
        contact: &RotorContact,
    ) -> f64 {
        let (c, offset) = (&contact.contact, contact.offset);
        let arm = self.journal.radius - (offset.x * c.nx + offset.y * c.ny);
        let tangent = PlaneVector { x: -c.ny, y: c.nx };
        let rotor = rotor.along(tangent, arm);
        let bore = self.journal.bore_radius;
        rotor + 1.0 / ring.mass + bore * bore / ring.polar_inertia
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::friction::Smooth;
    use crate::world::body::rigid_rotor::RigidRotor;
    use crate::world::body::rotor::LateralLoad;

    /// A seat whose mass centre is a fifth of its radius off the axis, or on it.
    fn seat(eccentricity: f64) -> RotorSeat {
        RotorSeat {
            eccentricity,
            phase: 0.7,
            z: 0.0,
        }
    }

    const ECCENTRICITY: f64 = 3e-3;

    fn rotor() -> RigidRotor {
        RigidRotor {
            mass: 20.0,
            polar_inertia: 0.02,
            weight: [0.0; 3],
            axial_load: 0.0,
            drive_torque: 0.0,
        }
    }

    const RING: InnerRing = InnerRing {
        mass: 0.2,
        polar_inertia: 5.5e-5,
        drag: 0.0,
        radial_load: 0.0,
        gravity: 0.0,
        unbalance_x: 0.0,
        unbalance_y: 0.0,
    };

    fn joint(seat: RotorSeat) -> JournalJoint {
        JournalJoint {
            seat,
            journal: Journal {
                radius: 14.8e-3,
                bore_radius: 15e-3,
                radial_clearance: 2e-4,
                stiffness: 1e9,
                exponent: 1.0,
                damping: 0.3,
            },
            friction: Friction::Smooth(Smooth::default()),
        }
    }

    /// A deep contact of it while it moves in every way.
    fn touching(joint: &JournalJoint) -> (RotorMotion, TurningRing, RotorContact) {
        let offset = joint.seat.offset(0.4);
        let motion = RotorMotion {
            x: 1.5e-4 + offset.x,
            y: -1.6e-4 + offset.y,
            vx: 0.3,
            vy: -0.2,
            angle: 0.4,
            speed: 321.0,
            ..RotorMotion::default()
        };
        let centre = Centre {
            x: 2e-6,
            y: -3e-6,
            vx: -0.01,
            vy: 0.02,
        };
        let ring = TurningRing {
            centre,
            speed: -55.0,
        };
        (motion, ring, joint.contact(&motion, &ring))
    }

    /// The sliding speed falls by the mobility under a unit of friction over a unit of time,
    /// wherever the mass centre is and whatever the rotor yields.
    #[test]
    fn mobility_is_what_friction_changes_of_the_slip() {
        let rigid = rotor().compliance();
        let bending = RotorCompliance::Bending {
            lateral: [[0.07, 0.01, 0.3], [0.01, 0.04, -0.2], [0.3, -0.2, 60.0]],
            axial: 0.05,
        };
        let [eccentric, centred] = [ECCENTRICITY, 0.0].map(|offset| joint(seat(offset)));
        for (joint, rotor) in [
            (&eccentric, rigid),
            (&centred, rigid),
            (&eccentric, bending),
        ] {
            let (motion, ring, contact) = touching(joint);
            let loads = joint.loads(&contact, 0.0, 1.0);
            let [x, y, _] = loads.force;
            let load = LateralLoad {
                force: PlaneVector { x, y },
                moment: loads.moment,
            };
            let about_journal = rotor.about(PlaneVector::default());
            let [ax, ay, spin] = about_journal.map(|row| load.along(&row));
            let time = 1e-3;
            let after = RotorMotion {
                vx: motion.vx + time * ax,
                vy: motion.vy + time * ay,
                speed: motion.speed + time * spin,
                ..motion
            };
            let pushed = TurningRing {
                centre: Centre {
                    vx: ring.centre.vx - time * loads.force[0] / RING.mass,
                    vy: ring.centre.vy - time * loads.force[1] / RING.mass,
                    ..ring.centre
                },
                speed: ring.speed + time * loads.ring_torque / RING.polar_inertia,
            };
            let change = joint.slip(&contact, &after, &pushed) - contact.contact.slip;
            let mobility = joint.slip_mobility(&rotor, &RING, &contact);
            assert!(
                (-change / time / mobility - 1.0).abs() < 1e-9,
                "{change} {mobility}"
            );
        }
        let shares = [eccentric, centred]
            .map(|joint| joint.slip_mobility(&rigid, &RING, &touching(&joint).2));
        assert!((shares[0] / shares[1] - 1.0).abs() > 1e-4, "{shares:?}");
    }

    /// The powers of the contact force on rotor and ring add up to what damping and friction
    /// take and the spring stores, wherever the mass centre is.
    #[test]
    fn powers_of_the_contact_close() {
        let joint = joint(seat(ECCENTRICITY));
        let (motion, ring, contact) = touching(&joint);
        assert!(contact.contact.force > 0.0);
        let friction = 0.15 * contact.contact.force;
        let loads = joint.loads(&contact, contact.contact.force, friction);
        let power = motion.power(&loads)
            - loads.force[0] * ring.centre.vx
            - loads.force[1] * ring.centre.vy
            + loads.ring_torque * ring.speed;
        let c = &contact.contact;
        let expected = -c.force * c.rate - friction * c.slip;
        assert!((power / expected - 1.0).abs() < 1e-12, "{power} {expected}");
    }
}
