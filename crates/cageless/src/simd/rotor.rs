//! The bodies under a falling rotor: reactions of the balls, and their motion.

use super::beginning::sticking_weight;
use super::flanks;
use super::friction::loaded_slips;
use super::implicit_friction::{apply, circumference, inner_friction_reactions, solve};
use super::motions::{CentreLanes, Motions, ring_speeds};
use super::parameters::Parameters;
use super::sums::{Addends, Sum, Sums};
use super::workspace::{BlockResults, Workspace};
use crate::contact::{
    InnerRaceway, JournalSlip, end_weights, implicit_slip, inner_slip, journal_slip, outer_slip,
    positive, with_law,
};
use crate::dynamics::ball::BallLanes;
use crate::dynamics::coordinates::{DropCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::dynamics::rotor::{RotorBody, RotorContact, bore_motion};
use crate::numerics::lanes::{LANES, Lanes};

/// Forces of the balls of a block on the outer ring: what the loads of their outer contacts are
/// without the weights.
#[inline(always)]
pub(super) fn outer_ring_reactions(
    p: &Parameters,
    balls: &BallLanes,
    results: &BlockResults,
    addends: &mut Addends,
) {
    for lane in 0..LANES {
        let weight = balls.mass.0[lane] * p.ring.gravity.0[lane];
        addends[Sum::OuterX as usize].0[lane] = -results.load.fx.0[lane];
        addends[Sum::OuterY as usize].0[lane] = -results.load.fy.0[lane] - weight;
    }
}

/// Friction forces of the balls of a block on the outer ring.
#[inline(always)]
pub(super) fn outer_friction_reactions(results: &BlockResults, addends: &mut Addends) {
    for lane in 0..LANES {
        let friction = results.outer_friction.0[lane];
        addends[Sum::OuterX as usize].0[lane] = -friction * results.polar.ey.0[lane];
        addends[Sum::OuterY as usize].0[lane] = friction * results.polar.ex.0[lane];
    }
}

/// Torques of friction on the inner ring, counter-clockwise: −Ri·f.
#[inline(always)]
pub(super) fn ring_torques(p: &Parameters, results: &BlockResults, addends: &mut Addends) {
    for lane in 0..LANES {
        addends[Sum::RingTorque as usize].0[lane] =
            -p.inner.radius.0[lane] * results.inner_friction.0[lane];
    }
}

/// Motion of inner ring, outer ring and rotor of one bearing and the powers of its energy ledger;
/// without friction of the rotor if a method treats friction implicitly.
#[inline(always)]
pub(super) fn rotor_and_ledger(
    p: &Parameters,
    bearing: usize,
    sums: &Sums,
    y: &[f64],
    dydt: &mut [f64],
    with_friction: bool,
) -> RotorContact {
    let layout = p.layout.of_bearing(bearing);
    let total = |sum: Sum| sums.total(sum, layout.width() == 1, bearing);
    let (body, outer_ring) = &p.drops[bearing];
    let ring = p.ring.get(bearing);
    let (motion, outer) = (layout.ring_motion(y), layout.outer_ring_motion(y));
    let ring_speed = y[layout.drop(DropCoordinate::RingSpeed)];
    let rotor = layout.rotor_motion(y).unwrap_or_default();
    let mut contact = body.contact(&rotor, &motion, ring_speed);
    if with_friction {
        let c = &contact.contact;
        [contact.friction, _] = body.friction.force(c.slip, c.force);
    }
    let friction = contact.friction;
    let force = contact.contact.force_on_journal(friction);
    let [ax, ay] = ring.acceleration(
        &motion,
        [total(Sum::RingX) - force[0], total(Sum::RingY) - force[1]],
    );
    for (coordinate, rate) in [
        (RingCoordinate::X, motion.vx),
        (RingCoordinate::Y, motion.vy),
        (RingCoordinate::Vx, ax),
        (RingCoordinate::Vy, ay),
    ] {
        dydt[layout.ring(coordinate)] = rate;
    }
    let torque = body.ring_torque(friction) + total(Sum::RingTorque);
    let [ox, oy] = outer_ring.acceleration(&outer, [total(Sum::OuterX), total(Sum::OuterY)]);
    let [gx, gy, spin] = body.acceleration(&contact, force);
    for (coordinate, rate) in [
        (DropCoordinate::RingSpeed, torque / body.ring_inertia),
        (DropCoordinate::OuterX, outer.vx),
        (DropCoordinate::OuterY, outer.vy),
        (DropCoordinate::OuterVx, ox),
        (DropCoordinate::OuterVy, oy),
        (DropCoordinate::RotorX, rotor.vx),
        (DropCoordinate::RotorY, rotor.vy),
        (DropCoordinate::RotorAngle, rotor.speed),
        (DropCoordinate::RotorVx, gx),
        (DropCoordinate::RotorVy, gy),
        (DropCoordinate::RotorSpeed, spin),
    ] {
        dydt[layout.drop(coordinate)] = rate;
    }
    for term in EnergyTerm::ALL {
        dydt[layout.energy_term(term)] = match term {
            EnergyTerm::Drive => body.drive_power(&rotor, &contact, force),
            EnergyTerm::Weight => {
                total(Sum::Weight) - ring.weight_n() * motion.vy - body.weight_n() * rotor.vy
            }
            EnergyTerm::InnerFriction => total(Sum::InnerFriction),
            EnergyTerm::OuterFriction => total(Sum::OuterFriction),
            EnergyTerm::BallFriction => total(Sum::BallFriction),
            EnergyTerm::Damping => total(Sum::RacewayDamping) + total(Sum::BallDamping),
            EnergyTerm::Drag => ring.drag * (motion.vx * motion.vx + motion.vy * motion.vy),
            EnergyTerm::RotorFriction => friction * contact.contact.slip,
            EnergyTerm::RotorDamping => contact.contact.damping_power,
            EnergyTerm::SupportDamping => outer_ring.damping_power(&outer),
            EnergyTerm::Load
            | EnergyTerm::Centrifugal
            | EnergyTerm::FrictionDirection
            | EnergyTerm::RelativeSpin => 0.0,
        };
    }
    contact
}

/// Adds friction at the raceways and at the journal over a step of `h_s`, see
/// [`super::add_implicit_friction`].
///
/// The balls are solved for the motion of the rings that the step was extrapolated to, then the
/// journal for the ring that the friction of the balls leads to. The friction of a ball answers to
/// the surface speed of the ring like a mass of at most its own, so that the ring, whose Ji/Ri² is
/// many times that of all balls, receives what is left of the coupling at the next step. Heat is
/// friction times the mean of the sliding speeds at both ends of the step with the rings where
/// they are then.
#[inline(always)]
pub(super) fn add_with_rotor(
    p: &Parameters,
    w: &mut Workspace,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let alone = p.layout.width() == 1;
    w.sums.clear(alone);
    with_law!(&p.friction, law => solve::<_, true>(law, p, w, y, h_s));
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let balls = p.balls(block);
        let against = |lane| circumference(results, lane);
        apply((p, balls, block), results, against, h_s, y, dydt);
        inner_friction_reactions(results, &mut addends);
        outer_friction_reactions(results, &mut addends);
        flanks::add_reactions(results, &mut addends);
        ring_torques(p, results, &mut addends);
        w.sums.add(&Sum::RING_FRICTION, &addends, alone, block);
    }
    for bearing in 0..p.layout.width() {
        for (place, rate) in ring_friction(p, &w.sums, bearing) {
            dydt[place] += rate;
            y[place] += h_s * rate;
        }
        journal_friction(p, w, bearing, h_s, y0, y, dydt);
    }
    let (start, end) = (RingMotion::new(p, y0), RingMotion::new(p, y));
    let mut slip_max = Lanes::ZERO;
    for (block, (results, friction)) in w.blocks.iter_mut().zip(&w.friction).enumerate() {
        let balls = p.balls(block);
        let motions_start = Motions::new(p.layout, y0, block);
        let motions_end = Motions::new(p.layout, y, block);
        let before = slip_speeds(p, balls, results, motions_start, &start);
        let after = slip_speeds(p, balls, results, motions_end, &end);
        for lane in 0..LANES {
            let mean = |k: usize| 0.5 * (before[k].0[lane] + after[k].0[lane]);
            addends[Sum::OuterFriction as usize].0[lane] = results.outer_friction.0[lane] * mean(0);
            addends[Sum::InnerFriction as usize].0[lane] = results.inner_friction.0[lane] * mean(1);
        }
        let ends = [(motions_start, &start.outer), (motions_end, &end.outer)];
        flanks::add_heat::<true>(results, ends, &mut addends);
        let [outer, inner] = after;
        (results.outer.slip, results.inner.slip) = (outer, inner);
        results.outer_friction = friction.slips.outer_friction;
        results.inner_friction = friction.slips.inner_friction;
        loaded_slips(results, &mut slip_max);
        w.sums.add(&Sum::HEAT, &addends, alone, block);
    }
    w.slip_max = slip_max;
    w.slips_known = true;
    for bearing in 0..p.layout.width() {
        let layout = p.layout.of_bearing(bearing);
        for (term, sum) in [
            (EnergyTerm::InnerFriction, Sum::InnerFriction),
            (EnergyTerm::OuterFriction, Sum::OuterFriction),
        ] {
            let heat = w.sums.total(sum, alone, bearing);
            let place = layout.energy_term(term);
            dydt[place] += heat;
            y[place] += h_s * heat;
        }
    }
}

