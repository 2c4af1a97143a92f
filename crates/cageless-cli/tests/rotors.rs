//! Files of rotors above several bearings: checked, dropped, refused.

use std::path::Path;

use crate::common::{call, call_on, keys, repository_case, row};

const RIGID: &str = "\
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
moment_g_mm = 200.0
";

/// A rotor file with its case beside it; the case leaves out what belongs to the rotor.
fn written(dir: &Path, text: &str) -> std::path::PathBuf {
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

#[test]
fn other_commands_name_those_that_take_it() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    for command in ["run", "static", "design", "tolerance"] {
        let answer = call_on(command, &path, &[], &[]);
        assert_eq!(answer.code, Some(2));
        let said = "is the file of a rotor above several bearings, which `cageless drop`, `cageless \
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
    assert!(summary["bearings"][1]["stopped"].is_string());
    assert!(summary.get("ensemble").is_none());
}

#[test]
fn impossible_rotor_files_are_refused_with_line_and_key() {
    let dir = tempfile::tempdir().unwrap();
    for (from, to, said) in [
        (
            "axial_mm = 200.0",
            "axial_mm = -100.0",
            "two bearings are at the same axial place",
        ),
        (
            "mass_kg = 40.0",
            "mass_kg = -40.0",
            "rotor.toml:2: mass_kg = -40: must be more than 0",
        ),
        (
            "mass_kg = 40.0",
            "mas_kg = 40.0",
            "rotor.toml:2: mas_kg is not a key of [rotor] of a rotor file; did you mean mass_kg?",
        ),
        (
            "mass_kg = 40.0",
            "mass_kg = \"40 kg\"",
            "rotor.toml:2: rotor.mass_kg = \"40 kg\" is not possible",
        ),
        ("speed_rpm = 30000.0\n", "", "rotor.speed_rpm is missing"),
        (
            "case = \"one.toml\"",
            "case = \"none.toml\"",
            "rotor.toml:8: case = \"none.toml\": ",
        ),
        ("case = \"one.toml\"\n", "", "bearing.1.case is missing"),
        (
            "axial_mm = 30.0",
            "node = 3",
            "rotor.toml:16: unbalance.1.node = 3 is not possible: it must be left out",
        ),
        (
            "moment_g_mm = 200.0",
            "",
            "unbalance.1.moment_g_mm is missing",
        ),
        (
            "mass_kg = 40.0",
            "matrices = \"none.json\"",
            "polar_inertia_kg_m2 = 0.04 is not possible: it must be left out",
        ),
    ] {
        let path = written(dir.path(), &RIGID.replacen(from, to, 1));
        let answer = call_on("drop", &path, &[], &[]);
        assert_eq!(answer.code, Some(2), "{said}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}

#[test]
fn changes_reach_the_rotor_all_bearings_or_one() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    let sets = [
        "rotor.mass_kg=60",
        "bearing.2.axial_mm=100",
        "contact.damping=3e5",
        "bearing.2.contact.damping=4e5",
        "bearing.1.raceway.half_angle_deg=24",
    ];
    let check = call_on("check", &path, &sets, &["--json"]).json();
    let share = check["mass_shares_kg"][0].as_f64().unwrap();
    assert!((share - 30.0).abs() < 1e-9, "{share}");
    let of = |k: usize, section: &str, key: &str| check["cases"][k][section][key].clone();
    assert_eq!(
        [of(0, "contact", "damping"), of(1, "contact", "damping")],
        [3e5, 4e5]
    );
    let angles = [0, 1].map(|k: usize| check["cases"][k]["raceway"]["half_angle_deg"].clone());
    assert_eq!(angles, [24.0, 25.2]);
    for (set, said) in [
        (
            "rotor.eccentricity_um=3",
            "is replaced by the unbalances of the rotor",
        ),
        (
            "bearing.2.rotor.speed_rpm=3",
            "belongs to the rotor as a whole: write rotor.speed_rpm",
        ),
        (
            "bearing.3.solver.seed=3",
            "there are 2 [[bearing]] sections, counted from 1",
        ),
        (
            "bearing.2.balls=3",
            "write bearing.2.section.key for a key of its case",
        ),
        ("bearing.1.case=x.toml", "stays as the rotor file gives it"),
        (
            "bearing.axial_mm=1",
            "write bearing.1.axial_mm for the first",
        ),
        ("rotor.sped_rpm=1", "did you mean speed_rpm?"),
        ("rotor.mass_kg=-1", "mass_kg = -1: must be more than 0"),
        (
            "bearing.2.rotor.air_gap_um=-3",
            "in bearing 2, rotor.air_gap_um = -3 is not possible",
        ),
    ] {
        let answer = call_on("check", &path, &[set], &[]);
        assert_eq!(answer.code, Some(2), "{set}: {}", answer.stdout);
        let place = format!("--set {set}: ");
        assert!(
            answer.stderr.contains(&place) && answer.stderr.contains(said),
            "{}",
            answer.stderr
        );
    }
}

/// What follows the case and the computation in a plan of a rotor, the line at fault, and what the
/// message must have.
#[rustfmt::skip]
const PLANS: &[(&str, usize, &[&str])] = &[
    ("compute = [\"static\", \"drop\"]", 2, &["compute has \"static\", which is for the case of one bearing", "there is \"drop\""]),
    ("compute = [\"drop\"]\n[grid]\nrotor.sped_rpm = [1.0]", 4, &["rotor.sped_rpm is not a key of [rotor]", "did you mean speed_rpm?"]),
    ("compute = [\"drop\"]\n[grid]\nunbalance.1.momnt_g_mm = [1.0]", 4, &["unbalance.1.momnt_g_mm is not a key", "did you mean moment_g_mm?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.balls = [12]", 4, &["grid.bearing.2.balls", "did you mean bearing.2.bearing.balls?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.contact.dampin = [12]", 4, &["bearing.2.contact.dampin is not a key of [contact]", "did you mean damping?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.racewey.half_angle_deg = [12]", 4, &["bearing.2.racewey is not a section", "did you mean [raceway]?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.3.contact.damping = [1e5]", 4, &["there are 2 [[bearing]] sections"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.1.case = [\"one.toml\"]", 4, &["bearing.1.case: stays as the rotor file gives it"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.matrices = [\"m.json\"]", 4, &["rotor.matrices: stays as the rotor file gives it"]),
    ("compute = [\"drop\"]\n[set]\nrotor.eccentricity_um = 3.0", 4, &["is replaced by the unbalances of the rotor"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.rotor.speed_rpm = [1.0]", 4, &["belongs to the rotor as a whole: write rotor.speed_rpm"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.speed_rpm = [\"fast\"]", 4, &["none of the 1 variants", "rotor.speed_rpm = \"fast\" is not possible: it must be a number"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.mass_kg = [-1.0]", 4, &["none of the 1 variants", "mass_kg = -1: must be more than 0"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.solver.duration_s = [0.1]", 0, &["none of the 1 variants", "solver.duration_s is 1.0 in the case of bearing 1 and 0.1 in that of bearing 2"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.node = [1]", 4, &["bearing.2.node = 1 is not possible", "a rigid rotor has places"]),
    ("compute = [\"drop\"]\n[grid]\ncontact.damping = [1e5]\nbearing.1.contact.damping = [1e5]", 5, &["bearing.1.contact.damping is a part of contact.damping on line 4"]),
    ("compute = [\"drop\"]\n[set]\nbearing.1.contact.damping = 1e5\n[grid]\ncontact.damping = [1e5]", 4, &["bearing.1.contact.damping varies on line 6", "[set] has no effect"]),
    ("compute = [\"drop\"]\nkeep = [\"drop_bearing_3_impacts\"]", 3, &["drop_bearing_3_impacts", "there are drop_verdict"]),
    ("compute = [\"drop\"]\n[scatter]\nrotor.transverse_inertia_kg_m2 = \"any\"", 4, &["{ normal = STANDARD_DEVIATION }"]),
];

#[test]
fn wrong_plans_of_a_rotor_are_refused_with_their_place_and_reason() {
    let dir = tempfile::tempdir().unwrap();
    written(dir.path(), RIGID);
    let plan = dir.path().join("plan.toml");
    for (text, line, fragments) in PLANS {
        std::fs::write(&plan, format!("case = \"rotor.toml\"\n{text}\n")).unwrap();
        let out = dir.path().join("out");
        let answer = call_on("sweep", &plan, &[], &["--out", out.to_str().unwrap()]);
        assert_eq!(answer.code, Some(2), "{text}\n{answer:?}");
        assert!(!out.exists(), "{text} left something");
        let place = match line {
            0 => "rotor.toml: ".to_owned(),
            line => format!("plan.toml:{line}: "),
        };
        for fragment in fragments.iter().copied().chain([place.as_str()]) {
            assert!(
                answer.stderr.contains(fragment),
                "{text}\nlacks {fragment:?}: {answer:?}"
            );
        }
    }
    let alone = RIGID.split("[[bearing]]").next().unwrap();
    std::fs::write(
        dir.path().join("rotor.toml"),
        format!("bearing = []\n{alone}"),
    )
    .unwrap();
    std::fs::write(&plan, "case = \"rotor.toml\"\ncompute = [\"drop\"]\n").unwrap();
    let answer = call_on("sweep", &plan, &[], &[]);
    assert_eq!(answer.code, Some(2));
    assert!(
        answer
            .stderr
            .contains("a rotor needs at least one touchdown bearing"),
        "{answer:?}"
    );
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
        .map(|b| b["heat_j"].as_f64().unwrap());
    assert_eq!(row["drop_heat_j"], heat.sum::<f64>());
    for key in [
        "end_state",
        "first_contact_ms",
        "rotor_force_max_n",
        "heat_j",
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

#[test]
fn files_of_matrices_are_refused_by_name() {
    let dir = tempfile::tempdir().unwrap();
    let file = "[rotor]\nmatrices = \"m.json\"\nspeed_rpm = 1000\n\
                [[bearing]]\ncase = \"one.toml\"\nnode = 0\n[[bearing]]\ncase = \"one.toml\"\nnode = 1\n";
    let path = written(dir.path(), file);
    for (text, said) in [
        ("{", "m.json:1: is no file of the matrices of a rotor"),
        (
            r#"{"schema": 2, "polar_inertia_kg_m2": 1, "M": [], "K": []}"#,
            "schema = 2 is not possible",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1, 0], [0]], "K": []}"#,
            "row 2 of M has 1 numbers",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1]], "K": [[1]], "X": []}"#,
            "unknown field `X`",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1]], "K": [[1]]}"#,
            "matrix M must be of four coordinates a node",
        ),
    ] {
        std::fs::write(dir.path().join("m.json"), text).unwrap();
        let answer = call_on("drop", &path, &[], &[]);
        assert_eq!(answer.code, Some(2), "{said}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}

#[test]
fn a_new_touch_down_case_drops_at_once() {
    for (name, full) in [
        ("6008", false),
        ("61808", true),
        ("6304", false),
        ("6000", true),
    ] {
        let mut args = vec!["new", "--bearing", name, "--touchdown"];
        args.extend(full.then_some("--full-complement"));
        let text = call(&args).stdout;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("case.toml");
        std::fs::write(&path, &text).unwrap();
        let path = path.to_str().unwrap();
        let answer = call(&["drop", path, "--json", "--set", "solver.duration_s=0.008"]);
        assert_eq!(answer.code, Some(0), "{name}: {answer:?}\n{text}");
        let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
        assert!(json["impacts"].as_u64().unwrap() > 0, "{name}");
        assert!(json["clearance_margin_um"].is_f64(), "{name}");
        // Each value that the bearing does not fix is marked.
        let sections = text.split("[contact]").nth(1).unwrap();
        let lines = sections
            .lines()
            .filter(|l| l.contains(" = ") && !l.contains("duration_s"));
        for line in lines {
            assert!(line.contains("(assumed)"), "{line}");
        }
        // A steel cylinder about its axis: J/m between the squares of its radii.
        let bearing = &json["case"]["bearing"];
        let of = |key: &str| bearing[key].as_f64().unwrap();
        let gyration = (of("inner_ring_polar_inertia_kg_m2") / of("inner_ring_mass_kg")).sqrt();
        let bore = 1e-3 * of("inner_ring_bore_radius_mm");
        assert!(
            gyration > bore && gyration < 1.6 * bore,
            "{name}: {gyration} {bore}"
        );
    }
}

#[test]
fn what_is_printed_of_drops_has_words_numbers_and_a_verdict() {
    let path = |name: &str| repository_case(name).display().to_string();
    let case = path("touchdown-d.toml");
    let short = "solver.duration_s=0.01";
    let rotor = path("rotors/two-bearings.toml");
    for args in [
        vec![
            "drop",
            &case,
            "--set",
            short,
            "--samples",
            "2",
            "--compare",
            "conventional",
        ],
        vec!["drop", &case, "--set", "solver.duration_s=0.001"],
        vec![
            "drop",
            &case,
            "--set",
            short,
            "--set",
            "operation.gravity_m_s2=1e-6",
        ],
        vec!["drop", &rotor, "--set", short, "--samples", "2"],
        vec![
            "drop",
            &rotor,
            "--set",
            short,
            "--set",
            "bearing.1.axial_mm=0",
        ],
        vec!["run", &case, "--set", short],
        vec!["check", &case],
        vec!["check", &rotor],
    ] {
        let answer = call(&args);
        assert_eq!(answer.code, Some(0), "{args:?}: {answer:?}");
        let text = answer.stdout + &answer.stderr;
        let mut words = text.split(|c: char| !c.is_alphabetic());
        assert!(
            !words.any(|word| ["inf", "NaN", "nan"].contains(&word)),
            "{args:?}: {text}"
        );
        assert!(
            !text.contains("ledger") && !text.contains("bouncing"),
            "{args:?}: {text}"
        );
        if args[0] == "drop" {
            assert!(text.starts_with("verdict"), "{args:?}: {text}");
        }
    }
    let text = call(&["drop", &case, "--set", short]).stdout;
    assert!(text.contains("not reached ("), "{text}");
    let refused = call(&["drop", &path("zhao-d.toml")]).stderr;
    for key in [
        "[rotor]",
        "contact_stiffness",
        "[support]",
        "stiffness_n_m",
        "[contact]",
        "--touchdown",
    ] {
        assert!(refused.contains(key), "{key}: {refused}");
    }
}
