//! Contact of a ball with the inner raceway.

use super::{Friction, NormalForce, friction_force, positive};
use crate::case::{FrictionLaw, Profile};
use crate::dynamics::ball::{Ball, BallMotion, PolarMotion};
use crate::simd::lanes::lane_struct;

lane_struct! {
    /// Radius and surface speed of the inner raceway.
    pub struct InnerRaceway per lane InnerRacewayLanes {
        /// Ri, m.
        radius,
        /// ωi·Ri, m/s.
        surface_speed,
    }
}

lane_struct! {
    /// Inner contact of one ball.
    pub struct InnerContact per lane InnerContactLanes {
        /// δi, m; negative: apart.
        deflection,
        /// Fi, N.
        force,
        /// ΔVi, m/s.
        slip,
        /// Friction along −ΔVi, N; positive drives the ball.
        friction,
        /// Friction and normal force on the ball, N; the ring takes the opposite.
        fx,
        /// Friction and normal force on the ball, N.
        fy,
        /// Moment about the ball's centre in the sense of its spin, N·m.
        torque,
        /// Power dissipated by damping, W.
        damping_power,
        /// `paper` profile: power of the relative spin in place of the absolute one, W.
        spin_power,
    }
}

/// δi = Ri + Rw − |rb − ri|, m (Zhao 2022, Eq. (16)); negative: apart.
#[inline(always)]
pub fn inner_deflection(distance_m: f64, ball: &Ball) -> f64 {
    ball.inner_contact_distance - distance_m
}

/// Normal force and friction of a ball at the inner raceway (Zhao 2022, Eq. (2));
/// `polar` is the motion of the ball about the centre of the ring and relative to it.
///
/// ΔVi is ωi·Ri − (Ωi·Ri + ω·Rw) with the relative spin ω in `paper`, Eq. (2), and the
/// difference ωi·Ri − (vt + ω·Rw) of the surface velocities in `physical`.
#[inline(always)]
pub fn inner_contact(
    profile: Profile,
    law: FrictionLaw,
    friction: &Friction,
    ball: &Ball,
    raceway: &InnerRaceway,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> InnerContact {
    let deflection = inner_deflection(polar.distance, ball);
    let normal = NormalForce::at_raceway(
        ball.inner_stiffness,
        ball.raceway_damping,
        positive(deflection),
        -polar.radial,
    );
    let carried = match profile {
        Profile::Paper => polar.orbit * raceway.radius,
        Profile::Physical => polar.tangential,
    };
    let slip = raceway.surface_speed - (carried + motion.spin * ball.radius);
    let friction = friction_force(law, friction, slip, normal.force_n);
    InnerContact {
        deflection,
        force: normal.force_n,
        slip,
        friction,
        fx: normal.force_n * polar.ex - friction * polar.ey,
        fy: normal.force_n * polar.ey + friction * polar.ex,
        torque: ball.radius * friction,
        damping_power: normal.damping_power_w,
        spin_power: friction * (polar.tangential - carried),
    }
}
