//! `cageless static`.

use cageless::equilibrium::solve;
use serde::Serialize;

use super::{deliver, read_case};
use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::format::{columns, pairs};

/// `static --json`.
#[derive(Debug, Serialize)]
struct StaticResult {
    ring_x_um: f64,
    ring_y_um: f64,
    ball_angle_deg: Vec<f64>,
    inner_force_n: Vec<f64>,
    outer_force_n: Vec<f64>,
    effective_radius_mm: Vec<f64>,
    inner_stiffness: f64,
    outer_stiffness: f64,
    inner_stress_max_gpa: f64,
    outer_stress_max_gpa: f64,
}

/// Solves and shows the equilibrium.
pub fn static_equilibrium(args: &CaseArgs) -> Result<(), Failure> {
    let file = read_case(args)?;
    let e = solve(file.case())?;
    let result = StaticResult {
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
    };
    let head = ["ball", "ψ °", "r mm", "inner force N", "outer force N"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for k in 0..result.ball_angle_deg.len() {
        rows.push(vec![
            format!("{}", k + 1),
            format!("{:.3}", result.ball_angle_deg[k]),
            format!("{:.4}", result.effective_radius_mm[k]),
            format!("{:.2}", result.inner_force_n[k]),
            format!("{:.2}", result.outer_force_n[k]),
        ]);
    }
    let text = pairs(&[
        (
            "ring displacement",
            format!("x {:.4} µm, y {:.4} µm", result.ring_x_um, result.ring_y_um),
        ),
        (
            "inner stiffness",
            format!("{:.4e} N/m^1.5", result.inner_stiffness),
        ),
        (
            "outer stiffness",
            format!("{:.4e} N/m^1.5", result.outer_stiffness),
        ),
        (
            "inner peak stress",
            format!("{:.4} GPa", result.inner_stress_max_gpa),
        ),
        (
            "outer peak stress",
            format!("{:.4} GPa", result.outer_stress_max_gpa),
        ),
    ]) + "\n"
        + &columns(&rows);
    deliver(args, "static.json", &result, &text)
}
