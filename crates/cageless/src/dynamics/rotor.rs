//! A rigid rotor in the plane of the bearing: constants, motion and acceleration.
//!
//! ```
//! use cageless::reference;
//! use cageless::initial_conditions::initial_state;
//!
//! let (state, _angles) = initial_state(&reference::rotor_drop())?;
//! let rotor = state.rotor_motion().unwrap();
//! assert!((rotor.speed - 3141.6).abs() < 0.1); // 30 000 rpm
//! assert_eq!((rotor.y, state.ring_speed_rad_s()), (0.0, Some(0.0)));
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use super::ball::Centre;
use crate::bearing::InnerRingBore;
use crate::case::Case;
use crate::contact::friction::STICK_FRACTION;
use crate::contact::{Friction, Journal, JournalContact, JournalMotion, journal_contact};
use crate::rotor::Rotor;

/// Constants of the rotor, of its contact with the inner ring, and of the turning of that ring.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RotorBody {
    /// m, kg.
    pub mass: f64,
    /// Ip, kg·m².
    pub polar_inertia: f64,
    /// ε, m.
    pub eccentricity: f64,
    /// φ, rad.
    pub phase: f64,
    /// g, m/s², along −Y.
    pub gravity: f64,
    /// Torque of the drive, N·m.
    pub drive_torque: f64,
    /// Contact of journal and bore.
    pub journal: Journal,
    /// Friction of that contact.
    pub friction: Friction,
    /// Ji of the inner ring, kg·m².
    pub ring_inertia: f64,
    /// Set where the motion of the journal is that of a rotor outside this bearing: the journal
    /// then has no mass of its own.
    pub guide: Option<JournalCompliance>,
}

/// Accelerations of a journal, [ẍ, ÿ, Ω̇], under a unit of each of the loads [Fx, Fy, moment about
/// its centre] on it: 1/kg, 1/(kg·m) and 1/(kg·m²).
pub(crate) type JournalCompliance = [[f64; 3]; 3];

/// Motion of the mass centre of a rotor and its rotation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotorMotion {
    /// x of the mass centre, m.
    pub x: f64,
    /// y of the mass centre, m.
    pub y: f64,
    /// ẋ of the mass centre, m/s.
    pub vx: f64,
    /// ẏ of the mass centre, m/s.
    pub vy: f64,
    /// θ, rad, counter-clockwise, from the start on.
    pub angle: f64,
    /// Ω, rad/s, counter-clockwise.
    pub speed: f64,
}

/// Contact of the rotor with the inner ring at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotorContact {
    /// Normal contact.
    pub contact: JournalContact,
    /// ε·e^(i(θ+φ)), from the centre of the journal to the mass centre, m.
    pub offset: [f64; 2],
    /// Friction on the rotor along −slip, N.
    pub friction: f64,
}

