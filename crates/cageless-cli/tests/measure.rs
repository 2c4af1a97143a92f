//! `cageless measure`: points of a ring, the profile that they give, and what is refused.

use std::path::{Path, PathBuf};

use cageless::numerics::RandomStream;

use crate::common::*;

const SIZE: [&str; 2] = [
    "bearing.outer_ring_outer_radius_mm=31",
    "bearing.outer_ring_width_mm=16",
];

/// The points of a ring as `export` writes them, without blends.
fn points(case: &Path, dir: &Path) -> PathBuf {
    spaced(case, dir, "0.4")
}

fn spaced(case: &Path, dir: &Path, spacing_mm: &str) -> PathBuf {
    let path = dir.join("points.csv");
    let more = [
        "--format",
        "csv",
        "--blend-mm",
        "0",
        "--spacing-mm",
        spacing_mm,
        "--out",
    ];
    let more = [&more[..], &[path.to_str().unwrap()]].concat();
    let answer = call_on("export", case, &SIZE, &more);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    path
}

fn measure(case: &Path, points: &Path, more: &[&str]) -> Answer {
    let words = ["measure", case.to_str().unwrap(), points.to_str().unwrap()];
    call(&[&words[..], more].concat())
}

fn close(found: &serde_json::Value, expected: f64, allowed: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() < allowed, "{found} for {expected}");
}

/// The points of an exported ring give its raceway back, and the case with it has its β0 and lag.
#[test]
fn an_exported_ring_is_measured() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let points = points(&case, dir.path());
    let out = dir.path().join("out");
    let answer = measure(&case, &points, &["--json", "--out", out.to_str().unwrap()]);
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let document = answer.json();
    let raceway = &document["raceways"][0];
    assert!(raceway["measured_points"].as_i64().unwrap() > 1000);
    close(&raceway["measured_deviation_max_um"], 0.0, 1e-4);
    let middle = (5.1 / (2.0 * 4.7625f64)).asin().to_degrees();
    close(&raceway["profile_flank_angle_deg"], middle, 1e-4);
    close(&raceway["profile_half_angle_deg"], 25.2, 1e-6);
    let text = std::fs::read_to_string(out.join("measured.toml")).unwrap();
    for (kept, what) in [
        (true, "shape = \"measured\"\nprofile = [[0.0, 32.37"),
        (true, "25.2, 0.0]]"),
        (true, "# not in the paper: 0.52 x ball diameter"),
        (false, "\naxial_span_mm"),
        (false, "\nhalf_angle_deg"),
    ] {
        assert_eq!(text.contains(what), kept, "{what}: {text}");
    }
    let design = |case: &Path| call_on("design", case, &[], &["--json"]).json();
    let (designed, measured) = (design(&case), design(&out.join("measured.toml")));
    for key in [
        "beta0_deg",
        "kinematic_lag_per_pass_deg",
        "critical_gap_deg",
    ] {
        close(&measured[key], designed[key].as_f64().unwrap(), 1e-3);
    }
    close(&measured["profile_flank_angle_deg"], middle, 1e-4);
    assert!(designed.get("profile_flank_angle_deg").is_none());
    assert_eq!(measured["raceways"][0]["half_angle_deg"], 25.2);
}

