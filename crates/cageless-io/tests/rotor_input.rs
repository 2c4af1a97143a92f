//! Falling rotors and quantities over time in case files.

use crate::common::{edited, refused};
use cageless::StartState;
use cageless_io::case_file::{CaseFile, CaseValue};

fn touchdown() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/touchdown-d.toml");
    std::fs::read_to_string(path).unwrap()
}

fn parse(text: &str) -> CaseFile {
    CaseFile::parse(text, "case.toml", &[]).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn a_rotor_with_its_support_is_read_and_starts_at_rest() {
    let file = parse(&touchdown());
    let case = file.case();
    let rotor = case.rotor.as_ref().unwrap();
    assert_eq!((rotor.mass_kg, rotor.radial_clearance_m), (20.0, 2e-4));
    assert!((rotor.speed_rad_s - 1000.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!((rotor.contact_exponent, rotor.eccentricity_m), (1.0, 0.0));
    assert_eq!(case.support.as_ref().unwrap().damping_n_s_m, 4e3);
    let bore = case.bearing.inner_ring_bore().unwrap();
    assert_eq!((bore.polar_inertia_kg_m2, bore.radius_m), (5.5e-5, 15e-3));
    assert!(case.start.state == StartState::AtRest);
    assert_eq!(case.operation.inner_speed_rad_s, 0.0);
    let text = touchdown().replacen(
        "[support]",
        "[support]\nstop_gap_um = 100.0\nstop_stiffness_n_m = 3e8",
        1,
    );
    let stop = parse(&text).case().support.clone().unwrap().stop.unwrap();
    assert_eq!((stop.gap_m, stop.stiffness_n_m), (1e-4, 3e8));
    let undamped = touchdown().replace("inner_ring_damping_n_s_m = 0.0", "");
    assert_eq!(parse(&undamped).case(), case);
    let again = parse(&file.document().to_toml().unwrap());
    assert_eq!((again.case(), again.document()), (case, file.document()));
}

#[test]
fn bad_rotors_are_named() {
    for (from, to, key, words) in [
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = 0.0",
            "rotor.radial_clearance_um",
            "more than 0 µm",
        ),
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = -1.0",
            "rotor.radial_clearance_um",
            "more than 0 µm",
        ),
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = 200.0\ny_um = -250.0",
            "rotor.y_um",
            "the touch-down clearance limits, is at most 200 µm, and it is 250 µm",
        ),
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = 200.0\nx_um = 150.0\ny_um = -150.0",
            "rotor.y_um",
            "is at most 200 µm, and it is 212.133 µm",
        ),
        (
            "mass_kg = 20.0",
            "mass_kg = -20.0",
            "rotor.mass_kg",
            "more than 0 kg",
        ),
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = 200.0\nvz_m_s = 0.1",
            "rotor.vz_m_s",
            "0, or with an axial_clearance_um",
        ),
        (
            "radial_clearance_um = 200.0",
            "radial_clearance_um = 200.0\nz_um = 5",
            "rotor.z_um",
            "0, or with an axial_clearance_um",
        ),
        (
            "mass_kg = 0.5",
            "mass_kg = -0.5",
            "support.mass_kg",
            "more than 0 kg",
        ),
        (
            "polar_inertia_kg_m2 = 0.02",
            "",
            "rotor.polar_inertia_kg_m2",
            "missing in [rotor]",
        ),
        (
            "inner_ring_polar_inertia_kg_m2 = 5.5e-5",
            "",
            "bearing.inner_ring_polar_inertia_kg_m2",
            "missing in [bearing]",
        ),
        (
            "inner_ring_bore_radius_mm = 15.0",
            "",
            "bearing.inner_ring_bore_radius_mm",
            "missing in [bearing]",
        ),
        (
            "inner_ring_bore_radius_mm = 15.0",
            "inner_ring_bore_radius_mm = 19.0",
            "bearing.inner_ring_bore_radius_mm",
            "less than 18.24 mm",
        ),
        (
            "contact_stiffness_n_mp = 1.0e9",
            "contact_stiffness_n_mp = 1.0e19",
            "rotor.contact_stiffness_n_mp",
            "at most",
        ),
        (
            "contact_stiffness_n_mp = 1.0e9",
            "contact_stiffness_n_mp = 1.0e9\ncontact_exponent = 2.0",
            "rotor.contact_exponent",
            "from 1",
        ),
        (
            "[solver]",
            "[start]\nstate = \"settled\"\n[solver]",
            "start.state",
            "\"at-rest\"",
        ),
        (
            "[solver]",
            "[operation]\ninner_speed_rpm = 100\n[solver]",
            "operation.inner_speed_rpm",
            "left out",
        ),
        (
            "[support] ",
            "[support]\nstop_gap_um = 100.0\n# ",
            "support.stop_stiffness_n_m",
            "missing in [support]",
        ),
        ("[rotor]", "[rotr]", "rotr", "did you mean [rotor]?"),
    ] {
        let text = touchdown();
        assert!(text.contains(from), "{from}");
        let error = refused(&text.replacen(from, to, 1), &[]);
        assert_eq!(error.key(), Some(key), "{to}: {error}");
        assert!(error.message().contains(words), "{error}");
    }
}

#[test]
fn speed_and_load_may_be_tables_over_time() {
    let text = edited(
        "inner_speed_rpm = 12000.0",
        "inner_speed_rpm = [[0, 0], [0.5, 12000]]",
    );
    let file = parse(&text);
    let table = file.case().operation.inner_speed_table.as_ref().unwrap();
    let full = 400.0 * std::f64::consts::PI;
    assert!(
        (table.value(0.25) - full / 2.0).abs() < 1e-9 && (table.value(9.0) - full).abs() < 1e-9
    );
    assert_eq!(file.case().operation.inner_speed_rad_s, 0.0);
    assert_eq!(
        file.value("operation.inner_speed_rpm"),
        Some(CaseValue::Table(vec![[0.0, 0.0], [0.5, 12000.0]]))
    );
    let again = parse(&file.document().to_toml().unwrap());
    assert_eq!(again.case(), file.case());
    let json = serde_json::to_string(file.document()).unwrap();
    assert_eq!(parse(&json).case(), file.case());
    for (table, words) in [
        ("[]", "rows of [time in s, value]"),
        ("[[0, 1], [0, 2]]", "times that increase"),
        ("[[-1, 1], [0, 2]]", "from 0 s or later"),
        ("[[0, 1, 2]]", "[time in s, value] in each row"),
        ("[0, 1]", "rows of [time in s, value]"),
        ("[[0, \"fast\"]]", "a number in rpm"),
        ("[[0, inf]]", "a finite number of rpm"),
    ] {
        let text = edited(
            "inner_speed_rpm = 12000.0",
            &format!("inner_speed_rpm = {table}"),
        );
        let error = refused(&text, &[]);
        assert_eq!(error.key(), Some("operation.inner_speed_rpm"), "{table}");
        assert!(error.message().contains(words), "{error}");
    }
    let text = edited("inner_speed_rpm = 12000.0", "# ");
    assert!(
        refused(&text, &[])
            .message()
            .contains("missing in [operation]")
    );
}
