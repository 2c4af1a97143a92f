//! Rotors above several bearings: checked, dropped, swept.

use std::path::Path;

use crate::common::{call, call_on, keys, repository_case, row};

pub const RIGID: &str = "\
[rotor]
mass_kg = 40.0
polar_inertia_kg_m2 = 0.04
transverse_inertia_kg_m2 = 0.6
speed_rpm = 30000.0

[[bearing]]
case = \"one.toml\"
axial_mm = -100.0

[[bearing]]
case = \"one.toml\"
axial_mm = 200.0

[[unbalance]]
axial_mm = 30.0
amount_g_mm = 200.0
";

/// A rotor file with its case beside it; the case leaves out what belongs to the rotor.
pub fn written(dir: &Path, text: &str) -> std::path::PathBuf {
    let case = std::fs::read_to_string(repository_case("touchdown-d.toml")).unwrap();
    let (head, rotor) = case.split_once("[rotor]").unwrap();
    let of_the_rotor = ["mass_kg", "polar_inertia_kg_m2", "speed_rpm"];
    let mut section = true;
    let rest = rotor.lines().filter(|line| {
        section &= !line.starts_with('[');
        !(section && of_the_rotor.iter().any(|key| line.starts_with(key)))
    });
    let rest: Vec<&str> = rest.collect();
    let text_of_case = format!("{head}[rotor]{}", rest.join("\n"));
    std::fs::write(dir.join("one.toml"), text_of_case).unwrap();
    let path = dir.join("rotor.toml");
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_rotor_is_checked_and_dropped() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    let check = call_on("check", &path, &[], &["--json"]).json();
    assert_eq!(check["valid"], true);
    let shares = check["mass_shares_kg"].as_array().unwrap();
    assert!((shares[0].as_f64().unwrap() - 80.0 / 3.0).abs() < 1e-9);
    // Precession at Ω·Ip/It.
    let frequency = check["natural_frequencies_hz"][0].as_f64().unwrap();
    assert!((frequency - 500.0 * 0.04 / 0.6).abs() < 1e-6, "{frequency}");

    let out = dir.path().join("out");
    let sets = ["solver.duration_s=0.002"];
    let drop = call_on(
        "drop",
        &path,
        &sets,
        &["--csv", "--out", out.to_str().unwrap()],
    );
    assert_eq!(drop.code, Some(0), "{}", drop.stderr);
    assert!(drop.stdout.contains("26.67, 13.33 kg"), "{}", drop.stdout);
    let text = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    let found = keys(&summary);
    for key in ["schema", "version", "rotor", "bearings"] {
        assert!(found.contains(&key), "{found:?}");
    }
    assert_eq!(summary["bearings"][1]["end_state"], "falling");
    for name in ["rotor.parquet", "balls.parquet", "rotor.csv"] {
        assert!(out.join("bearing-2").join(name).is_file(), "{name}");
    }
    assert!(out.join("report.html").is_file());
}

/// A plane that meets the stator before the rotor rests in its bearings is warned of, also a journal.
#[test]
fn a_check_says_what_the_rotor_meets_before_its_bearings() {
    let dir = tempfile::tempdir().unwrap();
    let check = |radial_um: f64, sets: &[&str]| {
        let plane = format!(
            "\n[[clearance]]\nname = \"impeller\"\naxial_mm = 250.0\nradial_um = {radial_um:?}\n"
        );
        let path = written(dir.path(), &format!("{RIGID}{plane}"));
        call_on("check", &path, sets, &[]).stdout
    };
    let said = "the rotor meets the stator at impeller before it rests in its bearings";
    assert!(check(150.0, &[]).contains(said), "{}", check(150.0, &[]));
    assert!(!check(250.0, &[]).contains(said));
    let sets = ["bearing.1.rotor.clearance_limit_um=150"];
    let journal =
        "bearing 1: the rotor meets the stator before its bearing: rotor.clearance_limit_um = 150";
    assert!(
        check(250.0, &sets).contains(journal),
        "{}",
        check(250.0, &sets)
    );
}

