//! Names of the columns of sweeps in words.

use cageless_results::{Computation, Quantity, bearing_in_column, of_column, quantities};

use crate::sweep::SweepQuantity;

/// Columns of inputs and their names. Results have the label of their table; what is left is named by
/// its words.
const INPUTS: [(&str, &str); 6] = [
    ("bearing_balls", "number of balls"),
    ("raceway_axial_span_mm", "axial span lC"),
    ("raceway_half_angle_deg", "half angle θ"),
    (
        "raceway_centre_angle_deg",
        "angular position of the raceway ψ",
    ),
    ("operation_radial_load_n", "radial load"),
    ("operation_inner_speed_rpm", "speed of the inner ring"),
];

/// Name of a column in words, without its unit.
pub fn name(quantity: &SweepQuantity) -> String {
    if let Some((_, name)) = INPUTS.iter().find(|(column, _)| *column == quantity.name) {
        return (*name).to_owned();
    }
    if let Some((result, bearing)) = of_column(&quantity.name) {
        return in_bearing(result_name(result), bearing);
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

/// Label of a result, with its computation where another one in the same sweep has that label.
fn result_name(result: &Quantity) -> String {
    let label = result.label.trim();
    let shared = |with: Computation| {
        let mut all = quantities().filter(|q| q.in_sweeps);
        all.any(|q| q.computation() == with && q.label.trim() == label)
    };
    match result.computation() {
        Computation::Static if shared(Computation::Run) => format!("{label}, static"),
        Computation::Run if shared(Computation::Verdict) => format!("{label}, in the run"),
        _ => label.to_owned(),
    }
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
    match quantity.sign().as_str() {
        "" => name(quantity),
        unit => format!("{} ({unit})", name(quantity)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A result has the same label on every page, and one of its own in a sweep of all but drops.
    #[test]
    fn results_have_one_label() {
        let mut names = std::collections::BTreeSet::new();
        for result in quantities().filter(|q| q.in_sweeps) {
            let quantity = SweepQuantity {
                name: result.column_name(),
                unit: result.unit.to_owned(),
            };
            let name = name(&quantity);
            assert!(name.starts_with(result.label.trim()), "{}", quantity.name);
            let alone = result.computation() == Computation::Drop || names.insert(name);
            assert!(alone, "{}", quantity.name);
        }
    }

    #[test]
    fn units_have_their_symbols() {
        let of = |unit: &str| {
            label(&SweepQuantity {
                name: "seal".to_owned(),
                unit: unit.to_owned(),
            })
        };
        let units = ["um", "C", "N m", "deg", ""].map(of);
        let expected = ["seal (µm)", "seal (°C)", "seal (N·m)", "seal (°)", "seal"];
        assert_eq!(units, expected);
    }

    #[test]
    fn keys_lose_their_units_and_bearings_come_last() {
        for (column, unit, expected) in [
            ("support_damping_n_s_m", "N s/m", "support damping"),
            (
                "bearing_2_rotor_radial_clearance_um",
                "um",
                "rotor radial clearance, bearing 2",
            ),
            ("bearing_balls", "", "number of balls"),
            (
                "drop_bearing_2_rotor_force_max_over_weight",
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
