//! Drops that differ in what nobody knows beforehand.

use std::f64::consts::TAU;

use crate::case::{Case, Gaps, Start};
use crate::design::search::uneven_gaps_rad;
use crate::numerics::random::RandomStream;

/// Scatter between the drops of an ensemble. Fractions are half widths of a uniform distribution
/// about the value of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Of both friction coefficients of the rotor and, independently, of the balls.
    pub friction_fraction: f64,
    /// Of the air gap.
    pub air_gap_fraction: f64,
    /// Largest factor, either way, on the damping of the support; its logarithm is uniform.
    pub support_damping_factor: f64,
    /// Whether the direction of the unbalance is drawn, uniform on the circle.
    pub eccentricity_phase: bool,
    /// Whether the gaps between the balls and the place of the first ball are drawn.
    pub ball_arrangement: bool,
}

impl Default for Scatter {
    /// Friction within 30 %, air gap within 10 %, support damping by a factor of 2, any direction
    /// of the unbalance, any arrangement of the balls.
    fn default() -> Self {
        Self {
            friction_fraction: 0.3,
            air_gap_fraction: 0.1,
            support_damping_factor: 2.0,
            eccentricity_phase: true,
            ball_arrangement: true,
        }
    }
}

/// What was drawn for one drop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drawn {
    /// Friction coefficient between rotor and inner ring.
    pub rotor_friction: f64,
    /// Friction coefficient of the balls.
    pub ball_friction: f64,
    /// Radial air gap, m.
    pub air_gap_m: f64,
    /// Direction of the unbalance at the start, rad.
    pub eccentricity_phase_rad: f64,
    /// Damping of the support, N·s/m; `None` without a support.
    pub support_damping_n_s_m: Option<f64>,
}

/// Purpose of the random streams of drops.
const DROP: u64 = 5;

impl Scatter {
    /// Case of drop `index` and what was drawn for it; the same seed and index give the same
    /// drop.
    ///
    /// # Panics
    /// If the case has no rotor.
    pub fn draw(&self, case: &Case, index: u64) -> (Case, Drawn) {
        let mut drop = case.clone();
        let factor = |dimension: u64, fraction: f64| {
            let mut stream = RandomStream::new(case.seed, DROP, dimension, index);
            1.0 + stream.between(-fraction, fraction)
        };
        let rotor = drop.rotor.as_mut().expect("a rotor");
        let sliding = factor(0, self.friction_fraction);
        rotor.scale_friction(sliding);
        rotor.air_gap_m *= factor(1, self.air_gap_fraction);
        if self.eccentricity_phase {
            let mut stream = RandomStream::new(case.seed, DROP, 2, index);
            // The magnets held the centre of the journal, wherever the mass centre is.
            let journal = rotor.journal_start_m();
            rotor.eccentricity_phase_rad = stream.between(0.0, TAU);
            let now = rotor.journal_start_m();
            rotor.x_m += journal[0] - now[0];
            rotor.y_m += journal[1] - now[1];
        }
        let mut drawn = Drawn {
            rotor_friction: rotor.friction_coefficient,
            ball_friction: 0.0,
            air_gap_m: rotor.air_gap_m,
            eccentricity_phase_rad: rotor.eccentricity_phase_rad,
            support_damping_n_s_m: None,
        };
        let rolling = factor(3, self.friction_fraction);
        drop.contact.scale_friction(rolling);
        drawn.ball_friction = drop.contact.friction_coefficient;
        if let Some(support) = &mut drop.support {
            let most = self.support_damping_factor.ln();
            let mut stream = RandomStream::new(case.seed, DROP, 4, index);
            support.damping_n_s_m *= stream.between(-most, most).exp();
            drawn.support_damping_n_s_m = Some(support.damping_n_s_m);
        }
        if self.ball_arrangement {
            let mut stream = RandomStream::new(case.seed, DROP, 5, index);
            drop.start = Start::AtRest {
                gaps: Gaps::List(uneven_gaps_rad(case, case.seed, index)),
                lead_ball_angle_rad: stream.between(0.0, TAU) - TAU / 2.0,
            };
        }
        (drop, drawn)
    }
}
