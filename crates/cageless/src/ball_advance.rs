//! Orbital speed of the balls around the bearing, the angle that they gain on each other by it, and the clearance
//! that it needs.
//!
//! A ball that rolls on both raceways without sliding has at ψ the orbital speed
//!
//!   Ω = vt/|rb|,   vt = ωi (Ri + ri (1 − cos αi)) ro/(ro + ri′),
//!
//! ro and ri′ the arms of its rotation at the outer and the inner contact: ½ ωi Ri/|rb| in the plane on the plain
//! raceway. The axis of rotation lies across the force at the outer raceway, so that the ball spins on the inner one
//! alone (outer raceway control).
//!
//! A ball that the outer raceway alone carries has no speed of its own. It keeps the energy with which the inner
//! raceway released it,
//!
//!   ½ m vt² (1 + ⅖ (R/ro)²) − m g |rb| cos ψ,
//!
//! as long as it does not fall onto the inner ring.
//!
//! All balls pass through the same Ω(ψ). In a turn of the time T = ∮ dψ/Ω a ball is ahead of one that turns steadily,
//! with Ω̄ = 2π/T, by
//!
//!   a(ψ) = ψ − Ω̄ ∫ dψ/Ω,
//!
//! the ball advance, which the pockets of a cage would have to admit. Balls without a cage that follow each other at
//! equal times T/N lose of their mean gap in a turn
//!
//!   max (a(t) − a(t + T/N)),
//!
//! and every gap loses as much in its turn: balls with a smaller mean gap meet in each of their turns.
//!
//! Larger balls have another Ω̄, by which neighbours drift. In the plane they touch the inner raceway over a longer part
//! of the turn, and their weight slows them over a shorter one. In space the drift is left out: it hangs on the axis
//! about which a lightly loaded ball turns, and race control gives more than the motion has, and of the other sign.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::ball_advance::BallAdvance;
//! use cageless::equilibrium::settle;
//!
//! let mut case = common::conventional(common::dimensions()); // Zhao 2022, Table 1
//! case.operation.space.axial_load_n = 500.0;
//!
//! let advance = BallAdvance::new(&case, &settle(&case)?).unwrap();
//! // Balls run ahead where their contact angle is large, on the side away from the radial load.
//! assert!(advance.orbit_speed_rad_s[7] > advance.orbit_speed_rad_s[0]);
//! assert!(advance.clearance_rad < case.bearing.mean_gap_rad());
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::TAU;

use crate::case::Case;
use crate::equilibrium::space::{RollingBall, RollingRow, SpatialEquilibrium};
use crate::formulation::Formulation;
use crate::numerics::root::brent;
use crate::steady::GRADE;
use crate::tolerance::ball_grade;

/// Places around the bearing, at least.
const PLACES: usize = 360;

/// Error of the place at which the inner raceway releases or meets a ball, rad.
const EDGE_RAD: f64 = 1e-9;

/// Orbital speeds of the balls in a static equilibrium, and what follows from their difference.
#[derive(Debug, Clone, PartialEq)]
pub struct BallAdvance {
    /// Ω of every ball, those of all rows one row after the other.
    pub orbit_speed_rad_s: Vec<f64>,
    /// Absolute rotation of every ball, vt/ro, clockwise.
    pub rotation_rad_s: Vec<f64>,
    /// Ω̄ of the balls of the first row, rad/s: 2π over the time of a turn.
    pub mean_speed_rad_s: f64,
    /// Largest difference of Ω around the bearing, of the row where it is largest.
    pub speed_difference_rad_s: f64,
    /// Ball advance, from the least a(ψ) to the largest; of the row where it is largest.
    pub advance_rad: f64,
    /// Mean gap below which neighbours meet by the ball advance in every turn; of the row where it is largest.
    pub clearance_rad: f64,
    /// Difference of Ω̄ of the neighbours whose radii differ most; of equal balls, of the smallest and the largest of a
    /// lot of grade [`GRADE`]. In the plane.
    pub neighbour_drift_rad_s: Option<f64>,
}

