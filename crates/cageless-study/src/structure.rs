//! Span and angle of a discrete raceway.

use cageless::Raceway;
use serde::{Deserialize, Serialize};

/// One of the paper's discrete raceways.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RacewayLabel {
    /// Letter in the paper's Fig. 8: `a` to `j`; may be empty.
    pub letter: String,
    /// lC, mm.
    pub axial_span_mm: f64,
    /// θ, degrees.
    pub half_angle_deg: f64,
}

impl RacewayLabel {
    /// `(d) lC 5.1 mm, θ 25.2°`.
    pub fn label(&self) -> String {
        let size = format!("lC {} mm, θ {}°", self.axial_span_mm, self.half_angle_deg);
        if self.letter.is_empty() {
            size
        } else {
            format!("({}) {size}", self.letter)
        }
    }

    /// The structure of a raceway; without one, its lengths and angles are NaN.
    pub fn new(letter: &str, raceway: Option<&Raceway>) -> Self {
        let d = raceway.map(Raceway::dimensions);
        Self {
            letter: letter.to_owned(),
            // Rounding away what the conversion to SI leaves.
            axial_span_mm: d.map_or(f64::NAN, |d| (d.axial_span_m * 1e9).round() / 1e6),
            half_angle_deg: d.map_or(f64::NAN, |d| {
                (d.half_angle_rad.to_degrees() * 1e9).round() / 1e9
            }),
        }
    }
}
