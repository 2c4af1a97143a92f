//! The cases of the paper and its numbers.

pub use cageless_study::law_name;
pub use cageless_study::paper::{experiment, label, structure};

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