impl BallAdvance {
    /// Ball advance of a case in its static equilibrium; `None` where nothing drives the balls of a row: at a
    /// standstill, or where no ball touches its inner raceway.
    pub fn new(case: &Case, settled: &SpatialEquilibrium) -> Option<Self> {
        if case.operation.inner_speed_rad_s == 0.0 {
            return None;
        }
        let rows = (0..settled.row_preload_m.len()).map(|row| Self::of_row(case, settled, row));
        rows.reduce(|all, row| Some(all?.with(row?)))?
    }

    /// That of two rows, the balls of `other` after these.
    fn with(mut self, other: Self) -> Self {
        self.orbit_speed_rad_s.extend(other.orbit_speed_rad_s);
        self.rotation_rad_s.extend(other.rotation_rad_s);
        Self {
            orbit_speed_rad_s: self.orbit_speed_rad_s,
            rotation_rad_s: self.rotation_rad_s,
            mean_speed_rad_s: self.mean_speed_rad_s,
            speed_difference_rad_s: (self.speed_difference_rad_s).max(other.speed_difference_rad_s),
            advance_rad: self.advance_rad.max(other.advance_rad),
            clearance_rad: self.clearance_rad.max(other.clearance_rad),
            neighbour_drift_rad_s: self.neighbour_drift_rad_s,
        }
    }

    fn of_row(case: &Case, settled: &SpatialEquilibrium, row: usize) -> Option<Self> {
        let balls: Vec<usize> = (0..settled.row.len())
            .filter(|k| settled.row[*k] == row)
            .collect();
        let turn = |deviation_m| Turn::new(case, settled, row, deviation_m);
        let deviations_m = case.bearing.ball_radius_deviations_m();
        let mean_m = match deviations_m {
            [] => 0.0,
            some => some.iter().sum::<f64>() / some.len() as f64,
        };
        let mean = turn(mean_m)?;
        let drift_rad_s = || {
            let [a, b] = extreme_neighbours_m(deviations_m).map(turn);
            Some((a?.mean_rad_s() - b?.mean_rad_s()).abs())
        };
        let in_plane = !case.moves_in_space();
        let speeds = balls.iter().map(|k| speeds_rad_s(case, settled, &mean, *k));
        let (orbit_speed_rad_s, rotation_rad_s) = speeds.unzip();
        Some(Self {
            orbit_speed_rad_s,
            rotation_rad_s,
            mean_speed_rad_s: mean.mean_rad_s(),
            speed_difference_rad_s: mean.speed_difference_rad_s(),
            advance_rad: mean.advance_rad(),
            clearance_rad: mean.closing_rad(balls.len()),
            neighbour_drift_rad_s: in_plane.then(drift_rad_s).flatten(),
        })
    }
}

/// Deviations of the neighbours whose radii differ most, of equal balls those of a lot.
fn extreme_neighbours_m(deviations_m: &[f64]) -> [f64; 2] {
    let count = deviations_m.len();
    let pairs = (0..count).map(|k| [deviations_m[k], deviations_m[(k + 1) % count]]);
    let apart = |[a, b]: &[f64; 2]| (a - b).abs();
    let of_lot_m = ball_grade(GRADE as u32).map_or(0.0, |grade| grade.radius_deviation_m());
    pairs
        .max_by(|a, b| apart(a).total_cmp(&apart(b)))
        .unwrap_or([-of_lot_m, of_lot_m])
}

/// Ω and rotation of ball `k` among all: by its own place where the inner raceway presses it, else by its energy at
/// its ψ.
fn speeds_rad_s(case: &Case, settled: &SpatialEquilibrium, turn: &Turn, k: usize) -> (f64, f64) {
    let rest = &settled.rest;
    let number = (0..k).filter(|j| settled.row[*j] == settled.row[k]).count();
    let rolling = RollingBall {
        angle_rad: rest.ball_angle_rad[k],
        distance_m: rest.ball_distance_m[k],
        speed_m_s: settled.orbit_speed_rad_s[k] * case.bearing.pitch_radius_m(),
        outer_arm: rest.effective_radius_m[k] / case.bearing.ball(number).radius_m,
        inner_depth_m: f64::NAN,
    };
    let kept = Energy::new(case, &rolling).speed_m_s(turn.energy_at_m2_s2(rolling.angle_rad));
    let kept = kept.filter(|_| rest.inner_force_n[k] == 0.0);
    let speed_m_s = kept.unwrap_or(rolling.speed_m_s);
    let orbit = speed_m_s / orbit_radius_m(case, rolling.distance_m);
    (orbit, speed_m_s / rest.effective_radius_m[k])
}

