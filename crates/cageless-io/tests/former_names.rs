//! Former names of keys are read like the present ones, wherever a key may be written.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{CaseFile, on_former_name, template};
use cageless_io::plan_file::PlanFile;

static NOTES: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// The note that contains `text`, of all that any test got.
fn note(text: &str) -> Option<String> {
    let notes = NOTES.lock().unwrap();
    notes.iter().find(|note| note.contains(text)).cloned()
}

fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

fn listen() {
    on_former_name(|note| NOTES.lock().unwrap().push(note.to_owned()));
}

/// Former key, present key and a value that no template has.
const OF_ALL: [(&str, &str, &str); 11] = [
    (
        "bearing.inner_ring_drag_n_s_m",
        "bearing.inner_ring_damping_n_s_m",
        "1234.0",
    ),
    (
        "contact.slip_scale_m_s",
        "contact.regularisation_speed_m_s",
        "0.033",
    ),
    ("contact.damping", "contact.damping_n_s_m1_5", "1.5e5"),
    (
        "contact.inner_stiffness",
        "contact.inner_stiffness_n_m1_5",
        "2.1e10",
    ),
    (
        "contact.outer_stiffness",
        "contact.outer_stiffness_n_m1_5",
        "2.2e10",
    ),
    (
        "contact.ball_stiffness",
        "contact.ball_stiffness_n_m1_5",
        "7.7e9",
    ),
    ("model.profile", "model.formulation", "\"paper\""),
    ("solver.method", "solver.method", "\"symplectic\""),
    (
        "search.spread_min",
        "search.critical_gap_min_fraction",
        "0.7",
    ),
    ("search.starts", "search.initial_states", "3"),
    ("search.budget", "search.runs_max", "123"),
];
const OF_ROTORS: [(&str, &str, &str); 3] = [
    ("rotor.air_gap_um", "rotor.radial_clearance_um", "211.0"),
    (
        "rotor.slip_scale_m_s",
        "rotor.regularisation_speed_m_s",
        "0.044",
    ),
    (
        "rotor.contact_stiffness",
        "rotor.contact_stiffness_n_mp",
        "1.1e9",
    ),
];

/// The text with the value of a key, under whichever of the names it has there.
fn with_line(text: &str, section: &str, names: [&str; 2], line: &str) -> String {
    let name = |line: &str| line.split('=').next().unwrap_or("").trim().to_owned();
    let head = format!("[{section}]");
    let mut inside = false;
    let mut lines: Vec<String> = vec![];
    for old in text.lines() {
        if old.starts_with('[') {
            inside = old.starts_with(&head);
        }
        if !(inside && names.contains(&name(old).as_str())) {
            lines.push(old.to_owned());
        }
        if old.starts_with(&head) {
            lines.push(line.to_owned());
        }
    }
    if !text.lines().any(|old| old.starts_with(&head)) {
        lines.extend([head, line.to_owned()]);
    }
    lines.join("\n")
}

#[test]
fn a_former_name_in_a_file_or_after_set_is_the_key() {
    listen();
    let rotor = std::fs::read_to_string(cases().join("touchdown-d.toml")).unwrap();
    let cases = [(template(false), &OF_ALL[..]), (rotor, &OF_ROTORS[..])];
    for (text, names) in cases {
        for &(former, present, value) in names {
            let (section, old) = former.split_once('.').unwrap();
            let name = present.split_once('.').unwrap().1;
            let value_now = value.replace("symplectic", "verlet");
            let parse = |line: &str| {
                let text = with_line(&text, section, [old, name], line);
                CaseFile::parse(&text, &format!("{former}.toml"), &[]).unwrap()
            };
            let expected = parse(&format!("{name} = {value_now}"));
            let plain = CaseFile::parse(&text, "plain.toml", &[]).unwrap();
            let found = parse(&format!("{old} = {value}"));
            assert_eq!(found.document(), expected.document(), "{former}");
            let noted = note(&format!("{former}.toml")).expect(former);
            assert!(
                noted.contains(&format!("{former} ")) && noted.contains(present),
                "{noted}"
            );

            let set = |key: &str, value: &str| {
                CaseFile::parse(&text, "set.toml", &[format!("{key}={value}")]).unwrap()
            };
            let (by_set, by_former) = (set(present, &value_now), set(former, value));
            assert_eq!(by_former.document(), by_set.document(), "--set {former}");
            // The method is the default one.
            let same = former == "solver.method";
            assert_eq!(
                by_former.document() == plain.document(),
                same,
                "--set {former}"
            );
        }
    }
}

#[test]
fn a_value_after_set_wins_over_the_file_under_either_name() {
    let text = with_line(
        &template(false),
        "contact",
        ["damping", "damping_n_s_m1_5"],
        "damping = 1.0e5",
    );
    for key in ["contact.damping", "contact.damping_n_s_m1_5"] {
        let file = CaseFile::parse(&text, "case.toml", &[format!("{key}=3e5")]).unwrap();
        let damping = file.document().number("contact.damping_n_s_m1_5");
        assert_eq!(damping, Some(3e5), "{key}");
    }
}

#[test]
fn both_names_at_once_are_refused() {
    let line = "damping = 1.0e5\ndamping_n_s_m1_5 = 1.0e5";
    let text = with_line(
        &template(false),
        "contact",
        ["damping", "damping_n_s_m1_5"],
        line,
    );
    let error = CaseFile::parse(&text, "case.toml", &[])
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("contact.damping is the former name of contact.damping_n_s_m1_5"),
        "{error}"
    );
    assert!(
        error.contains("case.toml") && error.contains("drop one"),
        "{error}"
    );
}

