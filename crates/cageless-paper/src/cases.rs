//! The bearings of Zhao 2022: the structures of Table 2 and the two of the experiment, as they
//! stand in `cases/`.
//!
//! ```
//! use cageless_paper::{Reading, structure};
//!
//! let case = structure(3, Reading::CONSISTENT, &[])?; // structure (d)
//! assert_eq!(case.raceways[0].dimensions().axial_span_m, 5.1e-3);
//! # Ok::<(), cageless_io::case_file::CaseError>(())
//! ```

use cageless::reference::{Structure, StructureRow};
use cageless::{Bearing, Case, Formulation, FrictionModel};
use cageless_io::case_file::{CaseError, CaseFile, template};

use cageless_study::RacewayLabel;

/// Equations of motion with a friction law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Set of equations.
    pub formulation: Formulation,
    /// Friction law of the raceways.
    pub law: FrictionModel,
}

impl Reading {
    /// The equations as published, with their friction law.
    pub const PUBLISHED: Self = Self::new(Formulation::Paper, FrictionModel::Coulomb);
    /// The physically consistent equations, with theirs.
    pub const CONSISTENT: Self = Self::new(Formulation::Physical, FrictionModel::Smooth);

    pub(crate) const fn new(formulation: Formulation, law: FrictionModel) -> Self {
        Self { formulation, law }
    }

    /// Both names: `paper, coulomb`.
    pub(crate) fn names(self) -> String {
        format!("{}, {}", self.formulation.name(), self.law.name())
    }

    fn overrides(self) -> [String; 2] {
        [
            format!("model.formulation=\"{}\"", self.formulation.name()),
            format!("contact.friction_law=\"{}\"", self.law.name()),
        ]
    }
}

/// The two readings: as published, and physically consistent.
pub(crate) const READINGS: [Reading; 2] = [Reading::PUBLISHED, Reading::CONSISTENT];

/// A row of Table 2 with the judgement of Section 4.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Published {
    /// Letter in Fig. 8.
    pub letter: char,
    /// Axial span lC, mm.
    pub axial_span_mm: f64,
    /// Half angle θ, degrees.
    pub half_angle_deg: f64,
    /// β0 of Eq. (11), degrees.
    pub theory_deg: f64,
    /// Simulated value, degrees.
    pub simulated_deg: f64,
    /// Judgement of Section 4.3, in the words of `design`.
    pub verdict: &'static str,
}

/// The ten structures: Zhao 2022, Table 2 and Section 4.3.
#[rustfmt::skip]
pub const PUBLISHED: [Published; 10] = [
    published('a', Structure::A, "double-collision"),
    published('b', Structure::B, "double-collision"),
    published('c', Structure::C, "double-collision"),
    published('d', Structure::D, "smooth"),
    published('e', Structure::E, "smooth"),
    published('f', Structure::F, "smooth"),
    published('g', Structure::G, "slips"),
    published('h', Structure::H, "slips"),
    published('i', Structure::I, "slips"),
    published('j', Structure::J, "slips"),
];

/// A row of Table 2 with its letter and judgement.
const fn published(letter: char, structure: Structure, verdict: &'static str) -> Published {
    let StructureRow {
        axial_span_mm,
        half_angle_deg,
        theoretical_gap_deg,
        simulated_gap_deg,
    } = structure.row();
    Published {
        letter,
        axial_span_mm,
        half_angle_deg,
        theory_deg: theoretical_gap_deg,
        simulated_deg: simulated_gap_deg,
        verdict,
    }
}

/// Row of the structure lC = 5.60 mm, which does not follow its neighbours.
pub const ODD_ROW: usize = 7;

/// Structure of the experiment, (d).
const EXPERIMENT: usize = 3;

/// The case of the template, which is the bearing of Table 1, with the paper's method and
/// further overrides.
fn paper_case(
    conventional: bool,
    title: &str,
    overrides: &[String],
) -> Result<CaseFile, CaseError> {
    let paper = [
        format!("title=\"{title}\""),
        "solver.method=\"abm4\"".to_owned(),
        "solver.step_us=1.0".to_owned(),
    ];
    let all = [&paper, overrides].concat();
    CaseFile::parse(&template(conventional), title, &all)
}

