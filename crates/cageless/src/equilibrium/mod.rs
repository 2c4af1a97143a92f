//! Static equilibrium at speed: where the ring settles and how the balls share the load.
//!
//! Each ball stays at its ψ and takes its weight, the centrifugal force m·vt²/|rb| of
//! rolling (in the `paper` formulation Fw of Zhao 2022, Eq. (15), on top) and the normal
//! forces of both raceways; friction is left out. The ring takes load, weight and the
//! reactions.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::equilibrium;
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//!
//! let rest = equilibrium::solve(&case)?;
//! assert!(rest.ring_y_m < 0.0); // the load presses the ring down
//! assert_eq!(rest.inner_force_n.len(), 14);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod error;
mod lowest_minimum;
mod minimum;
mod newton;
mod outer_force;
mod potential;
pub mod space;
mod stiffness;

use crate::bearing::Bearing;
use crate::case::{Case, Gaps};
use crate::contact::FlankSection;
use crate::contact::hertz::{PointContact, STRESS_LIMIT_PA};
use crate::error::InputError;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::kinematics::orbit_speed_of_rad_s;
use crate::outer_contact_geometry::{OuterContactGeometry, flank_section, outer_contact_geometry};
use crate::raceway_contact::{RacewayContact, RacewayPoint};
pub use error::EquilibriumError;
use lowest_minimum::lowest_minimum;
use newton::BallSolution;
use potential::{Ball, Problem};

/// Coordinates of the ring's centre, m.
type Place = [f64; 2];
/// Stiffness matrix, N/m.
type Stiffness = [[f64; 2]; 2];

/// Balls at rest in the turning frame, and the ring.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Equilibrium {
    /// Centre of the inner ring.
    pub ring_x_m: f64,
    /// Centre of the inner ring.
    pub ring_y_m: f64,
    /// ψ of each ball, increasing from that of ball 1 through one turn.
    pub ball_angle_rad: Vec<f64>,
    /// |rb| of each ball.
    pub ball_distance_m: Vec<f64>,
    /// r of each ball.
    pub effective_radius_m: Vec<f64>,
    /// Normal force at the inner raceway.
    pub inner_force_n: Vec<f64>,
    /// Normal force at the outer raceway.
    pub outer_force_n: Vec<f64>,
    /// K of a nominal ball at the inner raceway.
    pub inner_stiffness_n_m1_5: f64,
    /// K of a nominal ball at the outer raceway.
    pub outer_stiffness_n_m1_5: f64,
    /// Contact of each ball with the inner raceway.
    pub inner_contact: Vec<RacewayContact>,
    /// Contact of each ball with the outer raceway; on a discrete raceway one of its two.
    pub outer_contact: Vec<RacewayContact>,
    /// Stiffness matrix of the bearing ∂F/∂(X, Y) at its operating point, rows x and y, N/m:
    /// force on the inner ring over its displacement, every ball staying in equilibrium. `None`
    /// where nothing holds the ring in some direction: without load, or in the clearance.
    pub stiffness_n_m: Option<[[f64; 2]; 2]>,
    /// Largest Hertz pressure at the inner raceway.
    pub inner_pressure_max_pa: f64,
    /// Largest Hertz pressure at the outer raceway; on a discrete raceway that of one of
    /// the two contact points.
    pub outer_pressure_max_pa: f64,
}

impl Equilibrium {
    /// Warning if the contact pressure exceeds [`STRESS_LIMIT_PA`].
    pub fn overload(&self) -> Option<String> {
        let (ring, stress) = if self.inner_pressure_max_pa > self.outer_pressure_max_pa {
            ("inner", self.inner_pressure_max_pa)
        } else {
            ("outer", self.outer_pressure_max_pa)
        };
        (stress > STRESS_LIMIT_PA).then(|| {
            format!(
                "the contact pressure at the {ring} raceway is {:.0} MPa, above the {:.0} MPa that \
                 leave a lasting indentation (ISO 76)",
                stress * 1e-6,
                STRESS_LIMIT_PA * 1e-6
            )
        })
    }
}

/// Overlap of two balls, as a fraction of their radius, that a start may have: of balls that
/// touch on the pitch circle and are seated some deflections further in.
const OVERLAP_MAX: f64 = 1e-4;

