//! The published equations, Zhao 2022, Eq. (12) to (22), over the lanes of every block: the functions of
//! [`crate::contact::published`] in place of those of consistent mechanics.

use super::beginning::Beginning;
use super::friction::{both_raceways, friction, loaded_slips};
use super::geometry::{plain_positions, polynomial, raceway_geometry};
use super::harness::{accelerations, inner_loads, raceway_contacts, ring_and_ledger, slope_forces};
use super::implicit_friction::{add_ring_friction, apply, finish};
use super::motions::{CentreLanes, Motions, Moving};
use super::pairs::{ball_contacts, of_ball_ahead};
use super::parameters::{Parameters, RacewayBlock};
use super::sums::{Addends, Sum, Sums};
use super::workspace::{BlockResults, ImplicitFriction, Workspace};
use crate::ball::{BallLanes, BallMotion, BothContacts, Centre, PolarMotion};
use crate::contact::published::{
    FrictionDirection, FrictionDirectionLanes, PathPlace, PublishedBall, centrifugal_force,
    outer_load,
};
use crate::contact::{LawLanes, RacewayPosition, with_law};
use crate::dynamics::energy::EnergyTerm;
use crate::numerics::lanes::{LANES, Lanes, flat};
use crate::world::step_change::StepChange;

/// Writes the right-hand side into `dydt`, see [`super::evaluate`].
#[inline(always)]
pub(crate) fn evaluate(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
    dydt: &mut [f64],
    raceway_friction: bool,
) {
    let alone = p.layout.width() == 1;
    w.ring = CentreLanes::inner_ring(p.layout, y);
    w.sums.clear(alone);
    w.slip_max = Lanes::ZERO;
    let directions = w.friction_directions.iter_mut();
    for (block, (results, direction)) in w.blocks.iter_mut().zip(directions).enumerate() {
        let (balls, motions) = (p.balls(block), Motions::new(p.layout, y, block));
        plain_positions(balls, results, motions, &w.outer_ring);
        for lane in 0..LANES {
            let polar = results.polar.get(lane);
            results.spin.0[lane] -= polar.orbit;
            direction.put(lane, FrictionDirection::circumference(&polar));
        }
        if p.unequal {
            results.geometry.slope = Lanes::ZERO;
        }
        for raceway in &p.raceways {
            raceway_geometry(p, balls, raceway, results);
            follow_path(p, raceway, results, direction);
        }
        raceway_contacts(p, balls, results, motions, &w.ring);
        for lane in 0..LANES {
            let inner_polar = motions.get(lane).about(&w.ring.get(lane));
            results.inner_polar.put(lane, inner_polar);
        }
        let block_of = BlockOf {
            p,
            balls,
            direction,
        };
        set_slips(block_of, results, motions);
        (results.outer_friction, results.inner_friction) = (Lanes::ZERO, Lanes::ZERO);
        if raceway_friction {
            both_raceways(p, results);
            loaded_slips(results, &mut w.slip_max);
        }
        outer_loads(block_of, results, &mut w.addends, motions);
        if p.unequal {
            slope_forces(results);
        }
        inner_loads(p, balls, results, &mut w.addends);
        for sums in [&Sum::NORMAL[..], &Sum::FRICTION, &Sum::PUBLISHED] {
            w.sums.add(sums, &w.addends, alone, block);
        }
    }
    w.slips_known &= !raceway_friction;
    ball_contacts(p, w, y);
    if w.pairs_loaded {
        add_ball_turning(p, w);
    }
    accelerations(p, w, y, dydt);
    set_rates_of_rings(p, w, dydt);
}

/// Motion of the inner ring of each bearing, and the powers of its energy ledger.
#[inline(always)]
fn set_rates_of_rings(p: &Parameters, w: &Workspace, dydt: &mut [f64]) {
    for bearing in 0..p.layout.width() {
        ring_and_ledger(p, bearing, &w.ring.get(bearing), &w.sums, [0.0; 2], dydt);
        for (place, power) in published_powers(p, &w.sums, bearing) {
            dydt[place] = power;
        }
    }
}

