//! Passages of each row through each raceway.

use super::kinematic_lag_rad;
use crate::case::Case;
use crate::passage::{Passage, PassageTally};

/// Sums over the passages through each raceway, of all balls and of each row.
pub(super) struct RacewayTallies {
    /// N, balls of a row.
    balls: usize,
    /// Raceway by raceway.
    of_raceway: Vec<PassageTally>,
    /// Raceway by raceway, row after row.
    of_row: Vec<Vec<PassageTally>>,
}

impl RacewayTallies {
    /// Those of a case, without passages.
    pub fn new(case: &Case) -> Self {
        let tallies = |count: usize| vec![PassageTally::new(); count];
        let rows = case.all_rows().len();
        Self {
            balls: case.bearing.balls(),
            of_raceway: tallies(case.raceways.len()),
            of_row: vec![tallies(rows); case.raceways.len()],
        }
    }

    /// Adds a passage.
    pub fn add(&mut self, passage: &Passage) {
        self.of_raceway[passage.raceway].add(passage);
        self.of_row[passage.raceway][passage.ball / self.balls].add(passage);
    }

    /// Passages of all rows through raceway `k`.
    pub fn of_raceway(&self, k: usize) -> &PassageTally {
        &self.of_raceway[k]
    }

    /// Lag in raceway `k` over that of rolling on rigid flanks at the angle of its section, of the row where it
    /// is least; 0 where no ball passes.
    pub fn lag_fraction(&self, case: &Case, k: usize) -> f64 {
        let raceway = &case.raceways[k];
        let rolling_rad =
            kinematic_lag_rad(&case.bearing, raceway, raceway.section_angle_rad(), 0.0);
        let fraction = |tally: &PassageTally| match tally.count {
            0 => 0.0,
            _ => tally.lag_mean_rad() / rolling_rad,
        };
        self.of_row[k]
            .iter()
            .map(fraction)
            .fold(f64::INFINITY, f64::min)
    }
}
