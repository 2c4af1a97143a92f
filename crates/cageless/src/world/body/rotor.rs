//! A rotor as its bearings see it: coordinates, motion and what it yields to loads.

use super::row::{BodyRow, Freedom, row};
use super::{ContactStiffness, FastestRates, RestingRing};
use crate::case::Case;
use crate::dynamics::coordinates::Kind;
use crate::numerics::vector::PlaneVector;
use crate::world::joint::TouchLoads;

/// Index of a coordinate of the rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotorCoordinate {
    /// x of the mass centre.
    X,
    /// y of the mass centre.
    Y,
    /// θ.
    Angle,
    /// In space: z; where it is that of the inner ring, the shoulders are as far from either face.
    Z,
    /// ẋ of the mass centre.
    Vx,
    /// ẏ of the mass centre.
    Vy,
    /// Ω, counter-clockwise.
    Speed,
    /// In space: ż.
    Vz,
}

/// Number of coordinates of a rotor at a bearing.
pub(crate) const ROTOR: usize = TABLE.len();

/// Coordinates of a rotor at a bearing: of a rigid one those of its mass centre, of others those of the journal.
pub(crate) const TABLE: [BodyRow; 8] = {
    use Freedom::{UnderRotor, UnderRotorInSpace};
    [
        row(UnderRotor, "rotor_x_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "rotor_y_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "rotor_angle_rad", "rad", 1e-3, Kind::Position),
        row(UnderRotorInSpace, "rotor_z_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "rotor_vx_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
        row(UnderRotor, "rotor_vy_m_s", "m/s", 0.1, Kind::VelocityOf(1)),
        row(
            UnderRotor,
            "rotor_speed_rad_s",
            "rad/s",
            1.0,
            Kind::VelocityOf(2),
        ),
        row(
            UnderRotorInSpace,
            "rotor_vz_m_s",
            "m/s",
            0.1,
            Kind::VelocityOf(3),
        ),
    ]
};

/// Motion of the mass centre of a rotor and its rotation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RotorMotion {
    /// x of the mass centre, m.
    pub x: f64,
    /// y of the mass centre, m.
    pub y: f64,
    /// ẋ of the mass centre, m/s.
    pub vx: f64,
    /// ẏ of the mass centre, m/s.
    pub vy: f64,
    /// θ, rad, counter-clockwise, from the start on.
    pub angle: f64,
    /// Ω, rad/s, counter-clockwise.
    pub speed: f64,
    /// z, m; 0 in the plane.
    pub z: f64,
    /// ż, m/s; 0 in the plane.
    pub vz: f64,
}

impl RotorMotion {
    /// The motion with these coordinates.
    #[inline(always)]
    pub(crate) fn new(at: impl Fn(RotorCoordinate) -> f64) -> Self {
        Self {
            x: at(RotorCoordinate::X),
            y: at(RotorCoordinate::Y),
            vx: at(RotorCoordinate::Vx),
            vy: at(RotorCoordinate::Vy),
            angle: at(RotorCoordinate::Angle),
            speed: at(RotorCoordinate::Speed),
            z: at(RotorCoordinate::Z),
            vz: at(RotorCoordinate::Vz),
        }
    }

    /// Power of loads of the inner ring, W.
    #[inline(always)]
    pub(crate) fn power(&self, loads: &TouchLoads) -> f64 {
        let [x, y, z] = loads.force;
        x * self.vx + y * self.vy + z * self.vz + loads.moment * self.speed
    }

    /// Coordinates with their values.
    pub(crate) fn coordinates(&self) -> [(RotorCoordinate, f64); TABLE.len()] {
        [
            (RotorCoordinate::X, self.x),
            (RotorCoordinate::Y, self.y),
            (RotorCoordinate::Vx, self.vx),
            (RotorCoordinate::Vy, self.vy),
            (RotorCoordinate::Angle, self.angle),
            (RotorCoordinate::Speed, self.speed),
            (RotorCoordinate::Z, self.z),
            (RotorCoordinate::Vz, self.vz),
        ]
    }
}

