//! Static equilibrium at speed: where the ring settles and how the balls share the load.
//!
//! Each ball stays at its ψ and takes its weight, the centrifugal force m·vt²/|rb| of
//! rolling (in the `paper` profile Fw of Zhao 2022, Eq. (15), on top) and the normal
//! forces of both raceways; friction is left out. The ring takes load, weight and the
//! reactions.

use crate::bearing::Bearing;
use crate::case::{Case, Gaps, Profile};
use crate::contact::hertz::{PointContact, STRESS_LIMIT_PA};
use crate::error::InputError;
use crate::kinematics::orbit_speed_of_rad_s;
use crate::numerics::root;
use crate::seat::{self, Seat};

/// Balls at rest in the turning frame, and the ring.
#[derive(Debug, Clone, PartialEq)]
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
    /// Largest Hertz pressure at the inner raceway.
    pub inner_stress_max_pa: f64,
    /// Largest Hertz pressure at the outer raceway; on a discrete raceway that of one of
    /// the two contact points.
    pub outer_stress_max_pa: f64,
}

impl Equilibrium {
    /// Says so if a contact bears more than [`STRESS_LIMIT_PA`].
    pub fn overload(&self) -> Option<String> {
        let (ring, stress) = if self.inner_stress_max_pa > self.outer_stress_max_pa {
            ("inner", self.inner_stress_max_pa)
        } else {
            ("outer", self.outer_stress_max_pa)
        };
        (stress > STRESS_LIMIT_PA).then(|| {
            format!(
                "the contact stress at the {ring} raceway is {:.2} GPa, above the {} GPa that \
                 leave a lasting indentation (ISO 76)",
                stress * 1e-9,
                STRESS_LIMIT_PA * 1e-9
            )
        })
    }
}

/// What [`Equilibrium::overload`] says of a case; `None` as well if it has no equilibrium.
pub fn overload(case: &Case) -> Option<String> {
    let bearing = &case.bearing;
    let operation = &case.operation;
    let balls_kg = bearing.balls() as f64 * bearing.ball_mass_kg();
    let most = operation.radial_load_n
        + (bearing.dimensions().inner_ring_mass_kg + balls_kg) * operation.gravity_m_s2
        + case.centrifugal_force_n();
    // One ball that carried everything would bear it easily, on a discrete raceway as well.
    let easily = |contact: &PointContact| contact.peak_stress_pa(most) < 0.8 * STRESS_LIMIT_PA;
    if easily(bearing.inner_contact()) && easily(bearing.outer_contact()) {
        return None;
    }
    solve(case).ok()?.overload()
}

/// The solver did not reach equilibrium.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquilibriumError {
    /// The case itself is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// No convergence.
    #[error(
        "no static equilibrium found: {residual_n:e} N of force are left on the ring after \
         {iterations} iterations; the load may be too large for these contacts"
    )]
    NotConverged {
        /// Force left on the ring.
        residual_n: f64,
        /// Iterations made.
        iterations: usize,
    },
}

/// ψ of every ball at the start, increasing from ψ of ball 1 (Zhao 2022, Section 4.1).
pub fn start_angles_rad(case: &Case) -> Vec<f64> {
    let bearing = &case.bearing;
    let n = bearing.balls();
    let mut angle = case.start.lead_ball_angle_rad();
    (0..n)
        .map(|k| {
            let here = angle;
            angle += bearing.pair_angle_rad(k)
                + match case.start.gaps() {
                    Gaps::Uniform => bearing.even_gap_rad(),
                    Gaps::List(gaps) => gaps[k],
                };
            here
        })
        .collect()
}

/// Where ball `k` sits in the outer ring at ψ.
pub fn seat(case: &Case, k: usize, angle_rad: f64) -> Seat {
    let radius = case.bearing.ball(k).radius_m;
    seat::seat(&case.bearing, &case.raceways, angle_rad, radius)
}

/// What one ball contributes.
struct BallProblem {
    angle: f64,
    radius: f64,
    seat: Seat,
    inner_stiffness: f64,
    outer_stiffness: f64,
    /// Unit vector e.
    e: [f64; 2],
    /// Outward force that does not come from a contact, times |rb| where it is
    /// centrifugal: push = steady + turning/|rb|.
    steady: f64,
    turning: f64,
}

struct Problem<'c> {
    bearing: &'c Bearing,
    balls: Vec<BallProblem>,
    /// Load and weight on the ring, −Y.
    down: f64,
}

/// Solution of one ball for a given ring.
struct BallSolution {
    distance: f64,
    inner: f64,
    outer: f64,
    /// Direction from the ring's centre to the ball.
    ei: [f64; 2],
    /// d(inner)/d(approach of the ring).
    stiffness: f64,
}

