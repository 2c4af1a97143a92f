//! Passages of each row through each raceway.

use super::criterion::Criterion;
use cageless::Case;
use cageless::closed_forms::kinematic_lag_rad;
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::passage::{Passage, PassageTally};
use cageless::raceway::Raceway;

/// Sums over the passages through each raceway, of all balls and of each row.
#[derive(Debug, Clone, PartialEq)]
pub struct RacewayTallies {
    /// N, balls of a row.
    balls: usize,
    /// Raceway by raceway.
    of_raceway: Vec<PassageTally>,
    /// Raceway by raceway, row after row.
    of_row: Vec<Vec<PassageTally>>,
    /// Passages, raceway by raceway, ball after ball.
    of_ball: Vec<Vec<u64>>,
}

impl RacewayTallies {
    /// Sums of a case, without passages.
    pub fn new(case: &Case) -> Self {
        let tallies = |count: usize| vec![PassageTally::new(); count];
        let rows = case.all_rows().len();
        Self {
            balls: case.bearing.balls(),
            of_raceway: tallies(case.raceways.len()),
            of_row: vec![tallies(rows); case.raceways.len()],
            of_ball: vec![vec![0; case.balls()]; case.raceways.len()],
        }
    }

    /// Adds a passage.
    pub fn add(&mut self, passage: &Passage) {
        self.of_raceway[passage.raceway].add(passage);
        self.of_row[passage.raceway][passage.ball / self.balls].add(passage);
        self.of_ball[passage.raceway][passage.ball] += 1;
    }

    /// Passages of all rows through raceway `k`.
    pub fn of_raceway(&self, k: usize) -> &PassageTally {
        &self.of_raceway[k]
    }

    /// Passages of the ball that has passed a raceway least often, through the raceway that it has passed least.
    pub(crate) fn least_of_a_ball(&self) -> u64 {
        self.of_ball.iter().flatten().copied().min().unwrap_or(0)
    }

    /// How far raceway `k` slows the balls; not known before a ball has passed, of the lag before one has passed two.
    pub(super) fn slowing(&self, case: &Case, k: usize) -> Criterion {
        let slowest_rad_s = self.of_raceway[k].means().lowest_orbit_speed_rad_s;
        Criterion::slowing(
            case.has_elastic_flanks(),
            speed_drop_fraction(case, &case.raceways[k], slowest_rad_s),
            self.lag_fraction(case, k),
        )
    }

    /// Lag in raceway `k` over that of rolling on rigid flanks at the angle of its section, of the row where it
    /// is least; 0 where no ball passes.
    pub(crate) fn lag_fraction(&self, case: &Case, k: usize) -> f64 {
        let raceway = &case.raceways[k];
        let rolling_rad =
            kinematic_lag_rad(&case.bearing, raceway, raceway.section_angle_rad(), 0.0);
        let fraction = |tally: &PassageTally| match tally.count {
            0 => 0.0,
            _ => tally.means().lag_rad / rolling_rad,
        };
        self.of_row[k]
            .iter()
            .map(fraction)
            .fold(f64::INFINITY, f64::min)
    }
}

/// Fraction of the theoretical drop of orbital speed in a raceway that balls reach which fall to
/// `slowest_rad_s` at the largest speed of the inner ring, in a turned section of that at its contact angle.
pub(super) fn speed_drop_fraction(case: &Case, raceway: &Raceway, slowest_rad_s: f64) -> f64 {
    let bearing = &case.bearing;
    let gamma = bearing.ball_radius_m() / bearing.pitch_radius_m();
    // Ω has the factor 1 − γ cos α.
    let turned = (1.0 - gamma * raceway.section_angle_rad().cos()) / (1.0 - gamma);
    let inner_speed_rad_s = turned * case.largest_inner_speed_rad_s();
    let speed = |r: f64| rolling_orbit_speed_rad_s(bearing, inner_speed_rad_s, r);
    let plain = speed(bearing.ball_radius_m());
    let middle = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
    (plain - slowest_rad_s) / (plain - speed(middle))
}
