//! Data of the page that reproduces Zhao 2022.

use cageless::closed_forms::CurvePoint;
use serde::{Deserialize, Serialize};

use crate::claim::Claim;
use crate::comparison::RingComparison;
use crate::data::{Event, Motion, Parameter, Provenance, RacewayLabel, Vibration};
use crate::geometry::{ContactTrack, RacewaySurface};

/// All that the reproduction of the paper shows.
///
/// Figures that exist once per formulation are vectors, one figure per entry. What is
/// left empty is left out of the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ReproduceData {
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was done and what came out.
    pub lead: String,
    /// Table 1 and what the paper leaves out.
    pub table1: Vec<Parameter>,
    /// Table 2.
    pub table2: Option<Table2>,
    /// Fig. 1b.
    pub contact_track: Option<ContactTrack>,
    /// Fig. 2.
    pub surface: Option<RacewaySurface>,
    /// Fig. 5.
    pub design_curve: Option<DesignCurve>,
    /// Fig. 6.
    pub gap_histories: Vec<GapHistory>,
    /// Fig. 7.
    pub neighbours: Vec<Neighbours>,
    /// Fig. 8.
    pub phase_portraits: Vec<PhasePortraits>,
    /// Fig. 9.
    pub orbit_speeds: Vec<OrbitSpeeds>,
    /// Fig. 12.
    pub vibrations: Vec<Vibration>,
    /// Section 5 with lots of balls of several grades.
    pub ring_comparison: Option<RingComparison>,
    /// Fig. 13 and 14: two bearings side by side, conventional first.
    pub motions: Vec<Motion>,
    /// The paper's claims.
    pub claims: Vec<Claim>,
    /// Structure (d) as TOML, for the studio in the page; without one if empty.
    pub case_toml: String,
}

/// Table 2: theory and critical gap of the ten structures.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Table2 {
    /// Computed columns, in the order of [`Table2Row::critical_gap_deg`].
    pub variants: Vec<Variant>,
    /// One row per structure.
    pub rows: Vec<Table2Row>,
    /// How far the computed gaps move with what the paper leaves open.
    pub spreads: Vec<Spread>,
    /// Provenance.
    pub provenance: Provenance,
}

/// A computed column of Table 2.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Variant {
    /// `paper`, `physical`, or [`Self::ELASTIC`]: physical on elastic flanks.
    pub formulation: String,
    /// `coulomb` or `smooth`.
    pub friction_law: String,
}

impl Variant {
    /// The formulation of the column with the flanks of metal, which the paper does not have.
    pub const ELASTIC: &str = "elastic";

    /// Whether the paper can be read as this.
    pub fn is_of_the_paper(&self) -> bool {
        self.formulation != Self::ELASTIC
    }
}

/// A row of Table 2.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Table2Row {
    /// The raceway.
    pub structure: RacewayLabel,
    /// β0 of Zhao 2022, Eq. (11), computed, degrees.
    pub theory_deg: f64,
    /// β0 by Eq. (11) with the ball's own ψ as variable of integration, degrees.
    pub theory_polar_deg: Option<f64>,
    /// β0 as printed, degrees.
    pub paper_theory_deg: f64,
    /// The paper's simulated value, degrees.
    pub paper_simulated_deg: f64,
    /// Computed critical gap per variant, degrees.
    pub critical_gap_deg: Vec<Option<f64>>,
    /// Remark that calls the row out; usually empty.
    pub remark: String,
}

/// How far the computed critical gap moves with one thing that the paper leaves open.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Spread {
    /// Change of the computation: `step 1 to 0.5 µs`, `start at ψ = −120°`, `touch read as δb > 0`.
    pub cause: String,
    /// Variant that was changed: `paper, coulomb`.
    pub variant: String,
    /// Change per row of Table 2, degrees.
    pub change_deg: Vec<Option<f64>>,
}

/// θ over lC such that the discrete raceway restores the nominal gap (Fig. 5).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DesignCurve {
    /// lC of the curve's points, mm.
    pub axial_span_mm: Vec<f64>,
    /// θ that satisfies Zhao 2022, Eq. (11), degrees.
    pub half_angle_deg: Vec<f64>,
    /// θ with the ball's own ψ in Eq. (11), degrees; may be empty.
    pub half_angle_polar_deg: Vec<f64>,
    /// The nominal gap that is asked for, degrees.
    pub uniform_gap_deg: f64,
    /// The paper's structures.
    pub paper: Vec<RacewayLabel>,
    /// Constraints drawn as lines.
    pub limits: Vec<DesignLimit>,
    /// Provenance.
    pub provenance: Provenance,
}