/// lC and θ of structure `k`.
fn raceway_overrides(k: usize) -> [String; 2] {
    let Published {
        axial_span_mm,
        half_angle_deg,
        ..
    } = PUBLISHED[k];
    [
        format!("raceway.axial_span_mm={axial_span_mm:?}"),
        format!("raceway.half_angle_deg={half_angle_deg:?}"),
    ]
}

/// Housing of the experiment, which the paper does not give.
pub(crate) const HOUSING: [&str; 3] = [
    "housing.mass_kg=1.0",
    "housing.stiffness_n_m=1.0e8",
    "housing.damping_n_s_m=500.0",
];

/// The bearings of the experiment at 3000 rpm, Fig. 12 to 14: conventional, discrete.
///
/// # Errors
/// Never: the cases are sound.
pub fn experiment() -> Result<[CaseFile; 2], CaseError> {
    // Not in the paper: four bunches of balls for the raceway to spread apart.
    let both = [
        "operation.inner_speed_rpm=3000.0",
        "start.gaps=[0.05, 0.05, 0.05, 0.05, 6.2314, 0.05, 0.05, 0.05, 6.2314, 0.05, 0.05, 6.2314, \
         0.05, 6.2315]",
        "solver.duration_s=1.0",
    ];
    let both: Vec<String> = both.into_iter().chain(HOUSING).map(str::to_owned).collect();
    let title = "Zhao 2022, experiment: conventional outer ring at 3000 rpm";
    let conventional = paper_case(true, title, &both)?;
    let title = format!(
        "Zhao 2022, experiment: structure ({}) at 3000 rpm",
        PUBLISHED[EXPERIMENT].letter
    );
    let discrete = [&both[..], &raceway_overrides(EXPERIMENT)].concat();
    let discrete = paper_case(false, &title, &discrete)?;
    Ok([conventional, discrete])
}

/// Structure `k` under one reading of the equations, with further overrides
/// (`section.key=value`).
///
/// # Errors
/// An override is wrong.
pub fn structure(k: usize, reading: Reading, overrides: &[String]) -> Result<Case, CaseError> {
    Ok(structure_file(k, reading, overrides)?.case().clone())
}

/// The case file of [`structure`].
pub(crate) fn structure_file(
    k: usize,
    reading: Reading,
    overrides: &[String],
) -> Result<CaseFile, CaseError> {
    let Published {
        letter,
        axial_span_mm,
        half_angle_deg,
        ..
    } = PUBLISHED[k];
    let title =
        format!("Zhao 2022, structure ({letter}): lC {axial_span_mm:?} mm, θ {half_angle_deg:?}°");
    let all = [&raceway_overrides(k)[..], &reading.overrides(), overrides].concat();
    paper_case(false, &title, &all)
}

/// Label of structure `k` in reports.
pub fn label(k: usize, case: &Case) -> RacewayLabel {
    RacewayLabel::new(&PUBLISHED[k].letter.to_string(), case.raceways.first())
}

/// The structures of the paper, if `bearing` is the paper's; else none.
///
/// # Errors
/// Never: the case files are sound.
pub fn structures_of(bearing: &Bearing) -> Result<Vec<RacewayLabel>, CaseError> {
    // Curvatures, masses and damping are not the paper's.
    let geometry = |bearing: &Bearing| {
        let d = bearing.dimensions();
        (
            d.balls,
            d.ball_radius_m,
            d.inner_groove_bottom_radius_m,
            d.outer_groove_bottom_radius_m,
            d.outer_shoulder_radius_m,
        )
    };
    let mut here = vec![];
    for k in 0..PUBLISHED.len() {
        let case = structure(k, Reading::CONSISTENT, &[])?;
        if geometry(&case.bearing) == geometry(bearing) {
            here.push(label(k, &case));
        }
    }
    Ok(here)
}
