//! The inner ring: coordinates, constants and acceleration.

use super::row::{BodyRow, Freedom, row};
use super::{ContactStiffness, FastestRates, RestingRing};
use crate::ball::Centre;
use crate::case::Case;
use crate::dynamics::coordinates::Kind;
use crate::numerics::lanes::lane_struct;

/// Index of a coordinate of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingCoordinate {
    /// X of the centre.
    X,
    /// Y of the centre.
    Y,
    /// Ẋ of the centre.
    Vx,
    /// Ẏ of the centre.
    Vy,
    /// In space: Z of the centre.
    Z,
    /// In space: p, x of the axis **a** = (p, q, √(1 − p² − q²)): the tilt about Y.
    TiltP,
    /// In space: q, y of the axis: the tilt about −X.
    TiltQ,
    /// In space: Ż of the centre.
    Vz,
    /// In space: ṗ.
    TiltPRate,
    /// In space: q̇.
    TiltQRate,
    /// Under a rotor: ωi, counter-clockwise.
    Speed,
}

impl RingCoordinate {
    /// Coordinates of every case, in the order of the state vector.
    pub const ALL: [Self; 4] = [Self::X, Self::Y, Self::Vx, Self::Vy];
}

/// Coordinates of the inner ring.
pub(crate) const TABLE: [BodyRow; 11] = {
    use Freedom::{Always, InSpace, UnderRotor};
    [
        row(Always, "ring_x_m", "m", 1e-5, Kind::Position),
        row(Always, "ring_y_m", "m", 1e-5, Kind::Position),
        row(Always, "ring_vx_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
        row(Always, "ring_vy_m_s", "m/s", 0.1, Kind::VelocityOf(1)),
        row(InSpace, "ring_z_m", "m", 1e-5, Kind::Position),
        row(InSpace, "tilt_p", "1", 1e-3, Kind::Position),
        row(InSpace, "tilt_q", "1", 1e-3, Kind::Position),
        row(InSpace, "ring_vz_m_s", "m/s", 0.1, Kind::VelocityOf(4)),
        row(
            InSpace,
            "tilt_p_rate_per_s",
            "1/s",
            10.0,
            Kind::VelocityOf(5),
        ),
        row(
            InSpace,
            "tilt_q_rate_per_s",
            "1/s",
            10.0,
            Kind::VelocityOf(6),
        ),
        row(UnderRotor, "ring_speed_rad_s", "rad/s", 1.0, Kind::Rate),
    ]
};

lane_struct! {
    /// Constants of the inner ring and the forces on it that do not come from the balls.
    pub(crate) struct InnerRing per lane InnerRingLanes {
        /// mi, kg.
        mass,
        /// Ji, kg·m², where its speed is a state: under a rotor.
        polar_inertia,
        /// C, viscous damping of its translation, N·s/m.
        drag,
        /// Fr, N, along −Y.
        radial_load,
        /// g, m/s², along −Y.
        gravity,
        /// Force of the unbalance along X, N.
        unbalance_x,
        /// Force of the unbalance along Y, N.
        unbalance_y,
    }
}

/// The ring at the start.
pub(super) fn start(ring: &RestingRing) -> [(RingCoordinate, f64); 5] {
    let ([x, y, z], [p, q]) = (ring.place_m, ring.axis);
    [
        (RingCoordinate::X, x),
        (RingCoordinate::Y, y),
        (RingCoordinate::Z, z),
        (RingCoordinate::TiltP, p),
        (RingCoordinate::TiltQ, q),
    ]
}

/// Contribution of the ring to the fastest rates of a case: on the balls that carry it and the journal.
pub(super) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> FastestRates {
    let (c, d) = (contacts, case.bearing.dimensions());
    let damping_n_s_m = c.carrying * c.inner_n_s_m + d.inner_ring_damping_n_s_m + c.journal_n_s_m;
    FastestRates {
        square_1_s2: (c.carrying * c.inner_n_m + c.journal_n_m) / d.inner_ring_mass_kg,
        decay_1_s: damping_n_s_m / d.inner_ring_mass_kg,
    }
}

impl InnerRing {
    /// Acceleration of the centre under the sum of the balls' reactions, m/s²:
    /// mi(Ẍ, Ÿ) + C(Ẋ, Ẏ) = Fr + weight + unbalance + Σ reactions (Zhao 2022, Eq. (14)).
    #[inline(always)]
    pub(crate) fn acceleration(&self, motion: &Centre, reactions_n: [f64; 2]) -> [f64; 2] {
        let [x, y] = reactions_n;
        let down = self.radial_load - self.unbalance_y;
        [
            (x - (self.drag * motion.vx - self.unbalance_x)) / self.mass,
            (y - self.drag * motion.vy - down - self.weight_n()) / self.mass,
        ]
    }

    /// Power of load and unbalance, W.
    #[inline(always)]
    pub(crate) fn load_power_w(&self, motion: &Centre) -> f64 {
        self.unbalance_x * motion.vx - (self.radial_load - self.unbalance_y) * motion.vy
    }

    /// mi·g, N.
    #[inline(always)]
    pub(crate) fn weight_n(&self) -> f64 {
        self.mass * self.gravity
    }
}