impl RotorBody {
    /// The rotor of a case that has one.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        let (rotor, bore) = (case.rotor.as_ref()?, case.bearing.inner_ring_bore()?);
        let body = Self::in_bore(rotor, bore, case.operation.gravity_m_s2);
        let ring_mass = case.bearing.dimensions().inner_ring_mass_kg;
        let mobility = body.slip_mobility(&RotorContact::default(), ring_mass);
        let stick_gain = STICK_FRACTION / (mobility * case.solver.step_s);
        Some(Self {
            friction: Friction::new(rotor.friction_law, &rotor.friction, stick_gain),
            ..body
        })
    }

    /// A rotor in the bore of a ring. Coulomb's law slides only.
    pub(crate) fn in_bore(rotor: &Rotor, bore: InnerRingBore, gravity_m_s2: f64) -> Self {
        Self {
            mass: rotor.mass_kg,
            polar_inertia: rotor.polar_inertia_kg_m2,
            eccentricity: rotor.eccentricity_m,
            phase: rotor.eccentricity_phase_rad,
            gravity: gravity_m_s2,
            drive_torque: rotor.drive_torque_n_m,
            journal: Journal {
                radius: bore.radius_m - rotor.radial_clearance_m,
                bore_radius: bore.radius_m,
                radial_clearance: rotor.radial_clearance_m,
                stiffness: rotor.contact_stiffness_n_mp,
                exponent: rotor.contact_exponent,
                damping: rotor.contact_damping_s_m,
            },
            friction: Friction::new(rotor.friction_law, &rotor.friction, f64::MAX),
            ring_inertia: bore.polar_inertia_kg_m2,
            guide: None,
        }
    }

    /// Journal of a rotor that rests on other bearings as well: its contact without a mass of its own.
    pub(crate) fn guided(self) -> Self {
        Self {
            mass: 0.0,
            polar_inertia: 0.0,
            eccentricity: 0.0,
            drive_torque: 0.0,
            guide: Some(JournalCompliance::default()),
            ..self
        }
    }

    /// ε·e^(i(θ+φ)), m.
    #[inline(always)]
    pub(crate) fn offset(&self, angle: f64) -> [f64; 2] {
        if self.eccentricity == 0.0 {
            return [0.0; 2];
        }
        let (sin, cos) = (angle + self.phase).sin_cos();
        [self.eccentricity * cos, self.eccentricity * sin]
    }

    /// Motion of the centre of the journal: zr = zg − ε·e^(i(θ+φ)), żr = żg − iΩ·ε·e^(i(θ+φ)).
    #[inline(always)]
    pub(crate) fn journal_motion(&self, motion: &RotorMotion, offset: [f64; 2]) -> JournalMotion {
        let [ex, ey] = offset;
        JournalMotion {
            x: motion.x - ex,
            y: motion.y - ey,
            vx: motion.vx + motion.speed * ey,
            vy: motion.vy - motion.speed * ex,
            speed: motion.speed,
        }
    }

    /// Contact with the inner ring, without friction.
    #[inline(always)]
    pub(crate) fn contact(
        &self,
        motion: &RotorMotion,
        ring: &Centre,
        ring_speed: f64,
    ) -> RotorContact {
        let offset = self.offset(motion.angle);
        let journal = self.journal_motion(motion, offset);
        RotorContact {
            contact: journal_contact(&self.journal, &journal, &bore_motion(ring, ring_speed)),
            offset,
            friction: 0.0,
        }
    }

    /// m·g, N.
    #[inline(always)]
    pub(crate) fn weight_n(&self) -> f64 {
        self.mass * self.gravity
    }

    /// Moment about the mass centre of a force on the journal at zr + Rj·n, N·m.
    #[inline(always)]
    pub(crate) fn moment(&self, contact: &RotorContact, force: [f64; 2]) -> f64 {
        let (c, [ex, ey]) = (&contact.contact, contact.offset);
        let (ax, ay) = (
            self.journal.radius * c.nx - ex,
            self.journal.radius * c.ny - ey,
        );
        ax * force[1] - ay * force[0]
    }

    /// Acceleration of the mass centre and of the rotation under the force of the inner ring:
    /// m z̈g = F − i·m·g and Ip Ω̇ = moment of F + torque of the drive. A guided journal has the part
    /// that the force adds alone.
    #[inline(always)]
    pub(crate) fn acceleration(&self, contact: &RotorContact, force: [f64; 2]) -> [f64; 3] {
        if self.guide.is_some() {
            return self.added_acceleration(contact, force);
        }
        [
            force[0] / self.mass,
            (force[1] - self.weight_n()) / self.mass,
            (self.moment(contact, force) + self.drive_torque) / self.polar_inertia,
        ]
    }

    /// Acceleration that a force of the inner ring adds.
    #[inline(always)]
    pub(crate) fn added_acceleration(&self, contact: &RotorContact, force: [f64; 2]) -> [f64; 3] {
        self.response(force, self.moment(contact, force))
    }

    /// Accelerations under a force and a moment about the mass centre, which a guided journal has on its
    /// axis.
    #[inline(always)]
    pub(crate) fn response(&self, [fx, fy]: [f64; 2], moment: f64) -> [f64; 3] {
        match &self.guide {
            None => [fx / self.mass, fy / self.mass, moment / self.polar_inertia],
            Some(compliance) => compliance.map(|[x, y, turn]| x * fx + y * fy + turn * moment),
        }
    }

    /// Power that enters the bearing by the drive of the rotor, W; where the journal is guided,
    /// by the journal: that of the force of the inner ring on it, negative.
    #[inline(always)]
    pub(crate) fn drive_power(
        &self,
        motion: &RotorMotion,
        contact: &RotorContact,
        force: [f64; 2],
    ) -> f64 {
        if self.guide.is_some() {
            -self.power(motion, contact, force)
        } else {
            self.drive_torque * motion.speed
        }
    }

    /// Power of a force of the inner ring on the rotor, W.
    #[inline(always)]
    pub(crate) fn power(
        &self,
        motion: &RotorMotion,
        contact: &RotorContact,
        force: [f64; 2],
    ) -> f64 {
        force[0] * motion.vx + force[1] * motion.vy + self.moment(contact, force) * motion.speed
    }

    /// Accelerations of the centre of the journal and of the rotation under a unit of each load on it: with
    /// w = (εy, −εx, 1), diag(1/m, 1/m, 0) + w wᵀ/Ip.
    pub(crate) fn compliance(&self, [ex, ey]: [f64; 2]) -> JournalCompliance {
        if let Some(guide) = self.guide {
            return guide;
        }
        let w = [ey, -ex, 1.0];
        let mut rows = w.map(|a| w.map(|b| a * b / self.polar_inertia));
        for (axis, row) in rows.iter_mut().enumerate().take(2) {
            row[axis] += 1.0 / self.mass;
        }
        rows
    }

    /// Torque of a friction `friction_n` of the rotor on the inner ring, N·m: it acts at the bore.
    #[inline(always)]
    pub(crate) fn ring_torque(&self, friction_n: f64) -> f64 {
        friction_n * self.journal.bore_radius
    }

    /// Change of the sliding speed by a unit of friction, 1/kg: with a = Rj·n − ε·e^(i(θ+φ)),
    /// 1/m + (t·ia)²/Ip + 1/mi + Rb²/Ji. With the compliance G of a guided journal and
    /// p = (t, Rj), pᵀ·G·p stands for the first two.
    #[inline(always)]
    pub(crate) fn slip_mobility(&self, contact: &RotorContact, ring_mass: f64) -> f64 {
        let (c, [ex, ey]) = (&contact.contact, contact.offset);
        let rotor = match &self.guide {
            None => {
                // (t·ia) = a·n.
                let arm = self.journal.radius - (ex * c.nx + ey * c.ny);
                1.0 / self.mass + arm * arm / self.polar_inertia
            }
            Some(compliance) => {
                let along = [-c.ny, c.nx, self.journal.radius];
                let row = |[x, y, turn]: [f64; 3]| x * along[0] + y * along[1] + turn * along[2];
                row(compliance.map(row))
            }
        };
        rotor
            + 1.0 / ring_mass
            + self.journal.bore_radius * self.journal.bore_radius / self.ring_inertia
    }
}

