//! Numbers of `static` against a computation apart from this program: a 6008 full complement with
//! silicon nitride balls at 9000 rpm under 2 kN, exact elliptic integrals, balls and ring massless.

use cageless::equilibrium::solve;
use cageless_io::case_file::CaseFile;
use cageless_io::designation::find;
use cageless_study::StaticResult;

fn result(changes: &[&str]) -> StaticResult {
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
    StaticResult::new(file.case(), solve(file.case()).unwrap())
}

#[test]
fn numbers_are_those_of_a_computation_by_hand() {
    let r = result(&[]);
    let most = (0..21).max_by(|a, b| r.inner_force_n[*a].total_cmp(&r.inner_force_n[*b]));
    let k = most.unwrap();
    let [[kxx, _], [_, kyy]] = r.stiffness_n_m.unwrap();
    for (name, found, expected, tolerance) in [
        ("FTF", r.ftf_hz, 63.976, 1e-5),
        ("BPFO", r.bpfo_hz, 1343.490, 1e-6),
        ("BPFI", r.bpfi_hz, 1806.510, 1e-6),
        ("BSF", r.bsf_hz, 499.212, 2e-6),
        ("n·Dpw", r.speed_parameter_mm_rpm, 486_000.0, 1e-9),
        ("Fi", r.inner_force_n[k], 486.88, 2e-5),
        ("Fo", r.outer_force_n[k], 490.59, 2e-5),
        ("pi", r.inner_pressure_gpa[k], 2.195_77, 2e-5),
        ("po", r.outer_pressure_gpa[k], 1.924_44, 2e-5),
        ("pi max", r.inner_stress_max_gpa, 2.195_77, 2e-5),
        ("po max", r.outer_stress_max_gpa, 1.924_44, 2e-5),
        ("inner, along", r.inner_semi_axes_mm[k][0], 0.108_69, 1e-4),
        ("inner, across", r.inner_semi_axes_mm[k][1], 0.974_08, 2e-5),
        ("outer, along", r.outer_semi_axes_mm[k][0], 0.127_54, 1e-4),
        ("outer, across", r.outer_semi_axes_mm[k][1], 0.954_33, 2e-5),
        ("Ki", r.inner_stiffness, 3.04818e10, 1e-5),
        ("Ko", r.outer_stiffness, 3.17795e10, 1e-5),
        ("kxx", kxx, 106.69e6, 2e-3),
        ("kyy", kyy, 262.52e6, 1e-3),
        ("y", r.ring_y_um, -19.0391, 3e-4),
        ("orbit", r.ball_orbit_rpm[k], 60.0 * 63.976, 2e-4),
        (
            "rotation",
            r.ball_rotation_rpm[k],
            60.0 * (499.212 - 63.976),
            3e-4,
        ),
        ("r", r.effective_radius_mm[k], 3.96875, 1e-9),
        // 24 361 N with bm = 1.3, by the filling slot that 21 balls need 1.1/1.3 of it.
        ("Cr", r.basic_dynamic_rating_n, 20_613.0, 5e-5),
        ("L10", r.l10_mrev.unwrap(), (20.613f64 / 2.0).powi(3), 2e-4),
        (
            "L10 h",
            r.l10_h.unwrap(),
            (20.613f64 / 2.0).powi(3) / 0.54,
            2e-4,
        ),
        (
            "(4200 MPa/p)³",
            r.pressure_safety.unwrap(),
            (4200.0f64 / 2195.77).powi(3),
            1e-4,
        ),
        (
            "L10r h",
            r.l10r_h.unwrap(),
            r.l10r_mrev.unwrap() / 0.54,
            1e-9,
        ),
        (
            "at speed h",
            r.l10r_at_speed_h.unwrap(),
            r.l10r_at_speed_mrev.unwrap() / 0.54,
            1e-9,
        ),
        (
            "s0",
            r.static_safety.unwrap(),
            r.basic_static_rating_n / 2000.0,
            1e-12,
        ),
    ] {
        let off = found / expected - 1.0;
        assert!(
            off.abs() < tolerance,
            "{name}: {found} for {expected}: {off:e}"
        );
    }
    // Rigid rings against elastic ones: the distributions differ by little.
    let ratio = r.l10r_at_speed_mrev.unwrap() / r.l10r_mrev.unwrap();
    assert!((0.9..1.0).contains(&ratio), "{ratio}");
    assert_eq!(r.assembly, "filling-slot");
    assert!(
        r.notes.iter().any(|n| n.contains("bm = 1.1")),
        "{:?}",
        r.notes
    );
    assert!(
        r.notes.iter().any(|n| n.contains("ISO 20056-1")),
        "{:?}",
        r.notes
    );
}

/// The caged bearing: 16 775 N, L10 = 590.06 million revolutions, 1092.7 h; NSK has 16.8 and 11.5 kN.
#[test]
fn a_bearing_without_slot_keeps_the_factor_of_iso_281() {
    let r = result(&["bearing.balls=12", "bearing.assembly=without-slot"]);
    assert!(
        (r.l10_mrev.unwrap() / 590.06 - 1.0).abs() < 1e-4,
        "{:?}",
        r.l10_mrev
    );
    assert!((r.l10_h.unwrap() / 1092.7 - 1.0).abs() < 1e-4);
    assert!((r.basic_static_rating_n / 11_519.0 - 1.0).abs() < 1e-4);
    let other = result(&["bearing.balls=12", "bearing.assembly=filling-slot"]);
    let ratio = r.basic_dynamic_rating_n / other.basic_dynamic_rating_n;
    assert!((ratio - 1.3 / 1.1).abs() < 1e-12);
}
