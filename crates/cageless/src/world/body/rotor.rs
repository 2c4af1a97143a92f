//! A rigid rotor: coordinates, constants, motion and acceleration.

use super::row::{BodyRow, Freedom, row};
use super::{ContactStiffness, FastestRates, RestingRing};
use crate::case::Case;
use crate::contact::JournalMotion;
use crate::dynamics::coordinates::Kind;
use crate::rotor::Rotor;
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
    /// ẋ of the mass centre.
    Vx,
    /// ẏ of the mass centre.
    Vy,
    /// Ω, counter-clockwise.
    Speed,
    /// In space: z; where it is that of the inner ring, the shoulders are as far from either face.
    Z,
    /// In space: ż.
    Vz,
}

/// Coordinates of the rotor.
pub(crate) const TABLE: [BodyRow; 8] = {
    use Freedom::{UnderRotor, UnderRotorInSpace};
    [
        row(UnderRotor, "rotor_x_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "rotor_y_m", "m", 1e-5, Kind::Position),
        row(UnderRotor, "rotor_angle_rad", "rad", 1e-3, Kind::Position),
        row(UnderRotor, "rotor_vx_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
        row(UnderRotor, "rotor_vy_m_s", "m/s", 0.1, Kind::VelocityOf(1)),
        row(
            UnderRotor,
            "rotor_speed_rad_s",
            "rad/s",
            1.0,
            Kind::VelocityOf(2),
        ),
        row(UnderRotorInSpace, "rotor_z_m", "m", 1e-5, Kind::Position),
        row(
            UnderRotorInSpace,
            "rotor_vz_m_s",
            "m/s",
            0.1,
            Kind::VelocityOf(6),
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

/// What the rotor adds to the fastest rates of a case: on the contact of its journal.
pub(super) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> FastestRates {
    let inverse_mass = case.rotor.as_ref().map_or(0.0, |rotor| 1.0 / rotor.mass_kg);
    FastestRates {
        square_1_s2: contacts.journal_n_m * inverse_mass,
        decay_1_s: 0.0,
    }
}

/// Accelerations of a journal, [ẍ, ÿ, Ω̇], under a unit of each of the loads [Fx, Fy, moment about
/// its centre] on it: 1/kg, 1/(kg·m) and 1/(kg·m²).
pub(crate) type JournalCompliance = [[f64; 3]; 3];

/// Accelerations of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotorAcceleration {
    /// Acceleration of the mass centre, m/s².
    pub linear: [f64; 3],
    /// Angular acceleration, rad/s².
    pub spin: f64,
}

/// Constants of the rotor.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RotorBody {
    /// m, kg.
    pub mass: f64,
    /// m of all that moves along the axis with the rotor, kg.
    pub axial_mass: f64,
    /// Ip, kg·m².
    pub polar_inertia: f64,
    /// ε, m.
    pub eccentricity: f64,
    /// φ, rad.
    pub phase: f64,
    /// Weight, N.
    pub weight: [f64; 3],
    /// Force along +Z, N.
    pub axial_load: f64,
    /// Torque of the drive, N·m.
    pub drive_torque: f64,
    /// Set where the motion of the journal is that of a rotor outside this bearing: the journal
    /// then has no mass of its own.
    pub guide: Option<JournalCompliance>,
}

impl RotorBody {
    /// The rotor of a case.
    pub(crate) fn of_case(rotor: &Rotor, case: &Case) -> Self {
        let upward = match case.moves_in_space() {
            true => case.upward(),
            false => 1,
        };
        Self::new(rotor, upward, case.operation.gravity_m_s2)
    }

    /// A rotor whose weight acts against an axis: 1 for Y, 2 for Z.
    pub(crate) fn new(rotor: &Rotor, upward: usize, gravity_m_s2: f64) -> Self {
        let mut weight = [0.0; 3];
        weight[upward] = -rotor.mass_kg * gravity_m_s2;
        Self {
            mass: rotor.mass_kg,
            axial_mass: rotor.mass_kg,
            polar_inertia: rotor.polar_inertia_kg_m2,
            eccentricity: rotor.eccentricity_m,
            phase: rotor.eccentricity_phase_rad,
            weight,
            axial_load: rotor.axial_load_n,
            drive_torque: rotor.drive_torque_n_m,
            guide: None,
        }
    }

    /// Journal of a rotor of this mass that rests on other bearings as well: its contact without a mass
    /// and loads of its own.
    pub(crate) fn guided(self, rotor_mass_kg: f64) -> Self {
        Self {
            mass: 0.0,
            axial_mass: rotor_mass_kg,
            polar_inertia: 0.0,
            eccentricity: 0.0,
            weight: [0.0; 3],
            axial_load: 0.0,
            drive_torque: 0.0,
            guide: Some(JournalCompliance::default()),
            ..self
        }
    }

    /// ε·e^(i(θ+φ)), m.
    #[inline(always)]
    pub(crate) fn offset(&self, angle: f64) -> [f64; 2] {
        if self.eccentricity == 0.0 {
            return [0.0; 2];
        }
        let (sin, cos) = (angle + self.phase).sin_cos();
        [self.eccentricity * cos, self.eccentricity * sin]
    }

    /// Motion of the centre of the journal: zr = zg − ε·e^(i(θ+φ)), żr = żg − iΩ·ε·e^(i(θ+φ)).
    #[inline(always)]
    pub(crate) fn journal_motion(&self, motion: &RotorMotion, offset: [f64; 2]) -> JournalMotion {
        let [ex, ey] = offset;
        JournalMotion {
            x: motion.x - ex,
            y: motion.y - ey,
            vx: motion.vx + motion.speed * ey,
            vy: motion.vy - motion.speed * ex,
            speed: motion.speed,
        }
    }

    /// Acceleration under the loads of the inner ring: m z̈g = F + weight and Ip Ω̇ = moment of F +
    /// torque of the drive. A guided journal has the part that the loads add alone.
    #[inline(always)]
    pub(crate) fn acceleration(&self, loads: &TouchLoads) -> RotorAcceleration {
        if self.guide.is_some() {
            return self.response(loads);
        }
        let ([x, y, z], [wx, wy, wz]) = (loads.force, self.weight);
        RotorAcceleration {
            linear: [
                (x + wx) / self.mass,
                (y + wy) / self.mass,
                (z + (wz + self.axial_load)) / self.mass,
            ],
            spin: (loads.moment + self.drive_torque) / self.polar_inertia,
        }
    }

    /// Acceleration that loads of the inner ring add; a guided journal has the moment on its axis.
    #[inline(always)]
    pub(crate) fn response(&self, loads: &TouchLoads) -> RotorAcceleration {
        let [x, y, z] = loads.force;
        let [ax, ay, spin] = match &self.guide {
            None => [
                x / self.mass,
                y / self.mass,
                loads.moment / self.polar_inertia,
            ],
            Some(compliance) => compliance.map(|[a, b, turn]| a * x + b * y + turn * loads.moment),
        };
        RotorAcceleration {
            linear: [ax, ay, z / self.axial_mass],
            spin,
        }
    }

    /// Power that enters the bearing by the drive of the rotor, W; where the journal is guided,
    /// by the journal: that of the loads of the inner ring on it, negative.
    #[inline(always)]
    pub(crate) fn drive_power(&self, motion: &RotorMotion, loads: &TouchLoads) -> f64 {
        match &self.guide {
            Some(_) => -motion.power(loads),
            None => self.drive_torque * motion.speed,
        }
    }

    /// Power of the weight, W.
    #[inline(always)]
    pub(crate) fn weight_power(&self, motion: &RotorMotion) -> f64 {
        let [x, y, z] = self.weight;
        x * motion.vx + y * motion.vy + z * motion.vz
    }

    /// Kinetic energy, J.
    pub(crate) fn energy_j(&self, motion: &RotorMotion) -> f64 {
        let square = motion.vx * motion.vx + motion.vy * motion.vy + motion.vz * motion.vz;
        0.5 * self.mass * square + 0.5 * self.polar_inertia * motion.speed * motion.speed
    }

    /// Accelerations of the centre of the journal and of the rotation under a unit of each load on it: with
    /// w = (εy, −εx, 1), diag(1/m, 1/m, 0) + w wᵀ/Ip.
    pub(crate) fn compliance(&self, [ex, ey]: [f64; 2]) -> JournalCompliance {
        if let Some(guide) = self.guide {
            return guide;
        }
        let w = [ey, -ex, 1.0];
        let mut rows = w.map(|a| w.map(|b| a * b / self.polar_inertia));
        for (axis, row) in rows.iter_mut().enumerate().take(2) {
            row[axis] += 1.0 / self.mass;
        }
        rows
    }

    /// Change of the velocity of the surface of the journal of radius Rj along t by a unit of friction
    /// there, 1/kg: with a = Rj·n − ε·e^(i(θ+φ)), 1/m + (t·ia)²/Ip. With the compliance G of a guided
    /// journal and p = (t, Rj), pᵀ·G·p.
    #[inline(always)]
    pub(crate) fn mobility(&self, [nx, ny]: [f64; 2], radius: f64, [ex, ey]: [f64; 2]) -> f64 {
        match &self.guide {
            None => {
                // (t·ia) = a·n.
                let arm = radius - (ex * nx + ey * ny);
                1.0 / self.mass + arm * arm / self.polar_inertia
            }
            Some(compliance) => {
                let along = [-ny, nx, radius];
                let row = |[x, y, turn]: [f64; 3]| x * along[0] + y * along[1] + turn * along[2];
                row(compliance.map(row))
            }
        }
    }
}