#[test]
fn a_result_of_an_earlier_version_is_a_case() {
    let file = CaseFile::parse(&template(false), "case.toml", &[]).unwrap();
    let json = serde_json::to_string(&file.document_as_run()).unwrap();
    let case = json
        .replace("damping_n_s_m1_5", "damping")
        .replace("_stiffness_n_m1_5", "_stiffness");
    let result = format!("{{\"case\": {case}, \"defaults\": [\"contact.inner_stiffness\"]}}");
    let read = CaseFile::parse(&result, "summary.json", &[]).unwrap();
    let damping = |file: &CaseFile| file.document().number("contact.damping_n_s_m1_5");
    assert_eq!(damping(&read), damping(&file));
    assert!(damping(&read).is_some());
    // Derived, so it is derived again; the other was derived as well, but the file does not say so.
    assert_eq!(
        read.document().number("contact.inner_stiffness_n_m1_5"),
        None
    );
    assert!(
        read.document()
            .number("contact.outer_stiffness_n_m1_5")
            .is_some()
    );
}

const ROTOR: &str = "[rotor]\nmass_kg = 40.0\npolar_inertia_kg_m2 = 0.04\n\
    transverse_inertia_kg_m2 = 0.6\nspeed_rpm = 30000.0\n\
    [[bearing]]\ncase = \"touchdown-d.toml\"\naxial_mm = -100.0\n\
    [[bearing]]\ncase = \"touchdown-d.toml\"\naxial_mm = 200.0\n\
    [[unbalance]]\naxial_mm = 0.0\nAMOUNT = 200.0\nANGLE = 30.0\n";

#[test]
fn rotor_files_are_read_under_former_names_as_well() {
    listen();
    let parse = |[amount, angle]: [&str; 2], set: &[String]| {
        let text = ROTOR.replace("AMOUNT", amount).replace("ANGLE", angle);
        BearingArrangement::parse(&text, "former-rotor.toml", &cases(), set).unwrap()
    };
    let present = ["amount_g_mm", "angle_deg"];
    let expected = parse(present, &[]);
    let found = parse(["moment_g_mm", "phase_deg"], &[]);
    assert_eq!(found.rotor_file(), expected.rotor_file());
    assert_eq!(
        found.rotor_file().unwrap().rotor.unbalances[0].amount_g_mm,
        200.0
    );
    assert!(note("unbalance.moment_g_mm is now unbalance.amount_g_mm").is_some());
    for (key, now) in [
        ("unbalance.1.moment_g_mm", "unbalance.1.amount_g_mm"),
        ("rotor.air_gap_um", "rotor.radial_clearance_um"),
        (
            "bearing.2.rotor.air_gap_um",
            "bearing.2.rotor.radial_clearance_um",
        ),
        (
            "bearing.1.contact.damping",
            "bearing.1.contact.damping_n_s_m1_5",
        ),
    ] {
        let (by_former, by_present) = (
            parse(present, &[format!("{key}=190.0")]),
            parse(present, &[format!("{now}=190.0")]),
        );
        assert_eq!(by_former.rotor_file(), by_present.rotor_file(), "{key}");
        assert_ne!(by_former.rotor_file(), expected.rotor_file(), "{key}");
    }
}

#[test]
fn plans_are_read_under_former_names_as_well() {
    listen();
    let plan = |[damping, clearance, profile, method]: [&str; 4]| {
        let text = format!(
            "case = \"touchdown-d.toml\"\ncompute = [\"drop\"]\n[set]\n{profile} = \"physical\"\n\
             [grid]\ncontact.{damping} = [1e5, 2e5]\n\"rotor.{clearance}\" = [180.0, 200.0]\n\
             solver.method = [\"{method}\", \"abm4\"]\n"
        );
        PlanFile::parse(&text, "former-plan.toml", &cases()).unwrap()
    };
    let present = plan([
        "damping_n_s_m1_5",
        "radial_clearance_um",
        "model.formulation",
        "verlet",
    ]);
    let former = plan(["damping", "air_gap_um", "model.profile", "symplectic"]);
    assert_eq!(former.grid, present.grid);
    let keys: Vec<_> = former.grid.iter().map(|axis| axis.key.as_str()).collect();
    assert!(
        keys.contains(&"contact.damping_n_s_m1_5") && keys.contains(&"rotor.radial_clearance_um"),
        "{keys:?}"
    );
    let document = |plan: &PlanFile| plan.base_file.cases()[0].document().clone();
    assert_eq!(document(&former), document(&present));
    let notes = NOTES.lock().unwrap().clone();
    for (line, name) in [
        (4, "model.profile is now model.formulation"),
        (6, "contact.damping is now contact.damping_n_s_m1_5"),
        (7, "rotor.air_gap_um is now grid.rotor.radial_clearance_um"),
        (
            8,
            "solver.method = \"symplectic\" is now solver.method = \"verlet\"",
        ),
    ] {
        let place = format!("former-plan.toml:{line}: ");
        let found = notes.iter().any(|n| n.contains(&place) && n.contains(name));
        assert!(found, "{place}{name}: {notes:?}");
    }
}
