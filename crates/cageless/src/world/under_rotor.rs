//! The rings under a falling rotor and their joints with it, written once for plane and space.

use super::body::inner_ring::InnerRing;
use super::body::outer_ring::OuterRing;
use super::body::rigid_rotor::RigidRotor;
use super::joint::TouchLoads;
use super::joint::journal::{JournalJoint, RotorContact, TurningRing};
use super::joint::shoulder::Shoulder;
use super::step_change::StepChange;
use crate::case::Case;
use crate::contact::journal_energy_j;
use crate::dynamics::coordinates::{OuterRingCoordinate, RingCoordinate, RotorCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;

/// Constants of rings and joints.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct UnderRotor {
    pub joint: JournalJoint,
    /// None without shoulders.
    pub shoulder: Option<Shoulder>,
    pub ring: InnerRing,
    pub outer_ring: OuterRing,
}

/// Loads of the balls on the rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallLoads {
    /// Torque on the inner ring about its axis, N·m.
    pub ring_torque: f64,
    /// Force on the outer ring, N.
    pub outer_ring: [f64; 3],
}

/// Contact of the rotor with the inner ring, and what it does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touch {
    /// Contact of the journal.
    pub contact: RotorContact,
    /// Loads of all contacts.
    pub loads: TouchLoads,
    /// Heat of friction, W.
    pub heat: f64,
    /// Power that damping takes out, W.
    pub damping_power: f64,
}

impl UnderRotor {
    /// Constants of a case that has a rotor, between these rings.
    pub(crate) fn of_case(case: &Case, ring: InnerRing, outer_ring: OuterRing) -> Option<Self> {
        let (rotor, bore) = (case.rotor.as_ref()?, case.bearing.inner_ring_bore()?);
        let ring = InnerRing {
            polar_inertia: bore.polar_inertia_kg_m2,
            ..ring
        };
        let rigid = RigidRotor::of_case(rotor, case).compliance();
        let joint = JournalJoint::in_bore(rotor, bore);
        let groove_m = case.bearing.dimensions().inner_groove_bottom_radius_m;
        Some(Self {
            joint: joint.sticking(rotor, &rigid, &ring, case.solver.step_s),
            shoulder: Shoulder::new(rotor, 0.5 * (bore.radius_m + groove_m)),
            ring,
            outer_ring,
        })
    }

    /// Motion of the inner ring of a state.
    #[inline(always)]
    pub(crate) fn turning_ring(layout: Layout, y: &[f64]) -> TurningRing {
        TurningRing {
            centre: layout.ring_motion(y),
            speed: layout.at(y, RingCoordinate::Speed),
        }
    }

    /// Contact of the journal in a state, without friction.
    #[inline(always)]
    pub(crate) fn contact(&self, layout: Layout, y: &[f64]) -> RotorContact {
        let motion = layout.rotor_motion(y).unwrap_or_default();
        let ring = Self::turning_ring(layout, y);
        self.joint.contact(&motion, &ring)
    }

    /// Sliding speed of the journal along the directions of a contact in a state, m/s.
    #[inline(always)]
    pub(crate) fn slip(&self, contact: &RotorContact, layout: Layout, y: &[f64]) -> f64 {
        let motion = layout.rotor_motion(y).unwrap_or_default();
        let ring = Self::turning_ring(layout, y);
        self.joint.slip(contact, &motion, &ring)
    }

    /// Z of the rotor from that of the inner ring, m.
    pub(crate) fn axial_distance(&self, layout: Layout, y: &[f64]) -> f64 {
        self.joint.seat.z + layout.at(y, RotorCoordinate::Z) - layout.at(y, RingCoordinate::Z)
    }

    /// Contact of the journal of a state in the plane; friction only if asked for.
    #[inline(always)]
    pub(crate) fn touch_in_plane(&self, layout: Layout, y: &[f64], with_friction: bool) -> Touch {
        let mut contact = self.contact(layout, y);
        let c = contact.contact;
        if with_friction {
            [contact.friction, _] = self.joint.friction.force(c.slip, c.force);
        }
        Touch {
            contact,
            loads: self.joint.loads(&contact, c.force, contact.friction),
            heat: contact.friction * c.slip,
            damping_power: c.damping_power,
        }
    }

