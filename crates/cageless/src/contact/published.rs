//! Peculiarities of the published equations of motion, Zhao 2022, Eq. (12) to (22), beside consistent mechanics:
//! the formulation `paper`.
//!
//! - The centrifugal force Fw = m·vt²/Rm of Eq. (15) acts in Eq. (12), though the frame does not turn.
//! - ω of Eq. (13) is the spin relative to the orbit of the ball, with which Eq. (1) and Eq. (2) give the
//!   sliding speeds.
//! - Friction in a discrete raceway acts along the contact path, Eq. (22), not against the sliding.
//!
//! The power of each is a term of the energy ledger. Normal forces, Eq. (16) to (19), friction laws,
//! Eq. (20) and (21), and the motion of the ring, Eq. (14), are those of all equations of motion.

use super::{
    InnerRaceway, OuterContact, OuterGeometry, OuterRaceway, RacewayConstants, RacewayPosition,
    SlipProblem,
};
use crate::ball::{Ball, BallLoad, BallMotion, BothContacts, PolarMotion};
use crate::numerics::lanes::lane_struct;
use crate::numerics::vector::PlaneVector;

lane_struct! {
    /// Direction against which friction acts on a ball at the outer raceway.
    pub(crate) struct FrictionDirection per lane FrictionDirectionLanes {
        /// x of its unit vector.
        x,
        /// y of its unit vector.
        y,
        /// 1 where it is that of a contact path, in a discrete raceway, else 0.
        on_path,
    }
}

/// Contact path at the place of a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathPlace {
    /// 4a of Zhao 2022, Eq. (5).
    pub cubic: f64,
    /// 2b of Eq. (5).
    pub linear: f64,
    /// r, m.
    pub radius: f64,
    /// 1/√(1 + y′² + z′²).
    pub along: f64,
}

impl FrictionDirection {
    /// Unit vector of the direction.
    #[inline(always)]
    pub(crate) fn vector(&self) -> PlaneVector {
        PlaneVector {
            x: self.x,
            y: self.y,
        }
    }

    /// Direction of the circumference.
    #[inline(always)]
    pub(crate) fn circumference(polar: &PolarMotion) -> Self {
        Self {
            x: -polar.ey,
            y: polar.ex,
            on_path: 0.0,
        }
    }

    /// r_f of Zhao 2022, Eq. (22), in a discrete raceway, this direction elsewhere: the unit tangent
    /// (1, y′, z′)/√(1 + y′² + z′²) of the contact path with y′ = x(4a x² + 2b) of Eq. (5).
    #[inline(always)]
    pub(crate) fn on_path(
        self,
        raceway: &RacewayConstants,
        path: PathPlace,
        outer: &OuterRaceway,
        position: &RacewayPosition,
    ) -> Self {
        let along = path.along;
        let x = (path.radius + outer.orbit_radius) * position.sine;
        let across = along * (x * (path.cubic * x * x + path.linear));
        let inside = position.inside();
        let select = |new: f64, old: f64| if inside { new } else { old };
        let (sin, cos) = (raceway.sin_centre, raceway.cos_centre);
        Self {
            x: select(along * cos - across * sin, self.x),
            y: select(along * sin + across * cos, self.y),
            on_path: select(1.0, self.on_path),
        }
    }
}

