//! Contacts between neighbouring balls: the exchange of values along the row of balls.

use super::friction::friction;
use super::motions::{Motions, block_at};
use super::parameters::Parameters;
use super::sums::Sum;
use super::workspace::Workspace;
use crate::ball::BallMotion;
use crate::contact::{ball_ball_contact, ball_deflection};
use crate::dynamics::coordinates::BallCoordinate;
use crate::numerics::lanes::{LANES, Lanes, flat, flat_mut, lane_maxima, larger};

/// A squared distance over that at which balls touch, less 1, at which they are apart whatever the
/// rounding.
const APART: f64 = 1e-12;

/// Contacts between neighbours, if any of them touch; adds to the loads of both.
#[inline(always)]
pub(super) fn ball_contacts(p: &Parameters, w: &mut Workspace, y: &[f64]) {
    if !(w.pairs_loaded || pairs_near(p, y)) {
        return;
    }
    w.pair_deflection_max = lane_maxima(&pair_deflections(p, w, y), p.layout.width() == 1);
    let touch = w.pair_deflection_max.iter().any(|d| *d > 0.0);
    if touch {
        pair_contacts(p, w, y);
    } else if w.pairs_loaded {
        // Forces of the last contact must not outlive it.
        for results in &mut w.blocks {
            results.pair.force = Lanes::ZERO;
            results.pair.rate = Lanes::ZERO;
        }
    }
    w.pairs_loaded = touch;
}

/// Whether any two neighbours may touch: without roots, for in most evaluations none do.
#[inline(always)]
fn pairs_near(p: &Parameters, y: &[f64]) -> bool {
    let (width, count) = (p.layout.width(), p.layout.entries());
    let x = &y[p.layout.array(BallCoordinate::X)..];
    let y = &y[p.layout.array(BallCoordinate::Y)..];
    let near =
        |distance: f64, dx: f64, dy: f64| dx * dx + dy * dy < distance * distance * (1.0 + APART);
    let mut any = false;
    for block in 0..p.layout.stride / LANES {
        let distance = &p.balls(block).pair_distance.0;
        let (own_x, own_y) = (block_at(x, block * LANES), block_at(y, block * LANES));
        let next = block * LANES + width;
        let (next_x, next_y) = (block_at(x, next), block_at(y, next));
        for lane in 0..LANES {
            let (dx, dy) = (next_x[lane] - own_x[lane], next_y[lane] - own_y[lane]);
            any |= near(distance[lane], dx, dy);
        }
    }
    // The last ball is behind the first; above it has padding ahead of it, or anything.
    let last = count - width;
    for bearing in 0..width {
        let distance = p.balls((last + bearing) / LANES).pair_distance.0[(last + bearing) % LANES];
        let (dx, dy) = (
            x[bearing] - x[last + bearing],
            y[bearing] - y[last + bearing],
        );
        any |= near(distance, dx, dy);
    }
    any
}

/// Deflection of each ball with the ball ahead; returns the largest of each lane.
#[inline(always)]
fn pair_deflections(p: &Parameters, w: &mut Workspace, y: &[f64]) -> Lanes {
    let [next_x, next_y, ..] = &mut w.next;
    of_ball_ahead(p, &y[p.layout.array(BallCoordinate::X)..], next_x);
    of_ball_ahead(p, &y[p.layout.array(BallCoordinate::Y)..], next_y);
    let mut largest = Lanes::ZERO;
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let balls = p.balls(block);
        let motions = Motions::new(p.layout, y, block);
        let (next_x, next_y) = (&next_x[block].0, &next_y[block].0);
        for lane in 0..LANES {
            let ball = motions.get(lane);
            let (dx, dy) = (next_x[lane] - ball.x, next_y[lane] - ball.y);
            let deflection = ball_deflection(&balls.get(lane), dx, dy);
            results.pair.deflection.0[lane] = deflection;
            largest.0[lane] = larger(largest.0[lane], deflection);
        }
    }
    largest
}

