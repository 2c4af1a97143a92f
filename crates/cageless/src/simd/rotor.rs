//! The bodies under a falling rotor: reactions of the balls, and their motion.

use super::beginning::sticking_weight;
use super::flanks;
use super::friction::loaded_slips;
use super::implicit_friction::{apply, circumference, inner_friction_reactions, solve};
use super::motions::{CentreLanes, Motions, Moving, ring_speeds};
use super::parameters::Parameters;
use super::sums::{Addends, Sum, Sums};
use super::workspace::{BlockResults, Workspace};
use crate::ball::{BallLanes, BothContacts};
use crate::contact::{
    InnerRaceway, JournalSlip, end_weights, implicit_slip, inner_slip, outer_slip, positive,
    with_law,
};
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::numerics::lanes::{LANES, Lanes};
use crate::world::step_change::StepChange;
use crate::world::under_rotor::{BallLoads, Touch};

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

/// Forces of the balls of one bearing on its rings.
#[inline(always)]
fn ball_loads(p: &Parameters, bearing: usize, sums: &Sums) -> BallLoads {
    let total = |sum: Sum| sums.total(sum, p.layout.width() == 1, bearing);
    BallLoads {
        ring_torque: total(Sum::RingTorque),
        outer_ring: [total(Sum::OuterX), total(Sum::OuterY), 0.0],
    }
}

/// Rates of the bodies under the rotor of one bearing but those of the inner ring, and the powers of its
/// energy ledger.
#[inline(always)]
pub(super) fn set_rates_under_rotor(
    p: &Parameters,
    bearing: usize,
    sums: &Sums,
    touch: &Touch,
    y: &[f64],
    dydt: &mut [f64],
) {
    let layout = p.layout.of_bearing(bearing);
    let balls = ball_loads(p, bearing, sums);
    p.drops[bearing].set_rates(layout, &balls, touch, y, dydt);
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
    with_law!(&p.friction, law => solve(law, p, w, y, h_s));
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let balls = p.balls(block);
        let against = |lane| circumference(results, lane);
        let change = StepChange {
            layout: p.layout,
            h_s,
            y: &mut *y,
            dydt: &mut *dydt,
        };
        apply(balls, block, results, against, change);
        inner_friction_reactions(results, &mut addends);
        outer_friction_reactions(results, &mut addends);
        flanks::add_reactions(results, &mut addends);
        ring_torques(p, results, &mut addends);
        w.sums.add(&Sum::RING_FRICTION, &addends, alone, block);
    }
    for bearing in 0..p.layout.width() {
        let mut change = StepChange {
            layout: p.layout.of_bearing(bearing),
            h_s,
            y,
            dydt,
        };
        add_ball_friction(p, &w.sums, bearing, &mut change);
        journal_friction(p, w, bearing, y0, &mut change);
    }
    add_heat(p, w, [y0, y]);
    for bearing in 0..p.layout.width() {
        let mut change = StepChange {
            layout: p.layout.of_bearing(bearing),
            h_s,
            y,
            dydt,
        };
        for (term, sum) in [
            (EnergyTerm::InnerFriction, Sum::InnerFriction),
            (EnergyTerm::OuterFriction, Sum::OuterFriction),
        ] {
            change.add_energy(term, w.sums.total(sum, alone, bearing));
        }
    }
}