    /// Sets the rates of the outer ring and of the turning of the inner ring, and the powers of the
    /// ledger; the inner ring has its own already.
    pub(crate) fn set_rates(
        &self,
        layout: Layout,
        balls: &BallLoads,
        touch: &Touch,
        y: &[f64],
        dydt: &mut [f64],
    ) {
        let motion = layout.rotor_motion(y).unwrap_or_default();
        let outer = layout.outer_ring_motion(y);
        let along_axis = layout.outer_ring_along_axis(y);
        let torque = touch.loads.ring_torque + balls.ring_torque;
        layout.set(
            dydt,
            RingCoordinate::Speed,
            torque / self.ring.polar_inertia,
        );
        let [ox, oy, oz] = (self.outer_ring).acceleration(&outer, &along_axis, balls.outer_ring);
        for (coordinate, rate) in [
            (OuterRingCoordinate::X, outer.vx),
            (OuterRingCoordinate::Y, outer.vy),
            (OuterRingCoordinate::Z, along_axis.vz),
            (OuterRingCoordinate::Vx, ox),
            (OuterRingCoordinate::Vy, oy),
            (OuterRingCoordinate::Vz, oz),
        ] {
            layout.set(dydt, coordinate, rate);
        }
        let support = &self.outer_ring.support;
        for (term, power) in [
            (EnergyTerm::Drive, -motion.power(&touch.loads)),
            (EnergyTerm::RotorFriction, touch.heat),
            (EnergyTerm::RotorDamping, touch.damping_power),
            (
                EnergyTerm::SupportDamping,
                support.damping_power(&outer, along_axis.vz),
            ),
        ] {
            dydt[layout.energy_term(term)] = power;
        }
    }

    /// Adds what the friction of the balls does to the turning of the inner ring and to the outer ring over
    /// a step.
    pub(crate) fn add_ball_friction(&self, balls: &BallLoads, change: &mut StepChange<'_>) {
        let turning = balls.ring_torque / self.ring.polar_inertia;
        change.add(RingCoordinate::Speed, turning);
        let [x, y, z] = balls.outer_ring;
        let ring = &self.outer_ring;
        change.add(OuterRingCoordinate::Vx, x * ring.inverse_mass);
        change.add(OuterRingCoordinate::Vy, y * ring.inverse_mass);
        change.add(OuterRingCoordinate::Vz, z * ring.axial_inverse_mass);
    }

    /// Adds what the friction of the rotor does to the inner ring over a step, and its heat.
    pub(crate) fn add_touch_friction(
        &self,
        loads: &TouchLoads,
        heat: f64,
        change: &mut StepChange<'_>,
    ) {
        let turning = loads.ring_torque / self.ring.polar_inertia;
        change.add(RingCoordinate::Speed, turning);
        let [x, y, z] = loads.force.map(|force| -force / self.ring.mass);
        change.add(RingCoordinate::Vx, x);
        change.add(RingCoordinate::Vy, y);
        change.add(RingCoordinate::Vz, z);
        change.add_energy(EnergyTerm::RotorFriction, heat);
    }

    /// Energy of the outer ring, of the turning of the inner ring and of all joints, J.
    pub(crate) fn energy_j(&self, layout: Layout, y: &[f64]) -> f64 {
        let ring_speed = layout.at(y, RingCoordinate::Speed);
        let journal = &self.joint.journal;
        let depth = self.contact(layout, y).contact.deflection;
        let z = self.axial_distance(layout, y);
        let at_face = (self.shoulder).map_or(0.0, |shoulder| shoulder.energy_j(journal, z));
        let outer = layout.outer_ring_motion(y);
        0.5 * self.ring.polar_inertia * ring_speed * ring_speed
            + journal_energy_j(journal, depth)
            + at_face
            + (self.outer_ring).energy_j(&outer, &layout.outer_ring_along_axis(y))
    }
}
