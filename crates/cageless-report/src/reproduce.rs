//! Every table and figure of Zhao 2022 beside the paper's own numbers.

use cageless::design::CurvePoint;
use cageless::vibration::AFTER_CONTACT_S;
use serde::{Deserialize, Serialize};

use crate::claim::{Claim, ClaimStatus};
use crate::comparison::RingComparison;
use crate::data::{Event, Motion, Parameter, Provenance, RacewayLabel, Vibration};
use crate::figures::{self, comparison, design, orbit, phase, shape, spacing, vibration};
use crate::geometry::{ContactTrack, RacewaySurface};
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::studio::studio_section;
use crate::tables;
use crate::text::short;

/// All that the reproduction of the paper shows.
///
/// Figures that exist once per profile are vectors, one figure per entry. What is
/// left empty is left out of the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Variant {
    /// `paper` or `physical`.
    pub profile: String,
    /// `coulomb` or `smooth`.
    pub friction_law: String,
}

/// A row of Table 2.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Table2Row {
    /// The raceway.
    pub structure: RacewayLabel,
    /// β0 of Zhao 2022, Eq. (11), computed, degrees.
    pub theory_deg: f64,
    /// The same with the ball's own ψ as variable of integration, degrees.
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Spread {
    /// What is changed: `step 1 to 0.5 µs`, `start at ψ = −120°`, `touch read as δb > 0`.
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

/// What a [`DesignLimit`] bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LimitedQuantity {
    /// lC, mm.
    AxialSpan,
    /// θ, degrees.
    HalfAngle,
}

/// Gap of one pair over a long time and over one turn (Fig. 6).
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PhasePortraits {
    /// Up to ten portraits.
    pub portraits: Vec<PhasePortrait>,
    /// Provenance; its case names what they share.
    pub provenance: Provenance,
}

/// Phase portrait of one ball.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct OrbitSpeeds {
    /// One passage per structure.
    pub passages: Vec<OrbitSpeed>,
    /// Provenance.
    pub provenance: Provenance,
}

/// Orbital speed of a ball on its way through one discrete raceway.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
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

/// Moments of the high-speed photographs in the paper's Fig. 13 and 14, s.
const PHOTOGRAPHS_S: [f64; 4] = [0.05, 0.1, 0.15, 0.2];