/// Sums the heat of the balls over a step by the mean of the sliding speeds at both ends, and leaves those of
/// its end.
#[inline(always)]
fn add_heat(p: &Parameters, w: &mut Workspace, [y0, y]: [&[f64]; 2]) {
    let alone = p.layout.width() == 1;
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    let (start, end) = (RingMotion::new(p, y0), RingMotion::new(p, y));
    let mut slip_max = Lanes::ZERO;
    for (block, (results, friction)) in w.blocks.iter_mut().zip(&w.friction).enumerate() {
        let balls = p.balls(block);
        let motions_start = Motions::new(p.layout, y0, block);
        let motions_end = Motions::new(p.layout, y, block);
        let before = slip_speeds(p, balls, results, motions_start, &start);
        let after = slip_speeds(p, balls, results, motions_end, &end);
        for lane in 0..LANES {
            let mean = |before: &Lanes, after: &Lanes| 0.5 * (before.0[lane] + after.0[lane]);
            let outer = mean(&before.outer, &after.outer);
            let inner = mean(&before.inner, &after.inner);
            addends[Sum::OuterFriction as usize].0[lane] = results.outer_friction.0[lane] * outer;
            addends[Sum::InnerFriction as usize].0[lane] = results.inner_friction.0[lane] * inner;
        }
        let ends = [
            Moving {
                balls: motions_start,
                ring: &start.outer,
            },
            Moving {
                balls: motions_end,
                ring: &end.outer,
            },
        ];
        flanks::add_heat(results, ends, &mut addends);
        (results.outer.slip, results.inner.slip) = (after.outer, after.inner);
        results.outer_friction = friction.slips.outer_friction;
        results.inner_friction = friction.slips.inner_friction;
        loaded_slips(results, &mut slip_max);
        w.sums.add(&Sum::HEAT, &addends, alone, block);
    }
    w.slip_max = slip_max;
    w.slips_known = true;
}

/// Adds the friction of the balls to both rings.
#[inline(always)]
fn add_ball_friction(p: &Parameters, sums: &Sums, bearing: usize, change: &mut StepChange<'_>) {
    let total = |sum: Sum| sums.total(sum, p.layout.width() == 1, bearing);
    let mass = p.ring.mass.0[bearing];
    change.add(RingCoordinate::Vx, total(Sum::RingX) / mass);
    change.add(RingCoordinate::Vy, total(Sum::RingY) / mass);
    p.drops[bearing].add_ball_friction(&ball_loads(p, bearing, sums), change);
}

/// Adds the friction between rotor and inner ring over the step, and its heat.
#[inline(always)]
fn journal_friction(
    p: &Parameters,
    w: &mut Workspace,
    bearing: usize,
    y0: &[f64],
    change: &mut StepChange<'_>,
) {
    let (under, layout) = (&p.drops[bearing], change.layout);
    let (joint, contact) = (&under.joint, &mut w.rotors[bearing]);
    let start = under.slip(contact, layout, y0);
    let free = under.slip(contact, layout, change.y);
    let rotor = &w.rotor_compliances[bearing];
    let mobility = change.h_s * joint.slip_mobility(rotor, &under.ring, contact);
    let load = contact.contact.force;
    let before = w.rotor_slips[bearing];
    let extrapolated = JournalSlip::at(contact.contact.slip, &joint.friction, load);
    let weight = if !w.slips_known {
        1.0
    } else if joint.friction.sticks() {
        sticking_weight(before.slip)
    } else {
        end_weights([mobility * positive(before.slope); 2])[0]
    };
    let given = (1.0 - weight) * before.friction;
    let end = implicit_slip(
        &joint.friction,
        free - mobility * given,
        weight * mobility,
        load,
        extrapolated,
    );
    let mean = given + weight * end.friction;
    (contact.friction, contact.contact.slip) = (end.friction, end.slip);
    w.rotor_slips[bearing] = end;
    w.rotor_friction_mean[bearing] = mean;
    let loads = joint.loads(contact, 0.0, mean);
    let heat = mean * 0.5 * (start + end.slip);
    under.add_touch_friction(&loads, heat, change);
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
) -> BothContacts<Lanes> {
    let mut slips = BothContacts {
        outer: Lanes::ZERO,
        inner: Lanes::ZERO,
    };
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
        slips.outer.0[lane] = outer_slip(&geometry, &motion, &outer_polar);
        slips.inner.0[lane] = inner_slip(&ball, &raceway, &motion, &inner_polar);
    }
    slips
}
