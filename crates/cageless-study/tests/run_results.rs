//! Results and warnings of a run: one table, and the views of it.

use cageless_io::case_file::{CaseFile, template};
use cageless_results::{Cell, RUN, quantities, value_text};
use cageless_study::run::{Options, run};
use cageless_study::{RunSummary, Silent};
use serde_json::Value;

fn summary(conventional: bool, changes: &[&str]) -> RunSummary {
    let changes: Vec<String> = changes.iter().map(|c| (*c).to_owned()).collect();
    let file = CaseFile::parse(&template(conventional), "case.toml", &changes).unwrap();
    let options = Options {
        rows: None,
        verify: false,
    };
    run(&file, options, &Silent).unwrap().summary
}

fn json(summary: &RunSummary) -> Value {
    serde_json::from_str(&summary.to_json().unwrap()).unwrap()
}

/// The rows below the power loss are all of it, the rolling resistance of film and steel among them.
#[test]
fn rows_of_the_power_loss_in_oil_add_up() {
    let oil = [
        "solver.duration_s=0.05",
        "film.viscosity_mpa_s=5",
        "film.viscosity_temperature_1_k=0.035",
        "film.supply=flooded",
        "film.hysteresis=yes",
    ];
    let results = summary(false, &oil).results;
    let groups = results.groups();
    let friction = groups
        .iter()
        .find(|(heading, _)| *heading == "Friction and speed");
    let parts = friction.unwrap().1.iter();
    let parts = parts.filter(|(label, ..)| label.starts_with("  "));
    // Powers of ten are too small to count.
    let parts_w: f64 = parts
        .map(|(_, value, _)| value.parse().unwrap_or(0.0))
        .sum();
    let [loss_w, stored_w, rolling_w] = [
        "power_loss_w",
        "power_loss_stored_w",
        "rolling_resistance_power_w",
    ]
    .map(|name| results.number(name));
    assert!(rolling_w > 0.9 * loss_w, "{rolling_w} of {loss_w}");
    assert!(
        (parts_w + stored_w - loss_w).abs() < 1e-3 * loss_w,
        "{parts_w} {stored_w} {loss_w}"
    );
}

#[test]
fn summary_and_tables_are_views_of_one_table() {
    let summary = summary(false, &["solver.duration_s=0.09"]);
    let json = json(&summary);
    for name in [
        "friction_torque_n_m",
        "power_loss_w",
        "inner_pressure_max_mpa",
        "outer_pressure_max_mpa",
        "ball_pressure_max_mpa",
        "ring_x_mean_um",
        "gap_min_deg",
        "wall_s",
    ] {
        assert!(json[name].is_f64(), "{name}: {}", json[name]);
    }
    assert!(json["passes"].is_boolean());
    assert!(json["steps"].is_u64());
    let of_runs = RUN.iter();
    let elsewhere = [
        "rotor",
        "support",
        "row_",
        "ring_z",
        "tilt",
        "contact_angle",
        "ellipse_edge",
        "rolling_resistance",
        "half_turn",
        "regularisation_speed_mean",
        "film_",
    ];
    let of_runs = of_runs.filter(|q| !elsewhere.iter().any(|part| q.name.contains(part)));
    for quantity in of_runs.clone() {
        assert!(!json[quantity.name].is_null(), "{}", quantity.name);
    }
    let shown: Vec<_> = summary.results.rows().collect();
    assert_eq!(
        shown.len(),
        of_runs
            .filter(|q| q.in_tables && (q.shows_zero || json[q.name].as_f64() != Some(0.0)))
            .count()
    );
    let unit = |label: &str| &shown.iter().find(|r| r.0.starts_with(label)).unwrap().2;
    assert_eq!(
        unit("friction torque in the model, rolling in oil included"),
        "N·mm"
    );
    assert_eq!(unit("friction torque with lubricant"), "N·mm");
    assert_eq!(unit("peak contact pressure"), "MPa");

    let number = |name: &str| json[name].as_f64().unwrap();
    let parts: f64 = (json.as_object().unwrap())
        .keys()
        .filter(|key| key.starts_with("power_loss_") && *key != "power_loss_w")
        .filter_map(|key| json[key].as_f64())
        .sum();
    assert!((parts / number("power_loss_w") - 1.0).abs() < 1e-9);
    let speed = json["case"]["operation"]["inner_speed_rpm"]
        .as_f64()
        .unwrap();
    let power = number("friction_torque_n_m") * speed * std::f64::consts::TAU / 60.0;
    assert!((power / number("power_loss_w") - 1.0).abs() < 1e-12);
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
}

