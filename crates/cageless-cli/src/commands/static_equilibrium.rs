//! `cageless static`.

use cageless::equilibrium::solve;
use cageless_study::StaticResult;

use super::files::{deliver, read_case};
use crate::args::CaseArgs;
use crate::failure::Failure;
use crate::format::{columns, fixed, notes, pairs, power, warnings};

/// Solves and shows the equilibrium.
pub fn static_equilibrium(args: &CaseArgs) -> Result<(), Failure> {
    let file = read_case(args)?;
    let result = StaticResult::new(file.case(), solve(file.case())?);
    let text = pairs(&headline(&result))
        + "\n"
        + &columns(&balls(&result))
        + "\n"
        + &warnings(&result.warnings)
        + &notes(&result.notes);
    deliver(args, "static.json", &result, &text)
}

fn headline(result: &StaticResult) -> Vec<(&'static str, String)> {
    let mpa = |gpa: f64| format!("{} MPa", fixed(gpa * 1e3, 0));
    let optional = |value: Option<f64>, digits| {
        value.map_or_else(|| "not defined".to_owned(), |v| fixed(v, digits))
    };
    let life = |mrev: Option<f64>, hours: Option<f64>| match mrev {
        None => "not defined without load".to_owned(),
        Some(mrev) => {
            let hours = hours.map_or(String::new(), |h| format!(", {} h", fixed(h, 0)));
            format!("{} million revolutions{hours}", fixed(mrev, 0))
        }
    };
    let stiffness = result.stiffness_n_m.map_or_else(
        || "not defined".to_owned(),
        |[[xx, xy], [_, yy]]| {
            let [xx, xy, yy] = [xx, xy, yy].map(|k| fixed(k * 1e-6, 2));
            format!("kxx {xx}, kyy {yy}, kxy = kyx {xy} N/µm")
        },
    );
    let mut rows = vec![
        (
            "ring displacement",
            format!(
                "x {} µm, y {} µm",
                fixed(result.ring_x_um, 4),
                fixed(result.ring_y_um, 4)
            ),
        ),
        ("stiffness", stiffness),
        (
            "peak contact pressure",
            format!(
                "inner {}, outer {}",
                mpa(result.inner_stress_max_gpa),
                mpa(result.outer_stress_max_gpa)
            ),
        ),
        (
            "static safety factor",
            format!(
                "C0r/Fr {} (ISO 76), (4200 MPa/p)³ {}",
                optional(result.static_safety, 2),
                optional(result.pressure_safety, 2)
            ),
        ),
        (
            "load ratings",
            format!(
                "Cr {} N (ISO 281, {}: bm {}), C0r {} N (ISO 76)",
                fixed(result.basic_dynamic_rating_n, 0),
                result.assembly,
                result.rating_factor,
                fixed(result.basic_static_rating_n, 0)
            ),
        ),
        (
            "rating life L10",
            life(result.l10_mrev, result.l10_h) + " (ISO 281)",
        ),
        (
            "rating life L10r",
            life(result.l10r_mrev, result.l10r_h) + " (ISO/TS 16281)",
        ),
        (
            "L10r with centrifugal force",
            life(result.l10r_at_speed_mrev, result.l10r_at_speed_h),
        ),
        (
            "bearing frequencies",
            format!(
                "FTF {} Hz, BPFO {} Hz, BPFI {} Hz, BSF {} Hz",
                fixed(result.ftf_hz, 3),
                fixed(result.bpfo_hz, 2),
                fixed(result.bpfi_hz, 2),
                fixed(result.bsf_hz, 2)
            ),
        ),
    ];
    if result.raceway_ftf_hz != result.ftf_hz {
        rows.push((
            "with discrete raceway",
            format!("FTF {} Hz in rolling", fixed(result.raceway_ftf_hz, 3)),
        ));
    }
    rows.extend([
        (
            "speed factor n·Dpw",
            format!("{} mm/min", fixed(result.speed_parameter_mm_rpm, 0)),
        ),
        (
            "contact stiffness K",
            format!(
                "inner {}, outer {} N/m^1.5",
                power(result.inner_stiffness),
                power(result.outer_stiffness)
            ),
        ),
    ]);
    rows
}

fn balls(result: &StaticResult) -> Vec<Vec<String>> {
    let head = [
        "ball",
        "ψ °",
        "r mm",
        "Fi N",
        "Fo N",
        "pi MPa",
        "po MPa",
        "semi-axes a × b, inner, mm",
        "semi-axes a × b, outer, mm",
        "orbital speed, rpm",
        "ball speed ω_b (absolute), rpm",
    ];
    let ellipse = |[along, across]: [f64; 2]| {
        if along > 0.0 {
            format!("{along:.4} × {across:.4}")
        } else {
            "–".to_owned()
        }
    };
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for k in 0..result.ball_angle_deg.len() {
        rows.push(vec![
            format!("{}", k + 1),
            fixed(result.ball_angle_deg[k], 3),
            fixed(result.effective_radius_mm[k], 4),
            fixed(result.inner_force_n[k], 2),
            fixed(result.outer_force_n[k], 2),
            fixed(result.inner_pressure_gpa[k] * 1e3, 0),
            fixed(result.outer_pressure_gpa[k] * 1e3, 0),
            ellipse(result.inner_semi_axes_mm[k]),
            ellipse(result.outer_semi_axes_mm[k]),
            fixed(result.ball_orbit_rpm[k], 1),
            fixed(result.ball_rotation_rpm[k], 1),
        ]);
    }
    rows
}