/// The rotor of a case at the start: where the magnetic bearing held it.
pub(super) fn start(
    case: &Case,
    ring: &RestingRing,
) -> Option<[(RotorCoordinate, f64); TABLE.len()]> {
    let rotor = case.rotor.as_ref()?;
    let [.., ring_z_m] = ring.place_m;
    let motion = RotorMotion {
        x: rotor.x_m,
        y: rotor.y_m,
        vx: rotor.vx_m_s,
        vy: rotor.vy_m_s,
        angle: 0.0,
        speed: rotor.speed_rad_s,
        z: ring_z_m + rotor.z_m,
        vz: rotor.vz_m_s,
    };
    Some(motion.coordinates())
}

/// Contribution of the rotor to the fastest rates of a case: on the contact of its journal.
pub(super) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> FastestRates {
    let inverse_mass = case.rotor.as_ref().map_or(0.0, |rotor| 1.0 / rotor.mass_kg);
    FastestRates {
        square_1_s2: contacts.journal_n_m * inverse_mass,
        decay_1_s: 0.0,
    }
}

/// Load of a rotor across its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LateralLoad {
    /// Force, N.
    pub force: PlaneVector,
    /// Moment about the axis, N·m.
    pub moment: f64,
}

impl LateralLoad {
    /// Acceleration by the row of a compliance.
    #[inline(always)]
    pub(crate) fn along(&self, [per_x, per_y, per_moment]: &[f64; 3]) -> f64 {
        per_x * self.force.x + per_y * self.force.y + per_moment * self.moment
    }
}

/// Accelerations of a rotor at a bearing under loads there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RotorCompliance {
    /// Accelerations of a rigid rotor, by its mass and inertia.
    Rigid {
        /// m, kg.
        mass: f64,
        /// Ip, kg·m².
        polar_inertia: f64,
    },
    /// Accelerations of a bending rotor under a unit of each load.
    Bending {
        /// ẍ, ÿ and Ω̇, rows, under a force along X, one along Y and a moment about the axis: 1/kg, 1/(kg·m) and
        /// 1/(kg·m²).
        lateral: [[f64; 3]; 3],
        /// z̈ under a force along Z, 1/kg.
        axial: f64,
    },
}

impl RotorCompliance {
    /// Compliance of a rotor that nothing moves.
    pub(crate) const HELD: Self = Self::Bending {
        lateral: [[0.0; 3]; 3],
        axial: 0.0,
    };

    /// pᵀ·G·p with p = (tx, ty, a): the change of the velocity of a surface along the unit vector t by a unit of force
    /// there that turns by the arm a, 1/kg; of a rigid rotor 1/m + a²/Ip.
    #[inline(always)]
    pub(crate) fn along(&self, t: PlaneVector, arm: f64) -> f64 {
        match self {
            Self::Rigid {
                mass,
                polar_inertia,
            } => 1.0 / mass + arm * arm / polar_inertia,
            Self::Bending { lateral, .. } => {
                let load = LateralLoad {
                    force: t,
                    moment: arm,
                };
                load.along(&lateral.each_ref().map(|row| load.along(row)))
            }
        }
    }

    /// z̈ under a unit force along Z, 1/kg.
    pub(crate) fn axial(&self) -> f64 {
        match self {
            Self::Rigid { mass, .. } => 1.0 / mass,
            Self::Bending { axial, .. } => *axial,
        }
    }

    /// Accelerations ẍ, ÿ and Ω̇, rows, under a unit of each load across the axis and about it, at a point from which the
    /// mass centre is at `offset`, m: with w = (εy, −εx, 1), diag(1/m, 1/m, 0) + w wᵀ/Ip of a rigid rotor.
    pub(crate) fn about(&self, offset: PlaneVector) -> [[f64; 3]; 3] {
        let PlaneVector { x: ex, y: ey } = offset;
        match self {
            Self::Rigid {
                mass,
                polar_inertia,
            } => {
                let w = [ey, -ex, 1.0];
                let mut rows = w.map(|a| w.map(|b| a * b / polar_inertia));
                for (axis, row) in rows.iter_mut().enumerate().take(2) {
                    row[axis] += 1.0 / mass;
                }
                rows
            }
            Self::Bending { lateral, .. } => {
                // (vx + Ω·ey, vy − Ω·ex, Ω), and the loads likewise.
                let shift = |[x, y, turn]: [f64; 3]| [x + ey * turn, y - ex * turn, turn];
                let [x, y, turn] = lateral.map(shift);
                let sum = |a: [f64; 3], by: f64| [0, 1, 2].map(|k| a[k] + by * turn[k]);
                [sum(x, ey), sum(y, -ex), turn]
            }
        }
    }
}
