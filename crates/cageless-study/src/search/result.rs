//! The result of a search in display units.

use serde::{Deserialize, Serialize};

use crate::{Provenance, RacewayLabel};

/// Result of a search, in display units.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct SearchData {
    /// Findings as sentences.
    pub findings: Vec<String>,
    /// Speeds and loads that a structure must bear.
    pub points: Vec<PointData>,
    /// Share of the steady gap that a raceway must guarantee.
    pub critical_gap_min_fraction: f64,
    /// Uneven starts per structure.
    pub starts: u64,
    /// Seed of the starts.
    pub seed: u64,
    /// The recommended structure, from more starts.
    pub recommended: Option<StructureData>,
    /// Verdict on the recommended structure, entered as the case's own, at each operating point.
    pub recommended_verdicts: Vec<PointVerdict>,
    /// The case's own structure, likewise.
    pub own: Option<StructureData>,
    /// The recommended structure from the starts that all had, to be compared with them.
    pub recommended_from_usual_starts: Option<StructureData>,
    /// The case's own structure, likewise.
    pub own_from_usual_starts: Option<StructureData>,
    /// The Pareto front, nearest to the best in everything first.
    pub front: Vec<StructureData>,
    /// Every structure of the band.
    pub band: Vec<StructureData>,
    /// Number of designs excluded by each reason.
    pub rejections: Vec<RejectionCount>,
    /// Places of the raceways that were tried.
    pub placements: Vec<PlacementData>,
    /// Maps over lC and θ.
    pub maps: Vec<MapData>,
    /// θ over lC by Eq. (11).
    pub curve_axial_span_mm: Vec<f64>,
    /// θ by Eq. (11), degrees.
    pub curve_half_angle_deg: Vec<f64>,
    /// Structures of the paper, if this is its bearing.
    pub paper: Vec<RacewayLabel>,
    /// Provenance of critical gaps and motion.
    pub provenance: Provenance,
}

/// Verdict of `design` on a structure at one operating point.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PointVerdict {
    /// `smooth`, `double-collision`, `slips` or `infeasible`.
    pub verdict: String,
    /// Whether the structure passes.
    pub passes: Option<bool>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
}

/// Speed and load.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PointData {
    /// Speed of the inner ring, rpm.
    pub inner_speed_rpm: f64,
    /// Load, N.
    pub radial_load_n: f64,
}

impl PointData {
    /// `12000 rpm, 1500 N`.
    pub fn label(&self) -> String {
        format!("{:.0} rpm, {} N", self.inner_speed_rpm, self.radial_load_n)
    }
}

/// A structure and what is known of it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct StructureData {
    /// lC, mm.
    pub axial_span_mm: f64,
    /// θ, degrees.
    pub half_angle_deg: f64,
    /// ψ of the middle of each raceway, degrees.
    pub centre_angles_deg: Vec<f64>,
    /// `accepted`, `rejected`, or `left out` by the budget.
    pub status: String,
    /// Whether every requirement is met; null if it was left out.
    pub passes: Option<bool>,
    /// Short name of the reason of a rejection: `slips`, `eq-9`.
    pub reason: Option<String>,
    /// The reason in words; empty if there is none.
    pub why: String,
    /// Whether it is on the Pareto front.
    pub on_front: bool,
    /// β0 of Eq. (11), degrees.
    pub beta0_deg: Option<f64>,
    /// Gap outside the raceways in steady flow, degrees.
    pub steady_gap_deg: Option<f64>,
    /// Numbers at each operating point.
    pub points: Vec<PointNumbers>,
}

impl StructureData {
    /// `lC 5.1 mm, θ 25.2°`, with the places unless there is one at the bottom.
    pub fn label(&self) -> String {
        let size = format!(
            "lC {:.3} mm, θ {:.2}°",
            self.axial_span_mm, self.half_angle_deg
        );
        match self.centre_angles_deg.as_slice() {
            [0.0] => size,
            places => {
                let places: Vec<String> = places.iter().map(|p| format!("{p:.0}°")).collect();
                format!("{size} at ψ = {}", places.join(", "))
            }
        }
    }
}

/// Numbers of a structure at one operating point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PointNumbers {
    /// Critical gap, degrees.
    pub critical_gap_deg: Option<f64>,
    /// Steady gap less critical gap, degrees.
    pub margin_deg: Option<f64>,
    /// Share of β0 that slip takes.
    pub slip_shortfall: Option<f64>,
    /// Largest Hertz pressure at the outer raceway, MPa.
    pub pressure_mpa: Option<f64>,
    /// Means over runs of all balls from uneven starts.
    pub motion: Option<MotionNumbers>,
    /// Standard errors of these, if known.
    pub errors: Option<MotionNumbers>,
}

/// Numbers of runs of all balls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct MotionNumbers {
    /// Contacts between balls per ball and orbit.
    pub collisions: f64,
    /// Collisions per ball and orbit in steady state (second half of the run).
    pub collisions_late: f64,
    /// Share of the passages hit by both neighbours.
    pub double_collision_fraction: f64,
    /// Impulse between balls per ball and orbit, mN·s.
    pub impulse_mn_s: f64,
    /// Standard deviation of the gaps on arrival over the steady gap.
    pub spacing_scatter: f64,
    /// Smallest gap on arrival, degrees.
    pub gap_min_deg: f64,
    /// Largest slip, mean over the passages, m/s.
    pub sliding_m_s: f64,
    /// Share of the theoretical drop of orbital speed that the balls reach.
    pub speed_drop_fraction: f64,
    /// Standard deviation of the force on the outer ring, N.
    pub force_deviation_n: f64,
    /// Friction loss, W.
    pub friction_w: f64,
}

/// Number of designs that a reason excludes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RejectionCount {
    /// Short name.
    pub reason: String,
    /// In words.
    pub meaning: String,
    /// Structures.
    pub count: usize,
}

/// One placement of raceways.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlacementData {
    /// ψ of the middles, degrees.
    pub centre_angles_deg: Vec<f64>,
    /// Structures looked at.
    pub structures: usize,
    /// Structures that are acceptable.
    pub accepted: usize,
    /// Least share of β0 that slip takes from any that spreads the balls.
    pub least_shortfall: Option<f64>,
    /// The acceptable one nearest to the best in everything.
    pub best: Option<StructureData>,
}

/// Critical gaps and verdicts over lC (columns) and θ (rows).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MapData {
    /// Speed and load.
    pub point: PointData,
    /// lC of the columns, mm.
    pub axial_span_mm: Vec<f64>,
    /// θ of the rows, degrees.
    pub half_angle_deg: Vec<f64>,
    /// Critical gap, degrees.
    pub critical_gap_deg: Vec<Vec<Option<f64>>>,
    /// Steady gap, degrees.
    pub steady_gap_deg: Vec<Vec<Option<f64>>>,
    /// `smooth`, or the short name of the reason of a rejection.
    pub verdict: Vec<Vec<String>>,
    /// Whether every requirement is met.
    pub passes: Vec<Vec<bool>>,
}
