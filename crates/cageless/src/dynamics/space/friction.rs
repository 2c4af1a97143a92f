//! Friction at the raceways: of a state, or implicit at the end of a step whose other forces are known.
//!
//! With V = (**v**, R**ω**), ℳ = diag(m, J/R²) and the rows of J the [`super::frame::Frame::rows`]
//! of every contact,
//!
//!   ℳ(V − V*) = h Σ ((1 − θ) Q0 + θ Q(V)),
//!
//! V* the velocities to which all else leads and Q0 the friction at the start. Under a law that
//! grows with the sliding speed it is the gradient of a convex function: one solution, by Newton's
//! method with the symmetric matrix ℳ + hθ Σ Jᵀ Φ J. Balls in lanes iterate until the last of them
//! has converged; one that has keeps its solution.

use super::bearing::{Bearing, Totals, tilting_by};
use super::block::{INNER, KnownStrip, KnownStripLanes, PLACES, SpaceBlock, VELOCITIES};
use super::frame::{SIZE, TractionLanes, of_lane};
use super::model::SpaceModel;
use super::ring::RingMotion;
use super::strips::{Patch, SlidingLanes, StripFriction};
use super::workspace::SpaceWorkspace;
use crate::contact::{FrictionLanes, Law, LawLanes, MAX_ITERATIONS, end_weights, with_law};
use crate::dynamics::ball::BallLanes;
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::numerics::cholesky;
use crate::numerics::lanes::{LANES, Lanes, larger};
use crate::simd::{BlockResults, Workspace, block_mut};

/// No step of Newton's method follows one that changes no sliding velocity by more than this, in the
/// speed of the knee.
const LAST_STEP: f64 = 0.05;
/// In so many knees a contact slides: its friction changes with the direction alone,
const SLIDING: f64 = 4.0;
/// and by no more than the square of this fraction of the sliding velocity.
const LAST_TURN: f64 = 0.03;
/// Iterations after which every other one takes the safe matrix.
const PATIENCE: u32 = 6;

/// Adds the friction of the last evaluation to the rates.
#[inline(always)]
pub(super) fn add_explicit_friction(
    (p, model, space, _): Bearing<'_>,
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    for (block, (results, b)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        let at_rest = sliding_at_rest(b, &s.ring);
        b.at_rest = [at_rest.clone(), at_rest];
        slide(&p.friction, space, b, true);
        for step in &mut b.steps {
            (step.mean.along, step.mean.across) = (step.friction.along, step.friction.across);
        }
        b.weights = [Lanes::all(1.0); PLACES];
        let force = tractions(space, b, results, totals);
        accelerate(model.layout, p.balls(block), block, &force, dydt);
        powers(space, b, [&b.velocity; 2], results, &mut w.slip_max, totals);
    }
}

