//! Balls on elastic flanks of a discrete raceway: what differs from rigid ones, which are computed
//! for all lanes before. Few balls are in a raceway at a time, so that these are taken one by one.

use super::beginning::Beginning;
use super::creep;
use super::friction::at_raceways;
use super::motions::{CentreLanes, Motions, Moving};
use super::parameters::{Parameters, RacewayBlock};
use super::sums::{Addends, Sum};
use super::traction;
use super::workspace::{BlockResults, ImplicitFriction};
use crate::ball::{BallLanes, BallMotion, BothContacts};
use crate::contact::{
    AtFlanks, FlankShape, FlankSliding, Law, LawLanes, RacewayContacts, RacewayPosition,
    SlipProblem, end_weights, flank_contact, further_step, outer_load, slope_force, with_law,
};
use crate::numerics::lane_set::LaneSet;
use crate::numerics::lanes::{LANES, Lanes};

/// Puts the outer contacts of balls on flanks and their loads in place of those of rigid ones; without
/// friction if a method treats it implicitly.
#[inline(always)]
pub(super) fn outer_contacts(
    p: &Parameters,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    addends: &mut Addends,
    with_friction: bool,
) {
    results.on_flanks = LaneSet::NONE;
    if !p.unequal {
        results.slope_force = Lanes::ZERO;
    }
    if with_friction {
        (results.across_friction, results.spin_moment) = (Lanes::ZERO, Lanes::ZERO);
    }
    for raceway in &p.raceways {
        let here = LaneSet::of(|lane| {
            let constants = raceway.constants.get(lane);
            RacewayPosition::new(&constants, &results.polar.get(lane)).inside()
        });
        results.on_flanks = results.on_flanks.or(here);
        for lane in here {
            contact(p, balls, raceway, results, motions, lane);
        }
    }
    if with_friction {
        with_law!(&p.friction, law => friction(law, results));
    }
    loads(p, balls, results, addends, with_friction);
}

#[inline(always)]
fn contact(
    p: &Parameters,
    balls: &BallLanes,
    raceway: &RacewayBlock,
    results: &mut BlockResults,
    motions: Motions<'_>,
    lane: usize,
) {
    let (ball, outer, constants) = (
        balls.get(lane),
        p.outer.get(lane),
        raceway.constants.get(lane),
    );
    let polar = results.polar.get(lane);
    let position = RacewayPosition::new(&constants, &polar);
    let values = raceway.flanks[lane % raceway.flanks.len()].values(position.u);
    let shape = FlankShape::new(&constants, &outer, &ball, &position, &values);
    let (geometry, motion) = (results.geometry.get(lane), motions.get(lane));
    let (geometry, contact, flanks) =
        flank_contact(&ball, &outer, &shape, &geometry, &motion, &polar);
    results.geometry.put(lane, geometry);
    results.outer.put(lane, contact);
    results.flanks.put(lane, flanks);
    if let Some(constants) = &p.creep {
        creep::set_knee_on_flanks(constants, results, &motion, lane);
    }
    if let Some([outer, _]) = p.tractions() {
        traction::set_on_flanks(&outer.get(lane), ball.radius, results, &motion, lane);
    }
}

/// Friction of balls on flanks from their velocities.
#[inline(always)]
fn friction(law: &impl LawLanes, results: &mut BlockResults) {
    for lane in results.on_flanks {
        let (slip, normal) = (
            results.outer.slip.0[lane],
            results.outer.friction_normal.0[lane],
        );
        let law = extrapolated_law(at_raceways(law.lane(lane), results, lane), results, lane);
        let [radial, spin] = law.drag(&results.flanks.get(lane), slip, normal);
        [results.outer_friction.0[lane], _] = law.force(slip, normal);
        results.across_friction.0[lane] = radial * results.polar.radial.0[lane];
        results.spin_moment.0[lane] = spin * results.spin.0[lane];
    }
}

/// The law at the flanks of a ball under the velocities of the last evaluation.
#[inline(always)]
fn extrapolated_law<L: Law>(law: L, results: &BlockResults, lane: usize) -> AtFlanks<L> {
    let (radial, rotation) = (results.polar.radial.0[lane], results.spin.0[lane]);
    let sliding = FlankSliding::new(&law, &results.flanks.get(lane), radial, rotation);
    AtFlanks { law, sliding }
}

