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
use crate::contact::friction_step::{LAST_STEP, PATIENCE, slides_on};
use crate::contact::{
    AtKnees, EvaluatedLaws, FilmTractionLanes, FrictionLanes, Law, LawLanes, MAX_ITERATIONS,
    end_weights, with_law,
};
use crate::numerics::cholesky;
use crate::numerics::lanes::{LANES, Lanes, lane_struct, larger};

/// [`LAST_STEP`] where the matrix is that of [`Slopes::Joint`], whose steps are not exact.
const LAST_JOINT_STEP: f64 = 0.01;
/// γ/√(γ² + γs²) beyond which the moment of a strip hardly grows any more.
const SPINS: f64 = 0.7;

/// Friction of every strip at the velocities of the last iterate.
#[inline(always)]
pub(super) fn slide(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock) {
    with_law!(friction, law => slide_by(law, space, b));
}

#[inline(always)]
fn slide_by(law: &impl LawLanes, space: &SpaceModel, b: &mut SpaceBlock) {
    for &place in b.places {
        let sliding = b.sliding(place, &b.velocity, 1);
        let at = ContactOfBlock {
            frame: &b.frames[place],
            curvature: &b.curvature[usize::from(place == INNER)],
            inverse_knees: &b.inverse_knees[place],
            films: &b.films[place],
        };
        let steps = &mut b.steps[place * space.strips.len()..];
        for (strip, step) in space.strips.iter().zip(steps) {
            slide_strip(law, &at, &sliding, strip, step);
        }
    }
}

/// Contact of the balls of a block at a place.
struct ContactOfBlock<'a> {
    frame: &'a FrameLanes,
    /// κ, 1/m.
    curvature: &'a Lanes,
    /// 1/v_s of the law, s/m.
    inverse_knees: &'a Lanes,
    films: &'a FilmTractionLanes,
}

