//! `static` against equilibria solved independently (another implementation, 20 digits,
//! residual force below 1e-18 N). File `reference/statics.json`.

use std::path::Path;

use cageless::equilibrium::solve;
use cageless_io::case_file::CaseFile;
use serde_json::Value;

fn close(found: f64, expected: f64, scale: f64) -> bool {
    (found - expected).abs() <= 1e-9 * scale
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .filter_map(Value::as_f64)
        .collect()
}

#[test]
fn equilibria_agree_with_an_independent_solver() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("tests/reference/statics.json")).unwrap();
    let all: serde_json::Map<String, Value> = serde_json::from_str(&text).unwrap();
    assert_eq!(all.len(), 6);
    for (name, expected) in &all {
        let file = root
            .join("../../cases")
            .join(format!("{}.toml", expected["case"].as_str().unwrap()));
        let set: Vec<String> = expected["set"]
            .as_array()
            .unwrap()
            .iter()
            .filter_map(|s| s.as_str().map(str::to_owned))
            .collect();
        let file = CaseFile::read(&file, &set).unwrap();
        let found = solve(file.case()).unwrap();
        let number = |key: &str| expected[key].as_f64().unwrap();
        assert!(
            close(found.ring_x_m * 1e6, number("ring_x_um"), 10.0),
            "{name}"
        );
        assert!(
            close(found.ring_y_m * 1e6, number("ring_y_um"), 10.0),
            "{name}"
        );
        for (key, value) in [
            ("inner_stiffness_n_m1_5", found.inner_stiffness_n_m1_5),
            ("outer_stiffness_n_m1_5", found.outer_stiffness_n_m1_5),
            ("inner_pressure_max_mpa", found.inner_pressure_max_pa * 1e-6),
        ] {
            assert!(
                close(value, number(key), number(key)),
                "{name} {key}: {value}"
            );
        }
        for (key, values) in [
            ("inner_force_n", &found.inner_force_n),
            ("outer_force_n", &found.outer_force_n),
        ] {
            for (k, (value, wanted)) in values.iter().zip(numbers(&expected[key])).enumerate() {
                assert!(
                    close(*value, wanted, 500.0),
                    "{name} {key} {k}: {value} {wanted}"
                );
            }
        }
    }
}