/// ΔVo = Ω(r + Rm) − ω·r, m/s (Zhao 2022, Eq. (1)).
#[inline(always)]
pub(crate) fn outer_slip(
    raceway: &OuterRaceway,
    geometry: &OuterGeometry,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> f64 {
    let r = geometry.effective_radius;
    polar.orbit * (r + raceway.pitch_radius) - motion.spin * r
}

/// ΔVi = ωi·Ri − (Ωi·Ri + ω·Rw), m/s (Zhao 2022, Eq. (2)).
#[inline(always)]
pub(crate) fn inner_slip(
    ball: &Ball,
    raceway: &InnerRaceway,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> f64 {
    raceway.surface_speed - (polar.orbit * raceway.radius + motion.spin * ball.radius)
}

/// Fw = m·vt²/Rm, N, outward (Zhao 2022, Eq. (15)); in an inertial frame it comes out of the motion.
#[inline(always)]
pub(crate) fn centrifugal_force(ball: &Ball, raceway: &OuterRaceway, polar: &PolarMotion) -> f64 {
    ball.mass * polar.tangential * polar.tangential / raceway.pitch_radius
}

/// Force and moment on the ball of its outer contact and of the centrifugal force: Fw − Fo along the
/// radius, friction against r_f (Zhao 2022, Eq. (12), (13) and (22)).
#[inline(always)]
pub(crate) fn outer_load(
    contact: &OuterContact,
    geometry: &OuterGeometry,
    direction: &FrictionDirection,
    polar: &PolarMotion,
    friction_n: f64,
    centrifugal_n: f64,
) -> BallLoad {
    BallLoad {
        fx: -contact.force * polar.ex - friction_n * direction.x + centrifugal_n * polar.ex,
        fy: -contact.force * polar.ey - friction_n * direction.y + centrifugal_n * polar.ey,
        torque: geometry.effective_radius * friction_n,
    }
}

/// A ball between both raceways, as the published equations see it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PublishedBall<'a> {
    /// Constants of the ball.
    pub ball: &'a Ball,
    /// The outer raceway.
    pub outer: &'a OuterRaceway,
    /// The inner raceway.
    pub inner: &'a InnerRaceway,
    /// Geometry of the outer contact.
    pub geometry: &'a OuterGeometry,
    /// Direction of friction there.
    pub direction: &'a FrictionDirection,
    /// Motion of the ball, with the spin relative to the orbit.
    pub motion: &'a BallMotion,
    /// Motion about the outer ring.
    pub polar: &'a PolarMotion,
    /// Motion about the inner ring.
    pub inner_polar: &'a PolarMotion,
}

/// Powers of friction, W, that friction against the sliding with the absolute spin would not have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PublishedPowers {
    /// Power due to the direction of friction, W.
    pub direction: f64,
    /// Power due to the relative spin, W.
    pub spin: f64,
}

impl PublishedBall<'_> {
    /// ΔVo and ΔVi, m/s.
    #[inline(always)]
    pub(crate) fn slips(&self) -> BothContacts {
        BothContacts {
            outer: outer_slip(self.outer, self.geometry, self.motion, self.polar),
            inner: inner_slip(self.ball, self.inner, self.motion, self.inner_polar),
        }
    }

    /// Powers of the friction fo and fi.
    #[inline(always)]
    pub(crate) fn powers(&self, friction: BothContacts) -> PublishedPowers {
        let (fo, fi) = (friction.outer, friction.inner);
        let (motion, polar) = (self.motion, self.polar);
        let along = self.direction.x * motion.vx + self.direction.y * motion.vy;
        let slip = outer_slip(self.outer, self.geometry, motion, polar);
        let turning = slip + motion.spin * self.geometry.effective_radius - polar.tangential;
        let carried = self.inner_polar.orbit * self.inner.radius;
        PublishedPowers {
            direction: fo * (polar.tangential - along),
            spin: fo * turning + fi * (self.inner_polar.tangential - carried),
        }
    }

    /// Equations of the friction over a step of `h_s`, see [`SlipProblem::new`], under these normal forces:
    /// ΔVo = co·vt − ω·r and ΔVi = ωi·Ri − (ci·vt,i + ω·Rw) with co = (r + Rm)/|rb| and ci = Ri/|rb − ri|.
    #[inline(always)]
    pub(crate) fn slip_problem(&self, normal: BothContacts, h_s: f64) -> SlipProblem {
        let (ball, polar, inner_polar) = (self.ball, self.polar, self.inner_polar);
        let (r, radius) = (self.geometry.effective_radius, ball.radius);
        let (dx, dy) = (self.direction.x, self.direction.y);
        let tangents = polar.ey * inner_polar.ey + polar.ex * inner_polar.ex;
        let (mass, inertia) = (h_s * ball.inverse_mass, h_s * ball.inverse_inertia);
        let turning = r * radius * inertia;
        let co = (r + self.outer.pitch_radius) / polar.distance;
        let ci = self.inner.radius / inner_polar.distance;
        let outer_on_outer = polar.ex * dy - polar.ey * dx;
        let outer_on_inner = inner_polar.ex * dy - inner_polar.ey * dx;
        let free = self.slips();
        SlipProblem {
            outer_free: free.outer,
            inner_free: free.inner,
            outer_outer: co * outer_on_outer * mass + r * r * inertia,
            outer_inner: turning - co * tangents * mass,
            inner_outer: turning - ci * outer_on_inner * mass,
            inner_inner: ci * mass + radius * radius * inertia,
            outer_normal: normal.outer,
            inner_normal: normal.inner,
        }
    }
}