impl Equilibrium {
    /// Passes balls that are not pressed through each other at their places between the rings.
    ///
    /// # Errors
    /// [`EquilibriumError::BallsOverlap`] for the two that overlap most.
    pub(crate) fn check_balls_apart(&self, bearing: &Bearing) -> Result<(), EquilibriumError> {
        let (n, row) = (self.ball_angle_rad.len(), bearing.balls());
        let of = |k: usize| {
            let next = k - k % row + (k + 1) % row;
            let [a, b] = [k, next].map(|k| self.ball_distance_m[k]);
            let [own, ahead] = [k, next].map(|k| bearing.ball(k % row).radius_m);
            let reach = own + ahead;
            // Balls at the angle of this cosine touch.
            let cosine = (a * a + b * b - reach * reach) / (2.0 * a * b);
            let angle = self.ball_angle_rad[next] - self.ball_angle_rad[k];
            let apart = (a * a + b * b - 2.0 * a * b * angle.cos()).sqrt();
            (k, reach - apart, cosine.acos())
        };
        let deepest = (0..n).map(of).max_by(|a, b| a.1.total_cmp(&b.1));
        match deepest {
            Some((ball, overlap_m, angle)) if overlap_m > OVERLAP_MAX * bearing.ball_radius_m() => {
                Err(EquilibriumError::BallsOverlap {
                    ball,
                    overlap_m,
                    gap_rad: angle - bearing.pair_angle_rad(ball % row),
                })
            }
            _ => Ok(()),
        }
    }
}

/// Message of [`Equilibrium::overload`] for a case; `None` also without equilibrium.
pub fn overload(case: &Case) -> Option<String> {
    let bearing = &case.bearing;
    let operation = &case.operation;
    let balls_kg = bearing.balls() as f64 * bearing.ball_mass_kg();
    if case.rotor.is_some() || case.spatial_field().is_some() {
        return None;
    }
    let most = operation.radial_load_n
        + case.preload_n()
        + (bearing.dimensions().inner_ring_mass_kg + balls_kg) * operation.gravity_m_s2
        + case.centrifugal_force_n();
    // One ball that carried everything would bear it easily, on a discrete raceway as well.
    let easily = |contact: &PointContact| contact.peak_pressure_pa(most) < 0.8 * STRESS_LIMIT_PA;
    if easily(bearing.inner_contact()) && easily(bearing.outer_contact()) {
        return None;
    }
    solve(case).ok()?.overload()
}

/// ψ of every ball at the start, increasing from ψ of ball 1 (Zhao 2022, Section 4.1).
pub fn start_angles_rad(case: &Case) -> Vec<f64> {
    let bearing = &case.bearing;
    let n = bearing.balls();
    let mut angle = case.start.lead_ball_angle_rad;
    (0..n)
        .map(|k| {
            let here = angle;
            angle += bearing.pair_angle_rad(k)
                + match &case.start.gaps {
                    Gaps::Uniform => bearing.mean_gap_rad(),
                    Gaps::List(gaps) => gaps[k],
                };
            here
        })
        .collect()
}

/// Geometry of the outer contact of ball `k` of a case at ψ = `angle_rad`.
pub fn ball_outer_geometry(case: &Case, k: usize, angle_rad: f64) -> OuterContactGeometry {
    let radius = case.bearing.ball(k).radius_m;
    outer_contact_geometry(&case.bearing, &case.raceways, angle_rad, radius)
}

/// Elastic flanks under ball `k` of a case at ψ = `angle_rad`; `None` on the plain raceway and with
/// rigid ones.
fn elastic_flanks(case: &Case, k: usize, angle_rad: f64) -> Option<FlankSection> {
    let radius = case.bearing.ball(k).radius_m;
    let section = flank_section(&case.bearing, &case.raceways, angle_rad, radius);
    section.filter(|_| case.flanks == FlankModel::Elastic)
}

/// r of ball `k` of a case at ψ = `angle_rad` and |rb| = `distance_m`, m: on elastic flanks a ball
/// that is pressed in has a larger one.
pub(crate) fn effective_radius_m(case: &Case, k: usize, angle_rad: f64, distance_m: f64) -> f64 {
    let geometry = ball_outer_geometry(case, k, angle_rad);
    elastic_flanks(case, k, angle_rad).map_or(geometry.effective_radius_m, |flanks| {
        let press = flanks.press(distance_m - geometry.outer_orbit_radius_m);
        case.bearing.ball(k).radius_m * press.cosine
    })
}

