//! Implicit friction at the raceways: the end of a step whose other forces are known.

use super::beginning::{Beginning, STUCK_M_S};
use super::flanks;
use super::friction::{at_raceways, loaded_slips};
use super::motions::{CentreLanes, Motions, Moving, block_mut};
use super::parameters::Parameters;
use super::sums::{Addends, Sum, Sums};
use super::workspace::{BlockResults, ImplicitFriction, Workspace};
use crate::ball::{BallLanes, BallLoad, BothContacts, Centre};
use crate::contact::{
    EvaluatedLaws, Law, LawLanes, MAX_ITERATIONS, RacewayContacts, SlipProblem, further_step,
    inner_slip, outer_slip, with_law,
};
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::numerics::lanes::{LANES, Lanes};
use crate::numerics::vector::PlaneVector;
use crate::world::step_change::StepChange;

#[inline(always)]
pub(super) fn add(
    p: &Parameters,
    w: &mut Workspace,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let alone = p.layout.width() == 1;
    w.sums.clear(alone);
    let start_ring = CentreLanes::inner_ring(p.layout, y0);
    let mut slip_max = Lanes::ZERO;
    with_law!(&p.friction, law => solve(law, p, w, y, h_s));
    for (block, (results, friction)) in w.blocks.iter_mut().zip(&w.friction).enumerate() {
        let (balls, slips) = (p.balls(block), &friction.slips);
        results.outer.slip = slips.outer;
        results.inner.slip = slips.inner;
        let against = |lane| circumference(results, lane);
        let change = StepChange {
            layout: p.layout,
            h_s,
            y: &mut *y,
            dydt: &mut *dydt,
        };
        apply(balls, block, results, against, change);
        let [start, end] = [y0, &*y].map(|y| Motions::new(p.layout, y, block));
        let inner_start = Moving {
            balls: start,
            ring: &start_ring,
        };
        powers(p, balls, results, inner_start, &mut w.addends);
        let ends = [start, end].map(|balls| Moving {
            balls,
            ring: &w.outer_ring,
        });
        flanks::add_heat(results, ends, &mut w.addends);
        results.outer_friction = slips.outer_friction;
        results.inner_friction = slips.inner_friction;
        loaded_slips(results, &mut slip_max);
        w.sums.add(&Sum::RACEWAY_FRICTION, &w.addends, alone, block);
    }
    w.slip_max = slip_max;
    w.slips_known = true;
    for bearing in 0..p.layout.width() {
        add_ring_friction(p, bearing, &w.sums, h_s, y, dydt);
    }
}

/// Adds the friction of the balls to the inner ring of one bearing and to its energy ledger.
#[inline(always)]
pub(super) fn add_ring_friction(
    p: &Parameters,
    bearing: usize,
    sums: &Sums,
    h_s: f64,
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let layout = p.layout.of_bearing(bearing);
    let total = |sum: Sum| sums.total(sum, layout.width() == 1, bearing);
    let mass = p.ring.mass.0[bearing];
    for (place, rate) in [
        (layout.ring(RingCoordinate::Vx), total(Sum::RingX) / mass),
        (layout.ring(RingCoordinate::Vy), total(Sum::RingY) / mass),
        (layout.energy_term(EnergyTerm::Drive), total(Sum::Drive)),
        (
            layout.energy_term(EnergyTerm::InnerFriction),
            total(Sum::InnerFriction),
        ),
        (
            layout.energy_term(EnergyTerm::OuterFriction),
            total(Sum::OuterFriction),
        ),
    ] {
        dydt[place] += rate;
        y[place] += h_s * rate;
    }
}