impl Problem<'_> {
    fn ball(&self, ball: &BallProblem, ring: [f64; 2]) -> BallSolution {
        let touching = ball.seat.touching_radius_m;
        let reach = self.bearing.dimensions().inner_groove_bottom_radius_m + ball.radius;
        let forces = |distance: f64| {
            let offset = [
                distance * ball.e[0] - ring[0],
                distance * ball.e[1] - ring[1],
            ];
            let length = offset[0].hypot(offset[1]);
            let ei = offset.map(|c| c / length);
            let inner = ball.inner_stiffness * (reach - length).max(0.0).powf(1.5);
            let outer = ball.outer_stiffness * (distance - touching).max(0.0).powf(1.5);
            let cosine = ei[0] * ball.e[0] + ei[1] * ball.e[1];
            let net = inner * cosine + ball.steady + ball.turning / distance - outer;
            (net, inner, outer, ei, reach - length)
        };
        // Outward push falls with the distance; all the room there is brackets it.
        let width = self.bearing.ball_radius_m() + self.bearing.radial_clearance_m();
        let distance = root::brent(|d| forces(d).0, touching - width, touching + width, 0.0)
            .unwrap_or(touching);
        let (_, inner, outer, ei, approach) = forces(distance);
        let slope = |k: f64, deflection: f64| 1.5 * k * deflection.max(0.0).sqrt();
        let (ki, ko) = (
            slope(ball.inner_stiffness, approach),
            slope(ball.outer_stiffness, distance - touching),
        );
        let stiffness = if ki > 0.0 { ki * ko / (ki + ko) } else { 0.0 };
        BallSolution {
            distance,
            inner,
            outer,
            ei,
            stiffness,
        }
    }

    /// Force left on the ring and its stiffness against displacement.
    fn ring(&self, ring: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
        let mut force = [0.0, -self.down];
        let mut stiffness = [[0.0; 2]; 2];
        for ball in &self.balls {
            let s = self.ball(ball, ring);
            for a in 0..2 {
                force[a] -= s.inner * s.ei[a];
                for b in 0..2 {
                    stiffness[a][b] += s.stiffness * s.ei[a] * s.ei[b];
                }
            }
        }
        (force, stiffness)
    }
}

/// Solves the equilibrium of `case` with its balls at their starting angles.
///
/// # Errors
/// The case is impossible, or the iteration does not converge.
pub fn solve(case: &Case) -> Result<Equilibrium, EquilibriumError> {
    case.check()?;
    let bearing = &case.bearing;
    let angles = start_angles_rad(case);
    let [inner_stiffness, outer_stiffness, _] = case.stiffness_n_m1_5();
    let d = bearing.dimensions();
    let balls: Vec<BallProblem> = angles
        .iter()
        .enumerate()
        .map(|(k, &angle)| {
            let (sin, cos) = angle.sin_cos();
            let (ball, seat) = (bearing.ball(k), seat(case, k, angle));
            let orbit = orbit_speed_of_rad_s(
                bearing,
                ball.radius_m,
                case.operation.inner_speed_rad_s,
                seat.effective_radius_m,
            );
            let speed = orbit * bearing.pitch_radius_m();
            let doubled = match case.profile {
                Profile::Paper => ball.mass_kg * speed * speed / bearing.pitch_radius_m(),
                Profile::Physical => 0.0,
            };
            let [inner_stiffness, outer_stiffness, _] = case.ball_stiffness_n_m1_5(k);
            BallProblem {
                angle,
                radius: ball.radius_m,
                seat,
                inner_stiffness,
                outer_stiffness,
                e: [sin, -cos],
                steady: ball.mass_kg * case.operation.gravity_m_s2 * cos + doubled,
                turning: ball.mass_kg * speed * speed,
            }
        })
        .collect();
    let problem = Problem {
        bearing,
        balls,
        down: case.operation.radial_load_n + d.inner_ring_mass_kg * case.operation.gravity_m_s2,
    };
    let ring = settle_ring(&problem, bearing)?;
    let solutions: Vec<BallSolution> = problem
        .balls
        .iter()
        .map(|ball| problem.ball(ball, ring))
        .collect();
    let inner_force_n: Vec<f64> = solutions.iter().map(|s| s.inner).collect();
    let outer_force_n: Vec<f64> = solutions.iter().map(|s| s.outer).collect();
    let stress = |worst: f64, p: f64| worst.max(p);
    Ok(Equilibrium {
        ring_x_m: ring[0],
        ring_y_m: ring[1],
        ball_angle_rad: problem.balls.iter().map(|b| b.angle).collect(),
        ball_distance_m: solutions.iter().map(|s| s.distance).collect(),
        inner_stress_max_pa: inner_force_n
            .iter()
            .map(|&f| bearing.inner_contact().peak_stress_pa(f))
            .fold(0.0, stress),
        outer_stress_max_pa: outer_force_n
            .iter()
            .zip(&problem.balls)
            .map(|(&f, ball)| outer_stress_pa(bearing, ball.seat.effective_radius_m, f))
            .fold(0.0, stress),
        effective_radius_m: problem
            .balls
            .iter()
            .map(|b| b.seat.effective_radius_m)
            .collect(),
        inner_force_n,
        outer_force_n,
        inner_stiffness_n_m1_5: inner_stiffness,
        outer_stiffness_n_m1_5: outer_stiffness,
    })
}