/// Radius of the orbit that turns vt into Ω: |rb|; Rm in the equations as published (Zhao 2022, Eq. (1) and (2)).
fn orbit_radius_m(case: &Case, distance_m: f64) -> f64 {
    match case.formulation {
        Formulation::Physical => distance_m,
        Formulation::Paper => case.bearing.pitch_radius_m(),
    }
}

/// Kinetic and potential energy of a ball that rolls on the outer raceway.
#[derive(Debug, Clone, Copy)]
struct Energy {
    /// Kinetic energy over ½ m vt², 1 + ⅖ (R/ro)².
    kinetic_ratio: f64,
    /// g y, m²/s².
    potential_m2_s2: f64,
}

impl Energy {
    fn new(case: &Case, ball: &RollingBall) -> Self {
        let height_m = -ball.distance_m * ball.angle_rad.cos();
        Self {
            kinetic_ratio: 1.0 + 0.4 / ball.outer_arm.powi(2),
            potential_m2_s2: case.operation.gravity_m_s2 * height_m,
        }
    }

    /// Twice the energy over the mass at vt, m²/s².
    fn at_speed_m2_s2(&self, speed_m_s: f64) -> f64 {
        speed_m_s * speed_m_s * self.kinetic_ratio + 2.0 * self.potential_m2_s2
    }

    /// vt with an energy, m/s; `None` where the ball falls off the outer raceway, vt² < g y.
    fn speed_m_s(&self, energy_m2_s2: f64) -> Option<f64> {
        let square = (energy_m2_s2 - 2.0 * self.potential_m2_s2) / self.kinetic_ratio;
        (square > self.potential_m2_s2).then(|| square.sqrt())
    }
}

/// A place of a ball in its turn.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// ψ, rad, beyond that of the first place.
    angle_rad: f64,
    /// Ω, rad/s.
    orbit_speed_rad_s: f64,
    /// Twice the energy over the mass, m²/s².
    energy_m2_s2: f64,
    /// Time from the first place, s.
    time_s: f64,
}

/// One turn of a ball around the bearing, from a place where the inner raceway drives it.
#[derive(Debug, Clone)]
struct Turn {
    /// ψ of the first place, rad.
    first_rad: f64,
    /// Places up to the first one again.
    places: Vec<Place>,
}

impl Turn {
    fn new(
        case: &Case,
        settled: &SpatialEquilibrium,
        row: usize,
        deviation_m: f64,
    ) -> Option<Self> {
        let mut rolling = RollingRow::new(case, settled, row, deviation_m)?;
        let balls = settled.row.iter().filter(|of| **of == row).count();
        let parts = PLACES.div_ceil(balls);
        let part_rad = TAU / (balls * parts) as f64;
        let lead_rad = case.start.lead_ball_angle_rad;
        let leads = (0..parts).map(|part| rolling.balls(lead_rad + part as f64 * part_rad));
        let leads: Vec<_> = leads.collect();
        let around = (0..balls).flat_map(|k| leads.iter().map(move |seated| seated[k]));
        let mut around: Vec<RollingBall> = around.collect();
        let first = around.iter().position(|ball| ball.inner_depth_m > 0.0)?;
        around.rotate_left(first);
        around.push(around[0]);
        let first_rad = around[0].angle_rad;
        let mut turn = Self {
            first_rad,
            places: Vec::with_capacity(around.len() + 8),
        };
        for pair in around.windows(2) {
            let [here, next] = [&pair[0], &pair[1]];
            turn.push(case, here, here.inner_depth_m > 0.0);
            let [leaves, meets] = [here, next].map(|ball| ball.inner_depth_m > 0.0);
            if leaves != meets {
                let edge = edge(&mut rolling, here, part_rad);
                turn.push(case, &edge, leaves);
                turn.push(case, &edge, meets);
            }
        }
        turn.push(case, &around[0], true);
        Some(turn)
    }