/// Adds friction over a step of `h_s` from `y0` to the velocities and the ledger in `y` and to the
/// rates.
#[inline(always)]
pub(crate) fn add_implicit_friction(
    (p, model, space, drive): Bearing<'_>,
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let layout = model.layout;
    // Speeds at both ends of the step, along the directions in which the friction acts.
    let start_ring = RingMotion::new(layout, y0, drive.inner_speed);
    let start_ring = s.ring.with_velocities_of(&start_ring);
    let mut totals = Totals::default();
    w.slip_max = Lanes::ZERO;
    for (block, (results, b)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        b.at_rest = [sliding_at_rest(b, &start_ring), sliding_at_rest(b, &s.ring)];
        let free = b.velocities(layout, y, block);
        begin(space, b, h_s, s.known, free);
        iterate(&p.friction, space, b, h_s);
        let force = tractions(space, b, results, &mut totals);
        let rates = accelerate(layout, p.balls(block), block, &force, dydt);
        for i in 0..SIZE {
            let velocities = block_mut(y, layout.array(VELOCITIES[i].0) + block * LANES);
            for lane in 0..LANES {
                velocities[lane] += h_s * rates[i].0[lane];
            }
        }
        let (start, end) = (
            b.velocities(layout, y0, block),
            b.velocities(layout, y, block),
        );
        powers(
            space,
            b,
            [&start, &end],
            results,
            &mut w.slip_max,
            &mut totals,
        );
    }
    s.known = true;
    let mut add = |place: usize, rate: f64| {
        dydt[place] += rate;
        y[place] += h_s * rate;
    };
    let [force, moment] = totals.on_ring();
    add(layout.ring(RingCoordinate::Vx), force.x / model.ring.mass);
    add(layout.ring(RingCoordinate::Vy), force.y / model.ring.mass);
    add(layout.ring(RingCoordinate::Vz), force.z / model.ring.mass);
    if let Some(free) = &space.free_tilt {
        let [p, q] = tilting_by(free, &s.ring, moment);
        add(layout.ring(RingCoordinate::TiltPRate), p);
        add(layout.ring(RingCoordinate::TiltQRate), q);
    }
    let power = -drive.inner_speed * moment.dot(&s.ring.axis);
    add(layout.energy_term(EnergyTerm::Drive), power);
    add(
        layout.energy_term(EnergyTerm::OuterFriction),
        totals.heat[0],
    );
    add(
        layout.energy_term(EnergyTerm::InnerFriction),
        totals.heat[1],
    );
}

/// Sliding of balls at rest on the inner ring.
#[inline(always)]
fn sliding_at_rest(b: &SpaceBlock, ring: &RingMotion) -> SlidingLanes {
    let (velocity, rotation) = (ring.velocity.into(), ring.rotation.into());
    let mut sliding = SlidingLanes::ZERO;
    for lane in 0..LANES {
        sliding.put(
            lane,
            b.frames[INNER]
                .get(lane)
                .sliding_at_rest(velocity, rotation),
        );
    }
    sliding
}

impl SpaceBlock {
    /// The contact of a lane with the law.
    #[inline(always)]
    fn patch<L: Law>(&self, law: L, place: usize, lane: usize) -> Patch<L> {
        Patch {
            law,
            normal_n: self.frames[place].friction_normal_n.0[lane],
            half_length_m: self.frames[place].half_length_m.0[lane],
            curvature: self.curvature_at(place).0[lane],
        }
    }
}

/// Friction of every strip at the velocities of the last iterate; of the first with knees and moments.
#[inline(always)]
fn slide(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock, first: bool) {
    with_law!(friction, law => slide_by(law, space, b, first));
}

#[inline(always)]
fn slide_by(law: &impl LawLanes, space: &SpaceModel, b: &mut SpaceBlock, first: bool) {
    for place in 0..PLACES {
        let sliding = b.sliding(place, &b.velocity, 1);
        for (k, strip) in space.strips.iter().enumerate() {
            // Of its own, or the compiler takes its lanes for those that are read.
            let mut step = b.steps[place * space.strips.len() + k].clone();
            for lane in 0..LANES {
                let patch = b.patch(law.lane(lane), place, lane);
                let sliding = sliding.get(lane);
                let x = patch.place(strip);
                let slip = sliding.at(x, patch.curvature);
                let shear = sliding.shear(x, patch.curvature);
                if first {
                    step.inverse_knee.0[lane] = patch.inverse_knee(strip, shear);
                }
                let inverse_knee = step.inverse_knee.0[lane];
                let friction = patch.force(strip, slip, inverse_knee);
                if first {
                    step.mean.moment.0[lane] = patch.moment(strip, shear, &friction, inverse_knee);
                }
                step.slip[0].0[lane] = slip[0];
                step.slip[1].0[lane] = slip[1];
                step.friction.put(lane, friction);
            }
            b.steps[place * space.strips.len() + k] = step;
        }
    }
}