/// Peak Hertz pressure at the outer raceway of a ball with effective radius `r_m` under
/// the radial force `force_n`. Where r < Rw two points share it, each with
/// F′o = Fo·Rw/(2r) (Zhao 2022, Eq. (19)); the ring's curvature in the plane of rolling
/// is then that of a cone at the contact point, (r/Rw)/(Ro − Rw + r).
pub fn outer_stress_pa(bearing: &Bearing, r_m: f64, force_n: f64) -> f64 {
    let rw = bearing.ball_radius_m();
    if r_m >= rw {
        return bearing.outer_contact().peak_stress_pa(force_n);
    }
    let cosine = r_m / rw;
    PointContact::new(
        [1.0 / rw; 2],
        [
            -cosine / (bearing.touching_radius_m() + r_m),
            -1.0 / bearing.dimensions().outer_groove_curvature_radius_m,
        ],
        bearing.material(),
    )
    .peak_stress_pa(force_n / (2.0 * cosine))
}

/// Newton's method on the ring's centre with step halving.
fn settle_ring(problem: &Problem<'_>, bearing: &Bearing) -> Result<[f64; 2], EquilibriumError> {
    const ITERATIONS: usize = 200;
    let scale = problem.down.max(1e-6);
    let norm = |f: [f64; 2]| f[0].hypot(f[1]);
    // Nothing pulls: the ring stays in the middle.
    if norm(problem.ring([0.0; 2]).0) <= 1e-12 * scale {
        return Ok([0.0; 2]);
    }
    // Deep enough for contact below; the Hertz law is convex from there.
    let first = &problem.balls[0];
    let series = (first.inner_stiffness.powf(-2.0 / 3.0) + first.outer_stiffness.powf(-2.0 / 3.0))
        * (4.37 * problem.down / problem.balls.len() as f64).powf(2.0 / 3.0);
    // Balls thrown against the outer raceway leave the ring that much more room.
    let thrown = problem
        .balls
        .iter()
        .map(|b| {
            let push = b.steady + b.turning / bearing.touching_radius_m();
            (push.max(0.0) / b.outer_stiffness).powf(2.0 / 3.0)
        })
        .fold(0.0, f64::max);
    let mut ring = [0.0, -(bearing.radial_clearance_m() + thrown + series)];
    let (mut force, mut stiffness) = problem.ring(ring);
    for _ in 0..ITERATIONS {
        if norm(force) <= 1e-12 * scale {
            return Ok(ring);
        }
        // Where few balls carry, the ring is free sideways; a little stiffness keeps
        // the step finite.
        let soft = 1e-9 * (stiffness[0][0] + stiffness[1][1]).max(1.0);
        let (a, b, d) = (
            stiffness[0][0] + soft,
            stiffness[0][1],
            stiffness[1][1] + soft,
        );
        let determinant = a * d - b * b;
        let mut step = [
            (d * force[0] - b * force[1]) / determinant,
            (a * force[1] - b * force[0]) / determinant,
        ];
        let most = 0.05 * bearing.ball_radius_m();
        let length = norm(step);
        if length > most {
            step = step.map(|s| s * most / length);
        }
        let mut accepted = false;
        for _ in 0..40 {
            let trial = [ring[0] + step[0], ring[1] + step[1]];
            let (f, k) = problem.ring(trial);
            if norm(f) < norm(force) {
                (ring, force, stiffness) = (trial, f, k);
                accepted = true;
                break;
            }
            step = step.map(|s| s / 2.0);
        }
        if !accepted {
            break;
        }
    }
    // Rounding of 1e-18 m in a deflection is this much force.
    if norm(force) <= 1e-7 * scale {
        return Ok(ring);
    }
    Err(EquilibriumError::NotConverged {
        residual_n: norm(force),
        iterations: ITERATIONS,
    })
}
