//! The cases of the paper, as they stand in `cases/`, and its numbers.

use cageless::{Case, FrictionLaw, Profile};
use cageless_io::case_file::CaseFile;
use cageless_report::Structure;

use crate::failure::Failure;
use cageless_report::run_report::profile_name;

macro_rules! case_text {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../../../../cases/", $name, ".toml")),
        )
    };
}

/// The ten structures.
const STRUCTURES: [(&str, &str); 10] = [
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

const EXPERIMENT: [(&str, &str); 2] = [
    case_text!("experiment-3000rpm-conventional"),
    case_text!("experiment-3000rpm"),
];

/// What the paper says of one structure.
pub struct Published {
    /// β0 of Eq. (11), Table 2, degrees.
    pub theory_deg: f64,
    /// Simulated value, Table 2, degrees.
    pub simulated_deg: f64,
    /// Judgement of Section 4.3, in the words of `design`.
    pub verdict: &'static str,
}

/// Zhao 2022, Table 2 and Section 4.3.
pub const PUBLISHED: [Published; 10] = {
    const fn row(theory_deg: f64, simulated_deg: f64, verdict: &'static str) -> Published {
        Published {
            theory_deg,
            simulated_deg,
            verdict,
        }
    }
    [
        row(1.8153, 1.8131, "double-collision"),
        row(1.8176, 1.8281, "double-collision"),
        row(1.8185, 1.8323, "double-collision"),
        row(1.8171, 1.8190, "smooth"),
        row(1.8183, 1.7932, "smooth"),
        row(1.8156, 1.7552, "smooth"),
        row(1.8161, 1.6589, "slips"),
        row(1.8161, 1.6594, "slips"),
        row(1.8161, 1.5416, "slips"),
        row(1.8160, 1.4538, "slips"),
    ]
};

/// Row of the structure lC = 5.60 mm, which does not follow its neighbours.
pub const ODD_ROW: usize = 7;

fn parse((name, text): (&str, &str), overrides: &[String]) -> Result<Case, Failure> {
    Ok(
        CaseFile::parse(text, &format!("cases/{name}.toml"), overrides)?
            .case()
            .clone(),
    )
}

fn reading_overrides((profile, law): (Profile, FrictionLaw)) -> [String; 2] {
    [
        format!("model.profile=\"{}\"", profile_name(profile)),
        format!("contact.friction_law=\"{}\"", law_name(law)),
    ]
}

/// Name of a friction law in files.
pub fn law_name(law: FrictionLaw) -> &'static str {
    match law {
        FrictionLaw::Smooth => "smooth",
        FrictionLaw::Coulomb => "coulomb",
    }
}

/// Structure `k` of Table 2 under one reading of the equations, with further overrides
/// (`section.key=value`).
pub fn structure(
    k: usize,
    reading: (Profile, FrictionLaw),
    overrides: &[String],
) -> Result<Case, Failure> {
    let mut all = reading_overrides(reading).to_vec();
    all.extend_from_slice(overrides);
    parse(STRUCTURES[k], &all)
}

/// The bearings of Fig. 12 to 14: conventional, discrete.
pub fn experiment() -> Result<[Case; 2], Failure> {
    Ok([parse(EXPERIMENT[0], &[])?, parse(EXPERIMENT[1], &[])?])
}

/// How the report names structure `k`.
pub fn label(k: usize, case: &Case) -> Structure {
    let d = case.raceways.first().map(|raceway| *raceway.dimensions());
    Structure {
        letter: char::from(b'a' + k as u8).to_string(),
        // Rounding away what the conversion to SI leaves.
        axial_span_mm: d.map_or(f64::NAN, |d| (d.axial_span_m * 1e9).round() / 1e6),
        half_angle_deg: d.map_or(f64::NAN, |d| {
            (d.half_angle_rad.to_degrees() * 1e9).round() / 1e9
        }),
    }
}
