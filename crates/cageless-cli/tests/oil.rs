//! What `check`, `static` and `run` say of an oil before and beside their numbers.

use crate::common::*;

const OIL: [&str; 3] = [
    "film.oil=iso-vg-32",
    "film.temperature_c=70",
    "film.supply=two-drops",
];

/// Derived values of the oil, in text and JSON; the viscosity in `static` as well.
#[test]
fn the_oil_of_the_film_is_shown() {
    let case = repository_case("zhao-d.toml");
    let answer = call_on("check", &case, &OIL, &[]);
    for fragment in ["oil at the inlet", "η 9.", "β_T 0.02", "W/(m·K)", "kg/m³"] {
        assert!(
            answer.stdout.contains(fragment),
            "{answer:?}: no {fragment}"
        );
    }
    let checked = call_on("check", &case, &OIL, &["--json"]).json();
    let settled = call_on("static", &case, &OIL, &["--json"]).json();
    let viscosity = |value: &serde_json::Value| value.as_f64().unwrap();
    let mpa_s = viscosity(&checked["oil"]["viscosity_mpa_s"]);
    assert!((9.0..10.0).contains(&mpa_s), "{mpa_s}");
    assert_eq!(viscosity(&settled["oil_viscosity_mpa_s"]), mpa_s);
    let dry = call_on("check", &case, &[], &["--json"]).json();
    assert!(dry.get("oil").is_none());
}

/// A film at the inlet stands beside the supply that follows from it; below S = 2 each command says so.
#[test]
fn a_thin_film_at_the_inlet_is_said() {
    let case = repository_case("zhao-d.toml");
    let [thin, thick] =
        ["film.inlet_film_um=0.1", "film.inlet_film_um=5"].map(|inlet| [OIL[0], OIL[1], inlet]);
    let short = [&thin[..], &["solver.duration_s=1e-3"]].concat();
    for (command, sets) in [("check", &thin[..]), ("static", &thin), ("run", &short)] {
        let text = said(&call_on(command, &case, sets, &[]));
        let fragment = "times the least flooded film, below 2";
        assert_eq!(text.matches(fragment).count(), 1, "{command}: {text}");
    }
    for command in ["check", "static"] {
        let text = said(&call_on(command, &case, &thick, &[]));
        assert!(!text.contains("below 2"), "{command}: {text}");
        assert!(text.contains("film.inlet_film_um"), "{command}: {text}");
    }
}

/// Friction of asperities that is left from a lubricated case is said wherever it is used.
#[test]
fn friction_of_asperities_below_that_of_the_film_is_said() {
    let case = repository_case("zhao-d.toml");
    let sheared = [&OIL[..], &["film.traction=film"]].concat();
    let short = [&sheared[..], &["solver.duration_s=1e-3"]].concat();
    for (command, sets) in [("check", &sheared), ("static", &sheared), ("run", &short)] {
        let text = said(&call_on(command, &case, sets, &[]));
        let fragment = "contact.friction_coefficient = 0.007 is that of asperities";
        assert_eq!(text.matches(fragment).count(), 1, "{command}: {text}");
        let given = [&sets[..], &["contact.friction_coefficient=0.11"]].concat();
        let text = said(&call_on(command, &case, &given, &[]));
        assert!(!text.contains("is that of asperities"), "{command}: {text}");
    }
}

/// Oil that is not as warm as the rings is said.
#[test]
fn oil_beside_warm_rings_is_said() {
    let case = repository_case("full-6008.toml");
    let warmed = [
        "fit.shaft=k5",
        "fit.housing=H7",
        "fit.inner_ring_temperature_c=120",
        "fit.outer_ring_temperature_c=115",
    ];
    let sets = [&OIL[..], &warmed].concat();
    for command in ["check", "static"] {
        let text = said(&call_on(command, &case, &sets, &[]));
        assert!(
            text.contains("film.temperature_c = 70 is 45 K from"),
            "{text}"
        );
    }
}

/// A step that is too long for the friction law is said before the run.
#[test]
fn a_step_too_long_for_the_friction_is_said_by_check() {
    let case = repository_case("zhao-d.toml");
    for sets in [
        &["contact.regularisation=kalker"],
        &["contact.regularisation_speed_m_s=1e-4"],
    ] {
        let text = said(&call_on("check", &case, sets, &[]));
        assert!(text.contains("too long for this friction law"), "{text}");
    }
    let text = said(&call_on("check", &case, &[], &[]));
    assert!(!text.contains("too long for this friction law"), "{text}");
}

/// A step with which no run would close its energy balance is refused before anything is computed, with the value that
/// is allowed; implicit friction takes it.
#[test]
fn a_step_too_long_for_rolling_contacts_is_refused() {
    let case = repository_case("zhao-d.toml");
    let creeping = ["contact.regularisation=kalker"];
    for (command, more) in [
        ("run", &[][..]),
        ("compare", &["--with-conventional"]),
        ("design", &["--search"]),
        ("tolerance", &[]),
    ] {
        let answer = call_on(command, &case, &creeping, more);
        assert_eq!(answer.code, Some(2), "{command}: {answer:?}");
        for fragment in [
            "solver.step_us = 1.0 is not possible: it must be at most 0.2",
            "\"verlet\" treats it implicitly",
        ] {
            assert!(answer.stderr.contains(fragment), "{command}: {answer:?}");
        }
    }
    for other in ["solver.method=verlet", "solver.step_us=0.2"] {
        let sets = [creeping[0], other, "solver.duration_s=1e-3"];
        said(&call_on("run", &case, &sets, &[]));
    }
}

fn said(answer: &Answer) -> String {
    assert_eq!(answer.code, Some(0), "{answer:?}");
    format!("{}{}", answer.stdout, answer.stderr)
}