/// Several raceways, each by its own points, in a file of semicolons and decimal commas.
#[test]
fn every_raceway_is_measured() {
    let dir = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let second = "\n[[raceway]]\naxial_span_mm = 4\nhalf_angle_deg = 15\ncentre_angle_deg = 180\nshape = \"shuttle\"\n";
    let case = dir.path().join("two.toml");
    std::fs::write(&case, text.replace("[raceway]", "[[raceway]]") + second).unwrap();
    let points = points(&case, dir.path());
    let table = std::fs::read_to_string(&points).unwrap();
    std::fs::write(&points, table.replace(',', ";").replace('.', ",")).unwrap();
    let out = dir.path().join("out");
    let answer = measure(&case, &points, &["--out", out.to_str().unwrap()]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert!(answer.stdout.contains("\nraceway 2\n "), "{answer:?}");
    let shown = call_on("design", &out.join("measured.toml"), &[], &["--json"]).json();
    close(&shown["raceways"][1]["axial_span_mm"], 4.0, 1e-5);
    close(&shown["raceways"][1]["half_angle_deg"], 15.0, 1e-9);
}

/// A case with slots in space in the place of the raceway of structure (d).
fn slotted(dir: &Path, name: &str, slots: &[&str]) -> PathBuf {
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let (head, rest) = text.split_once("[raceway]").unwrap();
    let (_, tail) = rest.split_once("\n[").unwrap();
    let slots: String = slots
        .iter()
        .map(|slot| format!("\n[[raceway]]\nshape = \"slot\"\n{slot}\n"))
        .collect();
    let path = dir.join(name);
    std::fs::write(&path, format!("{head}[{tail}{slots}")).unwrap();
    path
}

/// Slots of an exported ring, by a drawing with other dimensions: what was made, the rest of the case is kept.
#[test]
fn slots_are_measured() {
    let dir = tempfile::tempdir().unwrap();
    let made = [
        "axial_span_mm = 2.4\nhalf_angle_deg = 25.2\ncentre_angle_deg = 17.3\nedge_radius_mm = 0.3",
        "axial_span_mm = 2.0\nhalf_angle_deg = 2.22\ncentre_angle_deg = 150.0\nedge_radius_mm = 0.35\nslot_depth_mm = 1.2",
    ];
    let drawn = [
        "axial_span_mm = 2.45 # as drawn\nhalf_angle_deg = 25.0\ncentre_angle_deg = 17.0\nedge_radius_mm = 0.25",
        "axial_span_mm = 1.95\nhalf_angle_deg = 2.3\ncentre_angle_deg = 150.2\nedge_radius_mm = 0.4\nslot_depth_mm = 1.3",
    ];
    let points = spaced(&slotted(dir.path(), "made.toml", &made), dir.path(), "0.08");
    let out = dir.path().join("out");
    let case = slotted(dir.path(), "drawn.toml", &drawn);
    let answer = measure(&case, &points, &["--json", "--out", out.to_str().unwrap()]);
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let [first, second] = [0, 1].map(|k| answer.json()["raceways"][k].clone());
    for (slot, key, expected) in [
        (&first, "axial_span_mm", 2.4),
        (&first, "edge_radius_mm", 0.3),
        (&first, "half_angle_deg", 25.2),
        (&first, "centre_angle_deg", 17.3),
        // 2 ((Rw + re) lC/(2 Rw) − re).
        (&first, "slot_width_mm", 5.0625 / 4.7625 * 2.4 - 0.6),
        (&first, "measured_deviation_max_um", 0.0),
        (&first, "measured_depth_error_um", 0.0),
        (&second, "axial_span_mm", 2.0),
        (&second, "edge_radius_mm", 0.35),
        (&second, "half_angle_deg", 2.22),
    ] {
        let allowed = if key.ends_with("_um") { 5e-3 } else { 2e-5 };
        close(&slot[key], expected, allowed);
    }
    // 2 re and the sink of a ball.
    let [ball, groove] = [4.7625 + 0.3, 4.953 + 0.3];
    let across: f64 = ball * 1.2 / 4.7625;
    let along = |reach: f64| (reach * reach - across * across).sqrt();
    let sink = along(groove) - along(ball) - (groove - ball);
    close(&first["slot_depth_mm"], 0.6 + sink, 1e-5);
    let text = std::fs::read_to_string(out.join("measured.toml")).unwrap();
    assert_eq!(text.matches("shape = \"slot\"").count(), 2);
    for kept in [
        "axial_span_mm = 2.4",
        "slot_depth_mm = 1.3",
        "edge_radius_mm = 0.3",
    ] {
        assert!(text.contains(kept), "{kept}: {text}");
    }
    assert!(text.contains("# not in the paper: 0.52 x ball diameter"));
    let checked = call_on("check", &out.join("measured.toml"), &[], &[]);
    assert_eq!(checked.code, Some(0), "{checked:?}");

    let answer = measure(&case, &points, &[]);
    for line in ["radius of the rounded edges", "depth error"] {
        assert!(answer.stdout.contains(line), "{answer:?}");
    }
    let plain = self::points(&repository_case("conventional.toml"), dir.path());
    let answer = measure(&case, &plain, &[]);
    let said = "0 points of raceway 1 are not possible: they must be 50 or more on the rounded edges of the slot";
    assert!(
        answer.code == Some(2) && answer.stderr.contains(said),
        "{answer:?}"
    );
}

#[test]
fn what_is_no_raceway_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let good = points(&case, dir.path());
    let table = std::fs::read_to_string(&good).unwrap();
    let file = |name: &str, text: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let few: Vec<_> = table.lines().take(20).collect();
    let turned = table.replace("y_mm,z_mm", "z_mm,y_mm");
    let paper = measure(&case, &good, &["--set", "model.formulation=paper"]);
    assert_eq!(paper.code, Some(2), "{paper:?}");
    let said = "zhao-d.toml: raceway.shape = \"measured\" is not possible: it must be \"quartic\"";
    assert!(paper.stderr.contains(said), "{paper:?}");
    let plain = repository_case("conventional.toml");
    for (case, points, said) in [
        (
            &case,
            dir.path().join("none.csv"),
            "none.csv: cannot be opened: no such file",
        ),
        (
            &case,
            file("few.csv", &few.join("\n")),
            "19 points are not possible: they must be 50 or more of the groove",
        ),
        (
            &case,
            file("head.csv", &table.replace("z_mm", "z")),
            "head.csv:1: has no column z_mm",
        ),
        (
            &case,
            file("word.txt", "# points\n1 2 3\n\n4 5 nan\n"),
            "word.txt:4: \"4 5 nan\" is not possible: it must be x, y and z in mm",
        ),
        (&case, file("short.txt", "1, 2\n"), "short.txt:1: \"1, 2\""),
        (
            &case,
            file("commas.csv", "x_mm,y_mm,z_mm\n1,5,-21,3,0,25\n"),
            "commas.csv:2: \"1,5,-21,3,0,25\" is not possible: it must be x, y and z in mm; a decimal sign is a point",
        ),
        (
            &case,
            file("tabs.txt", "1,5\t-21,3\t0,25\n"),
            "a decimal sign is a point, or a comma between semicolons",
        ),
        (
            &case,
            file("turned.csv", &turned),
            "they must be of the groove of this ring",
        ),
        (&plain, good, "has no [raceway]"),
    ] {
        let answer = measure(case, &points, &[]);
        assert_eq!(
            (answer.code, answer.stdout.as_str()),
            (Some(2), ""),
            "{answer:?}"
        );
        assert!(answer.stderr.contains(said), "{said}: {answer:?}");
    }
}

