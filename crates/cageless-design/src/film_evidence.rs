//! Effect of the film on the balls in the run of a verdict.

use std::f64::consts::FRAC_PI_2;

use cageless::Bearing;
use cageless::film::{free_share, opening_gap_rad};

/// Lag of the balls by a film, and what follows of it. Not a number where no ball has passed the half orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmEvidence {
    /// Λ, lag of the balls over the half orbit away from the load less that of the dry run, rad.
    pub lag_rad: f64,
    /// d = 2Λ/π, share of its speed that a ball loses there.
    pub speed_deficit: f64,
    /// g_f, gap that opens behind a ball that enters the load zone, rad.
    pub opening_gap_rad: f64,
    /// s, share of the pitch circle that balls leave free.
    pub free_share: f64,
}

impl FilmEvidence {
    /// Film of a bearing whose balls lag by these angles over the half orbit, wet and dry.
    pub(super) fn new(bearing: &Bearing, lags_rad: [Option<f64>; 2]) -> Self {
        let [wet, dry] = lags_rad.map(|lag| lag.unwrap_or(f64::NAN));
        let lag_rad = wet - dry;
        let speed_deficit = lag_rad / FRAC_PI_2;
        Self {
            lag_rad,
            speed_deficit,
            opening_gap_rad: opening_gap_rad(bearing, speed_deficit),
            free_share: free_share(bearing),
        }
    }
}