/// Accelerations of both rings by the friction of the balls.
#[inline(always)]
fn ring_friction(p: &Parameters, sums: &Sums, bearing: usize) -> [(usize, f64); 5] {
    let layout = p.layout.of_bearing(bearing);
    let total = |sum: Sum| sums.total(sum, layout.width() == 1, bearing);
    let (body, outer_ring) = &p.drops[bearing];
    let mass = p.ring.mass.0[bearing];
    [
        (layout.ring(RingCoordinate::Vx), total(Sum::RingX) / mass),
        (layout.ring(RingCoordinate::Vy), total(Sum::RingY) / mass),
        (
            layout.drop(DropCoordinate::RingSpeed),
            total(Sum::RingTorque) / body.ring_inertia,
        ),
        (
            layout.drop(DropCoordinate::OuterVx),
            total(Sum::OuterX) * outer_ring.inverse_mass,
        ),
        (
            layout.drop(DropCoordinate::OuterVy),
            total(Sum::OuterY) * outer_ring.inverse_mass,
        ),
    ]
}

/// Adds the friction between rotor and inner ring over the step, and its heat.
#[inline(always)]
fn journal_friction(
    p: &Parameters,
    w: &mut Workspace,
    bearing: usize,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let layout = p.layout.of_bearing(bearing);
    let (body, _) = &p.drops[bearing];
    let mass = p.ring.mass.0[bearing];
    let rotor = &mut w.rotors[bearing];
    let normal = [rotor.contact.nx, rotor.contact.ny];
    let sliding = |values: &[f64]| sliding_of_journal(layout, body, rotor, values);
    let (start, free) = (sliding(y0), sliding(y));
    let mobility = h_s * body.slip_mobility(rotor, mass);
    let load = rotor.contact.force;
    let before = w.rotor_slips[bearing];
    let extrapolated = JournalSlip::at(rotor.contact.slip, &body.friction, load);
    let weight = if !w.slips_known {
        1.0
    } else if body.friction.sticks() {
        sticking_weight(before.slip)
    } else {
        end_weights([mobility * positive(before.slope); 2])[0]
    };
    let given = (1.0 - weight) * before.friction;
    let end = implicit_slip(
        &body.friction,
        free - mobility * given,
        weight * mobility,
        load,
        extrapolated,
    );
    let mean = given + weight * end.friction;
    (rotor.friction, rotor.contact.slip) = (end.friction, end.slip);
    w.rotor_slips[bearing] = end;
    w.rotor_friction_mean[bearing] = mean;
    let force = [mean * normal[1], -mean * normal[0]];
    let [vx, vy, spin] = body.added_acceleration(rotor, force);
    for (place, rate) in [
        (layout.ring(RingCoordinate::Vx), -force[0] / mass),
        (layout.ring(RingCoordinate::Vy), -force[1] / mass),
        (
            layout.drop(DropCoordinate::RingSpeed),
            body.ring_torque(mean) / body.ring_inertia,
        ),
        (layout.drop(DropCoordinate::RotorVx), vx),
        (layout.drop(DropCoordinate::RotorVy), vy),
        (layout.drop(DropCoordinate::RotorSpeed), spin),
    ] {
        dydt[place] += rate;
        y[place] += h_s * rate;
    }
    let heat = mean * 0.5 * (start + end.slip);
    let place = layout.energy_term(EnergyTerm::RotorFriction);
    dydt[place] += heat;
    y[place] += h_s * heat;
}