/// The points of a table, moved in the machine: shift and tilt, turn about the axis, and errors of 0.3 µm.
fn moved(table: &str, turn_deg: f64) -> String {
    let (sin, cos) = turn_deg.to_radians().sin_cos();
    let mut lines = table.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|cell| *cell == name).unwrap();
    let places = ["x_mm", "y_mm", "z_mm"].map(column);
    let mut random = RandomStream::new(1, 0, 0, 0);
    let point = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let [x, y, z] = places.map(|at| cells[at].parse::<f64>().unwrap());
        let [x, y] = [x * cos - y * sin, x * sin + y * cos];
        // A tilt about x of 0.1 mrad.
        let place = [x + 0.01, y - 1e-4 * z, z + 1e-4 * y - 0.005];
        let [x, y, z] = place.map(|c| c + 0.3e-3 * random.normal());
        format!("{x:.7},{y:.7},{z:.7}")
    };
    let points: Vec<String> = lines.map(point).collect();
    points.join("\n")
}

fn part<'v>(rows: &'v serde_json::Value, name: &str) -> &'v serde_json::Value {
    let mut rows = rows.as_array().unwrap().iter();
    rows.find(|row| row["name"] == name).unwrap()
}

/// Frame and dimensions lie within their uncertainties, outliers are named by line, and the page shows it.
#[test]
fn a_ring_is_measured_where_it_lies() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let table = std::fs::read_to_string(points(&case, dir.path())).unwrap();
    let mut lines: Vec<String> = moved(&table, 1.0).lines().map(str::to_owned).collect();
    for line in [100, 2000] {
        let cells: Vec<f64> = lines[line].split(',').map(|c| c.parse().unwrap()).collect();
        let [x, y] = [0, 1].map(|k| cells[k] * (1.0 - 0.3 / cells[0].hypot(cells[1])));
        lines[line] = format!("{x},{y},{}", cells[2]);
    }
    let file = dir.path().join("moved.csv");
    std::fs::write(&file, lines.join("\n")).unwrap();
    let out = dir.path().join("out");
    let answer = measure(&case, &file, &["--json", "--out", out.to_str().unwrap()]);
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let found = answer.json();
    assert_eq!(found["outlier_lines"], serde_json::json!([101, 2001]));
    assert_eq!(
        (&found["outliers"], &found["passes"]),
        (&2.into(), &true.into())
    );
    let said = "2 outliers are left out, farther than five robust standard deviations from the groove: lines 101, 2001";
    assert_eq!(found["warnings"], serde_json::json!([said]));
    for (name, expected) in [
        ("shift x", 10.0),
        ("shift y", 0.0),
        ("shift z", -5.0),
        ("tilt about x", 0.1),
        ("tilt about y", 0.0),
        ("turn about z", 1.0),
    ] {
        let row = part(&found["frame"], name);
        let allowed = 1.5 * row["expanded_uncertainty"].as_f64().unwrap();
        assert!(allowed > 0.0 && allowed < 0.1, "{row}");
        close(&row["measured"], expected, allowed);
    }
    let dimensions = &found["raceways"][0]["dimensions"];
    for (name, drawn) in [
        ("axial span lC", 5.1),
        ("half angle θ", 25.2),
        ("depth error", 0.0),
    ] {
        let row = part(dimensions, name);
        close(
            &row["measured"],
            drawn,
            1.5 * row["expanded_uncertainty"].as_f64().unwrap(),
        );
        assert_eq!(
            (&row["drawn"], &row["verdict"]),
            (&drawn.into(), &"within".into())
        );
    }
    let text = std::fs::read_to_string(out.join("measured.toml")).unwrap();
    assert!(
        text.contains("centre_angle_deg = 1.00") || text.contains("centre_angle_deg = 0.99"),
        "{text}"
    );
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for shown in [
        "Deviation map",
        "PASS: all dimensions",
        "shift x",
        "lines 101, 2001",
        "heatmap",
    ] {
        assert!(page.contains(shown), "{shown}");
    }
}

