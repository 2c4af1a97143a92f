//! Contacts between neighbouring balls: the exchange of values along the row of balls.

use super::harness::{friction, larger};
use super::lanes::{Lanes, flat, flat_mut};
use super::motions::Motions;
use super::parameters::Parameters;
use super::sums::Sum;
use super::workspace::Workspace;
use crate::contact::{ball_ball_contact, ball_deflection};
use crate::dynamics::ball::BallMotion;
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::layout::LANES;

/// Deflection of each ball with the ball ahead; returns the largest of each lane.
#[inline(always)]
pub(super) fn pair_deflections(p: &Parameters, w: &mut Workspace, y: &[f64]) -> Lanes {
    for (k, coordinate) in [BallCoordinate::X, BallCoordinate::Y]
        .into_iter()
        .enumerate()
    {
        let values = &y[p.layout.array(coordinate)..][..p.layout.stride];
        forwards(p, values, &mut w.next[k]);
    }
    let mut largest = Lanes::ZERO;
    let [next_x, next_y, ..] = &w.next;
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let balls = p.balls(block);
        let motions = Motions::new(p, y, block);
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

/// Values of the ball ahead at the place of each ball.
#[inline(always)]
fn forwards(p: &Parameters, values: &[f64], next: &mut [Lanes]) {
    let (shift, count) = (p.layout.width(), p.layout.entries());
    let next = flat_mut(next);
    next[..count - shift].copy_from_slice(&values[shift..count]);
    next[count - shift..count].copy_from_slice(&values[..shift]);
}

/// Values of the ball behind at the place of each ball.
#[inline(always)]
fn backwards(p: &Parameters, values: &[Lanes], behind: &mut [Lanes]) {
    let (shift, count) = (p.layout.width(), p.layout.entries());
    let (values, behind) = (flat(values), flat_mut(behind));
    behind[shift..count].copy_from_slice(&values[..count - shift]);
    behind[..shift].copy_from_slice(&values[count - shift..count]);
}

/// Contacts between neighbours; adds to the loads of both.
#[inline(always)]
pub(super) fn pair_contacts<const PAPER: bool>(p: &Parameters, w: &mut Workspace, y: &[f64]) {
    for (k, coordinate) in [(2, BallCoordinate::Vx), (3, BallCoordinate::Vy)] {
        let values = &y[p.layout.array(coordinate)..][..p.layout.stride];
        forwards(p, values, &mut w.next[k]);
    }
    for (block, results) in w.blocks.iter().enumerate() {
        w.ahead[0][block] = results.spin;
        w.ahead[1][block] = results.polar.orbit;
    }
    for (k, from) in [(4, 0), (5, 1)] {
        forwards(p, flat(&w.ahead[from]), &mut w.next[k]);
    }
    let alone = p.layout.width() == 1;
    let [ahead_x, ahead_y, ahead_torque] = &mut w.ahead;
    let [behind_x, behind_y, behind_torque] = &mut w.behind;
    let mut addends = [Lanes::ZERO; Sum::COUNT];
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let (balls, motions) = (p.balls(block), Motions::new(p, y, block));
        let next = |k: usize| &w.next[k][block].0;
        let (next_x, next_y, next_vx, next_vy) = (next(0), next(1), next(2), next(3));
        let (next_spin, next_orbit) = (next(4), next(5));
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
            &results.pair.force,
            &mut pair_friction,
        );
        let (fx, fy) = (&mut ahead_x[block].0, &mut ahead_y[block].0);
        let (torque, next_torque) = (&mut ahead_torque[block].0, &mut behind_torque[block].0);
        for lane in 0..LANES {
            let (ball, contact) = (balls.get(lane), results.pair.get(lane));
            let friction = pair_friction.0[lane];
            let load = contact.load(&ball, friction);
            (fx[lane], fy[lane], torque[lane]) = (load.fx, load.fy, load.torque);
            next_torque[lane] = ball.next_radius * friction;
            addends[Sum::BallFriction as usize].0[lane] = friction * contact.slip;
            addends[Sum::BallDamping as usize].0[lane] = contact.damping_power;
            if PAPER {
                let turning =
                    ball.radius * results.polar.orbit.0[lane] + ball.next_radius * next_orbit[lane];
                addends[Sum::BallRelativeSpin as usize].0[lane] = friction * turning;
            }
        }
        w.sums.add(&Sum::BALL_CONTACTS, &addends, alone, block);
        if PAPER {
            w.sums.add(&[Sum::BallRelativeSpin], &addends, alone, block);
        }
    }
    // Each contact acts on the ball ahead, too; the moments there wait in `behind`.
    let [.., scratch, _] = &mut w.next;
    scratch.copy_from_slice(behind_torque);
    backwards(p, scratch, behind_torque);
    backwards(p, ahead_x, behind_x);
    backwards(p, ahead_y, behind_y);
    for (block, results) in w.blocks.iter_mut().enumerate() {
        let load = &mut results.load;
        for lane in 0..LANES {
            load.fx.0[lane] = load.fx.0[lane] - behind_x[block].0[lane] + ahead_x[block].0[lane];
            load.fy.0[lane] = load.fy.0[lane] - behind_y[block].0[lane] + ahead_y[block].0[lane];
            load.torque.0[lane] =
                load.torque.0[lane] + behind_torque[block].0[lane] + ahead_torque[block].0[lane];
        }
    }
}
