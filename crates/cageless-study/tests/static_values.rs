//! Numbers of `static` against a computation apart from this program: a 6008 full complement with
//! silicon nitride balls at 9000 rpm under 2 kN, exact elliptic integrals, balls and ring massless.

use cageless::equilibrium::settle;
use cageless_io::case_file::CaseFile;
use cageless_io::designation::find;
use cageless_results::{Cell, Record, static_record};

fn result(changes: &[&str]) -> Record {
    let text = find("6008").unwrap().case_file(true);
    let sets = [
        "ball_material.preset=Si3N4",
        "operation.inner_speed_rpm=9000",
        "operation.radial_load_n=2000",
    ];
    let sets: Vec<String> = sets
        .iter()
        .chain(changes)
        .map(|s| (*s).to_owned())
        .collect();
    let file = CaseFile::parse(&text, "case.toml", &sets).unwrap();
    static_record(
        file.case(),
        file.particulars(),
        &settle(file.case()).unwrap(),
    )
}

#[test]
fn numbers_are_those_of_a_computation_by_hand() {
    let record = result(&[]);
    let r = &record.results;
    let forces = r.values("inner_force_n");
    let most = (0..21).max_by(|a, b| forces[*a].total_cmp(&forces[*b]));
    let k = most.unwrap();
    let (one, of_ball) = (|name: &str| r.number(name), |name: &str| r.values(name)[k]);
    for (name, found, expected, tolerance) in [
        ("FTF", one("ftf_hz"), 63.976, 1e-5),
        ("BPFO", one("bpfo_hz"), 1343.490, 1e-6),
        ("BPFI", one("bpfi_hz"), 1806.510, 1e-6),
        ("BSF", one("bsf_hz"), 499.212, 2e-6),
        ("n·Dpw", one("speed_factor_mm_rpm"), 486_000.0, 1e-9),
        ("Fi", of_ball("inner_force_n"), 486.88, 2e-5),
        ("Fo", of_ball("outer_force_n"), 490.59, 2e-5),
        ("pi", of_ball("inner_pressure_mpa"), 2195.77, 2e-5),
        ("po", of_ball("outer_pressure_mpa"), 1924.44, 2e-5),
        ("pi max", one("inner_pressure_max_mpa"), 2195.77, 2e-5),
        ("po max", one("outer_pressure_max_mpa"), 1924.44, 2e-5),
        (
            "inner, along",
            of_ball("inner_semi_axis_along_mm"),
            0.108_69,
            1e-4,
        ),
        (
            "inner, across",
            of_ball("inner_semi_axis_across_mm"),
            0.974_08,
            2e-5,
        ),
        (
            "outer, along",
            of_ball("outer_semi_axis_along_mm"),
            0.127_54,
            1e-4,
        ),
        (
            "outer, across",
            of_ball("outer_semi_axis_across_mm"),
            0.954_33,
            2e-5,
        ),
        ("Ki", one("inner_stiffness_n_m1_5"), 3.04818e10, 1e-5),
        ("Ko", one("outer_stiffness_n_m1_5"), 3.17795e10, 1e-5),
        ("kxx", one("stiffness_xx_n_m"), 106.69e6, 2e-3),
        ("kyy", one("stiffness_yy_n_m"), 262.52e6, 1e-3),
        ("y", one("ring_y_um"), -19.0391, 3e-4),
        // ½ n Ri/|rb|, Gr = 13 µm: Ri = 27 − 3.96875 − 0.00325 mm, |rb| = 27 + 0.00325 mm + (Fo/Ko)^(2/3).
        (
            "orbit",
            of_ball("ball_orbit_rpm"),
            4500.0 * 23.028 / 27.009_450_5,
            1e-6,
        ),
        (
            "rotation",
            of_ball("ball_rotation_rpm"),
            60.0 * (499.212 - 63.976),
            3e-4,
        ),
        ("r", of_ball("effective_radius_mm"), 3.96875, 1e-9),
        // 24 361 N with bm = 1.3, by the filling slot that 21 balls need 1.1/1.3 of it.
        ("Cr", one("basic_dynamic_rating_n"), 20_613.0, 5e-5),
        ("L10", one("l10_mrev"), (20.613f64 / 2.0).powi(3), 2e-4),
        (
            "L10 h",
            one("l10_h"),
            (20.613f64 / 2.0).powi(3) / 0.54,
            2e-4,
        ),
        ("L10r h", one("l10r_h"), one("l10r_mrev") / 0.54, 1e-9),
        (
            "at speed h",
            one("l10r_at_speed_h"),
            one("l10r_at_speed_mrev") / 0.54,
            1e-9,
        ),
        (
            "s0",
            one("static_safety_factor"),
            one("basic_static_rating_n") / 2000.0,
            1e-12,
        ),
    ] {
        let off = found / expected - 1.0;
        assert!(
            off.abs() < tolerance,
            "{name}: {found} for {expected}: {off:e}"
        );
    }
    // At that factor on the load of 2000 N the largest pressure is 4200 MPa.
    let load_n = 2000.0 * one("pressure_safety");
    let at_limit = result(&[&format!("operation.radial_load_n={load_n}")]);
    let most = at_limit.results.number("inner_pressure_max_mpa");
    assert!((most / 4200.0 - 1.0).abs() < 1e-6, "{most}");
    // Rigid rings against elastic ones: the distributions differ by little.
    let ratio = one("l10r_at_speed_mrev") / one("l10r_mrev");
    assert!((0.9..1.0).contains(&ratio), "{ratio}");
    assert_eq!(r.get("assembly"), Some(&Cell::Text("filling-slot".into())));
    assert!(
        record
            .sentences("notes")
            .iter()
            .any(|n| n.contains("bm = 1.1")),
        "{:?}",
        record.sentences("notes")
    );
    assert!(
        record
            .sentences("notes")
            .iter()
            .any(|n| n.contains("ISO 20056-1")),
        "{:?}",
        record.sentences("notes")
    );
}

/// The caged bearing: 16 775 N, L10 = 590.06 million revolutions, 1092.7 h; NSK has 16.8 and 11.5 kN.
#[test]
fn a_bearing_without_slot_keeps_the_factor_of_iso_281() {
    let record = result(&["bearing.balls=12", "bearing.assembly=without-slot"]);
    let r = |name| record.results.number(name);
    assert!(
        (r("l10_mrev") / 590.06 - 1.0).abs() < 1e-4,
        "{:?}",
        r("l10_mrev")
    );
    assert!((r("l10_h") / 1092.7 - 1.0).abs() < 1e-4);
    assert!((r("basic_static_rating_n") / 11_519.0 - 1.0).abs() < 1e-4);
    let other_record = result(&["bearing.balls=12", "bearing.assembly=filling-slot"]);
    let ratio = r("basic_dynamic_rating_n") / other_record.results.number("basic_dynamic_rating_n");
    assert!((ratio - 1.3 / 1.1).abs() < 1e-12);
}
