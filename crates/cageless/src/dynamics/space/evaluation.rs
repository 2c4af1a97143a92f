//! The rates of all coordinates.

use super::Vector;
use super::contact::{Contact, Traction};
use super::model::{FreeTilt, SpaceModel};
use super::ring::RingMotion;
use super::strips::Patch;
use super::workspace::{BallContacts, PLACES, SpaceWorkspace};
use crate::contact::{NormalForce, positive};
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::dynamics::model::Model;
use crate::numerics::lanes::{LANES, Lanes};
use crate::simd::Workspace;

/// Loads and speed at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drive {
    /// ωi, rad/s.
    pub inner_speed: f64,
    /// Fr, N.
    pub radial_load: f64,
}

/// Place, velocity and rotation of ball `k` in a vector.
#[inline(always)]
pub(super) fn ball_motion(layout: Layout, y: &[f64], k: usize) -> [Vector; 3] {
    let at = |coordinate| y[layout.ball(coordinate, k)];
    [
        Vector::new(
            at(BallCoordinate::X),
            at(BallCoordinate::Y),
            at(BallCoordinate::Z),
        ),
        Vector::new(
            at(BallCoordinate::Vx),
            at(BallCoordinate::Vy),
            at(BallCoordinate::Vz),
        ),
        Vector::new(
            at(BallCoordinate::OmegaX),
            at(BallCoordinate::OmegaY),
            -at(BallCoordinate::Spin),
        ),
    ]
}

/// Coordinates of the velocities of a ball: **v**, **ω**.
pub(super) const VELOCITIES: [(BallCoordinate, f64); 6] = [
    (BallCoordinate::Vx, 1.0),
    (BallCoordinate::Vy, 1.0),
    (BallCoordinate::Vz, 1.0),
    (BallCoordinate::OmegaX, 1.0),
    (BallCoordinate::OmegaY, 1.0),
    (BallCoordinate::Spin, -1.0),
];

/// Second derivatives of p and q that a moment on the ring adds.
pub(super) fn tilting_by(free: &FreeTilt, ring: &RingMotion, moment: Vector) -> [f64; 2] {
    let turning = moment.cross(&ring.axis) / free.transverse;
    [turning.x, turning.y]
}

/// Force and moment on the inner ring, and powers of the ledger.
#[derive(Default)]
struct Totals {
    ring_force: Vector,
    ring_moment: Vector,
    weight: f64,
    inner_friction: f64,
    outer_friction: f64,
    ball_friction: f64,
    damping: f64,
}

/// Writes the rates of a state into `dydt` and its contacts into the work arrays; friction at the
/// raceways only if asked for.
pub(crate) fn evaluate(
    (model, space, drive): (&Model, &SpaceModel, Drive),
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    y: &[f64],
    dydt: &mut [f64],
    raceway_friction: bool,
) {
    let layout = model.layout;
    let ring = RingMotion::new(layout, y, drive.inner_speed);
    s.ring = ring;
    dydt.fill(0.0);
    let mut totals = Totals::default();
    let mut slip_max: f64 = 0.0;
    for k in 0..layout.balls {
        normal_contacts(model, space, (w, s), y, k, &mut totals, dydt);
        let slip = match raceway_friction {
            true => explicit_friction(model, space, (w, s), k, &mut totals, dydt),
            false => middle_slips(model, (w, s), k),
        };
        slip_max = slip_max.max(slip);
    }
    w.slip_max = Lanes::ZERO;
    w.slip_max.0[0] = slip_max;
    if raceway_friction {
        s.known = false;
    }
    w.pair_deflection_max[0] = if layout.balls > 1 {
        ball_pairs(model, w, y, &mut totals, dydt)
    } else {
        0.0
    };
    ring_rates(model, space, drive, &ring, &totals, dydt);
}

