//! The page of `design`: one raceway judged, or the search for a better one.

use serde::Serialize;

use cageless::design::search::NEIGHBOURS_WIDER;

use crate::data::{Motion, Parameter, Provenance, Structure};
use crate::figures::search as figures;
use crate::figures::{design, shape};
use crate::geometry::{ContactTrack, RacewaySurface};
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::reproduce::DesignCurve;
use crate::search_tables as tables;
use crate::tables::parameter_table;

/// All that the page of `design` shows. What is left empty is left out of the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DesignData {
    /// Title of the case.
    pub title: String,
    /// Name and version of the program, instruction set.
    pub software: String,
    /// First paragraph: what was asked and what came out.
    pub lead: String,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Whether the case's own raceways pass; `None` without one.
    pub passes: Option<bool>,
    /// PASS or FAIL with the reason and the margin.
    pub headline: String,
    /// Numbers of the case's own raceways.
    pub results: Vec<Parameter>,
    /// What the verdict rests on.
    pub reasons: Vec<String>,
    /// Whether the raceway of the recommendation passes; `None` if there is none.
    pub recommendation_passes: Option<bool>,
    /// The raceway near the curve of Eq. (11) with its verdict; empty if there is none.
    pub recommendation: String,
    /// θ over lC by Eq. (11), with the case's structure and the limits.
    pub curve: Option<DesignCurve>,
    /// Contact track of the case's first raceway.
    pub contact_track: Option<ContactTrack>,
    /// Surface of the case's first raceway.
    pub surface: Option<RacewaySurface>,
    /// The balls of the run that was judged.
    pub motion: Option<Motion>,
    /// What a search found.
    pub search: Option<SearchData>,
    /// Case as computed, one line per key.
    pub parameters: Vec<Parameter>,
    /// Provenance of the verdict.
    pub provenance: Provenance,
}

/// What a search found, in display units.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SearchData {
    /// What was found, in sentences.
    pub findings: Vec<String>,
    /// Speeds and loads that a structure must bear.
    pub points: Vec<PointData>,
    /// Share of the steady gap that a raceway must guarantee.
    pub spread_min: f64,
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
    /// What excludes how many structures.
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
    pub paper: Vec<Structure>,
    /// Provenance of critical gaps and motion.
    pub provenance: Provenance,
}

/// Verdict of `design` on a structure at one operating point.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PointVerdict {
    /// `smooth`, `double-collision`, `slips` or `infeasible`.
    pub verdict: String,
    /// Whether the structure passes.
    pub passes: Option<bool>,
    /// PASS or FAIL with the verdict, the criterion that decides, and its margin.
    pub headline: String,
}

/// Speed and load.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PointNumbers {
    /// Critical gap, degrees.
    pub critical_gap_deg: Option<f64>,
    /// Steady gap less critical gap, degrees.
    pub margin_deg: Option<f64>,
    /// Share of β0 that slip takes.
    pub slip_shortfall: Option<f64>,
    /// Largest Hertz pressure at the outer raceway, GPa.
    pub stress_gpa: Option<f64>,
    /// Means over runs of all balls from uneven starts.
    pub motion: Option<MotionNumbers>,
    /// Standard errors of these, if known.
    pub errors: Option<MotionNumbers>,
}

/// Numbers of runs of all balls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MotionNumbers {
    /// Contacts between balls per ball and turn.
    pub collisions: f64,
    /// The same once the balls have been sorted.
    pub collisions_late: f64,
    /// Share of the passages hit by both neighbours.
    pub twice_share: f64,
    /// Impulse between balls per ball and turn, mN·s.
    pub impulse_mn_s: f64,
    /// Standard deviation of the gaps on arrival over the steady gap.
    pub unevenness: f64,
    /// Smallest gap on arrival, degrees.
    pub gap_min_deg: f64,
    /// Largest slip, mean over the passages, m/s.
    pub slip_m_s: f64,
    /// Share of the theoretical drop of orbital speed that the balls reach.
    pub speed_drop_share: f64,
    /// Standard deviation of the force on the outer ring, N.
    pub force_deviation_n: f64,
    /// Friction loss, W.
    pub friction_w: f64,
}