/// Weights of the end of the step, and the velocities to which all but the friction there leads; `free`
/// those without any friction.
#[inline(always)]
fn begin(space: &SpaceModel, b: &mut SpaceBlock, h_s: f64, known: bool, free: [Lanes; SIZE]) {
    let (mut rest, mut weights) = (free, [Lanes::ZERO; PLACES]);
    for place in 0..PLACES {
        let curvature = *b.curvature_at(place);
        let mut start = TractionLanes::ZERO;
        let mut secant = Lanes::ZERO;
        for (k, strip) in space.strips.iter().enumerate() {
            let mut strips = b.strips[place * space.strips.len() + k].clone();
            for lane in 0..LANES {
                // A contact that has opened has no friction left.
                let bears = b.frames[place].friction_normal_n.0[lane] > 0.0;
                let kept = |value: f64| if bears { value } else { 0.0 };
                let known = strips.get(lane);
                let known = KnownStrip {
                    along: kept(known.along),
                    across: kept(known.across),
                    moment: kept(known.moment),
                    secant: kept(known.secant),
                };
                strips.put(lane, known);
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let mut traction = start.get(lane);
                traction.add(
                    [known.along, known.across],
                    known.moment,
                    x,
                    curvature.0[lane],
                );
                start.put(lane, traction);
                secant.0[lane] += known.secant;
            }
            b.strips[place * space.strips.len() + k] = strips;
        }
        for lane in 0..LANES {
            let inverse = [1.0 / b.mass[0].0[lane], 1.0 / b.mass[1].0[lane]];
            let gain = h_s * (inverse[0] + inverse[1]);
            let [decayed, _] = end_weights([gain * secant.0[lane], 0.0]);
            let stays = b.was_inside.0[lane] == b.outer.inside.0[lane];
            let weight = if known & stays { decayed } else { 1.0 };
            weights[place].0[lane] = weight;
            let share = h_s * (1.0 - weight);
            let frame = b.frames[place].get(lane);
            let force = frame.on_ball(&start.get(lane), b.inverse_radius.0[lane]);
            for i in 0..SIZE {
                rest[i].0[lane] += share * force[i] * inverse[i / 3];
            }
        }
    }
    (b.rest, b.weights, b.was_inside) = (rest, weights, b.outer.inside);
}

/// Φ of a strip along τ and l; if `safe` that of a cone which no step of Newton's method overshoots.
#[inline(always)]
fn stiffness(friction: &StripFriction, safe: bool) -> [f64; 3] {
    [
        if safe {
            friction.secant
        } else {
            friction.along_along
        },
        if safe { 0.0 } else { friction.along_across },
        if safe {
            friction.secant
        } else {
            friction.across_across
        },
    ]
}