#[test]
fn values_have_four_digits_and_flags_words() {
    let quantity = |name: &str| quantities().find(|q| q.name == name).unwrap();
    let text = |name: &str, cell| value_text(quantity(name), &cell);
    assert_eq!(
        text("power_loss_w", Cell::Number(31.234_567)).unwrap(),
        "31.23"
    );
    for (name, value, printed, unit) in [
        ("inner_pressure_max_mpa", 2195.77, "2196", "MPa"),
        ("friction_torque_n_m", 3.7e-5, "0.037", "N·mm"),
    ] {
        assert_eq!(text(name, Cell::Number(value)).unwrap(), printed);
        assert_eq!(quantity(name).printed_unit(), unit);
    }
    assert_eq!(text("passes", Cell::Integer(0)).unwrap(), "no");
    assert_eq!(text("steps", Cell::Integer(1_234_567)).unwrap(), "1234567");
    assert_eq!(text("gap_min_deg", Cell::Null), None);
}

#[test]
fn a_conventional_ring_is_not_judged() {
    let summary = summary(true, &["solver.duration_s=0.004"]);
    let json = json(&summary);
    assert_eq!(json["verdict"], "not-judged");
    assert!(json["passes"].is_null());
    assert!(summary.headline().starts_with("not judged"));
}

#[test]
fn loads_that_no_bearing_stands_are_warned_of() {
    let warned = |changes: &[&str], words: &str| {
        let all = summary(false, changes).warnings;
        assert!(all.iter().any(|w| w.contains(words)), "{words}: {all:?}");
    };
    let fast = [
        "operation.inner_speed_rpm=60000",
        "contact.friction_coefficient=0.15",
        "solver.duration_s=0.008",
    ];
    warned(
        &[
            "operation.inner_speed_rpm=60000",
            "operation.radial_load_n=15000",
            "contact.friction_coefficient=0.5",
            "solver.duration_s=0.008",
        ],
        "the power loss of",
    );
    warned(&fast, "pressure × sliding speed");
    warned(
        &["operation.inner_speed_rpm=70000", "solver.duration_s=0.001"],
        "n·Dpw",
    );
    warned(
        &["operation.radial_load_n=40000", "solver.duration_s=0.004"],
        "the contact pressure at the inner raceway reaches",
    );
}

/// Creep of the relaxed stick beyond that of the smooth law, with the step that ends it.
#[test]
fn coulomb_friction_far_from_its_limit_is_warned_of() {
    let warnings = |step_us: &str| {
        let overrides = [
            "solver.method=abm4",
            "contact.friction_law=coulomb",
            "contact.friction_coefficient=0.3",
            "solver.duration_s=0.0002",
            &format!("solver.step_us={step_us}"),
        ]
        .map(str::to_owned);
        let found = summary(false, &overrides.each_ref().map(String::as_str)).warnings;
        found.into_iter().find(|w| w.contains("Coulomb"))
    };
    let warning = warnings("auto").expect("a warning");
    assert!(warning.contains("creep by up to 0.5"), "{warning}");
    assert!(
        warning.contains("solver.step_us to 0.03 or less"),
        "{warning}"
    );
    assert_eq!(warnings("0.03"), None);
}

/// A fall of friction that one step jumps over, with the step that follows it.
#[test]
fn steep_falls_of_friction_are_warned_of() {
    let warning = |speed_m_s: &str, step_us: &str| {
        let overrides = [
            "solver.method=verlet",
            "contact.friction_law=stribeck",
            "contact.friction_coefficient=0.1",
            "contact.static_friction_coefficient=0.2",
            &format!("contact.stribeck_speed_m_s={speed_m_s}"),
            "solver.duration_s=0.0002",
            &format!("solver.step_us={step_us}"),
        ]
        .map(str::to_owned);
        let found = summary(false, &overrides.each_ref().map(String::as_str)).warnings;
        found.into_iter().find(|w| w.contains("falls so steeply"))
    };
    // 0.1 s/m is resolved at 2 µs, 2 s/m is not.
    assert_eq!(warning("1.0", "2"), None);
    let steep = warning("0.05", "2").expect("a warning");
    assert!(steep.contains("above 0.51"), "{steep}");
    assert_eq!(warning("0.05", "0.2"), None);
}

/// Where the speed of the ring follows a table there is no frequency of pure rolling.
#[test]
fn frequencies_of_rolling_need_one_speed() {
    let table = "operation.inner_speed_rpm=[[0.0, 100.0], [0.01, 20000.0]]";
    let summary = summary(false, &["solver.duration_s=0.0005", table]);
    for name in [
        "ftf_hz",
        "bpfo_hz",
        "bpfi_hz",
        "bsf_hz",
        "friction_torque_skf_n_m",
    ] {
        assert_eq!(summary.results.get(name), Some(&Cell::Null), "{name}");
    }
}
