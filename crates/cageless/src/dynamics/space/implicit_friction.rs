//! Implicit friction at the raceways: the end of a step whose other forces are known.
//!
//! With V = (**v**, R**ω**), ℳ = diag(m, J/R²) and the rows j of Jτ = (**τ**, −**l** + x/R **n**),
//! Jl = (**l**, **τ**) of every strip,
//!
//!   ℳ(V − V*) = h Σ ((1 − θ) Q0 + θ Q(V)),
//!
//! V* the velocities to which all else leads and Q0 the friction at the start. Under a law that
//! grows with the sliding speed it is the gradient of a convex function: one solution, by Newton's
//! method with the symmetric matrix ℳ + hθ Σ Jᵀ Φ J.

use super::Vector;
use super::contact::Traction;
use super::evaluation::{
    Drive, VELOCITIES, accelerate, ball_motion, store_friction, store_slips, tilting_by, velocities,
};
use super::model::SpaceModel;
use super::ring::RingMotion;
use super::strips::Patch;
use super::workspace::{KnownStrip, PLACES, SpaceWorkspace, StripStep};
use crate::contact::{MAX_ITERATIONS, end_weights};
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::model::Model;
use crate::numerics::cholesky;
use crate::numerics::lanes::Lanes;
use crate::simd::Workspace;

/// No step of Newton's method follows one that changes no sliding velocity by more than this, in the
/// speed of the knee.
const LAST_STEP: f64 = 0.05;
/// In so many knees a contact slides: its friction changes with the direction alone,
const SLIDING: f64 = 4.0;
/// and by no more than the square of this fraction of the sliding velocity.
const LAST_TURN: f64 = 0.03;
/// Iterations after which every other one takes the safe matrix.
const PATIENCE: u32 = 6;

/// Adds friction over a step of `h_s` from `y0` to the velocities and the ledger in `y` and to the
/// rates.
pub(crate) fn add_implicit_friction(
    (model, space, drive): (&Model, &SpaceModel, Drive),
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    let layout = model.layout;
    // Speeds at both ends of the step, along the directions in which the friction acts.
    let start_ring = s
        .ring
        .with_velocities_of(&RingMotion::new(layout, y0, drive.inner_speed));
    let (mut ring_force, mut ring_moment) = (Vector::zeros(), Vector::zeros());
    let mut heat = [0.0; 2];
    let mut slip_max: f64 = 0.0;
    for k in 0..layout.balls {
        let radius = model.balls[k].radius;
        let tractions = solve(model, space, s, k, h_s, y);
        for place in 0..PLACES {
            let contact = s.balls[k].contacts[place];
            if contact.friction_normal_n <= 0.0 {
                continue;
            }
            let on_ball = contact.on_ball(&tractions[place], radius);
            accelerate(model, k, on_ball, dydt);
            let linear = on_ball[0] * (h_s * model.balls[k].inverse_mass);
            let angular = on_ball[1] * (h_s * model.balls[k].inverse_inertia);
            let steps = [
                linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
            ];
            for ((coordinate, sign), step) in VELOCITIES.into_iter().zip(steps) {
                y[layout.ball(coordinate, k)] += sign * step;
            }
            if contact.inner {
                ring_force -= on_ball[0];
                ring_moment += contact.on_ring(&tractions[place]);
            } else {
                s.results[k].outer_ring_force_n[0] -= on_ball[0].x;
                s.results[k].outer_ring_force_n[1] -= on_ball[0].y;
            }
            store_friction(w, k, contact.inner, tractions[place].force[0]);
        }
        let [_, velocity0, rotation0] = ball_motion(layout, y0, k);
        let [_, velocity1, rotation1] = ball_motion(layout, y, k);
        let mut slips = [[0.0; 2]; PLACES];
        for (place, contact) in s.balls[k].contacts.iter().enumerate() {
            let end = contact.sliding(velocity1, rotation1, radius, &s.ring);
            slips[place] = [end.along, end.across];
            if contact.friction_normal_n <= 0.0 {
                continue;
            }
            let start = contact.sliding(velocity0, rotation0, radius, &start_ring);
            let curvature = space.balls[k].curvature[usize::from(contact.inner)];
            let steps = &s.steps[place * space.strips.len()..];
            for (strip, step) in space.strips.iter().zip(steps) {
                let x = strip.place * contact.half_length_m;
                let ([a, b], [c, d]) = (start.at(x, curvature), end.at(x, curvature));
                let shear = start.shear(x, curvature) + end.shear(x, curvature);
                let [along, across] = step.mean.force;
                heat[usize::from(contact.inner)] -=
                    0.5 * (along * (a + c) + across * (b + d) + step.mean.moment * shear);
            }
        }
        slip_max = slip_max.max(store_slips(w, s, k, slips));
        s.balls[k].inside[0] = s.balls[k].inside[1];
    }
    s.known = true;
    w.slip_max = Lanes::ZERO;
    w.slip_max.0[0] = slip_max;
    let mut add = |place: usize, rate: f64| {
        dydt[place] += rate;
        y[place] += h_s * rate;
    };
    let acceleration = ring_force / model.ring.mass;
    add(layout.ring(RingCoordinate::Vx), acceleration.x);
    add(layout.ring(RingCoordinate::Vy), acceleration.y);
    add(layout.ring(RingCoordinate::Vz), acceleration.z);
    if let Some(free) = &space.free_tilt {
        let [p, q] = tilting_by(free, &s.ring, ring_moment);
        add(layout.ring(RingCoordinate::TiltPRate), p);
        add(layout.ring(RingCoordinate::TiltQRate), q);
    }
    let power = -drive.inner_speed * ring_moment.dot(&s.ring.axis);
    add(layout.energy_term(EnergyTerm::Drive), power);
    add(layout.energy_term(EnergyTerm::OuterFriction), heat[0]);
    add(layout.energy_term(EnergyTerm::InnerFriction), heat[1]);
}