/// Adds friction at the raceways to the rates of the one bearing that was evaluated last without
/// it: fo, fi, ΔVo and ΔVi of each ball under a law that sticks, and the friction of the journal.
/// It stays within the cones of the forces evaluated; what sticks has the sliding speed given.
pub(crate) fn add_given_friction(
    p: &Parameters,
    w: &mut Workspace,
    given: &[[f64; 4]],
    journal_friction: f64,
    dydt: &mut [f64],
) {
    w.sums.clear(true);
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    for (block, results) in w.blocks.iter_mut().enumerate() {
        for (lane, [fo, fi, outer_slip, inner_slip]) in
            given.iter().skip(block * LANES).take(LANES).enumerate()
        {
            let coefficient = with_law!(&p.friction, law => law.lane(lane).coefficient());
            let bounded = |friction: f64, normal: f64| {
                let largest = coefficient * normal;
                friction.max(-largest).min(largest)
            };
            results.outer_friction.0[lane] = bounded(*fo, results.outer.friction_normal.0[lane]);
            results.inner_friction.0[lane] = bounded(*fi, results.inner.force.0[lane]);
            if outer_slip.abs() < STUCK_M_S {
                results.outer.slip.0[lane] = *outer_slip;
            }
            if inner_slip.abs() < STUCK_M_S {
                results.inner.slip.0[lane] = *inner_slip;
            }
        }
        let balls = p.balls(block);
        let rates = accelerations(balls, results, |lane| {
            let direction = w.friction_directions.get(block);
            direction.map_or(circumference(results, lane), |d| d.get(lane).vector())
        });
        add_to_balls(p, block, rates, dydt);
        inner_friction_reactions(results, &mut addends);
        w.sums.add(&[Sum::RingX, Sum::RingY], &addends, true, block);
    }
    let mass = p.ring.mass.0[0];
    let mut force = [Sum::RingX, Sum::RingY].map(|sum| w.sums.total(sum, true, 0));
    for rotor in &mut w.rotors[..p.drops.len()] {
        rotor.friction = journal_friction;
        // The ring takes the reaction of the journal.
        force[0] -= journal_friction * rotor.contact.ny;
        force[1] += journal_friction * rotor.contact.nx;
    }
    for (coordinate, force) in [RingCoordinate::Vx, RingCoordinate::Vy]
        .into_iter()
        .zip(force)
    {
        dydt[p.layout.ring(coordinate)] += force / mass;
    }
}

/// Friction forces of the balls of a block on the inner ring.
#[inline(always)]
pub(super) fn inner_friction_reactions(results: &BlockResults, addends: &mut Addends) {
    for lane in 0..LANES {
        let friction = results.inner_friction.0[lane];
        addends[Sum::RingX as usize].0[lane] = friction * results.inner_polar.ey.0[lane];
        addends[Sum::RingY as usize].0[lane] = -friction * results.inner_polar.ex.0[lane];
    }
}

/// Solves for the friction of the balls at the end of a step of `h_s`, where the other forces lead
/// to `y`; leaves that which changes their velocities, (1 − θ)·f₀ + θ·f₁, in `w.blocks`.
#[inline(always)]
pub(super) fn solve<L: LawLanes>(law: &L, p: &Parameters, w: &mut Workspace, y: &[f64], h_s: f64) {
    let rings = [&w.ring, &w.outer_ring];
    for (block, (results, friction)) in w.blocks.iter_mut().zip(&mut w.friction).enumerate() {
        let motions = Motions::new(p.layout, y, block);
        let bodies = (p.balls(block), rings, motions);
        let elastic = !<L::Constants as Law>::STICKS && p.elastic;
        if elastic {
            flanks::keep_start(results, friction, w.slips_known);
        }
        if w.slips_known {
            first_iterate::<L, true>(law, p, bodies, h_s, results, friction);
        } else {
            first_iterate::<L, false>(law, p, bodies, h_s, results, friction);
        }
        if elastic && w.slips_known {
            flanks::first_iterate::<L, true>(law, p, bodies, h_s, results, friction);
        } else if elastic {
            flanks::first_iterate::<L, false>(law, p, bodies, h_s, results, friction);
        }
    }
    finish(law, p.elastic, w);
}

