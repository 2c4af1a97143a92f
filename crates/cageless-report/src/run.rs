//! One simulation.

pub use cageless_study::CollisionPoint;
use serde::{Deserialize, Serialize};

use crate::data::{BearingOutline, Motion, Parameter, Provenance, RacewaySector, Vibration};
use crate::figures::{history, vibration};
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::tables::parameter_table;
use crate::verification::{VerificationTable, verification_table};

/// Data of the page of one run. Empty parts are omitted from the page.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RunData {
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
    /// PASS or FAIL with the reason and the margin; empty if there is nothing to say.
    pub headline: String,
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
    /// The inner ring; of a run with such histories, the end of it.
    pub ring: RingHistory,
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
    pub inner_slip_m_s: Vec<f64>,
    /// ΔVo, m/s.
    pub outer_slip_m_s: Vec<f64>,
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
}

/// Ball 1 over the last part of a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Recent {
    /// Begin, s.
    pub from_s: f64,
    /// The ball.
    pub ball: BallHistory,
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

/// The page of one run.
pub fn run_page(data: &RunData) -> String {
    let mut page = Page::new(&data.title, &data.lead, &data.software);
    if !data.headline.is_empty() {
        page.verdict(data.passes, &data.headline);
    }
    for warning in &data.warnings {
        page.note(Note::Warning, warning);
    }
    if !data.results.is_empty() {
        page.section("Results");
        let source = Some(data.provenance.clone());
        page.table(&parameter_table(
            "Results",
            "Summary of results.",
            &data.results,
            source,
        ));
    }
    if let Some(verification) = &data.verification {
        page.section("Numerical verification");
        verification
            .facts
            .iter()
            .for_each(|fact| page.note(Note::Remark, fact));
        page.table(&verification_table(verification, data.provenance.clone()));
    }
    if let Some(motion) = &data.motion {
        page.section("Balls in motion");
        page.motion(&MotionFigure {
            label: "Motion".to_owned(),
            caption: "The balls over time, to scale. The inner ring turns counter-clockwise, load \
                      and gravity point down; the discrete raceway is shaded orange, balls 1 and \
                      2 blue, balls in contact ringed."
                .to_owned(),
            bearings: vec![motion.clone()],
            moments_s: Vec::new(),
        });
    }
    let sections: [(&str, [Option<crate::figure::Figure>; 3]); 3] = [
        (
            "Spacing and collisions",
            [history::gaps(data), history::collisions(data), None],
        ),
        (
            "Motion of the balls",
            [
                history::orbit_speed(data),
                history::slip(data),
                history::phase(data),
            ],
        ),
        (
            "Forces, ring and energy",
            [
                history::loads(data),
                history::ring_orbit(data),
                history::energy(data),
            ],
        ),
    ];
    for (title, figures) in &sections {
        if figures.iter().any(Option::is_some) {
            page.section(title);
            figures
                .iter()
                .flatten()
                .for_each(|figure| page.figure(figure));
        }
        if *title == "Spacing and collisions" && data.collisions.is_empty() {
            page.note(Note::Remark, "No two balls touched.");
        }
    }
    if let Some(signals) = &data.vibration {
        page.section("Vibration");
        page.figure(&vibration::vibration("Vibration", signals));
    }
    if !data.parameters.is_empty() {
        page.section("The case as run");
        page.table(&parameter_table(
            "Case",
            "Every key of the case.",
            &data.parameters,
            None,
        ));
    }
    page.html()
}