    /// Adds a place, at which the inner raceway drives the ball or does not.
    fn push(&mut self, case: &Case, ball: &RollingBall, is_driven: bool) {
        let energy = Energy::new(case, ball);
        let before = self.places.last().copied();
        let kept = before.filter(|_| !is_driven);
        let kept = kept.and_then(|before| energy.speed_m_s(before.energy_m2_s2));
        let speed_m_s = kept.unwrap_or(ball.speed_m_s);
        let orbit_speed_rad_s = speed_m_s / orbit_radius_m(case, ball.distance_m);
        let beyond_rad = (ball.angle_rad - self.first_rad).rem_euclid(TAU);
        // Rounding takes no place back, and the last one is at the end of the turn.
        let angle_rad = match &before {
            Some(before) if beyond_rad < before.angle_rad - 1.0 => TAU,
            Some(before) => beyond_rad.max(before.angle_rad),
            None => 0.0,
        };
        let time_s = before.map_or(0.0, |before| {
            let slowness = 0.5 / before.orbit_speed_rad_s + 0.5 / orbit_speed_rad_s;
            before.time_s + (angle_rad - before.angle_rad) * slowness
        });
        self.places.push(Place {
            angle_rad,
            orbit_speed_rad_s,
            energy_m2_s2: energy.at_speed_m2_s2(speed_m_s),
            time_s,
        });
    }

    /// T, s.
    fn period_s(&self) -> f64 {
        self.places.last().map_or(f64::NAN, |place| place.time_s)
    }

    /// Ω̄, rad/s.
    fn mean_rad_s(&self) -> f64 {
        TAU / self.period_s()
    }

    fn speed_difference_rad_s(&self) -> f64 {
        span(self.places.iter().map(|place| place.orbit_speed_rad_s))
    }

    /// a at a place.
    fn ahead_rad(&self, place: &Place) -> f64 {
        place.angle_rad - self.mean_rad_s() * place.time_s
    }

    fn advance_rad(&self) -> f64 {
        span(self.places.iter().map(|place| self.ahead_rad(place)))
    }

    /// a at a time, rad.
    fn ahead_at_rad(&self, time_s: f64) -> f64 {
        let time_s = time_s.rem_euclid(self.period_s());
        let next = self.places.partition_point(|place| place.time_s <= time_s);
        let k = next.clamp(1, self.places.len() - 1);
        let [before, after] = [&self.places[k - 1], &self.places[k]];
        let part = (time_s - before.time_s) / (after.time_s - before.time_s);
        self.ahead_rad(before) * (1.0 - part) + self.ahead_rad(after) * part
    }

    /// Largest loss of the gap of one of `balls` to the next in a turn.
    fn closing_rad(&self, balls: usize) -> f64 {
        let lag_s = self.period_s() / balls as f64;
        let lost = |place: &Place| self.ahead_rad(place) - self.ahead_at_rad(place.time_s + lag_s);
        self.places.iter().map(lost).fold(0.0, f64::max)
    }

    /// Twice the energy over the mass at ψ, m²/s²: that of the place before it.
    fn energy_at_m2_s2(&self, angle_rad: f64) -> f64 {
        let beyond_rad = (angle_rad - self.first_rad).rem_euclid(TAU);
        let next = self
            .places
            .partition_point(|place| place.angle_rad <= beyond_rad);
        self.places[next.max(1) - 1].energy_m2_s2
    }
}

/// Ball where the inner raceway releases or meets it, within `part_rad` after `here`.
fn edge(rolling: &mut RollingRow, here: &RollingBall, part_rad: f64) -> RollingBall {
    let depth = |beyond_rad: f64| rolling.balls(here.angle_rad + beyond_rad)[0].inner_depth_m;
    let beyond_rad = brent(depth, 0.0, part_rad, EDGE_RAD).unwrap_or(part_rad);
    rolling.balls(here.angle_rad + beyond_rad)[0]
}

/// Largest less least value.
fn span(values: impl Iterator<Item = f64>) -> f64 {
    let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], v| {
        [least.min(v), most.max(v)]
    });
    ends[1] - ends[0]
}
