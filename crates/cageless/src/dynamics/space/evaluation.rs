//! The rates of all coordinates.

use super::Vector;
use super::bearing::{Bearing, Totals, tilting_by};
use super::block::VELOCITIES;
use super::film::{RollingBlock, add_rolling};
use super::friction::{add_explicit_friction, outer_ring_velocity};
use super::normal_contacts::{BlockWork, PLACE, normal_contacts};
use super::ring::RingMotion;
use super::sliding::{place_rings, sliding_rates};
use super::workspace::SpaceWorkspace;
use crate::contact::NormalForce;
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::numerics::lanes::{LANES, Lanes};
use crate::simd::{Parameters, Workspace};
use crate::world::under_rotor::BallLoads;

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

/// Writes the rates of a state into `dydt` and its contacts into the work arrays; friction at the
/// raceways only if asked for.
#[inline(always)]
pub(crate) fn evaluate(
    bearing: Bearing<'_>,
    w: &mut Workspace,
    s: &mut SpaceWorkspace,
    y: &[f64],
    dydt: &mut [f64],
    raceway_friction: bool,
) {
    let Bearing {
        parameters: p,
        space,
        drive,
        ..
    } = bearing;
    let layout = p.layout;
    let ring = RingMotion::new(layout, y, drive.inner_speed);
    s.ring = ring;
    s.outer_ring_velocity = outer_ring_velocity(layout, y);
    if !space.sliding.is_empty() {
        place_rings(bearing, s, y);
    }
    dydt[layout.start()..layout.end()].fill(0.0);
    let mut totals = Totals::default();
    for (number, (results, space)) in w.blocks.iter_mut().zip(&mut s.blocks).enumerate() {
        let work = BlockWork {
            number,
            results,
            space,
        };
        add_block(bearing, work, &ring, y, &mut totals, dydt);
    }
    w.slip_max = Lanes::ZERO;
    if raceway_friction {
        add_explicit_friction(bearing, w, s, &mut totals, dydt);
        s.known = false;
    }
    w.pair_deflection_max[0] = if layout.balls > 1 {
        ball_pairs(bearing, w, y, &mut totals, dydt)
    } else {
        0.0
    };
    let under = p.drops.first();
    let touch = under.map(|under| s.rotor.evaluate(under, layout, y, raceway_friction));
    let pushed = touch.map_or([0.0; 3], |touch| touch.loads.force);
    ring_rates(bearing, &ring, &totals, pushed.into(), dydt);
    if let Some((under, touch)) = under.zip(touch) {
        let balls = BallLoads {
            ring_torque: totals.torque_on(&ring),
            outer_ring: s.outer_ring_force_n(),
        };
        (w.rotors[0], w.rotor_loads[0]) = (touch.contact, touch.loads);
        under.set_rates(layout, &balls, &touch, y, dydt);
    }
    if !space.sliding.is_empty() {
        sliding_rates(bearing, s, y, dydt);
    }
}

/// Adds the normal forces of a block and its rolling on a film to the rates.
#[inline(always)]
fn add_block(
    bearing: Bearing<'_>,
    work: BlockWork<'_>,
    ring: &RingMotion,
    y: &[f64],
    totals: &mut Totals,
    dydt: &mut [f64],
) {
    let BlockWork {
        number,
        results,
        space: b,
    } = work;
    let now = BlockWork {
        number,
        results: &mut *results,
        space: &mut *b,
    };
    normal_contacts(bearing, now, ring, y, totals, dydt);
    let p = bearing.parameters;
    if let Some(film) = &bearing.space.film {
        let rolling = RollingBlock {
            film,
            balls: p.balls(number),
            polar: &results.polar,
            ring,
            inner_speed: bearing.drive.inner_speed,
        };
        add_rolling(&rolling, b, p.layout, number, totals, dydt);
    }
}

/// Force and moment on a ball.
struct Wrench {
    /// N.
    force: Vector,
    /// N·m.
    moment: Vector,
}

/// Adds accelerations of a ball under a load.
#[inline(always)]
fn accelerate(bearing: Bearing<'_>, k: usize, load: &Wrench, dydt: &mut [f64]) {
    let (ball, layout) = (&bearing.model.balls[k], bearing.parameters.layout);
    let linear = load.force * ball.inverse_mass;
    let angular = load.moment * ball.inverse_inertia;
    let rates = [
        linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
    ];
    for ((coordinate, sign), rate) in VELOCITIES.into_iter().zip(rates) {
        dydt[layout.ball(coordinate, k)] += sign * rate;
    }
}