/// Sliding speed of the journal in the bore along the directions of the last evaluation, m/s.
#[inline(always)]
fn sliding_of_journal(
    layout: Layout,
    body: &RotorBody,
    rotor: &RotorContact,
    values: &[f64],
) -> f64 {
    let motion = layout.rotor_motion(values).unwrap_or_default();
    let speed = values[layout.drop(DropCoordinate::RingSpeed)];
    let bore = bore_motion(&layout.ring_motion(values), speed);
    let journal = body.journal_motion(&motion, rotor.offset);
    let normal = [rotor.contact.nx, rotor.contact.ny];
    journal_slip(&body.journal, normal, &journal, &bore)
}

/// Centres of both rings and the speed of the inner one, of each lane.
struct RingMotion {
    inner: CentreLanes,
    outer: CentreLanes,
    speed: Lanes,
}

impl RingMotion {
    #[inline(always)]
    fn new(p: &Parameters, y: &[f64]) -> Self {
        Self {
            inner: CentreLanes::inner_ring(p.layout, y),
            outer: CentreLanes::outer_ring(p.layout, y),
            speed: ring_speeds(p.layout, y),
        }
    }
}

/// ΔVo and ΔVi of the balls of a block along the directions of the last evaluation, m/s.
#[inline(always)]
fn slip_speeds(
    p: &Parameters,
    balls: &BallLanes,
    results: &BlockResults,
    motions: Motions<'_>,
    rings: &RingMotion,
) -> [Lanes; 2] {
    let mut slips = [Lanes::ZERO; 2];
    for lane in 0..LANES {
        let motion = motions.get(lane);
        let outer_polar = results.polar.get(lane);
        let outer_polar = outer_polar.with_velocity(&motion, &rings.outer.get(lane));
        let inner_polar = results.inner_polar.get(lane);
        let inner_polar = inner_polar.with_velocity(&motion, &rings.inner.get(lane));
        let radius = p.inner.radius.0[lane];
        let raceway = InnerRaceway {
            radius,
            surface_speed: rings.speed.0[lane] * radius,
            following: p.inner.following.0[lane],
        };
        let (ball, geometry) = (balls.get(lane), results.geometry.get(lane));
        slips[0].0[lane] = outer_slip(&geometry, &motion, &outer_polar);
        slips[1].0[lane] = inner_slip(&ball, &raceway, &motion, &inner_polar);
    }
    slips
}