/// Powers of what only the published equations have, with their places in a vector.
fn published_powers(p: &Parameters, sums: &Sums, bearing: usize) -> [(usize, f64); 3] {
    let layout = p.layout.of_bearing(bearing);
    let total = |sum| sums.total(sum, layout.width() == 1, bearing);
    let spin = total(Sum::RelativeSpin) + total(Sum::BallRelativeSpin);
    [
        (EnergyTerm::Centrifugal, total(Sum::Centrifugal)),
        (EnergyTerm::FrictionDirection, total(Sum::FrictionDirection)),
        (EnergyTerm::RelativeSpin, spin),
    ]
    .map(|(term, power)| (layout.energy_term(term), power))
}

/// Constants of the balls of a block and the directions of friction on them.
#[derive(Clone, Copy)]
struct BlockOf<'a> {
    p: &'a Parameters,
    balls: &'a BallLanes,
    direction: &'a FrictionDirectionLanes,
}

/// Motion of a ball.
struct Seen {
    motion: BallMotion,
    /// About the outer ring.
    polar: PolarMotion,
    /// About the inner ring.
    inner_polar: PolarMotion,
}

/// Motion of the ball of a lane as of the last evaluation.
#[inline(always)]
fn seen_last(results: &BlockResults, motions: Motions<'_>, lane: usize) -> Seen {
    Seen {
        motion: motions.get(lane),
        polar: results.polar.get(lane),
        inner_polar: results.inner_polar.get(lane),
    }
}

/// Motion of the ball of a lane at its place of the last evaluation with the velocities of these motions.
#[inline(always)]
fn seen_with(results: &BlockResults, moving: Moving<'_>, lane: usize) -> Seen {
    let last = seen_last(results, moving.balls, lane);
    let (motion, ring) = (last.motion, moving.ring.get(lane));
    Seen {
        motion,
        polar: last.polar.with_velocity(&motion, &Centre::default()),
        inner_polar: last.inner_polar.with_velocity(&motion, &ring),
    }
}