/// Deflections between neighbouring balls; below 0 apart.
#[inline(always)]
fn near_pairs(p: &Parameters, layout: Layout, w: &mut Workspace, y: &[f64]) {
    for results in &mut w.blocks {
        results.pair.deflection = Lanes::ZERO;
    }
    // Squares of the distances first.
    for first in (0..layout.balls).step_by(layout.row) {
        let end = first + layout.row;
        for k in first..end {
            let next = if k + 1 == end { first } else { k + 1 };
            let mut square = 0.0;
            for coordinate in PLACE {
                let at = layout.array(coordinate);
                let between = y[at + next] - y[at + k];
                square += between * between;
            }
            w.blocks[k / LANES].pair.deflection.0[k % LANES] = square;
        }
    }
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let (pair, together) = (&mut results.pair, &p.balls(block).pair_distance);
        (pair.rate, pair.force, pair.slip) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
        for lane in 0..LANES {
            let distance = pair.deflection.0[lane].sqrt();
            pair.deflection.0[lane] = together.0[lane] - distance;
        }
    }
}

/// Forces between neighbouring balls; the largest deflection.
#[inline(always)]
fn ball_pairs(
    bearing: Bearing<'_>,
    w: &mut Workspace,
    y: &[f64],
    totals: &mut Totals,
    dydt: &mut [f64],
) -> f64 {
    let model = bearing.model;
    let layout = bearing.parameters.layout;
    let mut deepest: f64 = 0.0;
    near_pairs(bearing.parameters, layout, w, y);
    for k in 0..layout.balls {
        let (block, lane) = (k / LANES, k % LANES);
        let deflection = w.blocks[block].pair.deflection.0[lane];
        if deflection <= 0.0 {
            continue;
        }
        deepest = deepest.max(deflection);
        let (next, ball) = (layout.next(k), &model.balls[k]);
        let [place, velocity, rotation] = ball_motion(layout, y, k);
        let [next_place, next_velocity, next_rotation] = ball_motion(layout, y, next);
        let between = next_place - place;
        let u = between / between.norm();
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
        let on_ball = Wrench {
            force,
            moment: moment * ball.radius,
        };
        let on_next = Wrench {
            force: -force,
            moment: moment * ball.next_radius,
        };
        accelerate(bearing, k, &on_ball, dydt);
        accelerate(bearing, next, &on_next, dydt);
        totals.ball_friction += size * speed;
        totals.damping += normal.damping_power_w;
        let pair = &mut w.blocks[block].pair;
        (pair.rate.0[lane], pair.force.0[lane], pair.slip.0[lane]) = (rate, normal.force_n, speed);
    }
    deepest
}

/// Rates of the inner ring, which pushes a rotor with a force, and of the ledger.
fn ring_rates(
    bearing: Bearing<'_>,
    ring: &RingMotion,
    totals: &Totals,
    pushed: Vector,
    dydt: &mut [f64],
) {
    let Bearing {
        model,
        space,
        drive,
        ..
    } = bearing;
    let layout = bearing.parameters.layout;
    let (mass, drag) = (model.ring.mass, model.ring.drag);
    let [turning_x, turning_y] = drive.unbalance;
    let load = Vector::new(turning_x, turning_y - drive.radial_load, space.axial_load);
    let mut weight = Vector::zeros();
    weight[space.upward] = -mass * model.ring.gravity;
    let [contacts, mut moment] = totals.on_ring();
    let force = (contacts - pushed) + load + weight - ring.velocity * drag;
    let acceleration = force / mass;
    let mut load_power = load.dot(&ring.velocity);
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
        (EnergyTerm::InnerFriction, totals.heat[1]),
        (EnergyTerm::OuterFriction, totals.heat[0]),
        (EnergyTerm::BallFriction, totals.ball_friction),
        (EnergyTerm::Damping, totals.damping),
        (EnergyTerm::RollingResistance, totals.rolling),
        (EnergyTerm::Drag, drag * ring.velocity.norm_squared()),
    ] {
        dydt[layout.energy_term(term)] = power;
    }
}