/// Tolerances decide with the uncertainty: PASS, FAIL, or neither where the limit lies within it.
#[test]
fn dimensions_are_judged_by_their_tolerances() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let table = std::fs::read_to_string(points(&case, dir.path())).unwrap();
    let file = dir.path().join("moved.csv");
    std::fs::write(&file, moved(&table, 0.0)).unwrap();
    let judged = |set: &str, option: &str| {
        let answer = measure(&case, &file, &["--set", set, option]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        answer.stdout.lines().next().unwrap().to_owned()
    };
    let drawn = "raceway.axial_span_mm=5.1";
    assert_eq!(
        judged(drawn, "--axial-span-um=20"),
        "PASS: all dimensions are within tolerance"
    );
    let open = "not decided: the limit lies within the uncertainty of axial span lC";
    assert_eq!(judged(drawn, "--axial-span-um=0"), open);
    let other = "raceway.axial_span_mm=5.2";
    assert_eq!(
        judged(other, "--axial-span-um=20"),
        "FAIL: out of tolerance: axial span lC"
    );
    assert_eq!(
        judged(other, "--axial-span-um=150"),
        "PASS: all dimensions are within tolerance"
    );
    let answer = measure(&case, &file, &["--half-angle-deg=-1"]);
    let said = "--half-angle-deg -1 is not possible: it must be 0 or more";
    assert!(
        answer.code == Some(2) && answer.stderr.contains(said),
        "{answer:?}"
    );
}

/// A plain groove is no raceway of a tiny angle: the command says so and ends with exit code 3.
#[test]
fn a_plain_groove_is_no_raceway() {
    let dir = tempfile::tempdir().unwrap();
    let table = std::fs::read_to_string(points(&repository_case("conventional.toml"), dir.path()));
    let file = dir.path().join("moved.csv");
    std::fs::write(&file, moved(&table.unwrap(), 0.0)).unwrap();
    let out = dir.path().join("out");
    let case = repository_case("zhao-d.toml");
    let answer = measure(&case, &file, &["--json", "--out", out.to_str().unwrap()]);
    let said = "error: no raceway: the groove is plain all around\n";
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(3), said));
    let found = answer.json();
    assert_eq!(found["raceways"][0]["found"], false);
    assert_eq!(found["passes"], serde_json::Value::Null);
    close(&part(&found["frame"], "shift x")["measured"], 10.0, 0.1);
    assert!(!out.join("measured.toml").exists());
}
