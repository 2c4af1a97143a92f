//! A case file as data: exactly the keys of the TOML, in the units of the file.
//! The last words of each name are its unit; [`cageless::Case`] says what each
//! quantity is.

use cageless::{FrictionLaw, Method, Profile};
use serde::{Serialize, Serializer};

use super::error::CaseError;
use super::named;

/// A whole case file, every default filled in. Serialised, it is the case in
/// `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CaseDocument {
    /// Version of the file format.
    pub schema: u64,
    /// Free text.
    pub title: String,
    /// Rings and balls.
    pub bearing: BearingDocument,
    /// Material of rings and balls.
    pub material: MaterialDocument,
    /// Discrete raceways: none in a conventional bearing. One is written as a
    /// `[raceway]`, several as `[[raceway]]`.
    #[serde(
        skip_serializing_if = "Vec::is_empty",
        serialize_with = "one_or_several"
    )]
    pub raceway: Vec<RacewayDocument>,
    /// Speed and load.
    pub operation: OperationDocument,
    /// Friction, damping and stiffness.
    pub contact: ContactDocument,
    /// The set of equations.
    pub model: ModelDocument,
    /// Initial state.
    pub start: StartDocument,
    /// Integration.
    pub solver: SolverDocument,
    /// Support of the outer ring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub housing: Option<HousingDocument>,
    /// Output of a run.
    pub output: OutputDocument,
    /// Ranges of a search for the raceway.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub search: Option<SearchDocument>,
}

impl CaseDocument {
    /// The document as a case file.
    ///
    /// # Errors
    /// A [`CaseError`] if TOML cannot hold it: a seed above 2^63 − 1.
    pub fn to_toml(&self) -> Result<String, CaseError> {
        toml::to_string(self)
            .map_err(|e| CaseError::of_file("case", format!("cannot be written as TOML: {e}")))
    }
}

fn one_or_several<S: Serializer>(list: &[RacewayDocument], s: S) -> Result<S::Ok, S::Error> {
    match list {
        [one] => one.serialize(s),
        several => several.serialize(s),
    }
}

/// `[bearing]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingDocument {
    /// N, number of balls.
    pub balls: usize,
    /// Rw.
    pub ball_radius_mm: f64,
    /// Ri.
    pub inner_groove_bottom_radius_mm: f64,
    /// Ro.
    pub outer_groove_bottom_radius_mm: f64,
    /// Ros.
    pub outer_shoulder_radius_mm: f64,
    /// Radius of the inner groove in the meridian plane.
    pub inner_groove_curvature_radius_mm: f64,
    /// Re.
    pub outer_groove_curvature_radius_mm: f64,
    /// Mass of the inner ring with what turns with it.
    pub inner_ring_mass_kg: f64,
    /// C of Zhao 2022, Eq. (14).
    pub inner_ring_drag_n_s_m: f64,
    /// Deviation of each ball's radius from the nominal one, µm; all zero if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_radius_deviation_um: Option<Vec<f64>>,
    /// Outer radius of the outer ring, for export.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_ring_outer_radius_mm: Option<f64>,
    /// Width of the outer ring, for export.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_ring_width_mm: Option<f64>,
}

/// `[material]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialDocument {
    /// Density.
    pub density_kg_m3: f64,
    /// E.
    pub youngs_modulus_gpa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
}

/// `[raceway]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RacewayDocument {
    /// lC.
    pub axial_span_mm: f64,
    /// θ.
    pub half_angle_deg: f64,
    /// ψ of the raceway centre, rad.
    pub centre_angle_deg: f64,
    /// Depth error at the centre, m.
    pub depth_error_um: f64,
}

/// `[operation]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OperationDocument {
    /// ωi.
    pub inner_speed_rpm: f64,
    /// Fr.
    pub radial_load_n: f64,
    /// g.
    pub gravity_m_s2: f64,
}

