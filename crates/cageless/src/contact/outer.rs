//! Contact of a ball with the outer raceway, plain or discrete.

use super::{NormalForce, positive};
use crate::ball::{Ball, BallLoad, BallMotion, PolarMotion};
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Constants of the outer raceway.
    pub(crate) struct OuterRaceway per lane OuterRacewayLanes {
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
        /// Friction over that of the law.
        friction_factor,
        /// A, square of the semi-axis across the groove of the contact ellipse of a nominal ball on
        /// the plain raceway over its deflection, m.
        axis_square_per_m,
    }
}

lane_struct! {
    /// Geometry of the outer contact of one ball at its ψ.
    pub(crate) struct OuterGeometry per lane OuterGeometryLanes {
        /// |rb| of a ball that just touches, m.
        orbit_radius,
        /// r, effective contact radius, m (Zhao 2022, Eq. (6)).
        effective_radius,
        /// Slope of `orbit_radius` over ψ, m/rad; 0 for nominal balls.
        slope,
    }
}

impl OuterGeometry {
    /// Geometry on the plain raceway of a ball of radius R: |rb| = Ro − R, r = R.
    #[inline(always)]
    pub(crate) fn plain(ball: &Ball) -> Self {
        Self {
            orbit_radius: ball.outer_orbit_radius,
            effective_radius: ball.radius,
            slope: 0.0,
        }
    }
}

lane_struct! {
    /// Outer contact of one ball without its friction.
    pub(crate) struct OuterContact per lane OuterContactLanes {
        /// δo, m; negative: apart.
        deflection,
        /// Fo, N: the radial sum of both contact points on a discrete raceway.
        force,
        /// ΔVo, m/s.
        slip,
        /// Normal force that friction acts under, N: that of both contact points, Fo·Rw/r,
        /// times the friction factor.
        friction_normal,
        /// Power dissipated by damping, W.
        damping_power,
    }
}

/// δo = |rb| − (Ro − Rw), m (Zhao 2022, Eq. (18)); negative: apart.
#[inline(always)]
pub(crate) fn outer_deflection(distance_m: f64, geometry: &OuterGeometry) -> f64 {
    distance_m - geometry.orbit_radius
}

/// Normal force and sliding speed of a ball at the outer raceway (Zhao 2022, Eq. (1) and
/// Eq. (19)).
///
/// On a discrete raceway each of two points carries F′o = Fo·Rw/(2r), Eq. (19), so that
/// friction acts under Fo·Rw/r; on the plain one r = Rw makes it Fo. ΔVo is the surface velocity
/// vt − ω·r of the ball.
#[inline(always)]
pub(crate) fn outer_contact(
    ball: &Ball,
    raceway: &OuterRaceway,
    geometry: &OuterGeometry,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> OuterContact {
    let deflection = outer_deflection(polar.distance, geometry);
    let rate = polar.radial - geometry.slope * polar.orbit;
    let normal = NormalForce::at_raceway(
        ball.outer_stiffness_n_m1_5,
        ball.raceway_damping,
        positive(deflection),
        rate,
    );
    OuterContact {
        deflection,
        force: normal.force_n,
        slip: outer_slip(geometry, motion, polar),
        friction_normal: raceway.friction_factor * normal.force_n * ball.radius
            / geometry.effective_radius,
        damping_power: normal.damping_power_w,
    }
}

/// ΔVo = vt − ω·r, m/s.
#[inline(always)]
pub(crate) fn outer_slip(
    geometry: &OuterGeometry,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> f64 {
    polar.tangential - motion.spin * geometry.effective_radius
}

/// Force and moment of the outer contact on the ball under the friction `friction_n`, which
/// acts with arm r: 2μF′o on a discrete raceway, μFo on the plain one (Zhao 2022,
/// Eq. (22)).
#[inline(always)]
pub(crate) fn outer_load(
    contact: &OuterContact,
    geometry: &OuterGeometry,
    polar: &PolarMotion,
    friction_n: f64,
) -> BallLoad {
    BallLoad {
        fx: -contact.force * polar.ex + friction_n * polar.ey,
        fy: -contact.force * polar.ey - friction_n * polar.ex,
        torque: geometry.effective_radius * friction_n,
    }
}

/// Force along ψ of an outer contact whose geometry changes with ψ, Fo·(d|rb|/dψ)/|rb|, N:
/// the tangential part of −Fo·grad δo. Positive along the motion.
#[inline(always)]
pub(crate) fn slope_force(
    contact: &OuterContact,
    geometry: &OuterGeometry,
    distance_m: f64,
) -> f64 {
    contact.force * geometry.slope / distance_m
}
