//! The bearings of Zhao 2022: the structures of Table 2 and the two of the experiment, as they
//! stand in `cases/`.
//!
//! ```
//! use cageless::{FrictionLaw, Profile};
//! use cageless_study::paper;
//!
//! let reading = (Profile::Physical, FrictionLaw::Smooth);
//! let case = paper::structure(3, reading, &[])?; // structure (d)
//! assert_eq!(case.raceways[0].dimensions().axial_span_m, 5.1e-3);
//! # Ok::<(), cageless_io::case_file::CaseError>(())
//! ```

use cageless::{Bearing, Case, FrictionLaw, Profile};
use cageless_io::case_file::{CaseError, CaseFile, template};

use crate::{RacewayLabel, law_name, profile_name};

/// The ten structures of Table 2: lC in mm and θ in degrees.
pub const STRUCTURES: [(f64, f64); 10] = [
    (4.95, 35.0),
    (5.0, 30.5),
    (5.05, 27.5),
    (5.1, 25.2),
    (5.15, 23.5),
    (5.2, 22.0),
    (5.4, 18.167),
    (5.6, 15.774),
    (5.8, 14.062),
    (6.0, 12.717),
];

/// Structure of the experiment, (d).
const EXPERIMENT: usize = 3;

/// Letter of structure `k`.
fn letter(k: usize) -> char {
    char::from(b'a' + k as u8)
}

/// The case of the template, which is the bearing of Table 1, with the paper's method and
/// further overrides.
fn paper_case(conventional: bool, title: &str, overrides: &[String]) -> Result<Case, CaseError> {
    let paper = [
        format!("title=\"{title}\""),
        "solver.method=\"abm4\"".to_owned(),
        "solver.step_us=1.0".to_owned(),
    ];
    let all = [&paper, overrides].concat();
    Ok(CaseFile::parse(&template(conventional), title, &all)?
        .case()
        .clone())
}

/// lC and θ of structure `k`.
fn raceway_overrides(k: usize) -> [String; 2] {
    let (span_mm, angle_deg) = STRUCTURES[k];
    [
        format!("raceway.axial_span_mm={span_mm:?}"),
        format!("raceway.half_angle_deg={angle_deg:?}"),
    ]
}

/// The bearings of the experiment at 3000 rpm, Fig. 12 to 14: conventional, discrete.
///
/// # Errors
/// Never: the cases are sound.
pub fn experiment() -> Result<[Case; 2], CaseError> {
    // Not in the paper: the housing, and four bunches of balls, so that there is something to
    // spread apart.
    let both = [
        "operation.inner_speed_rpm=3000.0",
        "start.gaps=[0.05, 0.05, 0.05, 0.05, 6.2314, 0.05, 0.05, 0.05, 6.2314, 0.05, 0.05, 6.2314, \
         0.05, 6.2315]",
        "solver.duration_s=1.0",
        "housing.mass_kg=1.0",
        "housing.stiffness_n_m=1.0e8",
        "housing.damping_n_s_m=500.0",
    ]
    .map(str::to_owned);
    let title = "Zhao 2022, experiment: conventional outer ring at 3000 rpm";
    let conventional = paper_case(true, title, &both)?;
    let title = format!(
        "Zhao 2022, experiment: structure ({}) at 3000 rpm",
        letter(EXPERIMENT)
    );
    let discrete = [&both[..], &raceway_overrides(EXPERIMENT)].concat();
    Ok([conventional, paper_case(false, &title, &discrete)?])
}

/// Structure `k` under one reading of the equations, with further overrides
/// (`section.key=value`).
///
/// # Errors
/// An override is wrong.
pub fn structure(
    k: usize,
    reading: (Profile, FrictionLaw),
    overrides: &[String],
) -> Result<Case, CaseError> {
    let (span_mm, angle_deg) = STRUCTURES[k];
    let title = format!(
        "Zhao 2022, structure ({}): lC {span_mm:?} mm, θ {angle_deg:?}°",
        letter(k)
    );
    let all = [
        &raceway_overrides(k)[..],
        &reading_overrides(reading),
        overrides,
    ]
    .concat();
    paper_case(false, &title, &all)
}

fn reading_overrides((profile, law): (Profile, FrictionLaw)) -> [String; 2] {
    [
        format!("model.profile=\"{}\"", profile_name(profile)),
        format!("contact.friction_law=\"{}\"", law_name(law)),
    ]
}

/// How reports name structure `k`.
pub fn label(k: usize, case: &Case) -> RacewayLabel {
    RacewayLabel::new(&letter(k).to_string(), case.raceways.first())
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
    let reading = (Profile::Physical, FrictionLaw::Smooth);
    let mut here = vec![];
    for k in 0..STRUCTURES.len() {
        let case = structure(k, reading, &[])?;
        if geometry(&case.bearing) == geometry(bearing) {
            here.push(label(k, &case));
        }
    }
    Ok(here)
}