impl DesignCurve {
    /// The curve alone, nothing marked.
    pub fn new(points: &[CurvePoint], uniform_gap_deg: f64) -> Self {
        let degrees = |angle: Option<f64>| angle.map_or(f64::NAN, f64::to_degrees);
        Self {
            axial_span_mm: points.iter().map(|p| p.axial_span_m * 1e3).collect(),
            half_angle_deg: points.iter().map(|p| degrees(p.half_angle_rad)).collect(),
            half_angle_polar_deg: points
                .iter()
                .map(|p| degrees(p.half_angle_polar_rad))
                .collect(),
            uniform_gap_deg,
            ..Self::default()
        }
    }
}

/// A constraint on a discrete raceway.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DesignLimit {
    /// Which quantity it bounds.
    pub quantity: LimitedQuantity,
    /// Bound, mm or degrees.
    pub value: f64,
    /// Short label: `Eq. (8)`, `three balls inside: θ > (ε + β0)`.
    pub label: String,
}

impl DesignLimit {
    /// A bound, mm or degrees, with its label.
    pub fn new(quantity: LimitedQuantity, value: f64, label: &str) -> Self {
        let label = label.to_owned();
        Self {
            quantity,
            value,
            label,
        }
    }
}

/// Quantity bounded by a [`DesignLimit`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LimitedQuantity {
    /// lC, mm.
    AxialSpan,
    /// θ, degrees.
    HalfAngle,
}

/// Gap of one pair over a long time and over one turn (Fig. 6).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct GapHistory {
    /// The raceway.
    pub structure: RacewayLabel,
    /// Number of the ball behind, from 1.
    pub ball: usize,
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Gap to the ball ahead, degrees.
    pub gap_deg: Vec<f64>,
    /// End of the transient, s.
    pub settled_after_s: f64,
    /// Time of the enlargement, s: one turn, finely sampled.
    pub turn_time_s: Vec<f64>,
    /// Gap of the enlargement, degrees.
    pub turn_gap_deg: Vec<f64>,
    /// Ends of the stages, `a` to `e`.
    pub stages: Vec<Event>,
    /// The nominal gap β0, degrees.
    pub uniform_gap_deg: f64,
    /// Provenance.
    pub provenance: Provenance,
}

/// Three adjacent balls on their way through the discrete raceway (Fig. 7).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Neighbours {
    /// The raceway.
    pub structure: RacewayLabel,
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Orbital speed of balls i−1, i, i+1, degrees/s.
    pub orbit_speed_deg_s: [Vec<f64>; 3],
    /// Gap from i−1 to i and from i to i+1, degrees.
    pub gap_deg: [Vec<f64>; 2],
    /// Numbers of the three balls, from 1.
    pub balls: [usize; 3],
    /// `t0` to `t4`.
    pub events: Vec<Event>,
    /// Provenance.
    pub provenance: Provenance,
}

/// Phase portraits of ball 1, one per structure (Fig. 8).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PhasePortraits {
    /// Up to ten portraits.
    pub portraits: Vec<PhasePortrait>,
    /// Provenance; its case names what they share.
    pub provenance: Provenance,
}

/// Phase portrait of one ball.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PhasePortrait {
    /// The raceway.
    pub structure: RacewayLabel,
    /// `smooth`, `double collision`, `slips`: what we read from it.
    pub verdict: String,
    /// Position of the ball's centre, mm.
    pub x_mm: Vec<f64>,
    /// Velocity of the ball's centre, m/s.
    pub vx_m_s: Vec<f64>,
    /// Velocity of the ball's centre, m/s.
    pub vy_m_s: Vec<f64>,
}

/// Orbital speed of a ball against its place, for all structures (Fig. 9).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct OrbitSpeeds {
    /// One passage per structure.
    pub passages: Vec<OrbitSpeed>,
    /// Provenance.
    pub provenance: Provenance,
}

/// Orbital speed of a ball on its way through one discrete raceway.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct OrbitSpeed {
    /// The raceway.
    pub structure: RacewayLabel,
    /// `smooth`, `slips`, …
    pub verdict: String,
    /// ψ, degrees.
    pub angle_deg: Vec<f64>,
    /// Simulated, degrees/s.
    pub speed_deg_s: Vec<f64>,
    /// Pure rolling at the same ψ (Zhao 2022, Eq. (3)), degrees/s; may be empty.
    pub rolling_deg_s: Vec<f64>,
}
