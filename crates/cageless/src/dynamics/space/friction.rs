//! Friction at the raceways: of a state, or implicit at the end of a step whose other forces are known.

use super::bearing::{Bearing, Totals, tilting_by};
use super::block::{INNER, KnownStrip, KnownStripLanes, PLACES, SpaceBlock, VELOCITIES};
use super::creep::set_knees;
use super::frame::{FrameLanes, SIZE, TractionLanes};
use super::model::SpaceModel;
use super::newton::{begin, iterate, slide};
use super::ring::{RingMotion, RingMotions};
use super::sliding::{add_sliding_friction, slide_as_evaluated, slide_as_in};
use super::strips::SlidingLanes;
use super::traction::set_films;
use super::workspace::SpaceWorkspace;
use crate::ball::{BallLanes, PolarMotionLanes};
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::dynamics::model::Model;
use crate::numerics::lanes::{LANES, Lanes, larger};
use crate::simd::{BlockResults, Workspace, block_mut};
use crate::world::joint::rotor_touch::TouchStep;
use crate::world::step_change::StepChange;
use crate::world::under_rotor::{BallLoads, UnderRotor};

/// Adds the friction of the last evaluation to the rates.
#[inline(always)]
pub(super) fn add_explicit_friction(
    bearing: Bearing<'_>,
    w: &mut Workspace,
    s: &mut SpaceWorkspace,
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let Bearing {
        parameters: p,
        space,
        ..
    } = bearing;
    let rings = s.rings();
    for (block, (results, b)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        for end in 0..2 {
            set_at_rest(b, end, &rings);
            if !space.sliding.is_empty() {
                slide_as_evaluated(bearing, b, block, end, &s.sliding);
            }
        }
        set_law(bearing, &results.polar, b);
        slide(&p.friction, space, b);
        for step in &mut b.steps {
            let friction = &step.friction;
            (step.mean.along, step.mean.across) = (friction.along, friction.across);
            step.mean.moment = friction.moment;
        }
        b.weights = [Lanes::all(1.0); PLACES];
        let force = tractions(space, b, results, totals);
        accelerate(p.layout, p.balls(block), block, &force, dydt);
        powers(space, b, [&b.velocity; 2], results, &mut w.slip_max, totals);
    }
}

/// Adds friction over a step of `h_s` from `y0` to the velocities and the ledger in `y` and to the
/// rates.
#[inline(always)]
pub(crate) fn add_implicit_friction(
    bearing: Bearing<'_>,
    w: &mut Workspace,
    s: &mut SpaceWorkspace,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let Bearing {
        parameters: p,
        model,
        space,
        drive,
    } = bearing;
    let layout = bearing.parameters.layout;
    let mut totals = Totals::default();
    w.slip_max = Lanes::ZERO;
    let step = ImplicitStep {
        h_s,
        rings: rings_in(bearing, &s.ring, y0),
        start: y0,
        y: &mut *y,
    };
    solve_blocks(bearing, w, s, step, &mut totals, dydt);
    let mut change = StepChange {
        layout,
        h_s,
        y,
        dydt,
    };
    add_to_ring(model, space, &s.ring, &totals, &mut change);
    if !space.sliding.is_empty() {
        add_sliding_friction(bearing, s, &mut change);
    }
    let under = p.drops.first();
    if let Some(under) = under {
        add_rotor_friction(under, w, s, &totals, y0, &mut change);
    }
    if under.is_some() || !space.sliding.is_empty() {
        // The light inner ring turns, and outer rings slide, by the friction of the step.
        slide_at_end(bearing, s, change.y);
    }
    for (block, (results, b)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        let [start, end] = [y0, &*change.y].map(|y| b.velocities(layout, y, block));
        let slip_max = &mut w.slip_max;
        powers(space, b, [&start, &end], results, slip_max, &mut totals);
    }
    s.known = true;
    // A rotor, whose work on the ring is within the ledger, takes the place of what turns the ring.
    let driven = if under.is_some() { 0.0 } else { 1.0 };
    let torque = totals.torque_on(&s.ring);
    change.add_energy(EnergyTerm::Drive, -driven * drive.inner_speed * torque);
    change.add_energy(EnergyTerm::OuterFriction, totals.heat[0]);
    change.add_energy(EnergyTerm::InnerFriction, totals.heat[1]);
}

