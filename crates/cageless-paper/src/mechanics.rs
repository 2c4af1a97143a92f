//! Closed forms with which the paper's formulas are compared.

use cageless::Case;
use cageless::equilibrium::solve;
use cageless::kinematics::{
    rolling_orbit_speed_rad_s, rolling_relative_rotation_rad_s, rolling_rotation_rad_s,
};
use cageless_study::StudyError;

/// Numbers of one bearing, as the paper prints the formulas and as they must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mechanics {
    /// ε = 2 arcsin(Rw/Rm), degrees.
    pub epsilon_deg: f64,
    /// ε of Eq. (10) as printed, degrees.
    pub printed_epsilon_deg: f64,
    /// 360°/N.
    pub spacing_deg: f64,
    /// Outer force on the topmost ball with Fw of Eq. (15) and without it, N.
    pub top_force_n: [f64; 2],
    /// Rate of the relative spin of Eq. (13) over that of the absolute spin, of a ball that rolls
    /// into the raceway.
    pub spin_rate: f64,
    /// Sum of the forces on the ring at rest over its load: Eq. (14) with the force of Eq. (12) as
    /// printed, and with its reaction.
    pub ring_residual: [f64; 2],
}

impl Mechanics {
    /// From the static equilibrium under the equations as published and without Fw.
    pub fn new(published: &Case, consistent: &Case) -> Result<Self, StudyError> {
        let bearing = &consistent.bearing;
        let (rw, rm) = (bearing.ball_radius_m(), bearing.pitch_radius_m());
        // arccos((2Rm² − Rw²)/(2Rm²)) doubled: the chord is Rw.
        let chord = ((2.0 * rm * rm - rw * rw) / (2.0 * rm * rm)).acos();
        let top = |case: &Case| -> Result<f64, StudyError> {
            let found = solve(case)?;
            let height = |k: &usize| -found.ball_distance_m[*k] * found.ball_angle_rad[*k].cos();
            let highest = (0..bearing.balls()).max_by(|a, b| height(a).total_cmp(&height(b)));
            Ok(highest.map_or(f64::NAN, |k| found.outer_force_n[k]))
        };
        let rate = |spin: fn(&cageless::Bearing, f64, f64) -> f64| {
            let at = |r: f64| {
                let speed = consistent.operation.inner_speed_rad_s;
                spin(bearing, rolling_orbit_speed_rad_s(bearing, speed, r), r)
            };
            at(0.99 * rw) - at(rw)
        };
        Ok(Self {
            epsilon_deg: bearing.ball_angle_rad().to_degrees(),
            printed_epsilon_deg: 2.0 * chord.to_degrees(),
            spacing_deg: 360.0 / bearing.balls() as f64,
            top_force_n: [top(published)?, top(consistent)?],
            spin_rate: rate(rolling_relative_rotation_rad_s) / rate(rolling_rotation_rad_s),
            ring_residual: ring_residual(consistent)?,
        })
    }
}

/// |Fr + mi·g + s ΣFi| over the load, with s = 1, the force on the balls, and s = −1, on the ring.
fn ring_residual(case: &Case) -> Result<[f64; 2], StudyError> {
    let found = solve(case)?;
    let mass_kg = case.bearing.dimensions().inner_ring_mass_kg;
    let load_n = case.operation.radial_load_n + mass_kg * case.operation.gravity_m_s2;
    let mut on_balls = [0.0; 2];
    for (k, force_n) in found.inner_force_n.iter().enumerate() {
        let (sine, cosine) = found.ball_angle_rad[k].sin_cos();
        let x = found.ball_distance_m[k] * sine - found.ring_x_m;
        let y = -found.ball_distance_m[k] * cosine - found.ring_y_m;
        on_balls[0] += force_n * x / x.hypot(y);
        on_balls[1] += force_n * y / x.hypot(y);
    }
    Ok([1.0, -1.0].map(|s| (s * on_balls[0]).hypot(s * on_balls[1] - load_n) / load_n))
}
