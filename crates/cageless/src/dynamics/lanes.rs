//! Arrays over the balls in which the right-hand side works.

use crate::state::{BALLS_MAX, LANES};

/// One quantity of every ball.
pub(super) type Lane = [f64; BALLS_MAX];

/// Work arrays of one evaluation. Fields of one fixed-size struct, so that the
/// compiler knows that they do not overlap and turns each loop into vector code.
/// After an evaluation they hold everything that can be seen of the bearing.
#[derive(Clone)]
#[repr(C, align(64))]
pub(super) struct Lanes {
    /// 1 for a ball, 0 for padding.
    pub active: Lane,
    pub x: Lane,
    pub y: Lane,
    pub vx: Lane,
    pub vy: Lane,
    pub spin: Lane,
    /// Absolute spin.
    pub absolute: Lane,
    /// Unit vector from the centre of the bearing to the ball.
    pub ex: Lane,
    pub ey: Lane,
    pub rho: Lane,
    /// Tangential and radial velocity about the centre of the bearing.
    pub vt: Lane,
    pub vr: Lane,
    /// r, and direction of friction at the outer raceway.
    pub radius: Lane,
    pub dir_x: Lane,
    pub dir_y: Lane,
    /// sin²ψ, mapped; values of the polynomials.
    pub u: Lane,
    pub p: Lane,
    pub q: Lane,
    pub inside: Lane,
    pub sine: Lane,
    pub outer_deflection: Lane,
    pub outer_force: Lane,
    pub outer_slip: Lane,
    pub outer_friction: Lane,
    pub inner_deflection: Lane,
    pub inner_force: Lane,
    pub inner_slip: Lane,
    /// Sums over contacts.
    pub fx: Lane,
    pub fy: Lane,
    pub torque: Lane,
    pub ring_fx: Lane,
    pub ring_fy: Lane,
    /// The ball ahead.
    pub next_x: Lane,
    pub next_y: Lane,
    pub next_vx: Lane,
    pub next_vy: Lane,
    pub next_absolute: Lane,
    pub next_orbit: Lane,
    /// Deflection, its rate and force of the contact with the ball ahead.
    pub pair_deflection: Lane,
    pub pair_rate: Lane,
    pub pair_force: Lane,
    pub pair_fx: Lane,
    pub pair_fy: Lane,
    pub pair_torque: Lane,
    /// Powers of the ledger.
    pub drive: Lane,
    pub weight: Lane,
    pub inner_loss: Lane,
    pub outer_loss: Lane,
    pub ball_loss: Lane,
    pub damping_loss: Lane,
    pub pair_damping: Lane,
    pub centrifugal: Lane,
    pub direction: Lane,
    pub frame: Lane,
    pub pair_frame: Lane,
}

impl Lanes {
    pub fn new(balls: usize) -> Box<Self> {
        const ZERO: Lane = [0.0; BALLS_MAX];
        let mut lanes = Box::new(Self {
            active: ZERO,
            x: ZERO,
            y: ZERO,
            vx: ZERO,
            vy: ZERO,
            spin: ZERO,
            absolute: ZERO,
            ex: ZERO,
            ey: ZERO,
            rho: ZERO,
            vt: ZERO,
            vr: ZERO,
            radius: ZERO,
            dir_x: ZERO,
            dir_y: ZERO,
            u: ZERO,
            p: ZERO,
            q: ZERO,
            inside: ZERO,
            sine: ZERO,
            outer_deflection: ZERO,
            outer_force: ZERO,
            outer_slip: ZERO,
            outer_friction: ZERO,
            inner_deflection: ZERO,
            inner_force: ZERO,
            inner_slip: ZERO,
            fx: ZERO,
            fy: ZERO,
            torque: ZERO,
            ring_fx: ZERO,
            ring_fy: ZERO,
            next_x: ZERO,
            next_y: ZERO,
            next_vx: ZERO,
            next_vy: ZERO,
            next_absolute: ZERO,
            next_orbit: ZERO,
            pair_deflection: ZERO,
            pair_rate: ZERO,
            pair_force: ZERO,
            pair_fx: ZERO,
            pair_fy: ZERO,
            pair_torque: ZERO,
            drive: ZERO,
            weight: ZERO,
            inner_loss: ZERO,
            outer_loss: ZERO,
            ball_loss: ZERO,
            damping_loss: ZERO,
            pair_damping: ZERO,
            centrifugal: ZERO,
            direction: ZERO,
            frame: ZERO,
            pair_frame: ZERO,
        });
        lanes.active[..balls].fill(1.0);
        lanes
    }
}

/// Sum of the first `n` entries, `n` a multiple of [`LANES`], in an order that does
/// not depend on the instruction set.
#[inline(always)]
pub(super) fn sum(lane: &Lane, n: usize) -> f64 {
    let mut partial = [0.0; LANES];
    for chunk in lane[..n].chunks_exact(LANES) {
        for (p, c) in partial.iter_mut().zip(chunk) {
            *p += c;
        }
    }
    ((partial[0] + partial[4]) + (partial[2] + partial[6]))
        + ((partial[1] + partial[5]) + (partial[3] + partial[7]))
}