/// Lets balls at rest slide on the rings as they move at the end of the step.
#[inline(always)]
fn slide_at_end(bearing: Bearing<'_>, s: &mut SpaceWorkspace, y: &[f64]) {
    let rings = rings_in(bearing, &s.ring, y);
    for (block, b) in s.blocks.iter_mut().enumerate() {
        end_with_rings(b, &rings);
        if !bearing.space.sliding.is_empty() {
            slide_as_in(bearing, b, block, 1, y);
        }
    }
}

/// Sets what the law of friction has from the last evaluation: knees, where creep gives them, and films.
#[inline(always)]
fn set_law(bearing: Bearing<'_>, polar: &PolarMotionLanes, b: &mut SpaceBlock) {
    if bearing.model.creep.is_some() {
        set_knees(polar, b);
    }
    let film = bearing.space.film.as_ref();
    if let Some(traction) = film.and_then(|film| film.traction.as_ref()) {
        set_films(traction, polar, b);
    }
}

/// Motions of the rings in a state, along the directions in which the friction of this motion of the inner ring acts.
#[inline(always)]
fn rings_in(bearing: Bearing<'_>, ring: &RingMotion, y: &[f64]) -> RingMotions {
    let layout = bearing.parameters.layout;
    let speed = layout.ring_speed_rad_s(y);
    let moving = RingMotion::new(layout, y, speed.unwrap_or(bearing.drive.inner_speed));
    RingMotions {
        inner: ring.with_velocities_of(&moving),
        outer_velocity: outer_ring_velocity(layout, y),
    }
}

/// A step over which friction is implicit.
struct ImplicitStep<'y> {
    /// h, s.
    h_s: f64,
    /// Motions of the rings at the start.
    rings: RingMotions,
    /// State at the start.
    start: &'y [f64],
    /// State at the end, without friction at first.
    y: &'y mut [f64],
}

/// Solves for the friction of the balls over a step and adds it to the velocities and rates of the balls.
#[inline(always)]
fn solve_blocks(
    bearing: Bearing<'_>,
    w: &mut Workspace,
    s: &mut SpaceWorkspace,
    step: ImplicitStep<'_>,
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let ImplicitStep {
        h_s,
        rings: start,
        start: y0,
        y,
    } = step;
    let evaluated = s.rings();
    let Bearing {
        parameters: p,
        space,
        ..
    } = bearing;
    let layout = p.layout;
    for (block, (results, b)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        set_at_rest(b, 0, &start);
        set_at_rest(b, 1, &evaluated);
        if !space.sliding.is_empty() {
            slide_as_in(bearing, b, block, 0, y0);
            slide_as_evaluated(bearing, b, block, 1, &s.sliding);
        }
        set_law(bearing, &results.polar, b);
        let free = b.velocities(layout, y, block);
        begin(space, b, h_s, s.known, free);
        iterate(&p.friction, space, b, h_s);
        let force = tractions(space, b, results, totals);
        let rates = accelerate(layout, p.balls(block), block, &force, dydt);
        for i in 0..SIZE {
            let velocities = block_mut(y, layout.array(VELOCITIES[i].0) + block * LANES);
            for lane in 0..LANES {
                velocities[lane] += h_s * rates[i].0[lane];
            }
        }
    }
}

/// Adds what the friction of the balls does to the inner ring over the step.
fn add_to_ring(
    model: &Model,
    space: &SpaceModel,
    ring: &RingMotion,
    totals: &Totals,
    change: &mut StepChange<'_>,
) {
    let [force, moment] = totals.on_ring();
    change.add(RingCoordinate::Vx, force.x / model.ring.mass);
    change.add(RingCoordinate::Vy, force.y / model.ring.mass);
    change.add(RingCoordinate::Vz, force.z / model.ring.mass);
    if let Some(free) = &space.free_tilt {
        let [p, q] = tilting_by(free, ring, moment);
        change.add(RingCoordinate::TiltPRate, p);
        change.add(RingCoordinate::TiltQRate, q);
    }
}