/// How many structures a reason excludes.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RejectionCount {
    /// Short name.
    pub reason: String,
    /// In words.
    pub meaning: String,
    /// Structures.
    pub count: usize,
}

/// One placement of raceways.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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

/// The page of `design`.
pub fn design_page(data: &DesignData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    for warning in &data.warnings {
        page.note(Note::Warning, warning);
    }
    if let Some(search) = &data.search {
        search_sections(&mut page, search);
    }
    if !data.results.is_empty() {
        page.section("The raceway of the case");
        page.verdict(data.passes, &data.headline);
        if data.search.is_some() && data.passes.is_some() {
            page.note(Note::Remark, &two_critical_gaps());
        }
        page.table(&parameter_table(
            "Verdict",
            "What the case's own outer ring comes to.",
            &data.results,
            Some(data.provenance.clone()),
        ));
        data.reasons
            .iter()
            .for_each(|reason| page.note(Note::Remark, reason));
    }
    if !data.recommendation.is_empty() {
        page.section("A raceway near the curve of Eq. (11)");
        page.verdict(data.recommendation_passes, &data.recommendation);
    }
    if let Some(curve) = &data.curve {
        let mut figure = design::curve(curve);
        figure.label = "Axial span and half angle".to_owned();
        page.figure(&figure);
    }
    if let Some(track) = &data.contact_track {
        let mut figure = shape::contact_track(track);
        figure.label = "Contact track".to_owned();
        page.figure(&figure);
    }
    if let Some(surface) = &data.surface {
        let mut figure = shape::surface(surface);
        figure.label = "Surface".to_owned();
        page.figure(&figure);
    }
    if let Some(motion) = &data.motion {
        page.section("Balls in motion");
        page.motion(&MotionFigure {
            label: "Motion".to_owned(),
            caption: "The last orbits of the run that was judged, to scale. The inner ring turns \
                      counter-clockwise, load and gravity point down; the discrete raceway is \
                      shaded orange, balls 1 and 2 blue, touching balls ringed."
                .to_owned(),
            bearings: vec![motion.clone()],
            moments_s: Vec::new(),
        });
    }
    if !data.parameters.is_empty() {
        page.section("The case as computed");
        page.table(&parameter_table(
            "Case",
            "Every key of the case.",
            &data.parameters,
            None,
        ));
    }
    page.html()
}

fn search_sections(page: &mut Page, search: &SearchData) {
    page.section("Recommendation");
    let several = search.points.len() > 1;
    for (point, verdict) in search.points.iter().zip(&search.recommended_verdicts) {
        let at = if several {
            format!("At {}, from even spacing: ", point.label())
        } else {
            String::new()
        };
        page.verdict(verdict.passes, &format!("{at}{}", verdict.headline));
    }
    search
        .findings
        .iter()
        .for_each(|finding| page.note(Note::Remark, finding));
    if search.recommended.is_some() || search.own.is_some() {
        page.table(&tables::comparison(search));
    }
    page.section("Where raceways work");
    page.paragraph(MAPS);
    page.figure(&figures::verdicts(search));
    page.figure(&figures::critical_gaps(search));
    page.table(&tables::rejections(search));
    if search.placements.len() > 1 {
        page.table(&tables::placements(search));
    }
    if !search.front.is_empty() {
        page.section("Trade-offs");
        page.figure(&figures::trade_offs(search));
        page.table(&tables::front(search));
    }
}

/// Why a raceway may have two critical gaps on one page.
pub fn two_critical_gaps() -> String {
    format!(
        "The critical gap in this section is measured with all other balls evenly spaced; the \
         critical gaps of the search are measured with the neighbours of the pair {:.0} % further \
         off, so that in a deep raceway they do not push the pair together. The two differ where \
         neighbours interfere, and there may be none here.",
        100.0 * (NEIGHBOURS_WIDER - 1.0)
    )
}

const MAPS: &str = "Each cell is a raceway of span lC and half angle θ. Its critical gap is the \
    largest with which a pair of balls still touches on its way through: the smallest gap that the \
    raceway guarantees. It must not exceed the steady gap, which evenly flowing balls have outside \
    the raceway, or they would collide for ever; and it must not be much smaller, or the raceway \
    hardly spreads them. Without slip it is β0 of Eq. (11); what it falls short of that is taken by \
    slip.";