/// `[contact]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactDocument {
    /// μ.
    pub friction_coefficient: f64,
    /// Law of friction.
    #[serde(serialize_with = "named::serialize")]
    pub friction_law: FrictionLaw,
    /// μs of the Stribeck law.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub static_friction_coefficient: Option<f64>,
    /// Sliding speed over which the Stribeck law falls from μs to μ by 1/e.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stribeck_speed_m_s: Option<f64>,
    /// Sliding speed at the knee of the smooth law.
    pub slip_scale_m_s: f64,
    /// c of the raceway contacts, N·s·m^(−3/2).
    pub damping: f64,
    /// Coefficient of restitution between balls.
    pub ball_restitution: f64,
    /// K at the inner raceway, N·m^(−3/2); from Hertz if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner_stiffness: Option<f64>,
    /// K at the outer raceway, N·m^(−3/2); from Hertz if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_stiffness: Option<f64>,
    /// K between balls, N·m^(−3/2); from Hertz if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_stiffness: Option<f64>,
}

/// `[model]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModelDocument {
    /// The set of equations.
    #[serde(serialize_with = "named::serialize")]
    pub profile: Profile,
}

/// Kind of initial state; [`cageless::Start`] has the details.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartState {
    /// Static equilibrium at speed.
    Settled,
    /// Pure rolling, ring where put.
    Rolling,
}

/// `[start]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StartDocument {
    /// Kind of initial state.
    #[serde(serialize_with = "named::serialize")]
    pub state: StartState,
    /// Centre of the inner ring: only for [`StartState::Rolling`], there 0 if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring_x_um: Option<f64>,
    /// Centre of the inner ring: only for [`StartState::Rolling`], there 0 if `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring_y_um: Option<f64>,
    /// Gaps between neighbouring balls.
    pub gaps: GapsDocument,
    /// ψ of ball 1.
    pub lead_ball_angle_deg: f64,
}

/// `start.gaps`: `"uniform"` or a list.
#[derive(Debug, Clone, PartialEq)]
pub enum GapsDocument {
    /// All the same.
    Uniform,
    /// N gaps in degrees; gap k lies between ball k and ball k+1.
    ListDeg(Vec<f64>),
}

impl Serialize for GapsDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Uniform => serializer.serialize_str("uniform"),
            Self::ListDeg(gaps) => gaps.serialize(serializer),
        }
    }
}

/// `[solver]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolverDocument {
    /// Integration method.
    #[serde(serialize_with = "named::serialize")]
    pub method: Method,
    /// Step; the largest one of the adaptive method.
    pub step_us: StepDocument,
    /// Error per step of the adaptive method.
    pub tolerance: f64,
    /// Simulated time.
    pub duration_s: f64,
    /// Seed of whatever is random, at most 2^63 − 1.
    pub seed: u64,
}

/// `solver.step_us`: `"auto"` or a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepDocument {
    /// Step from the stiffest contact and the method.
    Auto,
    /// In microseconds.
    FixedUs(f64),
}

impl Serialize for StepDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Auto => serializer.serialize_str("auto"),
            Self::FixedUs(step) => serializer.serialize_f64(*step),
        }
    }
}

/// `[housing]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HousingDocument {
    /// Mass of housing and outer ring.
    pub mass_kg: f64,
    /// Stiffness of the support.
    pub stiffness_n_m: f64,
    /// Damping of the support.
    pub damping_n_s_m: f64,
}

/// `[output]`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputDocument {
    /// Time between rows.
    pub interval_us: f64,
}

/// `[search]`: what `design --search` looks at. What is `None` is that of the case, or all
/// that the geometry allows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SearchDocument {
    /// Operating speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner_speed_rpm: Option<RangeDocument>,
    /// Operating loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radial_load_n: Option<RangeDocument>,
    /// Spans lC.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_span_mm: Option<RangeDocument>,
    /// Angles θ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub half_angle_deg: Option<RangeDocument>,
    /// Places of one raceway.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_angle_deg: Option<RangeDocument>,
    /// Raceways at most.
    pub raceways_max: usize,
    /// Share of the steady gap that the raceway must guarantee.
    pub spread_min: f64,
    /// Uneven starts per structure.
    pub starts: u64,
    /// Runs of all balls at most.
    pub budget: usize,
    /// Further speeds to draw maps at.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map_speed_rpm: Option<Vec<f64>>,
}

/// A number, or the lowest and the highest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeDocument {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

impl Serialize for RangeDocument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.low == self.high {
            serializer.serialize_f64(self.low)
        } else {
            [self.low, self.high].serialize(serializer)
        }
    }
}
