//! Contact between neighbouring balls.

use super::{Friction, NormalForce, friction_force, positive};
use crate::case::FrictionLaw;
use crate::dynamics::ball::{Ball, BallMotion};
use crate::simd::lanes::lane_struct;

/// A ball and the ball ahead as their contact sees them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallPair {
    /// The ball.
    pub ball: BallMotion,
    /// The ball ahead.
    pub next: BallMotion,
    /// Orbital speed of the ball, rad/s (`paper` profile).
    pub orbit: f64,
    /// Orbital speed of the ball ahead, rad/s (`paper` profile).
    pub next_orbit: f64,
}

lane_struct! {
    /// Contact of one ball with the ball ahead.
    pub struct BallBallContact per lane BallBallContactLanes {
        /// δb, m; negative: apart.
        deflection,
        /// dδb/dt, m/s.
        rate,
        /// Normal force, N.
        force,
        /// Friction, N.
        friction,
        /// Force on the ball, N; the ball ahead takes the opposite.
        fx,
        /// Force on the ball, N.
        fy,
        /// Moment on the ball in the sense of its spin, N·m.
        torque,
        /// Moment on the ball ahead in the sense of its spin, N·m.
        next_torque,
        /// Power dissipated by friction, W.
        friction_power,
        /// Power dissipated by damping, W.
        damping_power,
        /// `paper` profile: power of the relative spin in place of the absolute one, W.
        spin_power,
    }
}

/// δb = 2Rw − |rj − rk|, m (Zhao 2022, Eq. (17)); negative: apart.
#[inline(always)]
pub fn ball_deflection(ball: &Ball, dx_m: f64, dy_m: f64) -> f64 {
    ball.pair_distance - (dx_m * dx_m + dy_m * dy_m).sqrt()
}

/// Normal force and friction between a ball and the ball ahead; spins are absolute.
///
/// With u the unit vector to the ball ahead and p = u turned by +90°, the surfaces slide at
/// (v − v′)·p − (ω·R + ω′·R′): friction pushes the balls along p and brakes both spins.
#[inline(always)]
pub fn ball_ball_contact(
    law: FrictionLaw,
    friction: &Friction,
    constants: &Ball,
    pair: &BallPair,
) -> BallBallContact {
    let (ball, next) = (&pair.ball, &pair.next);
    let (dx, dy) = (next.x - ball.x, next.y - ball.y);
    let inverse = 1.0 / (dx * dx + dy * dy).sqrt();
    let (ux, uy) = (dx * inverse, dy * inverse);
    let (vx, vy) = (ball.vx - next.vx, ball.vy - next.vy);
    let rate = vx * ux + vy * uy;
    let deflection = ball_deflection(constants, dx, dy);
    let normal = NormalForce::between_balls(
        constants.pair_stiffness,
        constants.pair_damping,
        positive(deflection),
        rate,
    );
    let force = normal.force_n;
    let (radius, next_radius) = (constants.radius, constants.next_radius);
    let surface = ball.spin * radius + next.spin * next_radius;
    let slip = vy * ux - vx * uy - surface;
    let friction = friction_force(law, friction, slip, force);
    let turning = radius * pair.orbit + next_radius * pair.next_orbit;
    BallBallContact {
        deflection,
        rate,
        force,
        friction,
        fx: -force * ux + friction * uy,
        fy: -force * uy - friction * ux,
        torque: radius * friction,
        next_torque: next_radius * friction,
        friction_power: friction * slip,
        damping_power: normal.damping_power_w,
        spin_power: friction * turning,
    }
}