/// Adds what the friction of the balls does to the bodies under a rotor over the step, then the friction of
/// the rotor itself.
#[inline(never)] // once for all instruction sets
fn add_rotor_friction(
    under: &UnderRotor,
    w: &mut Workspace,
    s: &mut SpaceWorkspace,
    totals: &Totals,
    y0: &[f64],
    change: &mut StepChange<'_>,
) {
    let balls = BallLoads {
        ring_torque: totals.torque_on(&s.ring),
        outer_ring: totals.outer_ring,
    };
    under.add_ball_friction(&balls, change);
    let step = TouchStep {
        h_s: change.h_s,
        is_known: s.known,
        start: y0,
        free: change.y,
    };
    let (contact, rotor) = (&mut w.rotors[0], &w.rotor_compliances[0]);
    let (loads, heat) = (s.rotor).implicit_friction(under, rotor, contact, change.layout, &step);
    under.add_touch_friction(&loads, heat, change);
}

/// Sets the sliding of a ball at rest at the end of the step to that of these velocities of the rings.
#[inline(never)] // once for all instruction sets
fn end_with_rings(b: &mut SpaceBlock, rings: &RingMotions) {
    set_at_rest(b, 1, rings);
}

/// Velocity of the outer ring, m/s.
pub(super) fn outer_ring_velocity(layout: Layout, y: &[f64]) -> [f64; 3] {
    let motion = layout.outer_ring_motion(y);
    [motion.vx, motion.vy, layout.outer_ring_along_axis(y).vz]
}

/// Lets balls at rest slide on the rings as they move at the start (0) or the end (1) of the step.
#[inline(always)]
fn set_at_rest(b: &mut SpaceBlock, end: usize, rings: &RingMotions) {
    let (ring, outer) = (&rings.inner, rings.outer_velocity);
    for &place in b.places {
        let (frames, sliding) = (&b.frames[place], &mut b.at_rest[end][place]);
        let (velocity, rotation) = match place == INNER {
            true => (ring.velocity.into(), ring.rotation.into()),
            false if outer == [0.0; 3] => {
                *sliding = SlidingLanes::ZERO;
                continue;
            }
            false => (outer, [0.0; 3]),
        };
        slide_at_rest(frames, velocity, rotation, sliding);
    }
}

/// [`set_at_rest`] of one place.
#[inline(always)]
fn slide_at_rest(
    frames: &FrameLanes,
    velocity: [f64; 3],
    rotation: [f64; 3],
    sliding: &mut SlidingLanes,
) {
    for lane in 0..LANES {
        let frame = frames.get(lane);
        sliding.put(lane, frame.sliding_at_rest(velocity, rotation));
    }
}

/// Friction that changes velocities over the step, (1 − θ)·f₀ + θ·f₁, of each strip in `mean`: the
/// forces on the balls.
#[inline(always)]
fn tractions(
    space: &SpaceModel,
    b: &mut SpaceBlock,
    results: &mut BlockResults,
    totals: &mut Totals,
) -> [Lanes; SIZE] {
    let mut forces = [Lanes::ZERO; SIZE];
    let mut on_ring = [Lanes::ZERO; SIZE];
    for &place in b.places {
        let curvature = *b.curvature_at(place);
        let mut traction = TractionLanes::ZERO;
        for (k, strip) in space.strips.iter().enumerate() {
            let at = place * space.strips.len() + k;
            let (step, known) = (&mut b.steps[at], &mut b.strips[at]);
            mean_friction(
                &b.weights[place],
                &step.friction.secant,
                &mut step.mean,
                known,
            );
            for lane in 0..LANES {
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let mean = step.mean.get(lane);
                let force = [mean.along, mean.across, mean.moment];
                traction.add(lane, force, x, curvature.0[lane]);
            }
        }
        let mut force = [Lanes::ZERO; SIZE];
        for lane in 0..LANES {
            let frame = b.frames[place].get(lane);
            let on_ball = frame.on_ball(&traction.get(lane), b.inverse_radius.0[lane]);
            for i in 0..SIZE {
                force[i].0[lane] = on_ball[i];
            }
        }
        for i in 0..SIZE {
            forces[i].add(&force[i], 1.0);
        }
        // With the signs of the plane.
        if place == INNER {
            results.inner_friction.add(&traction.along, -1.0);
            for lane in 0..LANES {
                let reaction = b.frames[place].get(lane).on_ring(&traction.get(lane));
                for i in 0..SIZE {
                    on_ring[i].0[lane] = reaction[i];
                }
            }
        } else {
            results.outer_friction.add(&traction.along, 1.0);
            for i in 0..3 {
                b.outer_ring_force_n[i].add(&force[i], -1.0);
                totals.outer_ring[i] -= force[i].sum();
            }
        }
    }
    for (total, lanes) in totals.ring.iter_mut().zip(&on_ring) {
        *total += lanes.sum();
    }
    forces
}

