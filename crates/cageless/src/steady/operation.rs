//! Which balls, from which start, and for how long.

use std::f64::consts::TAU;

use super::leading_ball;
use crate::ball_grade::{BallGrade, ball_grade};
use crate::case::{Case, bunched_gaps_rad, random_gaps_rad};
use crate::numerics::random::RandomStream;

crate::named_enum! {
    /// Start of steady operation.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum SteadyStart {
        /// All balls in the queue in which a conventional ring ends.
        Queue = "queue",
        /// Every division of the free angle equally likely.
        Random = "random",
    }
}

/// Grade of the balls unless a case gives one: that of balls for common deep groove bearings.
pub(crate) const GRADE: u32 = 10;
/// Orbits that are left out: a raceway of Zhao 2022 has spread a queue of balls after some 80.
const TRANSIENT_ORBITS: f64 = 120.0;
/// Orbits that are measured.
const MEASURED_ORBITS: f64 = 320.0;
/// Weight of each thing that is asked of a remedy.
const WEIGHT: f64 = 1.0;

/// Weights of what is asked of a remedy, 0 or more and not all 0; their sum does not matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenefitWeights {
    /// Fewer contacts between balls.
    pub contacts: f64,
    /// Even spacing.
    pub spacing: f64,
    /// Steady force on the outer ring.
    pub force: f64,
}

impl Default for BenefitWeights {
    fn default() -> Self {
        Self {
            contacts: WEIGHT,
            spacing: WEIGHT,
            force: WEIGHT,
        }
    }
}

/// Balls, start and length of runs of steady operation, and what is asked of a remedy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyOperation {
    /// Grade of the balls.
    pub grade: BallGrade,
    /// Start.
    pub start: SteadyStart,
    /// Orbits of the balls that are left out.
    pub transient_orbits: f64,
    /// Orbits of the balls that are measured.
    pub measured_orbits: f64,
    /// Weights of what is asked of a remedy.
    pub weights: BenefitWeights,
}

/// Balls and start of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyDraw {
    /// Deviations of the radii of the balls of a row, m.
    pub deviations_m: Vec<f64>,
    /// Gaps between the balls, rad.
    pub gaps_rad: Vec<f64>,
    /// ψ of ball 1, rad.
    pub lead_ball_angle_rad: f64,
}

impl Default for SteadyOperation {
    fn default() -> Self {
        Self {
            grade: ball_grade(GRADE).expect("a grade of the standard"),
            start: SteadyStart::Queue,
            transient_orbits: TRANSIENT_ORBITS,
            measured_orbits: MEASURED_ORBITS,
            weights: BenefitWeights::default(),
        }
    }
}

impl SteadyOperation {
    /// Time of the orbits that are left out, s.
    pub fn transient_s(&self, case: &Case) -> f64 {
        self.transient_orbits * case.rolling_orbit_s()
    }

    /// Time of all orbits, s.
    pub fn duration_s(&self, case: &Case) -> f64 {
        (self.transient_orbits + self.measured_orbits) * case.rolling_orbit_s()
    }

    /// Balls and start of run number `draw` under `seed`: radii evenly within the lot, those of the case where it
    /// gives any. Bearings with fewer balls get the first of them.
    pub fn draw(&self, case: &Case, seed: u64, draw: u64) -> SteadyDraw {
        /// Number of this use of random numbers among all.
        const STEADY: u64 = 103;
        let mut stream = RandomStream::new(seed, STEADY, 0, draw);
        let lead_ball_angle_rad = TAU * stream.uniform();
        let balls = case.bearing.balls();
        let most_m = self.grade.radius_deviation_m();
        let drawn = (0..balls).map(|_| stream.between(-most_m, most_m));
        let deviations_m = match case.bearing.ball_radius_deviations_m() {
            [] => drawn.collect(),
            given => given.to_vec(),
        };
        let gaps_rad = match self.start {
            SteadyStart::Random => random_gaps_rad(&case.bearing, &mut stream),
            SteadyStart::Queue => {
                let mut gaps_rad = bunched_gaps_rad(&case.bearing);
                // A larger ball is faster; the free angle is ahead of the last ball of the list.
                gaps_rad.rotate_left(balls - 1 - leading_ball(&deviations_m));
                gaps_rad
            }
        };
        SteadyDraw {
            deviations_m,
            gaps_rad,
            lead_ball_angle_rad,
        }
    }
}
