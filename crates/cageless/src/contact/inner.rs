//! Contact of a ball with the inner raceway.

use super::{NormalForce, positive};
use crate::ball::{Ball, BallLoad, BallMotion, PolarMotion};
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Radius and surface speed of the inner raceway.
    pub(crate) struct InnerRaceway per lane InnerRacewayLanes {
        /// Ri, m.
        radius,
        /// ωi·Ri, m/s.
        surface_speed,
        /// Mobility that a ring which follows its balls adds to that of each, 1/kg; 0 of a heavy ring.
        following,
    }
}

lane_struct! {
    /// Inner contact of one ball without its friction.
    pub(crate) struct InnerContact per lane InnerContactLanes {
        /// δi, m; negative: apart.
        deflection,
        /// Fi, N.
        force,
        /// ΔVi, m/s.
        slip,
        /// Power dissipated by damping, W.
        damping_power,
    }
}

/// δi = Ri + Rw − |rb − ri|, m (Zhao 2022, Eq. (16)); negative: apart.
#[inline(always)]
pub(crate) fn inner_deflection(distance_m: f64, ball: &Ball) -> f64 {
    ball.inner_contact_distance - distance_m
}

/// Normal force and sliding speed of a ball at the inner raceway (Zhao 2022, Eq. (2));
/// `polar` is the motion of the ball about the centre of the ring and relative to it.
///
/// ΔVi is the difference ωi·Ri − (vt + ω·Rw) of the surface velocities.
#[inline(always)]
pub(crate) fn inner_contact(
    ball: &Ball,
    raceway: &InnerRaceway,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> InnerContact {
    let deflection = inner_deflection(polar.distance, ball);
    let normal = NormalForce::at_raceway(
        ball.inner_stiffness_n_m1_5,
        ball.raceway_damping,
        positive(deflection),
        -polar.radial,
    );
    InnerContact {
        deflection,
        force: normal.force_n,
        slip: inner_slip(ball, raceway, motion, polar),
        damping_power: normal.damping_power_w,
    }
}

/// ΔVi = ωi·Ri − (vt + ω·Rw), m/s.
#[inline(always)]
pub(crate) fn inner_slip(
    ball: &Ball,
    raceway: &InnerRaceway,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> f64 {
    raceway.surface_speed - (polar.tangential + motion.spin * ball.radius)
}

/// Force and moment of the inner contact on the ball under the friction `friction_n`, μFi
/// (Zhao 2022, Eq. (20)); the ring takes the opposite force.
#[inline(always)]
pub(crate) fn inner_load(
    contact: &InnerContact,
    ball: &Ball,
    polar: &PolarMotion,
    friction_n: f64,
) -> BallLoad {
    BallLoad {
        fx: contact.force * polar.ex - friction_n * polar.ey,
        fy: contact.force * polar.ey + friction_n * polar.ex,
        torque: ball.radius * friction_n,
    }
}