/// Puts the friction that changes velocities in the place of that of the end of the step, `mean`, which
/// becomes the known one.
#[inline(always)]
fn mean_friction(
    weights: &Lanes,
    secant: &Lanes,
    mean: &mut KnownStripLanes,
    known: &mut KnownStripLanes,
) {
    for lane in 0..LANES {
        let (before, after, end) = (known.get(lane), mean.get(lane), weights.0[lane]);
        let between = |before: f64, after: f64| (1.0 - end) * before + end * after;
        mean.put(
            lane,
            KnownStrip {
                along: between(before.along, after.along),
                across: between(before.across, after.across),
                moment: between(before.moment, after.moment),
                secant: 0.0,
            },
        );
        let secant = secant.0[lane];
        known.put(lane, KnownStrip { secant, ..after });
    }
}

/// Adds the accelerations of the balls of a block under these forces to rates.
#[inline(always)]
pub(super) fn accelerate(
    layout: Layout,
    balls: &BallLanes,
    block: usize,
    force: &[Lanes; SIZE],
    dydt: &mut [f64],
) -> [Lanes; SIZE] {
    let mut added = [Lanes::ZERO; SIZE];
    for i in 0..SIZE {
        let (coordinate, sign) = VELOCITIES[i];
        let rates = block_mut(dydt, layout.array(coordinate) + block * LANES);
        for lane in 0..LANES {
            let ball = balls.get(lane);
            let turning = ball.radius * ball.inverse_inertia;
            let inverse = if i < 3 { ball.inverse_mass } else { turning };
            let rate = sign * (force[i].0[lane] * inverse);
            added[i].0[lane] = rate;
            rates[lane] += rate;
        }
    }
    added
}

/// Sliding at the end of the step and the heat of the friction over it, by the mean of the sliding
/// velocities at both ends.
#[inline(always)]
fn powers(
    space: &SpaceModel,
    b: &SpaceBlock,
    ends: [&[Lanes; SIZE]; 2],
    results: &mut BlockResults,
    slip_max: &mut Lanes,
    totals: &mut Totals,
) {
    let mut heat = [Lanes::ZERO; 2];
    for &place in b.places {
        let inner = place == INNER;
        let curvature = *b.curvature_at(place);
        let [start, end] = [b.sliding(place, ends[0], 0), b.sliding(place, ends[1], 1)];
        for lane in 0..LANES {
            let [along, across] = [end.along.0[lane], end.across.0[lane]];
            let loaded = b.frames[place].force_n.0[lane];
            let speed = if loaded > 0.0 {
                (along * along + across * across).sqrt()
            } else {
                0.0
            };
            slip_max.0[lane] = larger(slip_max.0[lane], speed);
            // τ points against the motion; at the inner ring the plane counts what drives the ball.
            if inner {
                results.inner.slip.0[lane] = along;
            } else if place == 0 || loaded > b.frames[0].force_n.0[lane] {
                results.outer.slip.0[lane] = -along;
            }
        }
        for (k, strip) in space.strips.iter().enumerate() {
            let step = &b.steps[place * space.strips.len() + k];
            for lane in 0..LANES {
                let (start, end, mean) = (start.get(lane), end.get(lane), step.mean.get(lane));
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let curvature = curvature.0[lane];
                let (start, end) = (start.at(x, curvature), end.at(x, curvature));
                heat[usize::from(inner)].0[lane] -= 0.5
                    * (mean.along * (start.along + end.along)
                        + mean.across * (start.across + end.across)
                        + mean.moment * (start.shear + end.shear));
            }
        }
    }
    for (total, lanes) in totals.heat.iter_mut().zip(&heat) {
        *total += lanes.sum();
    }
}