/// [`slide`] of one strip; a function, so that the compiler knows what is read apart from what is
/// written.
#[inline(always)]
fn slide_strip<L: LawLanes>(
    law: &L,
    at: &ContactOfBlock<'_>,
    sliding: &SlidingLanes,
    strip: &Strip,
    step: &mut StripStep,
) {
    let ContactOfBlock {
        frame,
        curvature,
        inverse_knees,
        films,
    } = *at;
    let mut speeds = Lanes::ZERO;
    for lane in 0..LANES {
        let (sliding, x) = (sliding.get(lane), strip.place * frame.half_length_m.0[lane]);
        let of_strip = sliding.at(x, curvature.0[lane]);
        speeds.0[lane] = of_strip.speed();
        step.sliding.put(lane, of_strip);
    }
    let laws = law.evaluated([&speeds, &speeds]);
    for lane in 0..LANES {
        let (film, normal_n) = (films.get(lane), frame.friction_normal_n.0[lane]);
        let patch = Patch {
            law: AtKnees {
                law: laws.lane(lane),
                inverse_knees: [inverse_knees.0[lane]; 2],
            },
            film,
            normal_n: match L::Constants::MIXES {
                true => film.asperity_share * normal_n,
                false => normal_n,
            },
            half_length_m: frame.half_length_m.0[lane],
        };
        let friction = patch.friction(strip, &step.sliding.get(lane));
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

/// Choice of the slopes of a strip in the matrix of Newton's method.
#[derive(Clone, Copy, PartialEq)]
enum Slopes {
    /// Force over sliding and moment over shear, with k and F′ k as they are at the first iterate: exact as of
    /// the velocities extrapolated to the end of the step, which are of second order.
    Apart,
    /// Slopes of force and moment over both sliding and shear.
    Joint,
}

/// Slopes of the friction of a strip in Newton's matrix.
struct Stiffness {
    /// Φ along τ, N·s/m.
    along_along: f64,
    /// Φ between τ and l, N·s/m.
    along_across: f64,
    /// Φ along l, N·s/m.
    across_across: f64,
    /// Between the sliding along τ and the shear, N·s.
    along_shear: f64,
    /// Between the sliding along l and the shear, N·s.
    across_shear: f64,
    /// Slope of the moment over the shear, N·m·s.
    shear_shear: f64,
}

impl Stiffness {
    /// Slopes of a strip; if `safe`, those of cones that no step of Newton's method overshoots.
    ///
    /// The force answers the shear otherwise than the moment the sliding; the geometric mean of both keeps the matrix
    /// symmetric and positive definite.
    #[inline(always)]
    fn of(friction: &StripFriction, slopes: Slopes, safe: bool) -> Self {
        let either = |safe_value: f64, value: f64| if safe { safe_value } else { value };
        let joint = if slopes == Slopes::Joint { 1.0 } else { 0.0 };
        let mean = joint * friction.moment_ratio.sqrt();
        let shear_shear = friction.shear_shear + joint * friction.widening;
        Self {
            along_along: either(friction.secant, friction.along_along),
            along_across: either(0.0, friction.along_across),
            across_across: either(friction.secant, friction.across_across),
            along_shear: either(0.0, mean * friction.along_shear),
            across_shear: either(0.0, mean * friction.across_shear),
            shear_shear: either(friction.moment_secant, shear_shear),
        }
    }
}

lane_struct! {
    /// Σ Φ, Φ·x/R and Φ·(x/R)² of the strips of a contact, with the shear 1/R, as far as the rows of J need them.
    pub(super) struct ContactStiffness per lane ContactStiffnessLanes {
        along_along,
        along_across,
        across_across,
        /// Between τ and the spin, as are the next between l and the spin, and of the spin.
        along_spin,
        across_spin,
        spin_spin,
    }
}

/// How Newton's method takes a step.
struct Iterate<'a> {
    slopes: Slopes,
    /// Largest change of a sliding speed in the last step, in knees.
    last_step: f64,
    /// 1 where the matrix is that of cones, else 0.
    safe: &'a Lanes,
    /// 1 where a ball has converged, else 0.
    done: &'a Lanes,
}

/// The matrix of Newton's method and what is missing to the equations.
#[inline(always)]
fn equations(
    space: &SpaceModel,
    b: &SpaceBlock,
    h_s: f64,
    iterate: &Iterate<'_>,
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
        let mut stiffness = ContactStiffnessLanes::ZERO;
        for (k, strip) in space.strips.iter().enumerate() {
            let step = &b.steps[place * space.strips.len() + k];
            for lane in 0..LANES {
                let x = strip.place * b.frames[place].half_length_m.0[lane];
                let friction = step.friction.get(lane);
                let force = [friction.along, friction.across, friction.moment];
                traction.add(lane, force, x, curvature.0[lane]);
                let phi = Stiffness::of(&friction, iterate.slopes, iterate.safe.0[lane] > 0.0);
                let inverse = b.inverse_radius.0[lane];
                stiffness.along_along.0[lane] += phi.along_along;
                stiffness.along_across.0[lane] += phi.along_across;
                stiffness.across_across.0[lane] += phi.across_across;
                stiffness.along_spin.0[lane] += inverse * (x * phi.along_along + phi.along_shear);
                stiffness.across_spin.0[lane] +=
                    inverse * (x * phi.along_across + phi.across_shear);
                stiffness.spin_spin.0[lane] += inverse
                    * inverse
                    * (x * (x * phi.along_along + 2.0 * phi.along_shear) + phi.shear_shear);
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
            let phi = stiffness.get(lane);
            let [aa, ac, cc] = [phi.along_along, phi.along_across, phi.across_across];
            let [a_spin, c_spin] = [phi.along_spin, phi.across_spin];
            let mut pressed = [[0.0; SIZE]; 3];
            for i in 0..SIZE {
                pressed[0][i] = share * (aa * along[i] + ac * across[i] + a_spin * spin[i]);
                pressed[1][i] = share * (ac * along[i] + cc * across[i] + c_spin * spin[i]);
                pressed[2][i] =
                    share * (a_spin * along[i] + c_spin * across[i] + phi.spin_spin * spin[i]);
            }
            add_products(matrix, lane, &rows, &pressed);
        }
    }
}

/// Adds Jᵀ·(h θ Φ J) of a contact to the lower half of the matrix.
#[inline(always)]
fn add_products(
    matrix: &mut [[Lanes; SIZE]; SIZE],
    lane: usize,
    rows: &[[f64; SIZE]; 3],
    pressed: &[[f64; SIZE]; 3],
) {
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

/// Newton's method until the equations of all balls hold; the friction of the end of the step,
/// linear about the last iterate, in `mean`.
#[inline(always)]
pub(super) fn iterate(friction: &FrictionLanes, space: &SpaceModel, b: &mut SpaceBlock, h_s: f64) {
    let (mut done, mut safe) = (Lanes::ZERO, Lanes::ZERO);
    let mut matrix = [[Lanes::ZERO; SIZE]; SIZE];
    let mut change = [Lanes::ZERO; SIZE];
    for iteration in 0..MAX_ITERATIONS {
        slide(friction, space, b);
        let (slopes, last_step) = match iteration {
            0 => (Slopes::Apart, LAST_STEP),
            _ => (Slopes::Joint, LAST_JOINT_STEP),
        };
        let iterate = Iterate {
            slopes,
            last_step,
            safe: &safe,
            done: &done,
        };
        equations(space, b, h_s, &iterate, &mut matrix, &mut change);
        cholesky::solve_lanes(&mut matrix, &mut change);
        let mut stops = Stops::NONE;
        for &place in b.places {
            for (k, strip) in space.strips.iter().enumerate() {
                let step = &mut b.steps[place * space.strips.len() + k];
                let (frames, inverse_radius) = (&b.frames[place], &b.inverse_radius);
                stop_strip(
                    frames,
                    inverse_radius,
                    strip,
                    &change,
                    &iterate,
                    step,
                    &mut stops,
                );
            }
        }
        let mut all_done = true;
        let mut advance = Lanes::ZERO;
        for lane in 0..LANES {
            let ends = done.0[lane] > 0.0 || stops.moves.0[lane] == 0.0;
            all_done &= ends;
            // A step across zero from full sliding goes too far: again with the matrix that never does.
            let again = stops.passes.0[lane] > 0.0 && safe.0[lane] == 0.0;
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

/// Whether contacts of a ball have converged.
struct Stops {
    /// 1 where a sliding velocity changes too much for the last step, else 0.
    moves: Lanes,
    /// 1 where one goes across zero from full sliding, else 0.
    passes: Lanes,
}

impl Stops {
    const NONE: Self = Self {
        moves: Lanes::ZERO,
        passes: Lanes::ZERO,
    };
}

/// Takes from a strip by a change of the velocities whether it has converged, and puts its friction, linear
/// about the last iterate, in `mean`.
#[inline(always)]
fn stop_strip(
    frames: &FrameLanes,
    inverse_radius: &Lanes,
    strip: &Strip,
    change: &[Lanes; SIZE],
    iterate: &Iterate<'_>,
    step: &mut StripStep,
    stops: &mut Stops,
) {
    let Iterate {
        slopes,
        last_step,
        safe,
        done,
    } = *iterate;
    let mean = &mut step.mean;
    for lane in 0..LANES {
        let frame = frames.get(lane);
        let inverse_radius = inverse_radius.0[lane];
        let by = frame.sliding(of_lane(change, lane), inverse_radius, &Default::default());
        let x = strip.place * frame.half_length_m;
        let (a, b, turn) = (by.along + x * by.spin, by.across, by.spin);
        let sliding = step.sliding.get(lane);
        let (c, d, shear) = (sliding.along, sliding.across, sliding.shear);
        let friction = step.friction.get(lane);
        let moved = (a * a + b * b).sqrt() * friction.inverse_knee;
        let speed = sliding.speed() * friction.inverse_knee;
        let turned = turn.abs() * friction.inverse_shear;
        let bears = frame.friction_normal_n > 0.0;
        let ends = ((moved <= last_step) & (turned <= last_step)) | slides_on(speed, moved, 1.0);
        let crosses = (speed > 1.0) & (c * (c + a) + d * (d + b) < 0.0)
            | (shear.abs() * friction.inverse_shear > SPINS) & (shear * (shear + turn) < 0.0);
        stops.moves.0[lane] = larger(stops.moves.0[lane], f64::from(u8::from(bears & !ends)));
        stops.passes.0[lane] = larger(stops.passes.0[lane], f64::from(u8::from(bears & crosses)));
        let safe = safe.0[lane] > 0.0;
        let phi = Stiffness::of(&friction, slopes, safe);
        let joint = (slopes == Slopes::Joint) & !safe;
        let of = |slope: f64| if joint { slope } else { 0.0 };
        let [pull, push] = [of(friction.along_shear), of(friction.across_shear)];
        let ratio = friction.moment_ratio;
        let along = phi.along_along * a + phi.along_across * b + pull * turn;
        let across = phi.along_across * a + phi.across_across * b + push * turn;
        let moment = phi.shear_shear * turn + ratio * (pull * a + push * b);
        // A solution that has converged stays.
        let before = mean.get(lane);
        let finished = done.0[lane] > 0.0;
        let kept = |before: f64, now: f64| if finished { before } else { now };
        mean.put(
            lane,
            KnownStrip {
                along: kept(before.along, friction.along - along),
                across: kept(before.across, friction.across - across),
                moment: kept(before.moment, friction.moment - moment),
                secant: 0.0,
            },
        );
    }
}