/// The matrix of Newton's method and what is missing to the equations.
#[inline(always)]
fn equations(
    space: &SpaceModel,
    b: &SpaceBlock,
    h_s: f64,
    safe: &Lanes,
    matrix: &mut [[Lanes; SIZE]; SIZE],
    missing: &mut [Lanes; SIZE],
) {
    for i in 0..SIZE {
        for j in 0..i {
            matrix[i][j] = Lanes::ZERO;
        }
        matrix[i][i] = b.mass[i / 3];
        for lane in 0..LANES {
            let mass = b.mass[i / 3].0[lane];
            missing[i].0[lane] = mass * (b.rest[i].0[lane] - b.velocity[i].0[lane]);
        }
    }
    // J, and h θ Φ J.
    let mut rows = [[Lanes::ZERO; SIZE]; 3];
    let mut pressed = [[Lanes::ZERO; SIZE]; 3];
    for place in 0..PLACES {
        let curvature = *b.curvature_at(place);
        let mut traction = TractionLanes::ZERO;
        // Σ Φ, Φ·x/R and Φ·(x/R)² as far as the rows need them.
        let mut sums = [Lanes::ZERO; 6];
        for (k, strip) in space.strips.iter().enumerate() {
            let step = &b.steps[place * space.strips.len() + k];
            for lane in 0..LANES {
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let friction = step.friction.get(lane);
                let mut sum = traction.get(lane);
                let moment = step.mean.moment.0[lane];
                sum.add(
                    [friction.along, friction.across],
                    moment,
                    x,
                    curvature.0[lane],
                );
                traction.put(lane, sum);
                let [aa, ac, cc] = stiffness(&friction, safe.0[lane] > 0.0);
                let arm = x * b.inverse_radius.0[lane];
                sums[0].0[lane] += aa;
                sums[1].0[lane] += ac;
                sums[2].0[lane] += cc;
                sums[3].0[lane] += arm * aa;
                sums[4].0[lane] += arm * ac;
                sums[5].0[lane] += arm * arm * aa;
            }
        }
        for lane in 0..LANES {
            let share = h_s * b.weights[place].0[lane];
            let frame = b.frames[place].get(lane);
            let force = frame.on_ball(&traction.get(lane), b.inverse_radius.0[lane]);
            let [along, across, spin] = frame.rows();
            let [aa, ac, cc, xaa, xac, xxaa] = of_lane(&sums, lane);
            for i in 0..SIZE {
                missing[i].0[lane] += share * force[i];
                rows[0][i].0[lane] = along[i];
                rows[1][i].0[lane] = across[i];
                rows[2][i].0[lane] = spin[i];
                pressed[0][i].0[lane] = share * (aa * along[i] + ac * across[i] + xaa * spin[i]);
                pressed[1][i].0[lane] = share * (ac * along[i] + cc * across[i] + xac * spin[i]);
                pressed[2][i].0[lane] = share * (xaa * along[i] + xac * across[i] + xxaa * spin[i]);
            }
        }
        for i in 0..SIZE {
            for j in 0..=i {
                let entry = &mut matrix[i][j];
                let [along, across, spin] = [0, 1, 2].map(|row| (&rows[row][i], &pressed[row][j]));
                for lane in 0..LANES {
                    let sum =
                        along.0.0[lane] * along.1.0[lane] + across.0.0[lane] * across.1.0[lane];
                    entry.0[lane] += sum;
                }
                // The row of the spin has no part of **v**.
                if i >= 3 {
                    for lane in 0..LANES {
                        entry.0[lane] += spin.0.0[lane] * spin.1.0[lane];
                    }
                }
            }
        }
    }
}