/// Adds accelerations of a ball under a force and a moment.
#[inline(always)]
pub(super) fn accelerate(model: &Model, k: usize, [force, moment]: [Vector; 2], dydt: &mut [f64]) {
    let linear = force * model.balls[k].inverse_mass;
    let angular = moment * model.balls[k].inverse_inertia;
    let rates = [
        linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
    ];
    for ((coordinate, sign), rate) in VELOCITIES.into_iter().zip(rates) {
        dydt[model.layout.ball(coordinate, k)] += sign * rate;
    }
}

/// Forces normal to the raceways, weight, and the frames in which friction acts.
#[inline]
fn normal_contacts(
    model: &Model,
    space: &SpaceModel,
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    y: &[f64],
    k: usize,
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let (layout, ball, grooves) = (model.layout, &model.balls[k], &space.balls[k]);
    let [place, velocity, rotation] = ball_motion(layout, y, k);
    for (coordinate, rate) in [
        (BallCoordinate::X, velocity.x),
        (BallCoordinate::Y, velocity.y),
        (BallCoordinate::Z, velocity.z),
    ] {
        dydt[layout.ball(coordinate, k)] = rate;
    }
    let work = &mut s.balls[k];
    let radius = ball.radius;
    work.velocity = [
        velocity.x,
        velocity.y,
        velocity.z,
        rotation.x * radius,
        rotation.y * radius,
        rotation.z * radius,
    ];
    let distance = (place.x * place.x + place.y * place.y).sqrt();
    let (ex, ey) = (place.x / distance, place.y / distance);
    let (e, t) = (Vector::new(ex, ey, 0.0), Vector::new(-ey, ex, 0.0));
    let tangential = velocity.y * ex - velocity.x * ey;
    let radial = velocity.x * ex + velocity.y * ey;
    let orbit = tangential / distance;

    let flanks = space.flanks.iter().find_map(|f| f.at([ex, ey]));
    let beyond = distance - ball.outer_orbit_radius;
    let touch = grooves.outer.touch(beyond, place.z, flanks);
    let mut rate = touch.slope * orbit;
    for point in &touch.points {
        rate += point.share * (point.normal[0] * radial + point.normal[1] * velocity.z);
    }
    let outer = NormalForce::at_raceway(
        ball.outer_stiffness_n_m1_5,
        ball.raceway_damping,
        positive(touch.approach),
        rate,
    );
    let mut outer_normal = t * (outer.force_n * touch.slope / distance);
    let mut share_sum = 0.0;
    for (point, contact) in touch.points.iter().zip(&mut work.contacts) {
        let [n_radial, n_axial] = point.normal;
        let force_n = point.share * outer.force_n;
        let normal = e * n_radial + Vector::z() * n_axial;
        outer_normal += normal * force_n;
        share_sum += point.share;
        *contact = Contact {
            normal,
            across: Vector::z() * n_radial - e * n_axial,
            along: -t,
            arm: Vector::zeros(),
            inner: false,
            force_n,
            friction_normal_n: force_n * model.outer.friction_factor,
            half_length_m: grooves.half_length_m_n1_3[0] * force_n.cbrt(),
        };
    }
    work.inside[1] = touch.inside;
    let in_section = |point: &super::outer_groove::Point| {
        [point.share * point.normal[0], point.share * point.normal[1]]
    };
    let [a, b] = [in_section(&touch.points[0]), in_section(&touch.points[1])];
    let (along, across) = (a[0] + b[0], a[1] + b[1]);
    let resultant = (along * along + across * across).sqrt();

    let inner_touch = grooves.inner.touch(place, &s.ring);
    let relative = velocity - s.ring.velocity - s.ring.tilting.cross(&inner_touch.ball);
    let inner_rate = inner_touch.normal.dot(&relative);
    let inner = NormalForce::at_raceway(
        ball.inner_stiffness_n_m1_5,
        ball.raceway_damping,
        positive(inner_touch.approach),
        inner_rate,
    );
    let inner_normal = inner_touch.normal * inner.force_n;
    work.contacts[2] = Contact {
        normal: inner_touch.normal,
        across: inner_touch.across,
        along: inner_touch.normal.cross(&inner_touch.across),
        arm: inner_touch.arm,
        inner: true,
        force_n: inner.force_n,
        friction_normal_n: inner.force_n,
        half_length_m: grooves.half_length_m_n1_3[1] * inner.force_n.cbrt(),
    };

    let weight = Vector::y() * (-ball.mass * model.ring.gravity);
    accelerate(
        model,
        k,
        [weight - outer_normal - inner_normal, Vector::zeros()],
        dydt,
    );
    totals.weight += weight.y * velocity.y;
    totals.ring_force += inner_normal;
    totals.ring_moment += inner_touch.ball.cross(&inner_normal);
    totals.damping += outer.damping_power_w + inner.damping_power_w;

    s.results[k] = BallContacts {
        inner_force_n: [inner_touch.cosine, inner_touch.sine].map(|part| part * inner.force_n),
        outer_force_n: [along, across].map(|part| part * outer.force_n),
        flank_force_n: [work.contacts[0].force_n, work.contacts[1].force_n],
        outer_ring_force_n: [outer_normal.x, outer_normal.y],
    };
    let (block, lane) = (k / LANES, k % LANES);
    let results = &mut w.blocks[block];
    for (lanes, value) in [
        (&mut results.polar.ex, ex),
        (&mut results.polar.ey, ey),
        (&mut results.polar.distance, distance),
        (&mut results.polar.tangential, tangential),
        (&mut results.polar.radial, radial),
        (&mut results.polar.orbit, orbit),
        (&mut results.spin, -rotation.z),
        (
            &mut results.geometry.effective_radius,
            if share_sum > 0.0 {
                radius * resultant / share_sum
            } else {
                radius
            },
        ),
        (&mut results.outer.deflection, touch.approach),
        (&mut results.outer.force, outer.force_n * resultant),
        (&mut results.inner.deflection, inner_touch.approach),
        (&mut results.inner.force, inner.force_n),
        (&mut results.outer_friction, 0.0),
        (&mut results.inner_friction, 0.0),
    ] {
        lanes.0[lane] = value;
    }
}