/// Loads of outer contacts and weights of balls on flanks, and the powers.
#[inline(always)]
fn loads(
    p: &Parameters,
    balls: &BallLanes,
    results: &mut BlockResults,
    addends: &mut Addends,
    with_friction: bool,
) {
    for lane in results.on_flanks {
        let (outer, geometry) = (results.outer.get(lane), results.geometry.get(lane));
        let polar = results.polar.get(lane);
        let friction = results.outer_friction.0[lane];
        let mut load = outer_load(&outer, &geometry, &polar, friction);
        load.fy -= balls.mass.0[lane] * p.ring.gravity.0[lane];
        let along = slope_force(&outer, &geometry, polar.distance);
        load.fx -= along * polar.ey;
        load.fy += along * polar.ex;
        results.slope_force.0[lane] = along;
        let mut heat = friction * outer.slip;
        if with_friction {
            let (across, moment) = (results.across_friction.0[lane], results.spin_moment.0[lane]);
            load.fx -= across * polar.ex;
            load.fy -= across * polar.ey;
            load.torque -= moment;
            heat += across * polar.radial + moment * results.spin.0[lane];
        }
        results.load.put(lane, load);
        addends[Sum::OuterFriction as usize].0[lane] = heat;
        addends[Sum::RacewayDamping as usize].0[lane] = outer.damping_power;
    }
}

/// Adds the accelerations by friction along the radius and about the axis.
#[inline(always)]
pub(super) fn add_accelerations(
    balls: &BallLanes,
    results: &BlockResults,
    rates: &mut [[f64; LANES]; 3],
) {
    for lane in results.on_flanks {
        let ball = balls.get(lane);
        let push = results.across_friction.0[lane] * ball.inverse_mass;
        rates[0][lane] -= push * results.polar.ex.0[lane];
        rates[1][lane] -= push * results.polar.ey.0[lane];
        rates[2][lane] -= results.spin_moment.0[lane] * ball.inverse_inertia;
    }
}

/// Adds the friction along the radius to the forces on the outer ring.
#[inline(always)]
pub(super) fn add_reactions(results: &BlockResults, addends: &mut Addends) {
    for lane in results.on_flanks {
        let across = results.across_friction.0[lane];
        addends[Sum::OuterX as usize].0[lane] += across * results.polar.ex.0[lane];
        addends[Sum::OuterY as usize].0[lane] += across * results.polar.ey.0[lane];
    }
}