/// Values of the ball ahead at the place of each ball. `values` starts with those of the balls
/// and goes on for a block or more.
#[inline(always)]
pub(super) fn of_ball_ahead(p: &Parameters, values: &[f64], next: &mut [Lanes]) {
    let (shift, count) = (p.layout.width(), p.layout.entries());
    for (block, next) in next.iter_mut().enumerate() {
        next.0 = *block_at(values, block * LANES + shift);
    }
    // The last ball is behind the first.
    flat_mut(next)[count - shift..count].copy_from_slice(&values[..shift]);
}

/// Puts the values of the last ball before those of the first, behind which `values` keeps a
/// block free.
#[inline(always)]
fn close_circle(p: &Parameters, values: &mut [Lanes]) {
    let (shift, count) = (p.layout.width(), p.layout.entries());
    let last = LANES + count - shift;
    flat_mut(values).copy_within(last..last + shift, LANES - shift);
}

/// Contacts between neighbours; adds to the loads of both.
#[inline(always)]
fn pair_contacts(p: &Parameters, w: &mut Workspace, y: &[f64]) {
    for (k, coordinate) in [(2, BallCoordinate::Vx), (3, BallCoordinate::Vy)] {
        of_ball_ahead(p, &y[p.layout.array(coordinate)..], &mut w.next[k]);
    }
    let [spins, ..] = &mut w.pairs;
    for (spin, results) in spins.iter_mut().zip(&w.blocks) {
        *spin = results.spin;
    }
    of_ball_ahead(p, flat(spins), &mut w.next[4]);
    let alone = p.layout.width() == 1;
    let [force_x, force_y, torque, next_torque] = &mut w.pairs;
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let (balls, motions) = (p.balls(block), Motions::new(p.layout, y, block));
        let next = |k: usize| &w.next[k][block].0;
        let (next_x, next_y, next_vx, next_vy) = (next(0), next(1), next(2), next(3));
        let next_spin = next(4);
        for lane in 0..LANES {
            let ball = BallMotion {
                spin: results.spin.0[lane],
                ..motions.get(lane)
            };
            let next = BallMotion {
                x: next_x[lane],
                y: next_y[lane],
                vx: next_vx[lane],
                vy: next_vy[lane],
                spin: next_spin[lane],
            };
            let contact = ball_ball_contact(&balls.get(lane), &ball, &next);
            results.pair.put(lane, contact);
        }
        let mut pair_friction = Lanes::ZERO;
        friction(
            p,
            &results.pair.slip,
            &results.pair.friction_normal,
            &mut pair_friction,
        );
        let at = block + 1;
        let (fx, fy) = (&mut force_x[at].0, &mut force_y[at].0);
        let (torque, next_torque) = (&mut torque[at].0, &mut next_torque[at].0);
        for lane in 0..LANES {
            let (ball, contact) = (balls.get(lane), results.pair.get(lane));
            let friction = pair_friction.0[lane];
            let load = contact.load(&ball, friction);
            (fx[lane], fy[lane], torque[lane]) = (load.fx, load.fy, load.torque);
            next_torque[lane] = ball.next_radius * friction;
            addends[Sum::BallFriction as usize].0[lane] = friction * contact.slip;
            addends[Sum::BallDamping as usize].0[lane] = contact.damping_power;
        }
        w.sums.add(&Sum::BALL_CONTACTS, &addends, alone, block);
    }
    // Each contact acts on the ball ahead, too.
    for values in [&mut *force_x, &mut *force_y, &mut *next_torque] {
        close_circle(p, values);
    }
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let behind = |values| block_at(flat(values), (block + 1) * LANES - p.layout.width());
        let (behind_x, behind_y, behind_torque) =
            (behind(force_x), behind(force_y), behind(next_torque));
        let at = block + 1;
        let load = &mut results.load;
        for lane in 0..LANES {
            load.fx.0[lane] = load.fx.0[lane] - behind_x[lane] + force_x[at].0[lane];
            load.fy.0[lane] = load.fy.0[lane] - behind_y[lane] + force_y[at].0[lane];
            load.torque.0[lane] = load.torque.0[lane] + behind_torque[lane] + torque[at].0[lane];
        }
    }
}