/// Iterates from the first iterates of all blocks, and leaves in them what changes velocities.
#[inline(always)]
pub(super) fn finish<L: LawLanes>(law: &L, elastic: bool, w: &mut Workspace) {
    if !<L::Constants as Law>::STICKS {
        iterate(law, elastic, &w.blocks, &mut w.friction);
    }
    for (results, friction) in w.blocks.iter_mut().zip(&w.friction) {
        let ([outer, inner], slips) = (&friction.weights, &friction.slips);
        for lane in 0..LANES {
            results.outer_friction.0[lane] += outer.0[lane] * slips.outer_friction.0[lane];
            results.inner_friction.0[lane] += inner.0[lane] * slips.inner_friction.0[lane];
        }
    }
}

/// The equations of the friction of a block at the end of the step and their first iterate from
/// the sliding speeds extrapolated to it, or their solution under a law that sticks; θ = 1 unless
/// the friction at the start is known. Leaves (1 − θ)·f₀ in `results`.
#[inline(always)]
fn first_iterate<L: LawLanes, const KNOWN: bool>(
    law: &L,
    p: &Parameters,
    (balls, [ring, outer_ring], motions): (&BallLanes, [&CentreLanes; 2], Motions<'_>),
    h_s: f64,
    results: &mut BlockResults,
    friction: &mut ImplicitFriction,
) {
    let law = law.evaluated([&results.outer.slip, &results.inner.slip]);
    for lane in 0..LANES {
        let (law, motion) = (
            at_raceways(law.lane(lane), results, lane),
            motions.get(lane),
        );
        let polar = results.polar.get(lane);
        let polar = polar.with_velocity(&motion, &outer_ring.get(lane));
        let inner_polar = results.inner_polar.get(lane);
        let inner_polar = inner_polar.with_velocity(&motion, &ring.get(lane));
        let contacts = RacewayContacts {
            ball: &balls.get(lane),
            inner_raceway: &p.inner.get(lane),
            geometry: &results.geometry.get(lane),
            outer: &results.outer.get(lane),
            inner: &results.inner.get(lane),
        };
        let whole = SlipProblem::new(&contacts, &motion, &polar, &inner_polar, h_s);
        let extrapolated = BothContacts {
            outer: results.outer.slip.0[lane],
            inner: results.inner.slip.0[lane],
        };
        let start = friction.slips.get(lane);
        Beginning::new::<_, KNOWN>(&law, &whole, &start, extrapolated).put(lane, results, friction);
    }
}

/// Iterates until the equations of all balls hold.
///
/// A ball at which Newton's method has converged keeps its solution while others iterate, so that
/// a bearing has the same bits alone and beside others.
#[inline(always)]
fn iterate<L: LawLanes>(
    law: &L,
    elastic: bool,
    blocks: &[BlockResults],
    friction: &mut [ImplicitFriction],
) {
    for _ in 1..MAX_ITERATIONS {
        // In a loop of its own: a sum would keep those around it from becoming vector code.
        let converged = |f: &ImplicitFriction| f.slips.converged.0.iter().all(|c| *c > 0.0);
        if friction.iter().all(converged) {
            return;
        }
        for (results, friction) in blocks.iter().zip(&mut *friction) {
            if elastic {
                flanks::keep_slips(results, friction);
            }
            let ImplicitFriction { problem, slips, .. } = &mut *friction;
            let laws = law.evaluated([&slips.outer, &slips.inner]);
            for lane in 0..LANES {
                let law = at_raceways(laws.lane(lane), results, lane);
                let next = further_step(&law, &problem.get(lane), &slips.get(lane));
                slips.put(lane, next);
            }
            if elastic {
                flanks::further_steps(law, results, friction);
            }
        }
    }
}

/// Adds accelerations of the balls of a block to rates.
fn add_to_balls(p: &Parameters, block: usize, rates: [[f64; LANES]; 3], dydt: &mut [f64]) {
    let coordinates = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Spin];
    for (coordinate, rates) in coordinates.into_iter().zip(rates) {
        let values = block_mut(dydt, p.layout.array(coordinate) + block * LANES);
        for lane in 0..LANES {
            values[lane] += rates[lane];
        }
    }
}