/// Motion of the bore of a ring whose centre moves and which turns.
#[inline(always)]
pub(crate) fn bore_motion(ring: &Centre, speed: f64) -> JournalMotion {
    JournalMotion {
        x: ring.x,
        y: ring.y,
        vx: ring.vx,
        vy: ring.vy,
        speed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::friction::Smooth;

    /// A rotor whose mass centre is a fifth of its radius off the axis.
    fn eccentric() -> RotorBody {
        RotorBody {
            mass: 20.0,
            polar_inertia: 0.02,
            eccentricity: 3e-3,
            phase: 0.7,
            gravity: 0.0,
            drive_torque: 0.0,
            journal: Journal {
                radius: 14.8e-3,
                bore_radius: 15e-3,
                radial_clearance: 2e-4,
                stiffness: 1e9,
                exponent: 1.0,
                damping: 0.3,
            },
            friction: Friction::Smooth(Smooth::default()),
            ring_inertia: 5.5e-5,
            guide: None,
        }
    }

    /// A deep contact of it while it moves in every way.
    fn touching(body: &RotorBody) -> (RotorMotion, Centre, RotorContact) {
        let offset = body.offset(0.4);
        let motion = RotorMotion {
            x: 1.5e-4 + offset[0],
            y: -1.6e-4 + offset[1],
            vx: 0.3,
            vy: -0.2,
            angle: 0.4,
            speed: 321.0,
        };
        let ring = Centre {
            x: 2e-6,
            y: -3e-6,
            vx: -0.01,
            vy: 0.02,
        };
        (motion, ring, body.contact(&motion, &ring, RING_SPEED))
    }

    const RING_SPEED: f64 = -55.0;

    /// The sliding speed falls by the mobility under a unit of friction over a unit of time,
    /// wherever the mass centre is, and also where a compliance stands for the rotor.
    #[test]
    fn mobility_is_what_friction_changes_of_the_slip() {
        let (eccentric, ring_mass) = (eccentric(), 0.2);
        let centred = RotorBody {
            eccentricity: 0.0,
            ..eccentric.clone()
        };
        let guided = RotorBody {
            guide: Some([[0.07, 0.01, 0.3], [0.01, 0.04, -0.2], [0.3, -0.2, 60.0]]),
            ..centred.clone()
        };
        for body in [eccentric.clone(), centred.clone(), guided] {
            let (motion, ring, contact) = touching(&body);
            let bare = JournalContact {
                force: 0.0,
                ..contact.contact
            };
            let force = bare.force_on_journal(1.0);
            let [ax, ay, turn] = body.added_acceleration(&contact, force);
            let time = 1e-3;
            let after = RotorMotion {
                vx: motion.vx + time * ax,
                vy: motion.vy + time * ay,
                speed: motion.speed + time * turn,
                ..motion
            };
            let pushed = Centre {
                vx: ring.vx - time * force[0] / ring_mass,
                vy: ring.vy - time * force[1] / ring_mass,
                ..ring
            };
            let spun = RING_SPEED + time * body.ring_torque(1.0) / body.ring_inertia;
            let change = body.contact(&after, &pushed, spun).contact.slip - contact.contact.slip;
            let mobility = body.slip_mobility(&contact, ring_mass);
            assert!(
                (-change / time / mobility - 1.0).abs() < 1e-9,
                "{change} {mobility}"
            );
        }
        let shares = [eccentric, centred].map(|b| b.slip_mobility(&touching(&b).2, ring_mass));
        assert!((shares[0] / shares[1] - 1.0).abs() > 1e-4, "{shares:?}");
    }

    /// The powers of the contact force on rotor and ring add up to what damping and friction
    /// take and the spring stores, wherever the mass centre is.
    #[test]
    fn powers_of_the_contact_close() {
        let body = eccentric();
        let (motion, ring, contact) = touching(&body);
        assert!(contact.contact.force > 0.0);
        let friction = 0.15 * contact.contact.force;
        let force = contact.contact.force_on_journal(friction);
        let power = force[0] * (motion.vx - ring.vx)
            + force[1] * (motion.vy - ring.vy)
            + body.moment(&contact, force) * motion.speed
            + body.ring_torque(friction) * RING_SPEED;
        let c = &contact.contact;
        let expected = -c.force * c.rate - friction * c.slip;
        assert!((power / expected - 1.0).abs() < 1e-12, "{power} {expected}");
    }
}