/// Newton's method until the equations of all balls hold; the friction of the end of the step,
/// linear about the last iterate, in `mean`.
#[inline(always)]
fn iterate(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock, h_s: f64) {
    let (mut done, mut safe) = (Lanes::ZERO, Lanes::ZERO);
    let mut matrix = [[Lanes::ZERO; SIZE]; SIZE];
    let mut change = [Lanes::ZERO; SIZE];
    for iteration in 0..MAX_ITERATIONS {
        slide(friction, space, b, iteration == 0);
        equations(space, b, h_s, &safe, &mut matrix, &mut change);
        cholesky::solve_lanes(&mut matrix, &mut change);
        let (mut moves, mut passes) = (Lanes::ZERO, Lanes::ZERO);
        for place in 0..PLACES {
            for (k, strip) in space.strips.iter().enumerate() {
                let step = &mut b.steps[place * space.strips.len() + k];
                let [mut along, mut across] = [Lanes::ZERO; 2];
                for lane in 0..LANES {
                    let frame = b.frames[place].get(lane);
                    let inverse_radius = b.inverse_radius.0[lane];
                    let by =
                        frame.sliding(of_lane(&change, lane), inverse_radius, &Default::default());
                    let x = strip.place * frame.half_length_m;
                    let (a, b) = (by.along + x * by.spin, by.across);
                    let [c, d] = of_lane(&step.slip, lane);
                    let inverse_knee = step.inverse_knee.0[lane];
                    let moved = (a * a + b * b).sqrt() * inverse_knee;
                    let speed = (c * c + d * d).sqrt() * inverse_knee;
                    let slides = (speed > SLIDING) & (moved <= LAST_TURN * speed);
                    let bears = frame.friction_normal_n > 0.0;
                    let goes_on = bears & !((moved <= LAST_STEP) | slides);
                    let crosses = bears & (speed > 1.0) & (c * (c + a) + d * (d + b) < 0.0);
                    moves.0[lane] = larger(moves.0[lane], if goes_on { 1.0 } else { 0.0 });
                    passes.0[lane] = larger(passes.0[lane], if crosses { 1.0 } else { 0.0 });
                    let friction = step.friction.get(lane);
                    let [aa, ac, cc] = stiffness(&friction, safe.0[lane] > 0.0);
                    along.0[lane] = friction.along - aa * a - ac * b;
                    across.0[lane] = friction.across - ac * a - cc * b;
                }
                (step.mean.along, step.mean.across) = (along, across);
            }
        }
        let mut all_done = true;
        let mut advance = Lanes::ZERO;
        for lane in 0..LANES {
            let ends = done.0[lane] > 0.0 || moves.0[lane] == 0.0;
            all_done &= ends;
            // A step across zero from full sliding goes too far: again with the matrix that never does.
            let again = passes.0[lane] > 0.0 && safe.0[lane] == 0.0;
            let patient = iteration <= PATIENCE || safe.0[lane] > 0.0;
            advance.0[lane] = f64::from(u8::from(!ends && !again));
            done.0[lane] = f64::from(u8::from(ends));
            if !ends {
                safe.0[lane] = f64::from(u8::from(again || !patient));
            }
        }
        if all_done {
            return;
        }
        for i in 0..SIZE {
            for lane in 0..LANES {
                b.velocity[i].0[lane] += advance.0[lane] * change[i].0[lane];
            }
        }
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
    for place in 0..PLACES {
        let curvature = *b.curvature_at(place);
        let mut traction = TractionLanes::ZERO;
        for (k, strip) in space.strips.iter().enumerate() {
            let at = place * space.strips.len() + k;
            let (step, known) = (&b.steps[at], &b.strips[at]);
            let (mut means, mut ends) = (KnownStripLanes::ZERO, KnownStripLanes::ZERO);
            for lane in 0..LANES {
                let (before, after) = (known.get(lane), step.mean.get(lane));
                let end = b.weights[place].0[lane];
                let mean = KnownStrip {
                    along: (1.0 - end) * before.along + end * after.along,
                    across: (1.0 - end) * before.across + end * after.across,
                    moment: (1.0 - end) * before.moment + end * after.moment,
                    secant: 0.0,
                };
                let secant = step.friction.secant.0[lane];
                ends.put(lane, KnownStrip { secant, ..after });
                means.put(lane, mean);
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let mut sum = traction.get(lane);
                sum.add([mean.along, mean.across], mean.moment, x, curvature.0[lane]);
                traction.put(lane, sum);
            }
            (b.steps[at].mean, b.strips[at]) = (means, ends);
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
            }
        }
    }
    for (total, lanes) in totals.ring.iter_mut().zip(&on_ring) {
        *total += lanes.sum();
    }
    forces
}

/// Adds the accelerations of the balls of a block under these forces to rates.
#[inline(always)]
fn accelerate(
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
    for place in 0..PLACES {
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
                let ([a, b], [c, d]) = (start.at(x, curvature), end.at(x, curvature));
                let shear = start.shear(x, curvature) + end.shear(x, curvature);
                heat[usize::from(inner)].0[lane] -=
                    0.5 * (mean.along * (a + c) + mean.across * (b + d) + mean.moment * shear);
            }
        }
    }
    for (total, lanes) in totals.heat.iter_mut().zip(&heat) {
        *total += lanes.sum();
    }
}
