//! Newton's method for the friction at the end of a step whose other forces are known.
//!
//! With V = (**v**, R**ω**), ℳ = diag(m, J/R²) and the rows of J the [`super::frame::Frame::rows`]
//! of every contact,
//!
//!   ℳ(V − V*) = h Σ ((1 − θ) Q0 + θ Q(V)),
//!
//! V* the velocities to which all else leads and Q0 the friction at the start. Under a law that
//! grows with the sliding speed it is the gradient of a convex function: one solution, by the symmetric
//! matrix ℳ + hθ Σ Jᵀ Φ J. Balls in lanes iterate until the last of them has converged; one that has
//! keeps its solution.

use super::block::{INNER, KnownStrip, KnownStripLanes, PLACES, SpaceBlock, StripStep};
use super::frame::{FrameLanes, SIZE, TractionLanes, of_lane};
use super::model::SpaceModel;
use super::strips::{Patch, SlidingLanes, Strip, StripFriction};
use crate::contact::{FrictionLanes, LawLanes, MAX_ITERATIONS, end_weights, with_law};
use crate::numerics::cholesky;
use crate::numerics::lanes::{LANES, Lanes, larger};

/// No step of Newton's method follows one that changes no sliding velocity by more than this, in the
/// speed of the knee.
const LAST_STEP: f64 = 0.05;
/// In so many knees a contact slides: its friction changes with the direction alone,
const SLIDING: f64 = 4.0;
/// and by no more than the square of this fraction of the sliding velocity.
const LAST_TURN: f64 = 0.03;
/// Iterations after which every other one takes the safe matrix.
const PATIENCE: u32 = 6;

/// Friction of every strip at the velocities of the last iterate; of the first with knees and moments.
#[inline(always)]
pub(super) fn slide(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock, first: bool) {
    with_law!(friction, law => slide_by(law, space, b, first));
}

#[inline(always)]
fn slide_by(law: &impl LawLanes, space: &SpaceModel, b: &mut SpaceBlock, first: bool) {
    for &place in b.places {
        let sliding = b.sliding(place, &b.velocity, 1);
        let (frame, curvature) = (&b.frames[place], &b.curvature[usize::from(place == INNER)]);
        let steps = &mut b.steps[place * space.strips.len()..];
        for (strip, step) in space.strips.iter().zip(steps) {
            slide_strip(law, frame, curvature, &sliding, strip, step, first);
        }
    }
}

/// [`slide`] of one strip; a function, so that the compiler knows what is read apart from what is
/// written.
#[inline(always)]
fn slide_strip(
    law: &impl LawLanes,
    frame: &FrameLanes,
    curvature: &Lanes,
    sliding: &SlidingLanes,
    strip: &Strip,
    step: &mut StripStep,
    first: bool,
) {
    for lane in 0..LANES {
        let patch = Patch {
            law: law.lane(lane),
            normal_n: frame.friction_normal_n.0[lane],
            half_length_m: frame.half_length_m.0[lane],
            curvature: curvature.0[lane],
        };
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
}

/// Weights of the end of the step, and the velocities to which all but the friction there leads; `free`
/// those without any friction.
#[inline(always)]
pub(super) fn begin(
    space: &SpaceModel,
    b: &mut SpaceBlock,
    h_s: f64,
    known: bool,
    free: [Lanes; SIZE],
) {
    let (mut rest, mut weights) = (free, [Lanes::ZERO; PLACES]);
    for place in 0..PLACES {
        if !b.places.contains(&place) {
            let strips = &mut b.strips[place * space.strips.len()..];
            strips[..space.strips.len()].fill(KnownStripLanes::ZERO);
            continue;
        }
        let curvature = *b.curvature_at(place);
        let mut start = TractionLanes::ZERO;
        let mut secant = Lanes::ZERO;
        let strips = &mut b.strips[place * space.strips.len()..];
        for (strip, known) in space.strips.iter().zip(strips) {
            keep_loaded(&b.frames[place].friction_normal_n, known);
            for lane in 0..LANES {
                let known = known.get(lane);
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let force = [known.along, known.across, known.moment];
                start.add(lane, force, x, curvature.0[lane]);
                secant.0[lane] += known.secant;
            }
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

/// Takes the friction from contacts that have opened.
#[inline(always)]
fn keep_loaded(normal_n: &Lanes, known: &mut KnownStripLanes) {
    for lane in 0..LANES {
        let bears = normal_n.0[lane] > 0.0;
        let kept = |value: f64| if bears { value } else { 0.0 };
        let before = known.get(lane);
        let after = KnownStrip {
            along: kept(before.along),
            across: kept(before.across),
            moment: kept(before.moment),
            secant: kept(before.secant),
        };
        known.put(lane, after);
    }
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
    for &place in b.places {
        let curvature = *b.curvature_at(place);
        let mut traction = TractionLanes::ZERO;
        // Σ Φ, Φ·x/R and Φ·(x/R)² as far as the rows need them.
        let mut sums = [Lanes::ZERO; 6];
        for (k, strip) in space.strips.iter().enumerate() {
            let step = &b.steps[place * space.strips.len() + k];
            for lane in 0..LANES {
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let friction = step.friction.get(lane);
                let moment = step.mean.moment.0[lane];
                let force = [friction.along, friction.across, moment];
                traction.add(lane, force, x, curvature.0[lane]);
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
            for i in 0..SIZE {
                missing[i].0[lane] += share * force[i];
            }
            // J, and h θ Φ J.
            let rows = frame.rows();
            let [along, across, spin] = rows;
            let [aa, ac, cc, xaa, xac, xxaa] = of_lane(&sums, lane);
            let mut pressed = [[0.0; SIZE]; 3];
            for i in 0..SIZE {
                pressed[0][i] = share * (aa * along[i] + ac * across[i] + xaa * spin[i]);
                pressed[1][i] = share * (ac * along[i] + cc * across[i] + xac * spin[i]);
                pressed[2][i] = share * (xaa * along[i] + xac * across[i] + xxaa * spin[i]);
            }
            let both = |i: usize, j: usize| rows[0][i] * pressed[0][j] + rows[1][i] * pressed[1][j];
            let spin = |i: usize, j: usize| rows[2][i] * pressed[2][j];
            // The row of the spin has no part of **v**.
            for i in 0..3 {
                for j in 0..3 {
                    matrix[3 + i][j].0[lane] += both(3 + i, j);
                    matrix[3 + i][j].0[lane] += spin(3 + i, j);
                    if j <= i {
                        matrix[i][j].0[lane] += both(i, j);
                        matrix[3 + i][3 + j].0[lane] += both(3 + i, 3 + j);
                        matrix[3 + i][3 + j].0[lane] += spin(3 + i, 3 + j);
                    }
                }
            }
        }
    }
}

/// Newton's method until the equations of all balls hold; the friction of the end of the step,
/// linear about the last iterate, in `mean`.
#[inline(always)]
pub(super) fn iterate(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock, h_s: f64) {
    let (mut done, mut safe) = (Lanes::ZERO, Lanes::ZERO);
    let mut matrix = [[Lanes::ZERO; SIZE]; SIZE];
    let mut change = [Lanes::ZERO; SIZE];
    for iteration in 0..MAX_ITERATIONS {
        slide(friction, space, b, iteration == 0);
        equations(space, b, h_s, &safe, &mut matrix, &mut change);
        cholesky::solve_lanes(&mut matrix, &mut change);
        let (mut moves, mut passes) = (Lanes::ZERO, Lanes::ZERO);
        for &place in b.places {
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
