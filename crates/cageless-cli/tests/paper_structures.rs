//! `design` on the ten structures of Zhao 2022, Table 2.

use crate::common::*;
use cageless_paper::{PUBLISHED, Published};
use rayon::prelude::*;

/// The published equations with the published law of friction.
const AS_PUBLISHED: [&str; 2] = ["model.formulation=paper", "contact.friction_law=coulomb"];

/// One structure of each verdict; all ten are those of `reproduce`, whose tests compare them.
#[test]
fn table_2() {
    PUBLISHED.par_iter().step_by(3).for_each(|published| {
        let Published {
            letter: name,
            theory_deg: beta0,
            simulated_deg: critical,
            verdict,
            ..
        } = *published;
        let case = repository_case(&format!("zhao-{name}.toml"));
        let answer = call_on("design", &case, &AS_PUBLISHED, &["--json"]);
        assert_eq!(answer.code, Some(0), "{name}: {}", answer.stderr);
        assert_eq!(answer.stderr, "", "{name}");
        let d = answer.json();
        let number = |key: &str| d[key].as_f64().unwrap_or_else(|| panic!("{name}: {key}"));
        let rounded = |key: &str| (number(key) * 1e4).round() / 1e4;
        assert_eq!(rounded("epsilon_deg"), 23.8982, "{name}");
        assert_eq!(rounded("uniform_gap_deg"), 1.8161, "{name}");
        assert_eq!(rounded("axial_span_limit_mm"), 7.4017, "{name}");
        assert_eq!(rounded("beta0_deg"), beta0, "{name}");
        let found = number("critical_gap_deg");
        assert!(
            (found - critical).abs() < 0.02,
            "{name}: critical gap {found}, published {critical}"
        );
        assert_eq!(d["verdict"], verdict, "{name}: {}", d["reasons"]);
    });
}

/// In the physical formulation balls slip earlier; the theory is the same.
#[test]
fn the_chosen_structure_is_smooth_in_the_physical_profile() {
    let answer = call_on("design", &repository_case("zhao-d.toml"), &[], &["--json"]);
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let d = answer.json();
    assert_eq!(d["verdict"], "smooth", "{d}");
    assert!(!d["reasons"].as_array().unwrap().is_empty());
    let critical = d["critical_gap_deg"].as_f64().unwrap();
    assert!((1.77..1.82).contains(&critical), "{critical}");
    assert_eq!(d["balls_in_raceway_max"], 3);
}
