//! The cases of the paper, as they stand in `cases/`, and its numbers.

use cageless::Case;
use cageless_io::case_file::CaseFile;

pub use cageless_study::law_name;
pub use cageless_study::paper::{label, structure};

use crate::failure::Failure;

macro_rules! case_text {
    ($name:literal) => {
        (
            $name,
            include_str!(concat!("../../../../cases/", $name, ".toml")),
        )
    };
}

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

fn parse((name, text): (&str, &str)) -> Result<Case, Failure> {
    Ok(CaseFile::parse(text, &format!("cases/{name}.toml"), &[])?
        .case()
        .clone())
}

/// The bearings of Fig. 12 to 14: conventional, discrete.
pub fn experiment() -> Result<[Case; 2], Failure> {
    Ok([parse(EXPERIMENT[0])?, parse(EXPERIMENT[1])?])
}
