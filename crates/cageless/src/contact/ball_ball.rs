//! Contact between neighbouring balls.

use super::{NormalForce, positive};
use crate::ball::{Ball, BallLoad, BallMotion};
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Contact of one ball with the ball ahead without its friction.
    pub(crate) struct BallBallContact per lane BallBallContactLanes {
        /// δb, m; negative: apart.
        deflection,
        /// dδb/dt, m/s.
        rate,
        /// Normal force, N.
        force,
        /// Normal force that friction acts under, N: times the friction factor.
        friction_normal,
        /// Sliding speed of the surfaces, m/s.
        slip,
        /// x of the unit vector u to the ball ahead.
        ux,
        /// y of the unit vector u to the ball ahead.
        uy,
        /// Power dissipated by damping, W.
        damping_power,
    }
}

/// δb = 2Rw − |rj − rk|, m (Zhao 2022, Eq. (17)); negative: apart.
#[inline(always)]
pub(crate) fn ball_deflection(ball: &Ball, dx_m: f64, dy_m: f64) -> f64 {
    ball.pair_distance - (dx_m * dx_m + dy_m * dy_m).sqrt()
}

/// Normal force and sliding speed between a ball and the ball ahead; spins are absolute.
///
/// With u the unit vector to the ball ahead and p = u turned by +90°, the surfaces slide at
/// (v − v′)·p − (ω·R + ω′·R′).
#[inline(always)]
pub(crate) fn ball_ball_contact(
    constants: &Ball,
    ball: &BallMotion,
    next: &BallMotion,
) -> BallBallContact {
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
    let surface = ball.spin * constants.radius + next.spin * constants.next_radius;
    BallBallContact {
        deflection,
        rate,
        force: normal.force_n,
        friction_normal: constants.pair_friction_factor * normal.force_n,
        slip: vy * ux - vx * uy - surface,
        ux,
        uy,
        damping_power: normal.damping_power_w,
    }
}

impl BallBallContact {
    /// Force and moment on the ball under the friction `friction_n`, which pushes the balls
    /// along p and brakes both spins; the ball ahead takes the opposite force.
    #[inline(always)]
    pub(crate) fn load(&self, constants: &Ball, friction_n: f64) -> BallLoad {
        BallLoad {
            fx: -self.force * self.ux + friction_n * self.uy,
            fy: -self.force * self.uy - friction_n * self.ux,
            torque: constants.radius * friction_n,
        }
    }
}
