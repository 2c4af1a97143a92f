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
//! All balls pass through the same Ω(ψ). In an orbit of the time T = ∮ dψ/Ω a ball is ahead of one that turns steadily,
//! with Ω̄ = 2π/T, by
//!
//!   a(ψ) = ψ − Ω̄ ∫ dψ/Ω,
//!
//! the ball advance, which the pockets of a cage would have to admit. Balls without a cage that follow each other at
//! equal times T/N lose of their mean gap in an orbit
//!
//!   max (a(t) − a(t + T/N)),
//!
//! and every gap loses as much in each orbit: balls with a smaller mean gap meet in each of them.
//!
//! Larger balls have another Ω̄, by which neighbours drift. In the plane they touch the inner raceway over a longer part
//! of the orbit, and their weight slows them over a shorter one. In space the drift is left out: it hangs on the axis
//! about which a lightly loaded ball turns, and race control gives more than the motion has, and of the other sign.
//!
//! ```
//! use cageless::reference;
//! use cageless::BallAdvance;
//! use cageless::equilibrium::settle;
//!
//! let mut case = reference::conventional(); // Zhao 2022, Table 1
//! case.operation.space.axial_load_n = 500.0;
//!
//! let advance = BallAdvance::new(&case, &settle(&case)?).unwrap();
//! // Balls run ahead where their contact angle is large, on the side away from the radial load.
//! assert!(advance.orbit_speed_rad_s[7] > advance.orbit_speed_rad_s[0]);
//! assert!(advance.clearance_rad < case.bearing.mean_gap_rad());
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod ball_orbit;
mod rolling_energy;
mod rolling_row;

use crate::ball_grade::ball_grade;
use crate::case::Case;
use crate::equilibrium::space::{RollingBall, SpatialEquilibrium};
use crate::steady::GRADE;
use ball_orbit::{BallOrbit, orbit_radius_m};
use rolling_energy::RollingEnergy;

/// Orbital speeds of the balls in a static equilibrium, and what follows from their difference.
#[derive(Debug, Clone, PartialEq)]
pub struct BallAdvance {
    /// Ω of every ball, those of all rows one row after the other.
    pub orbit_speed_rad_s: Vec<f64>,
    /// Absolute rotation of every ball, vt/ro, clockwise.
    pub rotation_rad_s: Vec<f64>,
    /// Ω̄ of the balls of the first row, rad/s: 2π over the time of an orbit.
    pub mean_speed_rad_s: f64,
    /// Largest difference of Ω around the bearing, of the row where it is largest.
    pub speed_difference_rad_s: f64,
    /// Ball advance, from the least a(ψ) to the largest; of the row where it is largest.
    pub advance_rad: f64,
    /// Mean gap below which neighbours meet by the ball advance in every orbit; of the row where it is largest.
    pub clearance_rad: f64,
    /// Difference of Ω̄ of the neighbours whose radii differ most; of equal balls, of the smallest and the largest of a
    /// lot of grade 10. In the plane.
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

    /// Speeds and advance of the balls of two rows, those of `other` last.
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
        let of_size = |deviation_m| BallOrbit::new(case, settled, row, deviation_m);
        let deviations_m = case.bearing.ball_radius_deviations_m();
        let mean_m = match deviations_m {
            [] => 0.0,
            some => some.iter().sum::<f64>() / some.len() as f64,
        };
        let mean = of_size(mean_m)?;
        let drift_rad_s = || {
            let [a, b] = extreme_neighbours_m(deviations_m).map(of_size);
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
    let of_lot_m = ball_grade(GRADE).map_or(0.0, |grade| grade.radius_deviation_m());
    pairs
        .max_by(|a, b| apart(a).total_cmp(&apart(b)))
        .unwrap_or([-of_lot_m, of_lot_m])
}

/// Ω and rotation of ball `k` among all: by its own place where the inner raceway presses it, else by its energy at
/// its ψ.
fn speeds_rad_s(
    case: &Case,
    settled: &SpatialEquilibrium,
    orbit: &BallOrbit,
    k: usize,
) -> (f64, f64) {
    let rest = &settled.rest;
    let number = (0..k).filter(|j| settled.row[*j] == settled.row[k]).count();
    let rolling = RollingBall {
        angle_rad: rest.ball_angle_rad[k],
        distance_m: rest.ball_distance_m[k],
        speed_m_s: settled.orbit_speed_rad_s[k] * case.bearing.pitch_radius_m(),
        outer_arm: rest.effective_radius_m[k] / case.bearing.ball(number).radius_m,
        inner_depth_m: f64::NAN,
    };
    let kept =
        RollingEnergy::new(case, &rolling).speed_m_s(orbit.energy_at_m2_s2(rolling.angle_rad));
    let kept = kept.filter(|_| rest.inner_force_n[k] == 0.0);
    let speed_m_s = kept.unwrap_or(rolling.speed_m_s);
    let orbit = speed_m_s / orbit_radius_m(case, rolling.distance_m);
    (orbit, speed_m_s / rest.effective_radius_m[k])
}