/// Evaluates `value` for the ball of a lane.
#[inline(always)]
fn with_ball<T>(
    block_of: BlockOf<'_>,
    results: &BlockResults,
    seen: &Seen,
    lane: usize,
    value: impl FnOnce(&PublishedBall<'_>) -> T,
) -> T {
    let BlockOf {
        p,
        balls,
        direction,
    } = block_of;
    value(&PublishedBall {
        ball: &balls.get(lane),
        outer: &p.outer.get(lane),
        inner: &p.inner.get(lane),
        geometry: &results.geometry.get(lane),
        direction: &direction.get(lane),
        motion: &seen.motion,
        polar: &seen.polar,
        inner_polar: &seen.inner_polar,
    })
}

/// Sets the sliding speeds of the balls of a block.
#[inline(always)]
fn set_slips(block_of: BlockOf<'_>, results: &mut BlockResults, motions: Motions<'_>) {
    for lane in 0..LANES {
        let seen = seen_last(results, motions, lane);
        let slips = with_ball(block_of, results, &seen, lane, |ball| ball.slips());
        (results.outer.slip.0[lane], results.inner.slip.0[lane]) = (slips.outer, slips.inner);
    }
}

/// Turns the directions of friction on the balls in a discrete raceway along its contact path.
#[inline(always)]
fn follow_path(
    p: &Parameters,
    raceway: &RacewayBlock,
    results: &BlockResults,
    direction: &mut FrictionDirectionLanes,
) {
    let position =
        |lane| RacewayPosition::new(&raceway.constants.get(lane), &results.polar.get(lane));
    let mut u = Lanes::ZERO;
    for lane in 0..LANES {
        u.0[lane] = position(lane).u;
    }
    let (mut radius, mut along) = (Lanes::ZERO, Lanes::ZERO);
    polynomial(&raceway.radius, &u, &mut radius);
    polynomial(&raceway.direction, &u, &mut along);
    let [cubic, linear] = &raceway.path_slope;
    for lane in 0..LANES {
        let turned = direction.get(lane).on_path(
            &raceway.constants.get(lane),
            PathPlace {
                cubic: cubic.0[lane],
                linear: linear.0[lane],
                radius: radius.0[lane],
                along: along.0[lane],
            },
            &p.outer.get(lane),
            &position(lane),
        );
        direction.put(lane, turned);
    }
}

/// Loads of outer contacts, centrifugal forces and weights; starts the loads and the addends.
#[inline(always)]
fn outer_loads(
    block_of: BlockOf<'_>,
    results: &mut BlockResults,
    addends: &mut Addends,
    motions: Motions<'_>,
) {
    let BlockOf {
        p,
        balls,
        direction,
    } = block_of;
    for lane in 0..LANES {
        let seen = seen_last(results, motions, lane);
        let (motion, polar) = (&seen.motion, &seen.polar);
        let (ball, outer) = (balls.get(lane), results.outer.get(lane));
        let (fo, fi) = (
            results.outer_friction.0[lane],
            results.inner_friction.0[lane],
        );
        let centrifugal = centrifugal_force(&ball, &p.outer.get(lane), polar);
        let mut load = outer_load(
            &outer,
            &results.geometry.get(lane),
            &direction.get(lane),
            polar,
            fo,
            centrifugal,
        );
        let weight = ball.mass * p.ring.gravity.0[lane];
        load.fy -= weight;
        let f = BothContacts {
            outer: fo,
            inner: fi,
        };
        let powers = with_ball(block_of, results, &seen, lane, |ball| ball.powers(f));
        results.load.put(lane, load);
        addends[Sum::Weight as usize].0[lane] = -weight * motion.vy;
        addends[Sum::OuterFriction as usize].0[lane] = fo * outer.slip;
        addends[Sum::RacewayDamping as usize].0[lane] = outer.damping_power;
        addends[Sum::Centrifugal as usize].0[lane] = centrifugal * polar.radial;
        addends[Sum::FrictionDirection as usize].0[lane] = powers.direction;
        addends[Sum::RelativeSpin as usize].0[lane] = powers.spin;
    }
}

/// Adds the powers of friction between balls whose spins are relative to their orbits.
#[inline(always)]
fn add_ball_turning(p: &Parameters, w: &mut Workspace) {
    let ([orbits, ..], [.., ahead]) = (&mut w.pairs, &mut w.next);
    for (orbit, results) in orbits.iter_mut().zip(&w.blocks) {
        *orbit = results.polar.orbit;
    }
    of_ball_ahead(p, flat(orbits), ahead);
    for (block, results) in w.blocks.iter().enumerate() {
        let (balls, pair) = (p.balls(block), &results.pair);
        let mut force = Lanes::ZERO;
        friction(p, &pair.slip, &pair.friction_normal, &mut force);
        let addend = &mut w.addends[Sum::BallRelativeSpin as usize];
        for lane in 0..LANES {
            let (own, next) = (results.polar.orbit.0[lane], ahead[block].0[lane]);
            let turning = balls.radius.0[lane] * own + balls.next_radius.0[lane] * next;
            addend.0[lane] = force.0[lane] * turning;
        }
        let alone = p.layout.width() == 1;
        (w.sums).add(&[Sum::BallRelativeSpin], &w.addends, alone, block);
    }
}

/// Adds friction at the raceways over a step of `h_s`, see [`super::add_implicit_friction`].
#[inline(always)]
pub(crate) fn add_implicit_friction(
    p: &Parameters,
    w: &mut Workspace,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let alone = p.layout.width() == 1;
    w.sums.clear(alone);
    w.slip_max = Lanes::ZERO;
    with_law!(&p.friction, law => solve(law, p, w, y, h_s));
    let start_ring = CentreLanes::inner_ring(p.layout, y0);
    let of_blocks = w.friction.iter().zip(&w.friction_directions);
    for (block, (results, (friction, direction))) in w.blocks.iter_mut().zip(of_blocks).enumerate()
    {
        let (balls, slips) = (p.balls(block), &friction.slips);
        (results.outer.slip, results.inner.slip) = (slips.outer, slips.inner);
        let against = |lane: usize| direction.get(lane).vector();
        let change = StepChange {
            layout: p.layout,
            h_s,
            y: &mut *y,
            dydt: &mut *dydt,
        };
        apply(balls, block, results, against, change);
        let start = Moving {
            balls: Motions::new(p.layout, y0, block),
            ring: &start_ring,
        };
        let end = Moving {
            balls: Motions::new(p.layout, y, block),
            ring: &w.ring,
        };
        let block_of = BlockOf {
            p,
            balls,
            direction,
        };
        powers(block_of, results, start, end, &mut w.addends);
        results.outer_friction = slips.outer_friction;
        results.inner_friction = slips.inner_friction;
        loaded_slips(results, &mut w.slip_max);
        for sums in [&Sum::RACEWAY_FRICTION[..], &Sum::PUBLISHED] {
            w.sums.add(sums, &w.addends, alone, block);
        }
    }
    w.slips_known = true;
    for bearing in 0..p.layout.width() {
        add_ring_friction(p, bearing, &w.sums, h_s, y, dydt);
        for (place, power) in published_powers(p, &w.sums, bearing) {
            dydt[place] += power;
            y[place] += h_s * power;
        }
    }
}

/// Solves for the friction of the balls at the end of a step of `h_s`, as that of consistent mechanics.
#[inline(always)]
fn solve<L: LawLanes>(law: &L, p: &Parameters, w: &mut Workspace, y: &[f64], h_s: f64) {
    let of_blocks = w.friction.iter_mut().zip(&w.friction_directions);
    for (block, (results, (friction, direction))) in w.blocks.iter_mut().zip(of_blocks).enumerate()
    {
        let block_of = BlockOf {
            p,
            balls: p.balls(block),
            direction,
        };
        let moving = Moving {
            balls: Motions::new(p.layout, y, block),
            ring: &w.ring,
        };
        match w.slips_known {
            true => first_iterate::<L, true>(law, block_of, moving, h_s, results, friction),
            false => first_iterate::<L, false>(law, block_of, moving, h_s, results, friction),
        }
    }
    finish(law, false, w);
}

/// The equations of the friction of a block and their first iterate.
#[inline(always)]
fn first_iterate<L: LawLanes, const KNOWN: bool>(
    law: &L,
    block_of: BlockOf<'_>,
    moving: Moving<'_>,
    h_s: f64,
    results: &mut BlockResults,
    friction: &mut ImplicitFriction,
) {
    for lane in 0..LANES {
        let (outer, inner) = (results.outer.get(lane), results.inner.get(lane));
        let normal = BothContacts {
            outer: outer.friction_normal,
            inner: inner.force,
        };
        let seen = seen_with(results, moving, lane);
        let whole = with_ball(block_of, results, &seen, lane, |ball| {
            ball.slip_problem(normal, h_s)
        });
        let (law, start) = (law.lane(lane), friction.slips.get(lane));
        let slips = BothContacts {
            outer: outer.slip,
            inner: inner.slip,
        };
        Beginning::new::<_, KNOWN>(&law, &whole, &start, slips).put(lane, results, friction);
    }
}

/// Reactions on the inner ring and powers of friction by the mean of the speeds at both ends of a step.
#[inline(always)]
fn powers(
    block_of: BlockOf<'_>,
    results: &BlockResults,
    start: Moving<'_>,
    end: Moving<'_>,
    addends: &mut Addends,
) {
    let p = block_of.p;
    for lane in 0..LANES {
        let (fo, fi) = (
            results.outer_friction.0[lane],
            results.inner_friction.0[lane],
        );
        let f = BothContacts {
            outer: fo,
            inner: fi,
        };
        let start = seen_with(results, start, lane);
        let end = seen_with(results, end, lane);
        let of = |seen: &Seen| with_ball(block_of, results, seen, lane, |ball| ball.powers(f));
        let (before, after) = (of(&start), of(&end));
        let slips = with_ball(block_of, results, &start, lane, |ball| ball.slips());
        let inner_polar = results.inner_polar.get(lane);
        let mean = |before: f64, after: f64| 0.5 * (before + after);
        for (sum, value) in [
            (Sum::RingX, fi * inner_polar.ey),
            (Sum::RingY, -fi * inner_polar.ex),
            (Sum::Drive, fi * p.inner.surface_speed.0[lane]),
            (
                Sum::OuterFriction,
                fo * mean(slips.outer, results.outer.slip.0[lane]),
            ),
            (
                Sum::InnerFriction,
                fi * mean(slips.inner, results.inner.slip.0[lane]),
            ),
            (Sum::Centrifugal, 0.0),
            (
                Sum::FrictionDirection,
                mean(before.direction, after.direction),
            ),
            (Sum::RelativeSpin, mean(before.spin, after.spin)),
        ] {
            addends[sum as usize].0[lane] = value;
        }
    }
}
