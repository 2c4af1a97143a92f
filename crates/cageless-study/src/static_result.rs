//! The numbers of a static equilibrium, in the units in which they are shown.

use cageless::equilibrium::Equilibrium;
use serde::Serialize;

/// `static --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StaticResult {
    /// Centre of the inner ring, µm.
    pub ring_x_um: f64,
    /// Centre of the inner ring, µm.
    pub ring_y_um: f64,
    /// ψ of each ball, degrees.
    pub ball_angle_deg: Vec<f64>,
    /// Fi of each ball, N.
    pub inner_force_n: Vec<f64>,
    /// Fo of each ball, N.
    pub outer_force_n: Vec<f64>,
    /// r of each ball, mm.
    pub effective_radius_mm: Vec<f64>,
    /// K at the inner raceway, N·m^(−3/2).
    pub inner_stiffness: f64,
    /// K at the outer raceway, N·m^(−3/2).
    pub outer_stiffness: f64,
    /// Largest Hertz stress at the inner raceway, GPa.
    pub inner_stress_max_gpa: f64,
    /// Largest Hertz stress at the outer raceway, GPa.
    pub outer_stress_max_gpa: f64,
    /// Warnings.
    pub warnings: Vec<String>,
}

impl StaticResult {
    /// Result of an equilibrium.
    pub fn new(e: Equilibrium) -> Self {
        Self {
            warnings: e.overload().into_iter().collect(),
            ring_x_um: e.ring_x_m * 1e6,
            ring_y_um: e.ring_y_m * 1e6,
            ball_angle_deg: e.ball_angle_rad.iter().map(|a| a.to_degrees()).collect(),
            inner_force_n: e.inner_force_n,
            outer_force_n: e.outer_force_n,
            effective_radius_mm: e.effective_radius_m.iter().map(|r| r * 1e3).collect(),
            inner_stiffness: e.inner_stiffness_n_m1_5,
            outer_stiffness: e.outer_stiffness_n_m1_5,
            inner_stress_max_gpa: e.inner_stress_max_pa * 1e-9,
            outer_stress_max_gpa: e.outer_stress_max_pa * 1e-9,
        }
    }
}
