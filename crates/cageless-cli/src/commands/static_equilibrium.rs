//! `cageless static`.

use cageless::equilibrium::solve;
use cageless_study::StaticResult;

use super::{deliver, read_case};
use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::format::{columns, pairs, warnings};

/// Solves and shows the equilibrium.
pub fn static_equilibrium(args: &CaseArgs) -> Result<(), Failure> {
    let file = read_case(args)?;
    let e = solve(file.case())?;
    let result = StaticResult::new(e);
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
        + &columns(&rows)
        + &warnings(&result.warnings);
    deliver(args, "static.json", &result, &text)
}
