//! Data of the page of a run.

pub use cageless_study::CollisionPoint;
use serde::{Deserialize, Serialize};

use crate::data::{BearingOutline, Motion, Parameter, Provenance, RacewaySector, Vibration};
use crate::verification::VerificationTable;

/// Data of the page of one run. Empty parts are omitted from the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RunData {
    /// The case as TOML, for the studio in the page; without one if empty.
    #[serde(default)]
    pub case_toml: String,
    /// Title of the case.
    pub title: String,
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was run and what came out.
    pub lead: String,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Whether the passages of the run keep the limits; `None` if none was judged.
    pub passes: Option<bool>,
    /// Whether it works, with the reason and the margin; empty if there is nothing to say.
    pub headline: String,
    /// Key numbers for the top of the page, the most important first.
    pub facts: Vec<Parameter>,
    /// Case as run, one line per key.
    pub parameters: Vec<Parameter>,
    /// Results of `summary.json`, one line per key.
    pub results: Vec<Parameter>,
    /// Rings and balls.
    pub outline: BearingOutline,
    /// Discrete raceways.
    pub sectors: Vec<RacewaySector>,
    /// End of the transient, s.
    pub settled_after_s: f64,
    /// The nominal gap 360°/N − ε, degrees.
    pub uniform_gap_deg: f64,
    /// Orbital speed of pure rolling on the plain raceway, degrees/s.
    pub rolling_orbit_speed_deg_s: Option<f64>,
    /// Time of the histories, s.
    pub time_s: Vec<f64>,
    /// Histories of the balls, ball 1 first.
    pub balls: Vec<BallHistory>,
    /// If the histories give the lowest and the highest value of stretches of the run, two
    /// rows for each, their length, s.
    pub stretch_s: Option<f64>,
    /// The end of a run with such histories, row by row.
    pub recent: Option<Recent>,
    /// Stretch of time that figures show first, the last orbits of the balls, s.
    pub view_s: Option<[f64; 2]>,
    /// The inner ring at the end of the run.
    pub ring: RingHistory,
    /// Loads and pressures around the bearing.
    pub load_profile: Option<LoadProfile>,
    /// Contacts between balls, of too many the strongest.
    pub collisions: Vec<CollisionPoint>,
    /// Total number of collisions.
    pub collisions_total: usize,
    /// Terms of the energy balance.
    pub energy: Vec<EnergyItem>,
    /// Energy balance error relative to the sum of all flows.
    pub energy_residual_relative: Option<f64>,
    /// Numerical verification of the run.
    pub verification: Option<VerificationTable>,
    /// Vibration of the outer ring.
    pub vibration: Option<Vibration>,
    /// The balls in motion.
    pub motion: Option<Motion>,
    /// Passages of the balls while their motion was recorded: name, from, to in s.
    pub passages: Vec<(String, [f64; 2])>,
    /// Provenance of every figure.
    pub provenance: Provenance,
}

/// One ball over [`RunData::time_s`]; a history left empty is not drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BallHistory {
    /// ψ, degrees, continuous.
    pub angle_deg: Vec<f64>,
    /// Gap to the ball ahead, degrees.
    pub gap_deg: Vec<f64>,
    /// Orbital speed, degrees/s.
    pub orbit_speed_deg_s: Vec<f64>,
    /// ΔVi, m/s.
    pub inner_sliding_m_s: Vec<f64>,
    /// ΔVo, m/s.
    pub outer_sliding_m_s: Vec<f64>,
    /// Fi, N.
    pub inner_force_n: Vec<f64>,
    /// Fo, N.
    pub outer_force_n: Vec<f64>,
    /// Centre, mm.
    pub x_mm: Vec<f64>,
    /// Velocity of the centre, m/s.
    pub vx_m_s: Vec<f64>,
    /// Velocity of the centre, m/s.
    pub vy_m_s: Vec<f64>,
    /// Distance of the centre from the bearing axis, m; like the next two empty in the plane.
    #[serde(default)]
    pub distance_m: Vec<f64>,
    /// z of the centre, m.
    #[serde(default)]
    pub z_m: Vec<f64>,
    /// Contact angle at the inner raceway, rad; NaN without contact.
    #[serde(default)]
    pub inner_contact_angle_rad: Vec<f64>,
}

/// The balls over the last part of a run, row by row.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Recent {
    /// Time, s.
    pub time_s: Vec<f64>,
    /// The balls, ball 1 first.
    pub balls: Vec<BallHistory>,
}

impl Recent {
    /// Begin, s.
    pub fn from_s(&self) -> f64 {
        self.time_s.first().copied().unwrap_or_default()
    }
}

/// Loads and pressures of all balls over the angular position.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct LoadProfile {
    /// Begin of the part of the run, s.
    pub from_s: f64,
    /// End of it, s.
    pub to_s: f64,
    /// ψ of the middles of the steps, degrees.
    pub angle_deg: Vec<f64>,
    /// Mean of Fi, N; NaN where no ball was seen.
    pub inner_force_mean_n: Vec<f64>,
    /// Largest Fi, N.
    pub inner_force_max_n: Vec<f64>,
    /// Mean of Fo, N.
    pub outer_force_mean_n: Vec<f64>,
    /// Largest Fo, N.
    pub outer_force_max_n: Vec<f64>,
    /// Highest peak pressure (Hertz) at the inner raceway, MPa.
    pub inner_pressure_max_mpa: Vec<f64>,
    /// Highest peak pressure (Hertz) at the outer raceway, MPa.
    pub outer_pressure_max_mpa: Vec<f64>,
}

/// The centre of the inner ring.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RingHistory {
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Centre, µm.
    pub x_um: Vec<f64>,
    /// Centre, µm.
    pub y_um: Vec<f64>,
}

/// An entry of the ledger of energy.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct EnergyItem {
    /// Name of the quantity.
    pub name: String,
    /// Energy, J; positive into the bearing.
    pub energy_j: f64,
}