/// Sliding speed along the groove of the more loaded contact of a ball with the outer ring and of
/// that with the inner ring, as in the plane; stored, and the larger speed under load.
#[inline(always)]
pub(super) fn store_slips(
    w: &mut Workspace,
    s: &SpaceWorkspace,
    k: usize,
    slips: [[f64; 2]; PLACES],
) -> f64 {
    let results = &mut w.blocks[k / LANES];
    let contacts = &s.balls[k].contacts;
    let outer = usize::from(contacts[1].force_n > contacts[0].force_n);
    // τ points against the motion; at the inner ring the plane counts what drives the ball.
    results.outer.slip.0[k % LANES] = -slips[outer][0];
    results.inner.slip.0[k % LANES] = slips[2][0];
    contacts
        .iter()
        .zip(slips)
        .filter(|(contact, _)| contact.force_n > 0.0)
        .fold(0.0, |most: f64, (_, [a, b])| {
            most.max((a * a + b * b).sqrt())
        })
}

/// Sliding of the middles of the contacts at the velocities of the evaluation.
fn middle_slips(model: &Model, (w, s): (&mut Workspace, &mut SpaceWorkspace), k: usize) -> f64 {
    let work = &s.balls[k];
    let radius = model.balls[k].radius;
    let [velocity, rotation] = velocities(&work.velocity, radius);
    let slips = work.contacts.map(|contact| {
        let sliding = contact.sliding(velocity, rotation, radius, &s.ring);
        [sliding.along, sliding.across]
    });
    store_slips(w, s, k, slips)
}