/// Adds the heat of friction along the radius and about the axis over a step between two motions of
/// the balls and the outer ring.
#[inline(always)]
pub(super) fn add_heat(results: &BlockResults, ends: [Moving<'_>; 2], addends: &mut Addends) {
    for lane in results.on_flanks {
        let polar = results.polar.get(lane);
        let (mut radial, mut spin) = (0.0, 0.0);
        for moving in ends {
            let (motion, outer_ring) = (moving.balls.get(lane), moving.ring.get(lane));
            radial += polar.with_velocity(&motion, &outer_ring).radial;
            spin += motion.spin;
        }
        addends[Sum::OuterFriction as usize].0[lane] +=
            0.5 * (results.across_friction.0[lane] * radial + results.spin_moment.0[lane] * spin);
    }
}

/// Keeps the slips of the balls on flanks.
#[inline(always)]
pub(super) fn keep_slips(results: &BlockResults, friction: &mut ImplicitFriction) {
    for lane in results.on_flanks {
        friction.kept.put(lane, friction.slips.get(lane));
    }
}

/// [`keep_slips`] at the start of a step; clears the drags of the balls that were not on flanks in the
/// step before, if that was one with implicit friction.
#[inline(always)]
pub(super) fn keep_start(results: &mut BlockResults, friction: &mut ImplicitFriction, known: bool) {
    keep_slips(results, friction);
    for lane in results.on_flanks {
        if known && !friction.on_flanks.has(lane) {
            friction.drags[0].0[lane] = 0.0;
            friction.drags[1].0[lane] = 0.0;
            results.across_friction.0[lane] = 0.0;
            results.spin_moment.0[lane] = 0.0;
        }
    }
    friction.on_flanks = results.on_flanks;
}

/// Puts the equations of the friction of balls on flanks in place of those of rigid ones, with the
/// slips of [`keep_start`].
///
/// v₁, the sliding along the groove and the coefficients C of the two drags, along the radius and
/// about the axis, are those of the velocities extrapolated to the end of the step. The drags D = C v
/// act before the other friction: with the end velocity v = v_x + h A (D_x − (1 − θ) D₀ − θ D₁), v_x
/// extrapolated with the drag D_x of the last step, they are of order 2 and damp as the other friction
/// does.
#[inline(always)]
pub(super) fn first_iterate<L: LawLanes, const KNOWN: bool>(
    law: &L,
    p: &Parameters,
    (balls, [ring, outer_ring], motions): (&BallLanes, [&CentreLanes; 2], Motions<'_>),
    h_s: f64,
    results: &mut BlockResults,
    friction: &mut ImplicitFriction,
) {
    for lane in results.on_flanks {
        let (ball, motion) = (balls.get(lane), motions.get(lane));
        let (outer, flanks) = (results.outer.get(lane), results.flanks.get(lane));
        let at_flanks = extrapolated_law(at_raceways(law.lane(lane), results, lane), results, lane);
        let coefficients = at_flanks.drag(&flanks, outer.slip, outer.friction_normal);
        let mobility = [h_s * ball.inverse_mass, h_s * ball.inverse_inertia];
        let decay = [coefficients[0] * mobility[0], coefficients[1] * mobility[1]];
        let weights = if KNOWN { end_weights(decay) } else { [1.0; 2] };
        let of_last_step = [results.across_friction.0[lane], results.spin_moment.0[lane]];
        let extrapolated = [results.polar.radial.0[lane], results.spin.0[lane]];
        let mut drags = [0.0; 2];
        for k in 0..2 {
            let rest = (1.0 - weights[k]) * friction.drags[k].0[lane];
            let free = extrapolated[k] + mobility[k] * (of_last_step[k] - rest);
            let end = coefficients[k] * free / (1.0 + weights[k] * decay[k]);
            friction.drags[k].0[lane] = end;
            drags[k] = rest + weights[k] * end;
        }
        [results.across_friction.0[lane], results.spin_moment.0[lane]] = drags;
        let polar = results.polar.get(lane);
        let push = mobility[0] * drags[0];
        let motion = BallMotion {
            vx: motion.vx - push * polar.ex,
            vy: motion.vy - push * polar.ey,
            spin: motion.spin - mobility[1] * drags[1],
            ..motion
        };
        let polar = polar.with_velocity(&motion, &outer_ring.get(lane));
        let inner_polar = results.inner_polar.get(lane);
        let inner_polar = inner_polar.with_velocity(&motion, &ring.get(lane));
        let contacts = RacewayContacts {
            ball: &ball,
            inner_raceway: &p.inner.get(lane),
            geometry: &results.geometry.get(lane),
            outer: &outer,
            inner: &results.inner.get(lane),
        };
        let whole = SlipProblem::new(&contacts, &motion, &polar, &inner_polar, h_s);
        let slips = BothContacts {
            outer: outer.slip,
            inner: results.inner.slip.0[lane],
        };
        let beginning =
            Beginning::new::<_, KNOWN>(&at_flanks, &whole, &friction.kept.get(lane), slips);
        beginning.put(lane, results, friction);
        friction.sliding.put(lane, at_flanks.sliding);
    }
}

/// Takes a step of Newton's method for the balls of a block on flanks, from the slips that
/// [`keep_slips`] kept.
#[inline(always)]
pub(super) fn further_steps(
    law: &impl LawLanes,
    results: &BlockResults,
    friction: &mut ImplicitFriction,
) {
    for lane in results.on_flanks {
        let law = at_raceways(law.lane(lane), results, lane);
        let sliding = friction.sliding.get(lane);
        let at_flanks = AtFlanks { law, sliding };
        let next = further_step(
            &at_flanks,
            &friction.problem.get(lane),
            &friction.kept.get(lane),
        );
        friction.slips.put(lane, next);
    }
}
