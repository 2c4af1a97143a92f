//! One simulation.

pub use cageless_study::CollisionPoint;
use serde::{Deserialize, Serialize};

use crate::data::{BearingOutline, Motion, Parameter, Provenance, RacewaySector, Vibration};
use crate::figure::Figure;
use crate::figures::{ball, collisions, energy, gap_map, history, polar, ring, vibration};
use crate::head::Head;
use crate::motion::MotionFigure;
use crate::page::{Note, Page};
use crate::sampling::range;
use crate::studio::studio_section;
use crate::tables::parameter_table;
use crate::text::short;
use crate::verification::{VerificationTable, verification_table};

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
    /// PASS or FAIL with the reason and the margin; empty if there is nothing to say.
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
    /// Highest peak pressure (Hertz) at the inner raceway, GPa.
    pub inner_pressure_max_gpa: Vec<f64>,
    /// Highest peak pressure (Hertz) at the outer raceway, GPa.
    pub outer_pressure_max_gpa: Vec<f64>,
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
    page.head(&Head::new(data.passes, &data.headline).facts(data.facts.clone()));
    for warning in &data.warnings {
        page.note(Note::Warning, warning);
    }
    section(
        &mut page,
        "Spacing and collisions",
        [
            gap_map::gap_map(data),
            history::gaps(data),
            collisions::collisions(data),
        ],
    );
    if !data.balls.is_empty() {
        let note = if data.sectors.is_empty() {
            FLATTENED
        } else {
            CLOSES
        };
        page.note(Note::Remark, note);
    }
    if data.collisions.is_empty() && !data.balls.is_empty() {
        page.note(Note::Remark, "No two balls touched.");
    }
    if let Some(motion) = &data.motion {
        page.section("Balls in motion");
        page.motion(&motion_figure(motion, &data.passages));
    }
    section(
        &mut page,
        "Loads, pressures and the inner ring",
        [
            polar::loads(data),
            ring::ring_orbit(data),
            energy::energy(data),
        ],
    );
    section(
        &mut page,
        "Motion of the balls",
        [history::orbit_speed(data), history::slip(data), None],
    );
    section(
        &mut page,
        "Ball 1",
        [ball::loads(data), ball::phase(data), None],
    );
    if let Some(signals) = &data.vibration {
        page.section("Vibration");
        page.figure(&vibration::vibration("Vibration", signals));
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
    if !data.parameters.is_empty() {
        page.section("The case as run");
        page.table(&parameter_table(
            "Case",
            "Every key of the case.",
            &data.parameters,
            None,
        ));
    }
    studio_section(&mut page, &data.case_toml, "");
    page.html()
}

/// Why a gap can be negative.
const FLATTENED: &str = "A gap is the angle between two balls less that at which they just touch: in \
    a contact, which flattens both, it is a little negative.";

/// Why pairs touch although the raceway spreads the balls.
const CLOSES: &str = "Inside the discrete raceway a pair closes up by design: the ball ahead slows \
    first, the one behind catches up and may touch it; the ball ahead leaves first and draws away, so \
    that the pair leaves with at least the critical gap. Contacts in the raceway are therefore no \
    fault by themselves; contacts with both neighbours in one passage are, and contacts elsewhere \
    show that the gaps have not settled. A gap is the angle between two balls less that at which they \
    just touch: in a contact, which flattens both, it is a little negative.";

fn section(page: &mut Page, title: &str, figures: [Option<Figure>; 3]) {
    if figures.iter().any(Option::is_some) {
        page.section(title);
    }
    figures.iter().flatten().for_each(|f| page.figure(f));
}

/// The balls of a run in motion, with its passages to choose from.
fn motion_figure(motion: &Motion, passages: &[(String, [f64; 2])]) -> MotionFigure {
    let (from, to) = range(&motion.time_s);
    MotionFigure {
        label: "Motion".to_owned(),
        caption: format!(
            "The balls from t = {} s to {} s, to scale. The inner ring turns counter-clockwise, \
             load and gravity point down; the discrete raceway is shaded orange, balls 1 and 2 \
             blue, balls in contact ringed. A passage or any stretch of time can be chosen, and \
             saved as an animated GIF.",
            short(from),
            short(to)
        ),
        bearings: vec![motion.clone()],
        moments_s: Vec::new(),
        stretches: passages.to_vec(),
    }
}
