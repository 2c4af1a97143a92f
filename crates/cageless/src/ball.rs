//! Constants, motion and acceleration of a ball.
//!
//! ```
//! use cageless::prelude::*;
//!
//! let simulation = Simulation::new(&reference::conventional())?;
//! let ring = simulation.view().ring();
//! assert!(ring.y_m < 0.0 && ring.vy_m_s == 0.0); // at rest, pressed down by the load
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::numerics::lanes::lane_struct;
use crate::numerics::vector::PlaneVector;

/// Place and velocity of a ring along the axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct AxialMotion {
    /// Z, m.
    pub z: f64,
    /// Ż, m/s.
    pub vz: f64,
}

/// A value at the contacts of a ball with both raceways.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BothContacts<T = f64> {
    /// At the outer raceway.
    pub outer: T,
    /// At the inner raceway.
    pub inner: T,
}

lane_struct! {
    /// Constants of one ball and of its contacts.
    pub(crate) struct Ball per lane BallLanes {
        /// R, m.
        radius,
        /// m, kg.
        mass,
        /// 1/m, 1/kg; 0 keeps padding at rest.
        inverse_mass,
        /// 1/J, 1/(kg·m²).
        inverse_inertia,
        /// Ro − R: distance from the bearing axis when it just touches the plain outer raceway, m.
        outer_orbit_radius,
        /// Ri + R: distance from the centre of the inner ring when it just touches, m.
        inner_contact_distance,
        /// K at the inner raceway, N·m^(−3/2).
        inner_stiffness_n_m1_5,
        /// K at the outer raceway, N·m^(−3/2).
        outer_stiffness_n_m1_5,
        /// c of both raceway contacts, N·s·m^(−3/2).
        raceway_damping,
        /// Distance of the centres of this ball and the ball ahead when they just touch, m.
        pair_distance,
        /// K between this ball and the ball ahead, N·m^(−3/2).
        pair_stiffness,
        /// α √(m K) between this ball and the ball ahead, m the reduced mass of the two.
        pair_damping,
        /// Radius of the ball ahead, m.
        next_radius,
        /// Friction between this ball and the ball ahead over that of the law.
        pair_friction_factor,
    }
}

lane_struct! {
    /// Position, velocity and spin of a ball.
    pub(crate) struct BallMotion per lane BallMotionLanes {
        /// x, m.
        x,
        /// y, m.
        y,
        /// ẋ, m/s.
        vx,
        /// ẏ, m/s.
        vy,
        /// ω, rad/s, clockwise positive: the state of Zhao 2022, Eq. (13), absolute in the
        /// `physical` formulation and relative to the orbit in `paper`.
        spin,
    }
}

lane_struct! {
    /// Motion of a ball's centre in polar coordinates about the centre of a ring, relative to
    /// that centre.
    pub(crate) struct PolarMotion per lane PolarMotionLanes {
        /// Unit vector e from the centre to the ball.
        ex,
        /// Unit vector e from the centre to the ball.
        ey,
        /// |rb|, m.
        distance,
        /// vt, m/s, counter-clockwise.
        tangential,
        /// d|rb|/dt, m/s.
        radial,
        /// Ω = vt/|rb|, rad/s.
        orbit,
    }
}

/// Position and velocity of the centre of a ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Centre {
    /// X, m.
    pub x: f64,
    /// Y, m.
    pub y: f64,
    /// Ẋ, m/s.
    pub vx: f64,
    /// Ẏ, m/s.
    pub vy: f64,
}

impl Centre {
    /// Position, m.
    #[inline(always)]
    pub(crate) fn place(&self) -> PlaneVector {
        PlaneVector {
            x: self.x,
            y: self.y,
        }
    }
}

impl BallMotion {
    /// Polar coordinates about `centre`: e = r/|r|, vt = v·t with t = e turned by +90°.
    #[inline(always)]
    pub(crate) fn about(&self, centre: &Centre) -> PolarMotion {
        let (x, y) = (self.x - centre.x, self.y - centre.y);
        let (vx, vy) = (self.vx - centre.vx, self.vy - centre.vy);
        let distance = (x * x + y * y).sqrt();
        let inverse = 1.0 / distance;
        let (ex, ey) = (x * inverse, y * inverse);
        let tangential = vy * ex - vx * ey;
        PolarMotion {
            ex,
            ey,
            distance,
            tangential,
            radial: vx * ex + vy * ey,
            orbit: tangential * inverse,
        }
    }
}

impl PolarMotion {
    /// **e**.
    #[inline(always)]
    pub(crate) fn direction(&self) -> PlaneVector {
        PlaneVector {
            x: self.ex,
            y: self.ey,
        }
    }

    /// Motion at this position with the velocities of `ball` and `centre`.
    #[inline(always)]
    pub(crate) fn with_velocity(&self, ball: &BallMotion, centre: &Centre) -> Self {
        let (vx, vy) = (ball.vx - centre.vx, ball.vy - centre.vy);
        let tangential = vy * self.ex - vx * self.ey;
        Self {
            tangential,
            radial: vx * self.ex + vy * self.ey,
            orbit: tangential / self.distance,
            ..*self
        }
    }
}

lane_struct! {
    /// Sum of the forces and moments on a ball.
    pub(crate) struct BallLoad per lane BallLoadLanes {
        /// Force along x, N.
        fx,
        /// Force along y, N.
        fy,
        /// Moment in the sense of the spin, N·m.
        torque,
    }
}

impl BallLoad {
    /// Acceleration of the centre, m(ẍ, ÿ) = Σ F, and of the spin, J·dωb/dt = Σ M
    /// (Zhao 2022, Eq. (12) and Eq. (13)).
    #[inline(always)]
    pub(crate) fn acceleration(&self, ball: &Ball) -> [f64; 3] {
        [
            self.fx * ball.inverse_mass,
            self.fy * ball.inverse_mass,
            self.torque * ball.inverse_inertia,
        ]
    }
}