/// Direction of the circumference at the ball of a lane.
#[inline(always)]
pub(super) fn circumference(results: &BlockResults, lane: usize) -> PlaneVector {
    PlaneVector {
        x: -results.polar.ey.0[lane],
        y: results.polar.ex.0[lane],
    }
}

/// Accelerations of the balls of a block by friction, which acts against `direction` at the outer raceway.
#[inline(always)]
fn accelerations(
    balls: &BallLanes,
    results: &BlockResults,
    direction: impl Fn(usize) -> PlaneVector,
) -> [[f64; LANES]; 3] {
    let mut rates = [[0.0; LANES]; 3];
    for lane in 0..LANES {
        let (geometry, d) = (results.geometry.get(lane), direction(lane));
        let (ball, inner_polar) = (balls.get(lane), results.inner_polar.get(lane));
        let (fo, fi) = (
            results.outer_friction.0[lane],
            results.inner_friction.0[lane],
        );
        let load = BallLoad {
            fx: -fo * d.x - fi * inner_polar.ey,
            fy: -fo * d.y + fi * inner_polar.ex,
            torque: geometry.effective_radius * fo + ball.radius * fi,
        };
        let acceleration = load.acceleration(&ball);
        for k in 0..3 {
            rates[k][lane] = acceleration[k];
        }
    }
    flanks::add_accelerations(balls, results, &mut rates);
    rates
}

/// Adds the friction of a block to velocities and rates; that at the outer raceway acts against `direction`.
#[inline(always)]
pub(super) fn apply(
    balls: &BallLanes,
    block: usize,
    results: &BlockResults,
    direction: impl Fn(usize) -> PlaneVector,
    change: StepChange<'_>,
) {
    let StepChange {
        layout,
        h_s,
        y,
        dydt,
    } = change;
    let rates = accelerations(balls, results, direction);
    let coordinates = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Spin];
    for (coordinate, rates) in coordinates.into_iter().zip(rates) {
        let at = layout.array(coordinate) + block * LANES;
        let (velocities, accelerations) = (block_mut(y, at), block_mut(dydt, at));
        for lane in 0..LANES {
            velocities[lane] += h_s * rates[lane];
            accelerations[lane] += rates[lane];
        }
    }
}

/// Reactions on the inner ring and powers of friction. Kinetic energy changes by an impulse
/// times the mean of the velocities before and after it, so that the heat of friction is that
/// of the mean sliding speed; all speeds are taken along the directions in which the friction
/// acts, those at the end of the step.
#[inline(always)]
fn powers(
    p: &Parameters,
    balls: &BallLanes,
    results: &BlockResults,
    start: Moving<'_>,
    addends: &mut Addends,
) {
    for lane in 0..LANES {
        let (geometry, ball) = (results.geometry.get(lane), balls.get(lane));
        let inner_raceway = p.inner.get(lane);
        let motion = start.balls.get(lane);
        let polar = results
            .polar
            .get(lane)
            .with_velocity(&motion, &Centre::default());
        let inner_polar = results.inner_polar.get(lane);
        let inner_start = inner_polar.with_velocity(&motion, &start.ring.get(lane));
        let outer_slip = outer_slip(&geometry, &motion, &polar);
        let inner_slip = inner_slip(&ball, &inner_raceway, &motion, &inner_start);
        let (fo, fi) = (
            results.outer_friction.0[lane],
            results.inner_friction.0[lane],
        );
        let outer_mean = 0.5 * (outer_slip + results.outer.slip.0[lane]);
        let inner_mean = 0.5 * (inner_slip + results.inner.slip.0[lane]);
        addends[Sum::RingX as usize].0[lane] = fi * inner_polar.ey;
        addends[Sum::RingY as usize].0[lane] = -fi * inner_polar.ex;
        addends[Sum::Drive as usize].0[lane] = fi * inner_raceway.surface_speed;
        addends[Sum::OuterFriction as usize].0[lane] = fo * outer_mean;
        addends[Sum::InnerFriction as usize].0[lane] = fi * inner_mean;
    }
}