/// **v** and **ω** of a ball by **v** and R**ω**.
#[inline(always)]
pub(super) fn velocities(values: &[f64; 6], radius_m: f64) -> [Vector; 2] {
    [
        Vector::new(values[0], values[1], values[2]),
        Vector::new(values[3], values[4], values[5]) / radius_m,
    ]
}

/// Friction at the raceways by the velocities of the evaluation.
fn explicit_friction(
    model: &Model,
    space: &SpaceModel,
    (w, s): (&mut Workspace, &mut SpaceWorkspace),
    k: usize,
    totals: &mut Totals,
    dydt: &mut [f64],
) -> f64 {
    let radius = model.balls[k].radius;
    let [velocity, rotation] = velocities(&s.balls[k].velocity, radius);
    let mut slips = [[0.0; 2]; PLACES];
    for place in 0..PLACES {
        let contact = s.balls[k].contacts[place];
        let sliding = contact.sliding(velocity, rotation, radius, &s.ring);
        slips[place] = [sliding.along, sliding.across];
        if contact.friction_normal_n <= 0.0 {
            continue;
        }
        let patch = Patch {
            friction: &model.friction,
            normal_n: contact.friction_normal_n,
            half_length_m: contact.half_length_m,
            curvature: space.balls[k].curvature[usize::from(contact.inner)],
        };
        let mut traction = Traction::default();
        let mut heat = 0.0;
        for strip in &space.strips {
            let x = patch.place(strip);
            let (slip, shear) = (
                sliding.at(x, patch.curvature),
                sliding.shear(x, patch.curvature),
            );
            let inverse_knee = patch.inverse_knee(strip, shear);
            let friction = patch.force(strip, slip, inverse_knee);
            let moment = patch.moment(strip, shear, &friction, inverse_knee);
            traction.add(friction.force, moment, x, patch.curvature);
            heat -= friction.force[0] * slip[0] + friction.force[1] * slip[1] + moment * shear;
        }
        let on_ball = contact.on_ball(&traction, radius);
        accelerate(model, k, on_ball, dydt);
        if contact.inner {
            totals.ring_force -= on_ball[0];
            totals.ring_moment += contact.on_ring(&traction);
            totals.inner_friction += heat;
        } else {
            s.results[k].outer_ring_force_n[0] -= on_ball[0].x;
            s.results[k].outer_ring_force_n[1] -= on_ball[0].y;
            totals.outer_friction += heat;
        }
        store_friction(w, k, contact.inner, traction.force[0]);
    }
    store_slips(w, s, k, slips)
}

/// Adds to the friction along the groove of a ball, with the signs of the plane.
#[inline(always)]
pub(super) fn store_friction(w: &mut Workspace, k: usize, inner: bool, along: f64) {
    let results = &mut w.blocks[k / LANES];
    match inner {
        true => results.inner_friction.0[k % LANES] -= along,
        false => results.outer_friction.0[k % LANES] += along,
    }
}