/// Force and moment over R on a ball.
#[inline(always)]
fn generalised([force, moment]: [Vector; 2], radius_m: f64) -> [f64; 6] {
    let m = moment / radius_m;
    [force.x, force.y, force.z, m.x, m.y, m.z]
}

/// Rows of J of a strip at x/R: along τ and along l.
#[inline(always)]
fn rows([normal, across, along]: [Vector; 3], x: f64) -> [[f64; 6]; 2] {
    let turn = normal * x - across;
    [
        [along.x, along.y, along.z, turn.x, turn.y, turn.z],
        [across.x, across.y, across.z, along.x, along.y, along.z],
    ]
}

#[inline(always)]
fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5])
}

/// Solves for the friction of ball `k` at the end of a step, where all else leads to `y`; the friction
/// of each place that changes velocities, (1 − θ)·f₀ + θ·f₁, of each strip in `s.steps`.
fn solve(
    model: &Model,
    space: &SpaceModel,
    s: &mut SpaceWorkspace,
    k: usize,
    h_s: f64,
    y: &[f64],
) -> [Traction; PLACES] {
    let (ball, count) = (&model.balls[k], space.strips.len());
    let radius = ball.radius;
    let SpaceWorkspace {
        ring,
        balls,
        strips,
        steps,
        ..
    } = s;
    let work = &balls[k];
    let [linear, angular] = [ball.mass, model.inertia[k] / (radius * radius)];
    let mass = [linear, linear, linear, angular, angular, angular];
    let [_, velocity, rotation] = ball_motion(model.layout, y, k);
    let mut rest = generalised([velocity, rotation * (radius * radius)], radius);
    let known = s.known && work.inside[0] == work.inside[1];
    let strips = &mut strips[k * PLACES * count..][..PLACES * count];
    let mut weights = [1.0; PLACES];
    let patch = |place: usize| {
        let contact = &work.contacts[place];
        Patch {
            friction: &model.friction,
            normal_n: contact.friction_normal_n,
            half_length_m: contact.half_length_m,
            curvature: space.balls[k].curvature[usize::from(contact.inner)],
        }
    };
    let touching = |place: usize| work.contacts[place].friction_normal_n > 0.0;
    let [v, o] = velocities(&work.velocity, radius);
    for place in 0..PLACES {
        let own = place * count..(place + 1) * count;
        if !touching(place) {
            strips[own].fill(KnownStrip::default());
            continue;
        }
        let (contact, patch) = (&work.contacts[place], patch(place));
        let sliding = contact.sliding(v, o, radius, ring);
        let mut start = Traction::default();
        let mut secant = 0.0;
        let pairs = strips[own.clone()].iter().zip(&mut steps[own]);
        for (strip, (known_strip, step)) in space.strips.iter().zip(pairs) {
            let x = patch.place(strip);
            let shear = sliding.shear(x, patch.curvature);
            let inverse_knee = patch.inverse_knee(strip, shear);
            let slip = sliding.at(x, patch.curvature);
            let friction = patch.force(strip, slip, inverse_knee);
            *step = StripStep {
                inverse_knee,
                moment: patch.moment(strip, shear, &friction, inverse_knee),
                slip,
                friction,
                mean: KnownStrip::default(),
            };
            start.add(known_strip.force, known_strip.moment, x, patch.curvature);
            secant += known_strip.secant;
        }
        if known {
            let gain = h_s * (ball.inverse_mass + radius * radius * ball.inverse_inertia);
            weights[place] = end_weights([gain * secant, 0.0])[0];
            let share = h_s * (1.0 - weights[place]);
            let force = generalised(contact.on_ball(&start, radius), radius);
            for i in 0..6 {
                rest[i] += share * force[i] / mass[i];
            }
        }
    }

    let mut values = work.velocity;
    let mut safe = false;
    for iteration in 0..MAX_ITERATIONS {
        let mut missing = [0.0; 6];
        let mut matrix = [[0.0; 6]; 6];
        for i in 0..6 {
            missing[i] = mass[i] * (rest[i] - values[i]);
            matrix[i][i] = mass[i];
        }
        for place in (0..PLACES).filter(|place| touching(*place)) {
            let (contact, patch) = (&work.contacts[place], patch(place));
            let frame = [contact.normal, contact.across, contact.along];
            let share = h_s * weights[place];
            let mut traction = Traction::default();
            for (strip, step) in space.strips.iter().zip(&mut steps[place * count..]) {
                let x = patch.place(strip);
                let friction = &step.friction;
                traction.add(friction.force, step.moment, x, patch.curvature);
                let [along, across] = rows(frame, x / radius);
                let [[aa, ac], [_, cc]] = step.stiffness(safe);
                for i in 0..6 {
                    let a = share * (aa * along[i] + ac * across[i]);
                    let c = share * (ac * along[i] + cc * across[i]);
                    for j in 0..=i {
                        matrix[i][j] += a * along[j] + c * across[j];
                    }
                }
            }
            let force = generalised(contact.on_ball(&traction, radius), radius);
            for i in 0..6 {
                missing[i] += share * force[i];
            }
        }
        let Some(change) = cholesky::solve(&matrix, 0.0, missing) else {
            break;
        };
        let mut last = true;
        let mut passes = false;
        for place in (0..PLACES).filter(|place| touching(*place)) {
            let (contact, patch) = (&work.contacts[place], patch(place));
            let frame = [contact.normal, contact.across, contact.along];
            for (strip, step) in space.strips.iter().zip(&mut steps[place * count..]) {
                let [along, across] = rows(frame, patch.place(strip) / radius);
                let (a, b) = (dot(&along, &change), dot(&across, &change));
                let [c, d] = step.slip;
                let moved = (a * a + b * b).sqrt() * step.inverse_knee;
                let speed = (c * c + d * d).sqrt() * step.inverse_knee;
                let slides = speed > SLIDING && moved <= LAST_TURN * speed;
                last &= moved <= LAST_STEP || slides;
                passes |= speed > 1.0 && c * (c + a) + d * (d + b) < 0.0;
                let [[aa, ac], [_, cc]] = step.stiffness(safe);
                let [f, g] = step.friction.force;
                step.mean.force = [f - aa * a - ac * b, g - ac * a - cc * b];
            }
        }
        if last {
            break;
        }
        // A step across zero from full sliding goes too far: again with the matrix that never does.
        if passes && !safe {
            safe = true;
            continue;
        }
        for i in 0..6 {
            values[i] += change[i];
        }
        safe = iteration > PATIENCE && !safe;
        let [v, o] = velocities(&values, radius);
        for place in (0..PLACES).filter(|place| touching(*place)) {
            let (contact, patch) = (&work.contacts[place], patch(place));
            let sliding = contact.sliding(v, o, radius, ring);
            for (strip, step) in space.strips.iter().zip(&mut steps[place * count..]) {
                step.slip = sliding.at(patch.place(strip), patch.curvature);
                step.friction = patch.force(strip, step.slip, step.inverse_knee);
            }
        }
    }

    let mut tractions = [Traction::default(); PLACES];
    for place in (0..PLACES).filter(|place| touching(*place)) {
        let (patch, end) = (patch(place), weights[place]);
        let pairs = strips[place * count..]
            .iter_mut()
            .zip(&mut steps[place * count..]);
        for (strip, (known_strip, step)) in space.strips.iter().zip(pairs) {
            let solved = KnownStrip {
                force: step.mean.force,
                moment: step.moment,
                secant: step.friction.secant,
            };
            let mix = |before: f64, after: f64| (1.0 - end) * before + end * after;
            step.mean = KnownStrip {
                force: [0, 1].map(|i| mix(known_strip.force[i], solved.force[i])),
                moment: mix(known_strip.moment, solved.moment),
                secant: 0.0,
            };
            let x = patch.place(strip);
            tractions[place].add(step.mean.force, step.mean.moment, x, patch.curvature);
            *known_strip = solved;
        }
    }
    tractions
}