/// Times that the centrifugal forces follow the contact angles.
const SPEED_ROUNDS: usize = 20;

/// Relative change of a centrifugal force that ends them.
const TURNING_TOLERANCE: f64 = 1e-12;

/// Solves the equilibrium of `case` with its balls at their starting angles.
///
/// # Errors
/// The case is impossible, or the iteration does not converge.
pub fn solve(case: &Case) -> Result<Equilibrium, EquilibriumError> {
    case.check()?;
    if case.rotor.is_some() {
        let why = "a bearing under a falling rotor has no static equilibrium";
        return Err(InputError::rotor_left_out(why).into());
    }
    case.check_planar()?;
    let bearing = &case.bearing;
    let inner_speed = case.operation.inner_speed_rad_s;
    let mut problem = problem(case, inner_speed);
    let (mut ring, mut stiffness_n_m) = settle_ring(&problem)?;
    for _ in 0..SPEED_ROUNDS {
        if !follow_speeds(case, &mut problem, ring, inner_speed) {
            break;
        }
        (ring, stiffness_n_m) = settle_ring(&problem)?;
    }
    let solutions: Vec<BallSolution> = problem
        .balls
        .iter()
        .map(|ball| problem.ball(ball, ring))
        .collect();
    let effective_radius_m: Vec<f64> = (0..)
        .zip(problem.balls.iter().zip(&solutions))
        .map(|(k, (b, s))| effective_radius_m(case, k, b.angle, s.distance))
        .collect();
    let inner_contact: Vec<RacewayContact> = solutions
        .iter()
        .map(|s| RacewayContact::new(bearing.inner_contact(), s.inner))
        .collect();
    let outer_contact: Vec<RacewayContact> = solutions
        .iter()
        .zip(&effective_radius_m)
        .enumerate()
        .map(|(k, (s, r))| {
            let point = RacewayPoint::of_outer(r / bearing.ball(k).radius_m, s.outer);
            RacewayContact::outer(bearing, point)
        })
        .collect();
    let largest =
        |contacts: &[RacewayContact]| contacts.iter().map(|c| c.pressure_pa).fold(0.0, f64::max);
    let [inner_stiffness_n_m1_5, outer_stiffness_n_m1_5, _] = case.stiffness_n_m1_5();
    Ok(Equilibrium {
        ring_x_m: ring[0],
        ring_y_m: ring[1],
        ball_angle_rad: problem.balls.iter().map(|b| b.angle).collect(),
        ball_distance_m: solutions.iter().map(|s| s.distance).collect(),
        inner_pressure_max_pa: largest(&inner_contact),
        outer_pressure_max_pa: largest(&outer_contact),
        inner_contact,
        outer_contact,
        stiffness_n_m,
        effective_radius_m,
        inner_force_n: solutions.iter().map(|s| s.inner).collect(),
        outer_force_n: solutions.iter().map(|s| s.outer).collect(),
        inner_stiffness_n_m1_5,
        outer_stiffness_n_m1_5,
    })
}

/// |rb| of every ball that is in equilibrium at its starting angle, for a given place of the
/// inner ring, which turns at `inner_speed_rad_s`.
pub(crate) fn seated_distances_m(case: &Case, ring: Place, inner_speed_rad_s: f64) -> Vec<f64> {
    let mut problem = problem(case, inner_speed_rad_s);
    for _ in 0..SPEED_ROUNDS {
        if !follow_speeds(case, &mut problem, ring, inner_speed_rad_s) {
            break;
        }
    }
    let balls = problem.balls.iter();
    balls
        .map(|ball| problem.ball(ball, ring).distance)
        .collect()
}

/// Puts the centrifugal forces right for the contact angles of balls on elastic flanks around a ring;
/// whether that changes anything.
fn follow_speeds(
    case: &Case,
    problem: &mut Problem<'_>,
    ring: Place,
    inner_speed_rad_s: f64,
) -> bool {
    let distances: Vec<Option<f64>> = problem
        .balls
        .iter()
        .map(|ball| ball.flanks.map(|_| problem.ball(ball, ring).distance))
        .collect();
    let mut changed = false;
    for (k, (ball, distance)) in problem.balls.iter_mut().zip(distances).enumerate() {
        let Some(distance) = distance else { continue };
        let r = effective_radius_m(case, k, ball.angle, distance);
        let turning = turning_n_m(case, k, r, inner_speed_rad_s);
        changed |= (turning - ball.turning).abs() > TURNING_TOLERANCE * turning;
        ball.turning = turning;
    }
    changed
}

