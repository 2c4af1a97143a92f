//! Names of the columns of sweeps in words.

use cageless_study::quantities::{Quantity, bearing_in_column};

use crate::sweep::SweepQuantity;

/// Columns and their names; results that are not here have the label of their table, what is left
/// is named by its words.
const NAMES: [(&str, &str); 42] = [
    ("bearing_balls", "number of balls"),
    ("raceway_axial_span_mm", "axial span lC"),
    ("raceway_half_angle_deg", "half angle θ"),
    (
        "raceway_centre_angle_deg",
        "angular position of the raceway ψ",
    ),
    ("operation_radial_load_n", "radial load"),
    ("operation_inner_speed_rpm", "speed of the inner ring"),
    ("static_ring_x_um", "displacement of the inner ring x"),
    ("static_ring_y_um", "displacement of the inner ring y"),
    ("static_inner_force_max_n", "largest force, inner raceway"),
    ("static_outer_force_max_n", "largest force, outer raceway"),
    ("static_loaded_balls", "loaded balls"),
    (
        "static_inner_stiffness_n_m1_5",
        "contact stiffness, inner raceway",
    ),
    (
        "static_outer_stiffness_n_m1_5",
        "contact stiffness, outer raceway",
    ),
    (
        "static_inner_stress_max_gpa",
        "contact pressure, inner raceway",
    ),
    (
        "static_outer_stress_max_gpa",
        "contact pressure, outer raceway",
    ),
    ("design_epsilon_deg", "angular ball pitch at contact ε"),
    ("design_uniform_gap_deg", "nominal gap"),
    ("design_axial_span_limit_mm", "largest axial span, Eq. (8)"),
    ("design_beta0_deg", "β0 of Eq. (11)"),
    ("design_beta0_polar_deg", "β0 with the polar angle"),
    (
        "design_half_angle_for_span_deg",
        "θ of Eq. (11) for the span",
    ),
    ("design_steady_gap_deg", "mean ball spacing in steady state"),
    (
        "design_balls_in_raceway_max",
        "balls in the raceway, at most",
    ),
    ("design_kink_deg", "slope discontinuity at raceway ends"),
    ("verdict_passes", "passes"),
    ("verdict_critical_gap_deg", "critical gap"),
    ("verdict_collisions_mean", "contacts per passage"),
    (
        "verdict_double_collision_fraction",
        "passages hit from both sides",
    ),
    ("verdict_slip_mean_m_s", "sliding speed per passage"),
    ("verdict_speed_drop_fraction", "deceleration in the raceway"),
    ("verdict_gap_leave_min_deg", "smallest gap on leaving"),
    ("verdict_gap_leave_max_deg", "largest gap on leaving"),
    ("run_collisions", "contacts between balls"),
    ("run_gap_min_deg", "smallest gap"),
    ("run_gap_max_deg", "largest gap"),
    (
        "run_ring_x_um_mean",
        "mean displacement of the inner ring x",
    ),
    (
        "run_ring_y_um_mean",
        "mean displacement of the inner ring y",
    ),
    ("run_slip_max_m_s", "largest sliding speed"),
    ("run_settled_after_s", "transient discarded until"),
    ("run_energy_residual_relative", "energy balance error"),
    ("run_steps", "steps"),
    ("run_rhs_evaluations", "force evaluations"),
];

/// Name of a column in words, without its unit.
pub fn name(quantity: &SweepQuantity) -> String {
    if let Some((_, name)) = NAMES.iter().find(|(column, _)| *column == quantity.name) {
        return (*name).to_owned();
    }
    if let Some((result, bearing)) = Quantity::of_column(&quantity.name) {
        return in_bearing(result.label.trim().to_owned(), bearing);
    }
    // `verdict_verdict = smooth`: the share of one verdict.
    if let Some(value) = quantity.name.strip_prefix("verdict_verdict = ") {
        return format!("verdict {value}");
    }
    let unit = quantity.unit.to_lowercase().replace(['/', '.', ' '], "_");
    let plain = match unit.as_str() {
        "" => quantity.name.as_str(),
        unit => quantity.name.strip_suffix(unit).unwrap_or(&quantity.name),
    };
    let (bearing, key) = match bearing_in_column(plain) {
        Some((k, key)) => (Some(k), key),
        None => (None, plain),
    };
    in_bearing(key.trim_matches('_').replace('_', " "), bearing)
}

/// The name of what one of several bearings has.
fn in_bearing(name: String, bearing: Option<usize>) -> String {
    match bearing {
        Some(k) => format!("{name}, bearing {}", k + 1),
        None => name,
    }
}

/// `name (unit)`.
pub fn label(quantity: &SweepQuantity) -> String {
    match quantity.sign() {
        "" => name(quantity),
        unit => format!("{} ({unit})", name(quantity)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_lose_their_units_and_bearings_come_last() {
        for (column, unit, expected) in [
            ("support_damping_n_s_m", "N s/m", "support damping"),
            (
                "bearing_2_rotor_air_gap_um",
                "um",
                "rotor air gap, bearing 2",
            ),
            ("bearing_balls", "", "number of balls"),
            (
                "drop_bearing_2_rotor_force_max_weights",
                "",
                "largest force on the rotor / its weight, bearing 2",
            ),
        ] {
            let quantity = SweepQuantity {
                name: column.to_owned(),
                unit: unit.to_owned(),
            };
            assert_eq!(name(&quantity), expected);
        }
    }
}