#[test]
fn other_commands_name_those_that_take_it() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    for command in ["run", "static", "design", "tolerance"] {
        let answer = call_on(command, &path, &[], &[]);
        assert_eq!(answer.code, Some(2));
        let said = "is the file of a rotor on several bearings, which `cageless drop`, `cageless \
                    check` and the plans of `cageless sweep` take";
        assert!(answer.stderr.contains(said), "{}", answer.stderr);
    }
    let answer = call_on("drop", &path, &[], &["--samples", "0"]);
    assert_eq!(answer.code, Some(2));
    assert!(
        answer.stderr.contains("--samples 0 is not possible"),
        "{}",
        answer.stderr
    );
}

#[test]
fn a_drop_that_stops_names_its_bearing() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(
        dir.path(),
        &RIGID
            .replacen("one.toml", "soft.toml", 2)
            .replacen("soft", "one", 1),
    );
    let case = std::fs::read_to_string(dir.path().join("one.toml")).unwrap();
    let soft = case
        .replace("stiffness_n_m = 2.0e7", "stiffness_n_m = 2.0e3")
        .replace("damping_n_s_m = 4.0e3", "damping_n_s_m = 1.0");
    assert!(soft != case);
    std::fs::write(dir.path().join("soft.toml"), soft).unwrap();
    let out = dir.path().join("out");
    let sets = [
        "solver.duration_s=0.01",
        "rotor.y_um=-195",
        "rotor.vy_m_s=-3",
    ];
    let more = ["--samples", "2", "--out", out.to_str().unwrap()];
    let drop = call_on("drop", &path, &sets, &more);
    assert_eq!(drop.code, Some(3), "{}", drop.stdout);
    for said in [
        "bearing 2: at t = ",
        "the outer ring left its support",
        "What was computed",
    ] {
        assert!(drop.stderr.contains(said), "{said}: {}", drop.stderr);
    }
    // What there is until then, and nothing beside it.
    let text = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(summary["bearings"][0]["stopped"].is_null());
    let cause = &summary["bearings"][1]["stopped"]["cause"];
    assert_eq!(cause, "the outer ring left its support");
    assert!(summary.get("ensemble").is_none());
}

#[test]
fn a_sweep_of_a_rotor_has_the_rows_of_its_drops_and_a_page() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    let near = [
        "solver.duration_s=0.0012",
        "rotor.y_um=-170.0",
        "rotor.vy_m_s=-0.06",
    ];
    let plan = dir.path().join("plan.toml");
    let set = near.map(|change| change.replace('=', " = ")).join("\n");
    let text = format!(
        "case = \"rotor.toml\"\ncompute = [\"drop\"]\n[set]\n{set}\n[grid]\n\
         rotor.speed_rpm = [15000.0, 30000.0]\nbearing.2.support.damping_n_s_m = [2e3, -1.0]\n"
    );
    std::fs::write(&plan, text).unwrap();
    let out = dir.path().join("out");
    let answer = call_on(
        "sweep",
        &plan,
        &[],
        &["--out", out.to_str().unwrap(), "--json"],
    );
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let summary = answer.json();
    assert_eq!(
        (&summary["variants"], &summary["failed"]),
        (&4.into(), &2.into())
    );
    let reason = summary["first_reason"].as_str().unwrap();
    assert!(
        reason.starts_with("in bearing 2, support.damping_n_s_m = -1"),
        "{reason}"
    );
    let more = [
        "rotor.speed_rpm=30000.0",
        "bearing.2.support.damping_n_s_m=2e3",
    ];
    let sets = [&near[..], &more].concat();
    let drop = call_on("drop", &path, &sets, &["--json"]).json();
    let row = row(&out.join("sweep.parquet"), 2);
    assert_eq!(row["rotor_speed_rpm"], 30000.0);
    let heat = drop["bearings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|b| b["dissipated_j"].as_f64().unwrap());
    assert_eq!(row["drop_dissipated_j"], heat.sum::<f64>());
    for key in [
        "end_state",
        "first_contact_ms",
        "rotor_force_max_n",
        "dissipated_j",
        "ring_speed_rpm",
    ] {
        assert_eq!(
            row[&format!("drop_bearing_2_{key}")],
            drop["bearings"][1][key],
            "{key}"
        );
    }
    let report = call(&["report", out.to_str().unwrap(), "--json"]);
    assert_eq!(report.code, Some(0), "{report:?}");
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("largest force on the rotor, bearing 2"));
    assert!(page.contains("case.bearing.2.axial_mm"));
}
