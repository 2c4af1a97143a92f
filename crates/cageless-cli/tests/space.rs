//! A bearing in space: what `static` computes of it, and what everything else refuses.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::common::*;

fn statics(case: &Path, sets: &[&str]) -> Value {
    let answer = call_on("static", case, sets, &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    answer.json()
}

fn numbers(value: &Value, name: &str) -> Vec<f64> {
    let items = value[name]
        .as_array()
        .unwrap_or_else(|| panic!("no list {name}"));
    items
        .iter()
        .map(|v| v.as_f64().unwrap_or(f64::NAN))
        .collect()
}

#[test]
fn an_axial_load_moves_and_tilts_the_ring() {
    let case = repository_case("zhao-d.toml");
    let plane = statics(&case, &[]);
    assert!(
        plane.get("ring_z_um").is_none(),
        "without a key nothing changes"
    );
    // What is 0 takes nothing out of the plane.
    let zeros = [
        "operation.axial_load_n=0",
        "operation.tilt_x_mrad=0",
        "bearing.contact_angle_deg=0",
    ];
    assert_eq!(statics(&case, &zeros)["ring_y_um"], plane["ring_y_um"]);
    // Space without anything that moves the ring along its axis.
    let [still, touched] = ["model.motion=space", "operation.axial_load_n=1e-6"]
        .map(|set| statics(&case, &[set])["ring_y_um"].as_f64().unwrap());
    assert!((still / touched - 1.0).abs() < 1e-6, "{still} {touched}");
    let loaded = statics(&case, &["operation.axial_load_n=300"]);
    let z = loaded["ring_z_um"].as_f64().unwrap();
    assert!(z > 30.0 && z < 60.0, "{z}");
    assert_eq!(
        (&loaded["tilt_x_mrad"], &loaded["tilt_y_mrad"]),
        (&0.0.into(), &0.0.into())
    );
    let [inner, outer] =
        ["inner_contact_angle_deg", "outer_contact_angle_deg"].map(|n| numbers(&loaded, n));
    assert!(
        inner[0] > 5.0 && (inner[0] - outer[0]).abs() < 1.0,
        "{inner:?} {outer:?}"
    );
    assert_eq!(numbers(&loaded, "stiffness_matrix").len(), 25);
    let life = |value: &Value| value["l10r_mrev"].as_f64().unwrap();
    // A light axial load spreads the radial one over more balls, a heavy one costs life.
    let heavy = statics(&case, &["operation.axial_load_n=3000"]);
    assert!(life(&heavy) < 0.5 * life(&plane));
    let free = statics(
        &case,
        &["operation.axial_load_n=300", "operation.moment_x_n_m=1"],
    );
    assert!(free["tilt_x_mrad"].as_f64().unwrap().abs() > 0.01);
}

/// A case file of two rows of the bearing of the paper, opened to 15°.
fn pair(folder: &Path, second: &str) -> PathBuf {
    let text = std::fs::read_to_string(repository_case("conventional.toml")).unwrap();
    let rows =
        format!("\n[[row]]\naxial_position_mm = -8.0\npreload_um = 5.0\n\n[[row]]\n{second}\n");
    let path = folder.join("pair.toml");
    std::fs::write(
        &path,
        text.replace("[bearing]", "[bearing]\ncontact_angle_deg = 15.0") + &rows,
    )
    .unwrap();
    path
}

#[test]
fn rows_of_a_pair_carry_alike() {
    let folder = tempfile::tempdir().unwrap();
    let case = pair(
        folder.path(),
        "axial_position_mm = 8.0\ncontact_sign = -1\npreload_um = 5.0",
    );
    let value = statics(&case, &[]);
    let forces = numbers(&value, "inner_force_n");
    let rows = numbers(&value, "row");
    let balls = forces.len() / 2;
    assert_eq!((rows[0], rows[balls]), (1.0, 2.0));
    for k in 0..balls {
        assert!(
            (forces[k] - forces[k + balls]).abs() < 1e-6 * (1.0 + forces[k]),
            "{forces:?}"
        );
    }
    assert!(value["tilt_stiffness_xx_n_m_rad"].as_f64().unwrap() > 0.0);
}

/// A spring presses with its force; a run starts with the displacement that `static` finds for it.
#[test]
fn a_spring_gives_the_displacement_of_its_force() {
    let folder = tempfile::tempdir().unwrap();
    let second = "axial_position_mm = 8.0\ncontact_sign = -1\npreload_n = 200.0";
    let case = pair(folder.path(), second);
    // The first row is held where it is.
    let loads = ["operation.radial_load_n=100", "operation.axial_load_n=50"];
    let value = statics(&case, &[&["row.1.preload_um=0"][..], &loads].concat());
    let forces = numbers(&value, "row_axial_force_n");
    assert!(
        (forces[0] - 250.0).abs() < 1e-6 && (forces[1] + 200.0).abs() < 1e-6,
        "{forces:?}"
    );
    let displaced = numbers(&value, "row_preload_um");
    assert!(displaced[0] == 0.0 && displaced[1] > 1.0, "{displaced:?}");
    let sets = [
        &["row.1.preload_um=0", "solver.duration_s=0.01"][..],
        &loads,
    ]
    .concat();
    let run = call_on("run", &case, &sets, &["--json"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let run: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(numbers(&run, "row_preload_start_um"), displaced);
    let mean = numbers(&run, "row_axial_force_mean_n");
    assert!((mean[1] + 200.0).abs() < 1.0, "{mean:?}");
    assert!((numbers(&run, "row_preload_mean_um")[1] / displaced[1] - 1.0).abs() < 0.1);
}

/// Rings that are warmed by drops press held rows more, and those under a spring alike.
#[test]
fn a_spring_keeps_its_preload_as_drops_warm_the_rings() {
    let case = repository_case("touchdown-pair.toml");
    let quick = [
        "solver.duration_s=0.15",
        "rotor.speed_rpm=4000",
        "rotor.drive_torque_n_m=-2",
    ];
    let spring = [
        "row.1.preload_um=0",
        "row.2.preload_um=0",
        "row.2.preload_n=150",
    ];
    let forces = |sets: &[&str]| {
        let answer = call_on("drop", &case, sets, &["--drops", "2", "--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        let value: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
        let drops = value["succession"].as_array().unwrap();
        [0, 1].map(|k| numbers(&drops[k], "row_axial_force_n"))
    };
    let [cold, warm] = forces(&quick);
    assert!(
        cold[0] > 100.0 && (cold[0] + cold[1]).abs() < 1e-6,
        "{cold:?}"
    );
    assert!(warm[0] > 1.005 * cold[0], "{warm:?} {cold:?}");
    for sprung in forces(&[&quick[..], &spring].concat()) {
        assert!((sprung[0] - 150.0).abs() < 1e-3 && (sprung[1] + 150.0).abs() < 1e-3);
    }
}

/// What each row carries along the axis, and by how much its spring displaces it, is in the tables.
#[test]
fn tables_show_what_each_row_carries() {
    let folder = tempfile::tempdir().unwrap();
    let second = "axial_position_mm = 8.0\ncontact_sign = -1\npreload_n = 200.0";
    let case = pair(folder.path(), second);
    let loads = [
        "row.1.preload_um=0",
        "operation.radial_load_n=100",
        "operation.axial_load_n=50",
    ];
    let out = folder.path().join("out");
    let answer = call_on("static", &case, &loads, &["--out", out.to_str().unwrap()]);
    let line = |label: &str| answer.stdout.lines().find(|line| line.contains(label));
    let forces = line("axial force of the rows").unwrap();
    assert!(forces.ends_with(" 250, −200 N"), "{forces}");
    assert!(
        line("preload of the rows").unwrap().contains(" 0, "),
        "{answer:?}"
    );
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("250, −200"), "no row of forces");
    assert!(page.contains("2 rows of 14 balls"));
    assert!(page.contains("100 N, axial load 50 N."));
}

#[test]
fn impossible_values_are_named() {
    let case = repository_case("zhao-d.toml");
    for (sets, words) in [
        (
            &["bearing.contact_angle_deg=70"][..],
            ["bearing.contact_angle_deg = 70", "shoulder"],
        ),
        (
            &["raceway.contact_angle_deg=30"],
            ["raceway.contact_angle_deg = 30", "shoulder"],
        ),
        (
            &["model.motion=space", "search.contact_angle_deg=[0,80]"],
            ["search.contact_angle_deg", "outer shoulder"],
        ),
        (
            &["operation.tilt_x_mrad=500"],
            [
                "operation.tilt_x_mrad = 500",
                "between -100 mrad and 100 mrad",
            ],
        ),
        (
            &["operation.tilt_x_mrad=1", "operation.moment_y_n_m=1"],
            ["operation.tilt_x_mrad = 1", "moments turn the ring"],
        ),
        (
            &[
                "bearing.contact_angle_deg=15",
                "bearing.outer_groove_bottom_radius_mm=27.775",
            ],
            ["bearing.contact_angle_deg = 15", "clearance"],
        ),
    ] {
        let answer = call_on("static", &case, sets, &[]);
        assert_eq!(answer.code, Some(2), "{sets:?} {answer:?}");
        for word in words {
            assert!(answer.stderr.contains(word), "{word}: {answer:?}");
        }
    }
    let folder = tempfile::tempdir().unwrap();
    for (second, word) in [
        ("axial_position_mm = 8.0\nballs = 0", "row without balls"),
        ("axial_position_mm = 8.0\npreload_um = 900.0", "4200 MPa"),
        ("axial_position_mm = 8.0\npreload_n = -1.0", "at least 0 N"),
        ("axial_position_mm = 8.0\npreload_n = 9e5", "4200 MPa"),
        (
            "axial_position_mm = 8.0\npreload_um = 5.0\npreload_n = 100.0",
            "row.2.preload_n = 100.0 is not possible: it must be 0 or left out",
        ),
        ("axial_position_mm = 8.0\ncontact_sign = 2", "1 or -1"),
        (
            "axial_position_mm = 1.5",
            "row.2.axial_position_mm = 1.5 is not possible: it must be 9.525 mm or more from row 1, at -8 mm",
        ),
        (
            "axial_position_mm = 1e6",
            "row.2.axial_position_mm = 1e6 is not possible: it must be between -4600.5 mm and \
             4600.5 mm",
        ),
        ("contact_sign = 1", "axial_position_mm is missing"),
    ] {
        let answer = call_on("static", &pair(folder.path(), second), &[], &[]);
        assert_eq!(answer.code, Some(2), "{second} {answer:?}");
        assert!(answer.stderr.contains(word), "{word}: {answer:?}");
    }
    let slipped = call_on("static", &case, &["operation.axial_load_n=9e5"], &[]);
    assert!(matches!(slipped.code, Some(2 | 3)), "{slipped:?}");
}

/// Inertias of the shaft: both are named where they are missing, and no body exceeds a thin disc.
#[test]
fn inertias_of_the_shaft_are_those_of_a_body() {
    let case = repository_case("zhao-d.toml");
    let [moment, transverse, polar] = [
        "operation.moment_x_n_m=1",
        "operation.shaft_transverse_inertia_kg_m2=1e-3",
        "operation.shaft_polar_inertia_kg_m2=3e-3",
    ];
    for (command, sets, words) in [
        (
            "run",
            &[moment][..],
            [
                "shaft_transverse_inertia_kg_m2",
                "shaft_polar_inertia_kg_m2",
            ],
        ),
        (
            "check",
            &[moment, transverse, polar],
            [
                "operation.shaft_polar_inertia_kg_m2 = 3e-3 is not possible",
                "at most 0.002 kg·m²",
            ],
        ),
    ] {
        let answer = call_on(command, &case, sets, &[]);
        assert_eq!(answer.code, Some(2), "{sets:?} {answer:?}");
        for word in words {
            assert!(answer.stderr.contains(word), "{word}: {answer:?}");
        }
    }
    let disc = "operation.shaft_polar_inertia_kg_m2=2e-3";
    let kept = call_on("check", &case, &[moment, transverse, disc], &[]);
    assert_eq!(kept.code, Some(0), "{kept:?}");
}

/// One message each, with the key and the command that takes it.
#[test]
fn everything_else_refuses_what_it_would_ignore() {
    let case = repository_case("zhao-d.toml");
    for (set, key) in [
        ("operation.axial_load_n=100", "operation.axial_load_n = 100"),
        ("operation.moment_y_n_m=0", "operation.moment"),
        ("operation.tilt_y_mrad=1", "operation.tilt_y_mrad = 1"),
        ("bearing.contact_angle_deg=15", "bearing.contact_angle_deg"),
        (
            "raceway.contact_angle_deg=5",
            "raceway.contact_angle_deg = 5",
        ),
    ] {
        let answer = call_on("design", &case, &[set], &["--axial"]);
        assert_eq!(answer.code, Some(2), "{set}: {answer:?}");
        assert!(answer.stderr.contains(key), "{key}: {answer:?}");
        assert!(answer.stderr.contains("`cageless static`"), "{answer:?}");
    }
    let folder = tempfile::tempdir().unwrap();
    let plan = folder.path().join("plan.toml");
    let swept = |set: &str, grid: &str| {
        let text =
            format!("case = {case:?}\ncompute = [\"design\"]\n[set]\n{set}\n[grid]\n{grid}\n");
        std::fs::write(&plan, text).unwrap();
        let out = tempfile::tempdir().unwrap();
        let [plan, out] = [&plan, out.path()].map(|path| path.to_str().unwrap());
        call(&["sweep", plan, "--out", out])
    };
    let base = swept(
        "operation.axial_load_n = 50",
        "operation.radial_load_n = [500, 900]",
    );
    assert_eq!(base.code, Some(0), "{base:?}");
    let some = swept("", "operation.axial_load_n = [0, 50]");
    assert_eq!(some.code, Some(0), "{some:?}");
    let checked = call_on("check", &case, &["operation.axial_load_n=100"], &[]);
    assert_eq!(checked.code, Some(0), "{checked:?}");
}

/// Designs and tolerances of a turned raceway are computed in space: without the turn the lag is lost.
#[test]
fn designs_and_tolerances_are_computed_in_space() {
    let case = repository_case("zhao-d.toml");
    let sets = [
        "operation.axial_load_n=150",
        "operation.radial_load_n=300",
        "solver.method=verlet",
        "solver.step_us=2",
    ];
    let judged = |more: &[&str]| {
        let sets = [&sets[..], more].concat();
        let answer = call_on("design", &case, &sets, &["--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        answer.json()
    };
    let turned = ["raceway.contact_angle_deg=10"];
    let [straight, turned_json] = [&[][..], &turned].map(judged);
    assert_eq!(straight["verdict"], "loses-lag");
    let lag = |d: &Value| d["passages"]["lag_per_pass_deg"].as_f64().unwrap();
    assert!(lag(&turned_json) > lag(&straight), "{turned_json}");
    assert!(straight["recommendation"].is_null());
    let sets = [&sets[..], &turned].concat();
    let mut options = vec!["--samples", "0", "--json"];
    // The contact angle alone.
    for equal in [
        "--groove-depth-um",
        "--axial-span-um",
        "--half-angle-deg",
        "--ball-grade",
        "--friction",
        "--clearance-um",
        "--speed-percent",
        "--load-percent",
    ] {
        options.extend([equal, "0"]);
    }
    let answer = call_on("tolerance", &case, &sets, &options);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let found = answer.json();
    let rows = found["influences"].as_array().unwrap();
    let names: Vec<_> = rows.iter().filter_map(|r| r["name"].as_str()).collect();
    assert!(names.contains(&"contact angle of the raceway"), "{names:?}");
    let nominal = found["nominal_critical_gap_deg"].as_f64();
    assert_eq!(nominal, turned_json["critical_gap_deg"].as_f64());
    // What [search] asks of space is refused in the plane, and the other way round.
    for (set, sets) in [
        ("search.axial_load_n=[0, 50]", &[][..]),
        ("search.contact_angle_deg=[0, 10]", &[]),
        ("search.axial_load_max_n=50", &["model.motion=space"]),
    ] {
        let sets = [&[set], sets].concat();
        let answer = call_on("design", &case, &sets, &["--search"]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        let key = set.split('=').next().unwrap();
        assert!(answer.stderr.contains(key), "{answer:?}");
    }
}

/// What a run in space does not have, in one message each.
#[test]
fn a_run_in_space_says_what_it_does_not_take() {
    let case = repository_case("zhao-d.toml");
    for (sets, words) in [
        (
            &["model.formulation=paper"][..],
            "the published equations are planar",
        ),
        (&["contact.friction_law=coulomb"], "needs a smooth knee"),
        (&["operation.moment_x_n_m=1"], "operation.moment_x_n_m = 1"),
        (&["operation.moment_y_n_m=1"], "operation.moment_y_n_m = 1"),
        (
            &[
                "operation.moment_x_n_m=1",
                "operation.shaft_polar_inertia_kg_m2=1e-4",
            ],
            "shaft_transverse_inertia_kg_m2 is missing",
        ),
        (
            &["contact.friction_strips=0"],
            "contact.friction_strips = 0",
        ),
    ] {
        let sets: Vec<&str> = [&["model.motion=space"], sets].concat();
        let answer = call_on("run", &case, &sets, &[]);
        assert_eq!(answer.code, Some(2), "{sets:?}: {answer:?}");
        assert!(answer.stderr.contains(words), "{words}: {answer:?}");
        // Where the case can be at rest, `check` says so.
        let checked = call_on("check", &case, &sets, &[]);
        let said = match checked.code {
            Some(0) => checked.stdout.contains("`run` refuses this case: "),
            _ => checked.code == Some(2),
        };
        let text = checked.stdout + &checked.stderr;
        assert!(said && text.contains(words), "{words}: {text}");
    }
    let moves = call_on("check", &case, &["model.motion=space"], &[]);
    assert!(!moves.stdout.contains("refuses"), "{moves:?}");
    let folder = tempfile::tempdir().unwrap();
    let rows = pair(folder.path(), "axial_position_mm = 8.0");
    let answer = call_on("run", &rows, &["row.2.balls=13"], &[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    let words = "row.2.balls = 13 is not possible: it must be 14";
    assert!(answer.stderr.contains(words), "{answer:?}");
}

/// Balls lag by about as much with the strips that a file leaves out as with nine; with one by 8 % more, at a quarter of
/// the speed of the paper. Three cost little more than one.
#[test]
fn strips_that_are_left_out_resolve_the_lag() {
    let case = repository_case("zhao-d.toml");
    let lag_deg = |strips: &[&str]| {
        let sets = [
            "model.motion=space",
            "raceway.blend_mm=1",
            "operation.inner_speed_rpm=3000",
            "solver.method=verlet",
            "solver.step_us=2",
            "solver.duration_s=0.15",
        ];
        let answer = call_on("run", &case, &[&sets, strips].concat(), &["--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        answer.json()["lag_per_pass_deg"].as_f64().unwrap()
    };
    let many = lag_deg(&["contact.friction_strips=9"]);
    let [left_out, one] = [&[][..], &["contact.friction_strips=1"]].map(lag_deg);
    assert!((left_out / many - 1.0).abs() < 0.03, "{left_out} {many}");
    assert!((one / many - 1.0).abs() > 0.05, "{one} {many}");
}

/// A run under axial load prints what only space has, and its tables have the columns of space.
#[test]
fn a_run_in_space_shows_what_the_plane_has_not() {
    let case = repository_case("zhao-d.toml");
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let sets = [
        "operation.axial_load_n=150",
        "solver.method=verlet",
        "solver.step_us=2",
        "solver.duration_s=0.03",
    ];
    let answer = call_on("run", &case, &sets, &["--out", out, "--csv", "--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let results: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let number = |key: &str| results[key].as_f64().unwrap_or(f64::NAN);
    assert!(
        (15.0..30.0).contains(&number("ring_z_mean_um")),
        "{results}"
    );
    assert!((2.0..8.0).contains(&number("inner_contact_angle_mean_deg")));
    let lag = number("lag_per_pass_deg");
    assert!((1.2..2.3).contains(&lag), "{lag}");
    let header = |name: &str| {
        let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
        text.lines().next().unwrap().to_owned()
    };
    assert!(header("balls.csv").ends_with(
        "z_m,vz_m_s,omega_x_rad_s,omega_y_rad_s,inner_contact_angle_rad,outer_contact_angle_rad,outer_ring_z_m"
    ));
    assert!(header("ring.csv").ends_with("z_m,vz_m_s,tilt_x_rad,tilt_y_rad"));
    let planar = call_on("run", &case, &sets[1..], &["--out", out, "--csv", "--json"]);
    assert_eq!(planar.code, Some(0), "{planar:?}");
    assert!(header("balls.csv").ends_with("outer_sliding_m_s"));
}

/// Under axial load rings are compared in space: the discrete raceway holds the inner ring back.
#[test]
fn rings_are_compared_in_space() {
    let case = repository_case("zhao-d.toml");
    let sets = [
        "operation.axial_load_n=150",
        "solver.method=verlet",
        "solver.step_us=2",
        "solver.duration_s=0.002",
        "steady.transient_orbits=1",
        "steady.measured_orbits=2",
    ];
    let options = ["--with-conventional", "--draws", "2", "--json"];
    let answer = call_on("compare", &case, &sets, &options);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let comparison: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let results = comparison["results"].as_array().unwrap();
    let found = results.iter().find(|row| row["name"] == "ring_z_mean_um");
    let mean = |ring: usize| found.unwrap()["values"][ring]["mean"].as_f64().unwrap();
    assert!(15.0 < mean(1) && mean(1) < 0.8 * mean(0), "{found:?}");
}

/// Loads and tilts are none of the ring's; contact angles turn its raceways and offset its groove.
#[test]
fn the_ring_of_a_bearing_in_space_is_exported() {
    const SIZE: [&str; 2] = [
        "bearing.outer_ring_outer_radius_mm=31",
        "bearing.outer_ring_width_mm=16",
    ];
    let case = repository_case("zhao-d.toml");
    let export = |case: &Path, sets: &[&str], more: &[&str]| {
        let more = [&["--format", "csv"], more].concat();
        call_on("export", case, &[&SIZE[..], sets].concat(), &more)
    };
    let plane = export(&case, &[], &[]);
    let loaded = [
        "operation.axial_load_n=100",
        "operation.moment_y_n_m=2",
        "operation.radial_load_n=5",
    ];
    let loaded = export(&case, &loaded, &[]);
    assert_eq!(loaded.code, Some(0), "{loaded:?}");
    assert_eq!(loaded.stdout, plane.stdout);
    let turned = [
        "bearing.contact_angle_deg=15",
        "raceway.contact_angle_deg=15",
    ];
    let numbers = export(&case, &turned, &["--json"]).json();
    assert!((numbers["contact_angle_deg"].as_f64().unwrap() - 15.0).abs() < 1e-9);
    // ½ (Re + ri − 2Rw) sin 15°
    let offset = -0.1905 * 15f64.to_radians().sin();
    assert!((numbers["groove_centre_z_mm"].as_f64().unwrap() - offset).abs() < 1e-9);
    let text = export(&case, &turned, &[]).stderr;
    assert!(
        text.contains("15.0000°") && text.contains("both full"),
        "{text}"
    );
    let none = export(&case, &[], &["--json"]).json();
    assert!(none.get("contact_angle_deg").is_none() && none.get("groove_centre_z_mm").is_none());
    let refused = export(&case, &["raceway.contact_angle_deg=30"], &[]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    for words in ["raceway.contact_angle_deg = 30", "beyond the shoulder"] {
        assert!(refused.stderr.contains(words), "{refused:?}");
    }
    let folder = tempfile::tempdir().unwrap();
    let rows = pair(folder.path(), "axial_position_mm = 8.0\ncontact_sign = -1");
    let refused = export(&rows, &[], &[]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    for words in ["axial_position_mm = 8", "with its [[row]]"] {
        assert!(refused.stderr.contains(words), "{refused:?}");
    }
}

/// Elastic flanks are of the physical formulation and of laws without sticking.
#[test]
fn elastic_flanks_are_refused_where_there_are_none() {
    let case = repository_case("zhao-d.toml");
    for other in ["model.formulation=paper", "contact.friction_law=coulomb"] {
        let answer = call_on("run", &case, &["model.flanks=elastic", other], &[]);
        assert_eq!(answer.code, Some(2), "{other}: {answer:?}");
        assert!(
            answer.stderr.contains("model.flanks"),
            "{other}: {answer:?}"
        );
    }
    let unknown = call_on("check", &case, &["model.flanks=soft"], &[]);
    assert_eq!(unknown.code, Some(2), "{unknown:?}");
    assert!(
        unknown.stderr.contains("\"rigid\" or \"elastic\""),
        "{unknown:?}"
    );
}

/// What cannot bear an axial load is refused; the loads that a raceway bears are those of
/// `crates/cageless-py/tests/test_studies.py`, from Python and by the command.
#[test]
fn a_design_without_load_or_raceway_bears_no_axial_load() {
    let case = repository_case("zhao-d.toml");
    for (set, named) in [
        ("model.formulation=paper", "model.formulation"),
        ("operation.radial_load_n=0", "operation.radial_load_n"),
    ] {
        let answer = call_on("design", &case, &[set], &["--axial"]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        assert!(answer.stderr.contains(named), "{answer:?}");
    }
    let answer = call_on(
        "design",
        &repository_case("conventional.toml"),
        &[],
        &["--axial"],
    );
    assert_eq!(answer.code, Some(2), "{answer:?}");
}

/// Tilt moves the rows of a pair across the axis, too: the automatic step resolves what that presses together.
#[test]
fn tilted_pairs_are_stable_at_the_automatic_step() {
    let short = ["solver.step_us=auto", "solver.duration_s=0.004"];
    for (case, load) in [
        (
            "preloaded-pair.toml",
            &["operation.radial_load_n=20", "operation.tilt_x_mrad=1.6"][..],
        ),
        (
            "preloaded-pair-conventional.toml",
            &[
                "operation.radial_load_n=100",
                "operation.tilt_x_mrad=0.8",
                "row.1.axial_position_mm=-30",
                "row.2.axial_position_mm=30",
            ],
        ),
    ] {
        let sets = [load, &short].concat();
        let answer = call_on("run", &repository_case(case), &sets, &["--json"]);
        assert_eq!(answer.code, Some(0), "{case}: {answer:?}");
        let residual = answer.json()["energy_residual_relative"].as_f64().unwrap();
        assert!(residual.abs() < 1e-3, "{case}: {residual}");
    }
}