/// Speed of the centre of ball `k` that rolls with the effective contact radius `r_m`, m/s.
fn rolling_speed_m_s(case: &Case, k: usize, r_m: f64, inner_speed_rad_s: f64) -> f64 {
    let bearing = &case.bearing;
    let radius = bearing.ball(k).radius_m;
    orbit_speed_of_rad_s(bearing, radius, inner_speed_rad_s, r_m) * bearing.pitch_radius_m()
}

/// Its centrifugal force times its distance from the axis, N·m.
fn turning_n_m(case: &Case, k: usize, r_m: f64, inner_speed_rad_s: f64) -> f64 {
    let speed = rolling_speed_m_s(case, k, r_m, inner_speed_rad_s);
    case.bearing.ball(k).mass_kg * speed * speed
}

/// The balls of a case at their starting angles, rolling at `inner_speed_rad_s`, and its ring.
fn problem(case: &Case, inner_speed_rad_s: f64) -> Problem<'_> {
    let bearing = &case.bearing;
    let inner = bearing.dimensions().inner_groove_bottom_radius_m;
    let balls: Vec<Ball> = start_angles_rad(case)
        .into_iter()
        .enumerate()
        .map(|(k, angle)| {
            let (sin, cos) = angle.sin_cos();
            let (ball, outer_geometry) = (bearing.ball(k), ball_outer_geometry(case, k, angle));
            let r = outer_geometry.effective_radius_m;
            let speed = rolling_speed_m_s(case, k, r, inner_speed_rad_s);
            let doubled = match case.formulation {
                Formulation::Paper => ball.mass_kg * speed * speed / bearing.pitch_radius_m(),
                Formulation::Physical => 0.0,
            };
            let [inner_stiffness_n_m1_5, outer_stiffness_n_m1_5, _] = case.ball_stiffness_n_m1_5(k);
            let outer_orbit_radius = outer_geometry.outer_orbit_radius_m;
            Ball {
                angle,
                radius: ball.radius_m,
                outer_orbit_radius,
                slack: inner + ball.radius_m - outer_orbit_radius,
                flanks: elastic_flanks(case, k, angle),
                inner_stiffness_n_m1_5,
                outer_stiffness_n_m1_5,
                e: [sin, -cos],
                steady: ball.mass_kg * case.operation.gravity_m_s2 * cos + doubled,
                turning: turning_n_m(case, k, r, inner_speed_rad_s),
            }
        })
        .collect();
    let ring_kg = bearing.dimensions().inner_ring_mass_kg;
    Problem {
        bearing,
        balls,
        down: case.operation.radial_load_n + ring_kg * case.operation.gravity_m_s2,
        preload: bearing.balls() as f64 * case.preload_n(),
    }
}

/// Where the ring's potential energy is least, and the stiffness there. Without any force on it
/// it stays in the middle.
fn settle_ring(problem: &Problem<'_>) -> Result<(Place, Option<Stiffness>), EquilibriumError> {
    let bearing = problem.bearing;
    let settled = |ring: Place| (ring, problem.at(ring).stiffness_n_m());
    if problem.at_rest_in_the_middle() {
        return Ok(settled([0.0; 2]));
    }
    let depth = problem.contact_depth_m();
    let lowest = lowest_minimum(problem, depth, 0.05 * bearing.ball_radius_m())?;
    let [x, y] = lowest.place;
    if x.hypot(y) > bearing.shoulder_clearance_m() {
        return Err(EquilibriumError::Unsupported);
    }
    // A ring that several balls hold comes to the same place by Newton's method on the forces,
    // whose last bits are those of all earlier results.
    let same = |ring: &[f64; 2]| (ring[0] - x).hypot(ring[1] - y) <= SAME_PLACE * x.hypot(y);
    let polished = lowest.held().then(|| problem.newton_from_below(depth));
    Ok(settled(
        polished.flatten().filter(same).unwrap_or(lowest.place),
    ))
}

/// Distance of two places of the ring that differ by rounding, as a fraction of the displacement.
const SAME_PLACE: f64 = 1e-9;