/// The page with every table and figure of the paper.
pub fn reproduce_page(data: &ReproduceData) -> String {
    let mut page = Page::new(
        "Discrete dynamics of balls in cageless ball bearings, reproduced",
        &data.lead,
        &data.software,
    );
    page.head(&head(data));
    page.note(Note::Remark, SOURCE);
    if !data.claims.is_empty() {
        page.section("Claims of the paper and what was found");
        page.claims(&data.claims);
    }
    if !data.table1.is_empty() {
        page.section("Parameters");
        page.table(&tables::table1(&data.table1));
    }
    if data.contact_track.is_some() || data.surface.is_some() {
        page.section("The discrete raceway");
        data.contact_track
            .iter()
            .for_each(|t| page.figure(&shape::contact_track(t)));
        data.surface
            .iter()
            .for_each(|s| page.figure(&shape::surface(s)));
    }
    if let Some(curve) = &data.design_curve {
        page.section("Axial span and half angle");
        page.figure(&design::curve(curve));
    }
    if !data.gap_histories.is_empty() || !data.neighbours.is_empty() {
        page.section("Spacing of the balls");
        data.gap_histories
            .iter()
            .for_each(|g| page.figure(&spacing::gap_history(g)));
        data.neighbours
            .iter()
            .for_each(|n| page.figure(&spacing::neighbours(n)));
    }
    if let Some(table) = &data.table2 {
        page.section("Ten structures: theory and simulation");
        page.table(&tables::table2(table));
        tables::spread(table).iter().for_each(|t| page.table(t));
        page.figure(&design::table2(table));
    }
    if !data.phase_portraits.is_empty() {
        page.section("Phase portraits of ball 1");
        for portraits in &data.phase_portraits {
            page.figure(&phase::velocities(portraits));
            page.figure(&phase::positions(portraits));
        }
    }
    if !data.orbit_speeds.is_empty() {
        page.section("Orbital speed in the discrete raceway");
        data.orbit_speeds
            .iter()
            .for_each(|s| page.figure(&orbit::speeds(s)));
    }
    if !data.vibrations.is_empty() {
        page.section("Vibration");
        for vibration in &data.vibrations {
            let label = figures::labelled("Figure 12", &vibration.provenance);
            page.figure(&vibration::vibration(&label, vibration));
        }
    }
    if let Some(rings) = &data.ring_comparison {
        page.section("Rings compared with equal and unequal balls");
        page.paragraph(&format!(
            "{} At passing: the part of the power spectrum at the multiples of the balls' mean \
             orbital frequency, where everything lies that recurs with each orbit, contacts \
             included if they do; between: the rest. The squares of the two add up to that of the \
             RMS, start by start. Contacts cut out: the housing under the same force, but with a \
             straight line from each touch of two balls to {} ms after they part; contacts alone: \
             the housing under what was cut out. These two add up as signals; their squares do \
             not where they are correlated, as they are where balls stay in contact for much of a \
             passage: the line then takes out force of the passage as well, and the rest may \
             exceed the whole. Contacts: from touch to parting, in the part of the \
             run that is not discarded.",
            rings.starts,
            AFTER_CONTACT_S * 1e3
        ));
        page.paragraph(&format!(
            "Left out by the model: {}.",
            rings.left_out.join(", ")
        ));
        page.paragraph(&format!(
            "To repeat the comparison: {}. The raceways found by search: {}.",
            rings.command,
            rings.search_commands.join(", ")
        ));
        page.figure(&comparison::comparison(rings));
        rings.tables().iter().for_each(|t| page.table(t));
    }
    if !data.motions.is_empty() {
        page.section("Balls in motion");
        page.motion(&MotionFigure {
            label: "Figures 13 and 14".to_owned(),
            caption: "The balls over time, to scale. The inner ring turns counter-clockwise, load \
                      and gravity point down; the discrete raceway is shaded orange, balls 1 and \
                      2 blue, touching balls ringed. The buttons show the moments of the paper's \
                      photographs."
                .to_owned(),
            bearings: data.motions.clone(),
            moments_s: PHOTOGRAPHS_S.to_vec(),
            stretches: Vec::new(),
        });
    }
    studio_section(&mut page, &data.case_toml, STUDIO);
    page.html()
}

/// How many claims hold, and how far Table 2 is from the paper.
fn head(data: &ReproduceData) -> Head {
    let count = |status| data.claims.iter().filter(|c| c.status() == status).count();
    let facts = [
        ("Confirmed", count(ClaimStatus::Confirmed)),
        ("Partly confirmed", count(ClaimStatus::Partly)),
        ("Not confirmed", count(ClaimStatus::NotConfirmed)),
        ("Errata", count(ClaimStatus::Erratum)),
        ("Not tested", count(ClaimStatus::NotTested)),
    ];
    let facts = facts.map(|(name, count)| Parameter {
        name: name.to_owned(),
        value: count.to_string(),
        unit: "claims".to_owned(),
        ..Parameter::default()
    });
    let off = data.table2.iter().flat_map(|table| &table.rows).map(|row| {
        let own = row.theory_deg;
        (own - row.paper_theory_deg).abs()
    });
    let theory = off.reduce(f64::max).map(|most| Parameter {
        name: "β0 of Table 2, largest difference".to_owned(),
        value: short(most),
        unit: "°".to_owned(),
        ..Parameter::default()
    });
    if data.claims.is_empty() {
        return Head::default().facts(theory);
    }
    Head::default().facts(facts).facts(theory)
}

const STUDIO: &str = "Structure (d) of Table 2, the raceway of the experiment, with the equations of \
    the profile `physical`. Everything above stays as it was computed.";

const SOURCE: &str = "Zhao, Y.; Zhou, G.; Wang, Q. Discrete Dynamics of Balls in Cageless Ball \
    Bearings. Symmetry 2022, 14, 2242, doi 10.3390/sym14112242 (CC BY). Numbers of figures, tables \
    and equations are the paper's. Gap: angle from a ball to the ball ahead less the angle of two \
    balls in contact; 0 is contact. ψ: place of a ball, from the bottom, counter-clockwise.";
