//! `static`: what it needs and what not, and how it shows what is nothing.

use crate::common::*;

/// An overload is looked at without another integrator: no step is made.
#[test]
fn no_step_is_asked_for_without_motion() {
    let case = repository_case("zhao-d.toml");
    let overload = ["operation.radial_load_n=1e5"];
    let answer = call_on("static", &case, &overload, &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let pressure_mpa = answer.json()["inner_pressure_max_mpa"].as_f64().unwrap();
    // (1e5/1500)^(1/3) of the pressure at 1500 N, nearly.
    assert!((6500.0..7500.0).contains(&pressure_mpa), "{pressure_mpa}");
    let ring = tempfile::tempdir().unwrap();
    let out = ring.path().join("ring.csv");
    let sizes = [
        "bearing.outer_ring_outer_radius_mm=31",
        "bearing.outer_ring_width_mm=16",
        overload[0],
    ];
    let file = ["--format", "csv", "--out", out.to_str().unwrap()];
    let answer = call_on("export", &case, &sizes, &file);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    for command in ["check", "run", "design", "tolerance"] {
        let answer = call_on(command, &case, &overload, &[]);
        assert_eq!(answer.code, Some(2), "{command}: {answer:?}");
        let said = "zhao-d.toml:48: solver.step_us = 1.0 is not possible: it must be at most";
        assert!(answer.stderr.contains(said), "{command}: {answer:?}");
    }
}

/// `static` refuses a speed or load over time, in the plane and in space.
#[test]
fn a_table_over_time_has_no_equilibrium() {
    let case = repository_case("zhao-d.toml");
    for motion in ["auto", "space"] {
        for (key, value) in [
            ("operation.radial_load_n", "[[0,100],[1,3000]]"),
            ("operation.inner_speed_rpm", "[[0,6000],[1,12000]]"),
        ] {
            let sets = [format!("{key}={value}"), format!("model.motion={motion}")];
            let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
            let answer = call_on("static", &case, &sets, &["--json"]);
            assert_eq!(answer.code, Some(2), "{key}: {answer:?}");
            for part in [
                key,
                "one number, not a table over time",
                "a static equilibrium",
            ] {
                assert!(answer.stderr.contains(part), "{part}: {answer:?}");
            }
        }
    }
}

/// Ellipses over a shoulder are warned of in the plane as in space.
#[test]
fn ellipses_over_a_shoulder_are_warned_of_in_every_motion() {
    let case = repository_case("zhao-d.toml");
    let said = "the shoulder of the outer ring cuts off contact ellipses: they reach to ";
    for (set, edge) in [
        ("model.flanks=rigid", "50.1°"),
        ("model.flanks=elastic", "50.1°"),
        ("model.motion=space", "50.1°"),
    ] {
        let sets = [
            "operation.radial_load_n=12000",
            "solver.method=verlet",
            "solver.step_us=auto",
        ];
        let sets = [&sets[..], &[set, "solver.duration_s=0.002"]].concat();
        let answer = call_on("static", &case, &sets, &[]);
        let expected = format!("{said}{edge}, the groove to 49.9°");
        assert!(answer.stdout.contains(&expected), "{set}: {answer:?}");
        assert!(
            call_on("run", &case, &sets, &[]).stdout.contains(said),
            "{set}"
        );
        let fewer = call_on("static", &case, &[set], &[]);
        assert!(!fewer.stdout.contains(said), "{set}: {fewer:?}");
    }
    let sets = [
        "operation.radial_load_n=12000",
        "solver.method=verlet",
        "solver.step_us=auto",
    ];
    let answer = call_on("design", &case, &sets, &[]);
    assert!(
        answer.stdout.contains(&format!("{said}50.1°")),
        "{answer:?}"
    );
}

/// A row that bears nothing along the axis bears 0 N, neither −0 N nor what rounding left.
#[test]
fn nothing_has_no_sign() {
    let case = repository_case("conventional.toml");
    let answer = call_on("static", &case, &["bearing.contact_angle_deg=15"], &[]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert!(
        answer.stdout.contains("row 1 bears 0 N along its axis"),
        "{answer:?}"
    );
    for zero in ["-0 N", "−0 N", "× 10⁻¹³ N", "× 10⁻¹⁴ N"] {
        assert!(!answer.stdout.contains(zero), "{zero}: {answer:?}");
    }
}

/// Standstill, not a direction, is refused.
#[test]
fn a_speed_of_either_sign_is_one() {
    let case = repository_case("zhao-d.toml");
    let answer = call_on("static", &case, &["operation.inner_speed_rpm=0"], &[]);
    assert_eq!(answer.code, Some(2));
    assert!(
        answer
            .stderr
            .contains("inner_speed_rpm = 0 is not possible: it must be other than 0"),
        "{answer:?}"
    );
    let clockwise = call_on("static", &case, &["operation.inner_speed_rpm=-12000"], &[]);
    assert_eq!(clockwise.code, Some(0));
}