/// Forces between neighbouring balls; the largest deflection.
fn ball_pairs(
    model: &Model,
    w: &mut Workspace,
    y: &[f64],
    totals: &mut Totals,
    dydt: &mut [f64],
) -> f64 {
    let layout = model.layout;
    let mut deepest: f64 = 0.0;
    for k in 0..layout.balls {
        let next = (k + 1) % layout.balls;
        let ball = &model.balls[k];
        let place = |k: usize| {
            let at = |coordinate| y[layout.ball(coordinate, k)];
            Vector::new(
                at(BallCoordinate::X),
                at(BallCoordinate::Y),
                at(BallCoordinate::Z),
            )
        };
        let between = place(next) - place(k);
        let distance = between.norm();
        let deflection = ball.pair_distance - distance;
        let pair = &mut w.blocks[k / LANES].pair;
        let lane = k % LANES;
        pair.deflection.0[lane] = deflection;
        for lanes in [&mut pair.rate, &mut pair.force, &mut pair.slip] {
            lanes.0[lane] = 0.0;
        }
        if deflection <= 0.0 {
            continue;
        }
        deepest = deepest.max(deflection);
        let [_, velocity, rotation] = ball_motion(layout, y, k);
        let [_, next_velocity, next_rotation] = ball_motion(layout, y, next);
        let u = between / distance;
        let relative = velocity - next_velocity;
        let rate = relative.dot(&u);
        let normal =
            NormalForce::between_balls(ball.pair_stiffness, ball.pair_damping, deflection, rate);
        let surface = rotation * ball.radius + next_rotation * ball.next_radius;
        let slip = relative - u * rate + surface.cross(&u);
        let speed = slip.norm();
        let size = model
            .friction
            .force(speed, ball.pair_friction_factor * normal.force_n)[0];
        let friction = match speed > 0.0 {
            true => slip * (-size / speed),
            false => Vector::zeros(),
        };
        let force = friction - u * normal.force_n;
        let moment = u.cross(&friction);
        accelerate(model, k, [force, moment * ball.radius], dydt);
        accelerate(model, next, [-force, moment * ball.next_radius], dydt);
        totals.ball_friction += size * speed;
        totals.damping += normal.damping_power_w;
        (pair.rate.0[lane], pair.force.0[lane], pair.slip.0[lane]) = (rate, normal.force_n, speed);
    }
    deepest
}

/// Rates of the inner ring and of the ledger.
fn ring_rates(
    model: &Model,
    space: &SpaceModel,
    drive: Drive,
    ring: &RingMotion,
    totals: &Totals,
    dydt: &mut [f64],
) {
    let layout = model.layout;
    let (mass, drag) = (model.ring.mass, model.ring.drag);
    let load = Vector::new(0.0, -drive.radial_load, space.axial_load);
    let weight = Vector::y() * (-mass * model.ring.gravity);
    let force = totals.ring_force + load + weight - ring.velocity * drag;
    let acceleration = force / mass;
    let mut load_power = load.dot(&ring.velocity);
    let mut moment = totals.ring_moment;
    let mut tilt = [0.0; 2];
    if let Some(free) = &space.free_tilt {
        let given = Vector::new(free.moment[0], free.moment[1], 0.0);
        moment += given;
        load_power += given.dot(&ring.rotation);
        let gyroscopic = ring.axis_rate * (free.polar * drive.inner_speed);
        let [p, q] = tilting_by(free, ring, moment - gyroscopic);
        let square = ring.axis_rate.norm_squared();
        tilt = [p - square * ring.axis.x, q - square * ring.axis.y];
    }
    for (coordinate, rate) in [
        (RingCoordinate::X, ring.velocity.x),
        (RingCoordinate::Y, ring.velocity.y),
        (RingCoordinate::Z, ring.velocity.z),
        (RingCoordinate::TiltP, ring.axis_rate.x),
        (RingCoordinate::TiltQ, ring.axis_rate.y),
        (RingCoordinate::Vx, acceleration.x),
        (RingCoordinate::Vy, acceleration.y),
        (RingCoordinate::Vz, acceleration.z),
        (RingCoordinate::TiltPRate, tilt[0]),
        (RingCoordinate::TiltQRate, tilt[1]),
    ] {
        dydt[layout.ring(coordinate)] = rate;
    }
    for (term, power) in [
        (
            EnergyTerm::Drive,
            -drive.inner_speed * moment.dot(&ring.axis),
        ),
        (EnergyTerm::Load, load_power),
        (
            EnergyTerm::Weight,
            totals.weight + weight.dot(&ring.velocity),
        ),
        (EnergyTerm::InnerFriction, totals.inner_friction),
        (EnergyTerm::OuterFriction, totals.outer_friction),
        (EnergyTerm::BallFriction, totals.ball_friction),
        (EnergyTerm::Damping, totals.damping),
        (EnergyTerm::Drag, drag * ring.velocity.norm_squared()),
    ] {
        dydt[layout.energy_term(term)] = power;
    }
}
