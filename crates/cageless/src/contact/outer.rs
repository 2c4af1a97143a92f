//! Contact of a ball with the outer raceway, plain or discrete.

use super::{Friction, NormalForce, friction_force, positive};
use crate::case::{FrictionLaw, Profile};
use crate::dynamics::ball::{Ball, BallMotion, PolarMotion};
use crate::simd::lanes::lane_struct;

lane_struct! {
    /// Constants of the outer raceway.
    pub struct OuterRaceway per lane OuterRacewayLanes {
        /// Rm, m.
        pitch_radius,
        /// Ro − Rw of the nominal ball, m.
        orbit_radius,
        /// Re − Rw of the nominal ball, m.
        curvature_offset,
        /// Re, m.
        curvature,
        /// Rw of the nominal ball, m.
        ball_radius,
    }
}

lane_struct! {
    /// Geometry of the outer contact of one ball at its ψ.
    pub struct OuterGeometry per lane OuterGeometryLanes {
        /// |rb| of a ball that just touches, m.
        orbit_radius,
        /// r, effective contact radius, m (Zhao 2022, Eq. (6)).
        effective_radius,
        /// Slope of `orbit_radius` over ψ, m/rad; 0 for nominal balls.
        slope,
        /// x of the direction of friction (`paper` profile).
        direction_x,
        /// y of the direction of friction (`paper` profile).
        direction_y,
        /// 1 within a discrete raceway, else 0 (`paper` profile).
        inside,
    }
}

impl OuterGeometry {
    /// Geometry on the plain raceway of a ball of radius R: |rb| = Ro − R, r = R, friction
    /// along the circumference.
    #[inline(always)]
    pub fn plain(ball: &Ball, polar: &PolarMotion) -> Self {
        Self {
            orbit_radius: ball.outer_orbit_radius,
            effective_radius: ball.radius,
            slope: 0.0,
            direction_x: -polar.ey,
            direction_y: polar.ex,
            inside: 0.0,
        }
    }
}

lane_struct! {
    /// Outer contact of one ball.
    pub struct OuterContact per lane OuterContactLanes {
        /// δo, m; negative: apart.
        deflection,
        /// Fo, N: the radial sum of both contact points on a discrete raceway.
        force,
        /// ΔVo, m/s.
        slip,
        /// Friction along −ΔVo, N.
        friction,
        /// Friction and normal force on the ball, N.
        fx,
        /// Friction and normal force on the ball, N.
        fy,
        /// Moment about the ball's centre in the sense of its spin, N·m.
        torque,
        /// Power dissipated by damping, W.
        damping_power,
        /// `paper` profile: power of friction that does not act along the sliding velocity, W.
        direction_power,
        /// `paper` profile: power of the relative spin in place of the absolute one, W.
        spin_power,
    }
}

/// δo = |rb| − (Ro − Rw), m (Zhao 2022, Eq. (18)); negative: apart.
#[inline(always)]
pub fn outer_deflection(distance_m: f64, geometry: &OuterGeometry) -> f64 {
    distance_m - geometry.orbit_radius
}

/// Normal force and friction of a ball at the outer raceway (Zhao 2022, Eq. (1), Eq. (19) and
/// Eq. (22)).
///
/// On a discrete raceway each of two points carries F′o = Fo·Rw/(2r), Eq. (19), and friction is
/// 2μF′o = μ·Fo·Rw/r with arm r, Eq. (22); on the plain one r = Rw makes it μ·Fo, Eq. (21).
/// ΔVo is Ω(r + Rm) − ω·r with the relative spin ω in `paper`, Eq. (1), and the surface
/// velocity vt − ω·r of the ball in `physical`.
#[inline(always)]
#[allow(clippy::too_many_arguments)] // two switches, then what the contact depends on
pub fn outer_contact(
    profile: Profile,
    law: FrictionLaw,
    friction: &Friction,
    ball: &Ball,
    raceway: &OuterRaceway,
    geometry: &OuterGeometry,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> OuterContact {
    let (r, spin) = (geometry.effective_radius, motion.spin);
    let deflection = outer_deflection(polar.distance, geometry);
    let rate = polar.radial - geometry.slope * polar.orbit;
    let normal = NormalForce::at_raceway(
        ball.outer_stiffness,
        ball.raceway_damping,
        positive(deflection),
        rate,
    );
    let force = normal.force_n;
    let slip = match profile {
        Profile::Paper => polar.orbit * (r + raceway.pitch_radius) - spin * r,
        Profile::Physical => polar.tangential - spin * r,
    };
    let friction = friction_force(law, friction, slip, force * ball.radius / r);
    let (direction_x, direction_y) = match profile {
        Profile::Paper => (geometry.direction_x, geometry.direction_y),
        Profile::Physical => (-polar.ey, polar.ex),
    };
    let along = direction_x * motion.vx + direction_y * motion.vy;
    OuterContact {
        deflection,
        force,
        slip,
        friction,
        fx: -force * polar.ex - friction * direction_x,
        fy: -force * polar.ey - friction * direction_y,
        torque: r * friction,
        damping_power: normal.damping_power_w,
        direction_power: friction * (polar.tangential - along),
        spin_power: friction * (slip + spin * r - polar.tangential),
    }
}

/// Force along ψ of an outer contact whose geometry changes with ψ, Fo·(d|rb|/dψ)/|rb|, N:
/// the tangential part of −Fo·grad δo. Positive along the motion.
#[inline(always)]
pub fn slope_force(contact: &OuterContact, geometry: &OuterGeometry, distance_m: f64) -> f64 {
    contact.force * geometry.slope / distance_m
}

/// Fw = m·vt²/Rm, N, outward (Zhao 2022, Eq. (15)): `paper` profile only, for in an inertial
/// frame the centrifugal force comes out of the motion.
#[inline(always)]
pub fn centrifugal_force(ball: &Ball, raceway: &OuterRaceway, polar: &PolarMotion) -> f64 {
    ball.mass * polar.tangential * polar.tangential / raceway.pitch_radius
}
