//! Drops that differ in what nobody knows beforehand.

use std::f64::consts::TAU;

use crate::case::{Case, Gaps, Start, StartState};
use crate::contact::FrictionParameters;
use crate::numerics::random::{RandomStream, split_mix};
use crate::simulation::RotorDrop;

/// Scatter between the drops of an ensemble. Fractions are half widths of a uniform distribution
/// about the value of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Half width of both friction coefficients of the rotor and, independently, of the balls, as a fraction.
    pub friction_fraction: f64,
    /// Half width of the radial air gap, as a fraction.
    pub radial_clearance_fraction: f64,
    /// Largest factor, either way, on the damping of the support; its logarithm is uniform.
    pub support_damping_factor: f64,
    /// Whether the direction of the unbalance is drawn, uniform on the circle; several unbalances
    /// keep their directions to each other.
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
            radial_clearance_fraction: 0.1,
            support_damping_factor: 2.0,
            eccentricity_phase: true,
            ball_arrangement: true,
        }
    }
}

/// Random values drawn for one bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnBearing {
    /// Friction between rotor and inner ring.
    pub rotor_friction: FrictionParameters,
    /// Friction of the balls.
    pub ball_friction: FrictionParameters,
    /// Radial air gap, m.
    pub radial_clearance_m: f64,
    /// Damping of the support, N·s/m; `None` without a support.
    pub support_damping_n_s_m: Option<f64>,
    /// Gaps between the balls and place of the first one, rad; `None` if they are not drawn.
    pub arrangement_rad: Option<(Vec<f64>, f64)>,
}

/// Random values drawn for one drop.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Each bearing.
    pub bearings: Vec<DrawnBearing>,
    /// Direction of the unbalance of a case at the start; angle by which all unbalances of a linear
    /// rotor are turned, rad. `None` if it is not drawn.
    pub unbalance_rad: Option<f64>,
    /// Mass centre of the rotor of a case at the start, m: the magnets held the journal, wherever the
    /// unbalance is.
    pub centre_m: Option<[f64; 2]>,
}

/// Purpose of the random streams of drops.
const DROP: u64 = 5;

/// Quantity to be drawn: the dimension of its random stream.
#[derive(Clone, Copy)]
enum Dimension {
    RotorFriction,
    RadialClearance,
    UnbalanceDirection,
    BallFriction,
    SupportDamping,
    FirstBall,
}

/// The random streams of one bearing in one drop.
#[derive(Clone, Copy)]
struct Streams {
    seed: u64,
    index: u64,
}

impl Streams {
    /// Streams of bearing `k` of a rotor; those of the first are the streams of `seed` itself.
    fn of_bearing(seed: u64, index: u64, k: usize) -> Self {
        let own = match k {
            0 => seed,
            _ => split_mix(seed, k as u64),
        };
        Self { seed: own, index }
    }

    fn between(&self, dimension: Dimension, low: f64, high: f64) -> f64 {
        RandomStream::new(self.seed, DROP, dimension as u64, self.index).between(low, high)
    }

    fn factor(&self, dimension: Dimension, fraction: f64) -> f64 {
        1.0 + self.between(dimension, -fraction, fraction)
    }
}

impl Scatter {
    /// Drop `index` of an ensemble and what was drawn for it: the direction of the unbalances once,
    /// all else for each bearing on its own. The same seed and index give the same drop.
    pub fn draw(&self, drop: &RotorDrop, seed: u64, index: u64) -> (RotorDrop, Drawn) {
        let mut bearings = vec![];
        let mut scattered = drop.map_cases(|case| {
            let streams = Streams::of_bearing(seed, index, bearings.len());
            let (case, drawn) = self.draw_bearing(case, streams);
            bearings.push(drawn);
            case
        });
        let unbalance_rad = self.eccentricity_phase.then(|| {
            let streams = Streams::of_bearing(seed, index, 0);
            streams.between(Dimension::UnbalanceDirection, 0.0, TAU)
        });
        if let Some(angle_rad) = unbalance_rad {
            scattered.turn_unbalances(angle_rad);
        }
        let of_case = scattered.rotor().is_none();
        let rotor = scattered.cases()[0].rotor.as_ref().filter(|_| of_case);
        let drawn = Drawn {
            bearings,
            unbalance_rad,
            centre_m: rotor.map(|rotor| [rotor.x_m, rotor.y_m]),
        };
        (scattered, drawn)
    }

    fn draw_bearing(&self, case: &Case, streams: Streams) -> (Case, DrawnBearing) {
        let mut drop = case.clone();
        let rotor = drop.rotor.as_mut().expect("a rotor");
        let sliding = streams.factor(Dimension::RotorFriction, self.friction_fraction);
        rotor.friction.scale(sliding);
        rotor.radial_clearance_m *=
            streams.factor(Dimension::RadialClearance, self.radial_clearance_fraction);
        let rolling = streams.factor(Dimension::BallFriction, self.friction_fraction);
        drop.contact.friction.scale(rolling);
        let mut drawn = DrawnBearing {
            rotor_friction: rotor.friction.clone(),
            ball_friction: drop.contact.friction.clone(),
            radial_clearance_m: rotor.radial_clearance_m,
            support_damping_n_s_m: None,
            arrangement_rad: None,
        };
        if let Some(support) = &mut drop.support {
            let most = self.support_damping_factor.ln();
            support.damping_n_s_m *= streams
                .between(Dimension::SupportDamping, -most, most)
                .exp();
            drawn.support_damping_n_s_m = Some(support.damping_n_s_m);
        }
        if self.ball_arrangement {
            let Streams { seed, index } = streams;
            let gaps_rad = Gaps::uneven_rad(&case.bearing, seed, index);
            let lead_ball_angle_rad = streams.between(Dimension::FirstBall, 0.0, TAU) - TAU / 2.0;
            drop.start = Start::new(
                StartState::AtRest,
                Gaps::List(gaps_rad.clone()),
                lead_ball_angle_rad,
            );
            drawn.arrangement_rad = Some((gaps_rad, lead_ball_angle_rad));
        }
        (drop, drawn)
    }
}
