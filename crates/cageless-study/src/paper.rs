//! The structures of Zhao 2022, Table 2, as they stand in `cases/`.

use cageless::{Bearing, Case, FrictionLaw, Profile};
use cageless_io::case_file::{CaseError, CaseFile};

use crate::{Structure, law_name, profile_name};

macro_rules! case_text {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../../../cases/", $name, ".toml")),
        )
    };
}

/// The ten structures: name and text of the case file.
pub const STRUCTURES: [(&str, &str); 10] = [
    case_text!("zhao-a"),
    case_text!("zhao-b"),
    case_text!("zhao-c"),
    case_text!("zhao-d"),
    case_text!("zhao-e"),
    case_text!("zhao-f"),
    case_text!("zhao-g"),
    case_text!("zhao-h"),
    case_text!("zhao-i"),
    case_text!("zhao-j"),
];

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
    let mut all = reading_overrides(reading).to_vec();
    all.extend_from_slice(overrides);
    let (name, text) = STRUCTURES[k];
    let file = CaseFile::parse(text, &format!("cases/{name}.toml"), &all)?;
    Ok(file.case().clone())
}

fn reading_overrides((profile, law): (Profile, FrictionLaw)) -> [String; 2] {
    [
        format!("model.profile=\"{}\"", profile_name(profile)),
        format!("contact.friction_law=\"{}\"", law_name(law)),
    ]
}

/// How reports name structure `k`.
pub fn label(k: usize, case: &Case) -> Structure {
    let letter = char::from(b'a' + k as u8).to_string();
    Structure::new(&letter, case.raceways.first())
}

/// The structures of the paper, if `bearing` is the paper's; else none.
///
/// # Errors
/// Never: the case files are sound.
pub fn structures_of(bearing: &Bearing) -> Result<Vec<Structure>, CaseError> {
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
