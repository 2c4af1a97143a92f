//! Contact of a ball with the inner raceway.

use super::{NormalForce, positive};
use crate::dynamics::ball::{Ball, BallLoad, BallMotion, PolarMotion};
use crate::numerics::lanes::lane_struct;
use crate::profile::Profile;

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
    /// Inner contact of one ball without its friction.
    pub struct InnerContact per lane InnerContactLanes {
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
pub fn inner_deflection(distance_m: f64, ball: &Ball) -> f64 {
    ball.inner_contact_distance - distance_m
}

/// Normal force and sliding speed of a ball at the inner raceway (Zhao 2022, Eq. (2));
/// `polar` is the motion of the ball about the centre of the ring and relative to it.
///
/// ΔVi is ωi·Ri − (Ωi·Ri + ω·Rw) with the relative spin ω in `paper`, Eq. (2), and the
/// difference ωi·Ri − (vt + ω·Rw) of the surface velocities in `physical`.
#[inline(always)]
pub fn inner_contact(
    profile: Profile,
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
        slip: inner_slip(profile, ball, raceway, motion, polar),
        damping_power: normal.damping_power_w,
    }
}

/// ΔVi, m/s, see [`inner_contact`] (Zhao 2022, Eq. (2)).
#[inline(always)]
pub fn inner_slip(
    profile: Profile,
    ball: &Ball,
    raceway: &InnerRaceway,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> f64 {
    let carried = carried_speed(profile, raceway, polar);
    raceway.surface_speed - (carried + motion.spin * ball.radius)
}

/// Part of the surface speed of a ball that its orbit makes, m/s.
#[inline(always)]
fn carried_speed(profile: Profile, raceway: &InnerRaceway, polar: &PolarMotion) -> f64 {
    match profile {
        Profile::Paper => polar.orbit * raceway.radius,
        Profile::Physical => polar.tangential,
    }
}

/// Force and moment of the inner contact on the ball under the friction `friction_n`, μFi
/// (Zhao 2022, Eq. (20)); the ring takes the opposite force.
#[inline(always)]
pub fn inner_load(
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

/// Power of inner friction in the `paper` profile that comes from the relative spin in place of
/// the absolute one, W.
#[inline(always)]
pub fn inner_paper_power(raceway: &InnerRaceway, polar: &PolarMotion, friction_n: f64) -> f64 {
    friction_n * (polar.tangential - carried_speed(Profile::Paper, raceway, polar))
}
