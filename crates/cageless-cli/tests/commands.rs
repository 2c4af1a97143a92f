//! What every command prints where, and the exit codes of success.

use std::path::Path;

use crate::common::*;

/// `--help` has the exit codes in the words of the manual.
#[test]
fn exit_codes_are_those_of_the_manual() {
    let manual = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/command-line.md");
    let manual = std::fs::read_to_string(manual).unwrap();
    let help = call(&["--help"]).stdout;
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    let rows = (manual.lines()).filter_map(|line| line.strip_prefix("| ")?.split_once(" | "));
    let codes = rows.filter_map(|(code, meaning)| Some((code.parse::<u8>().ok()?, meaning)));
    let mut count = 0;
    for (code, meaning) in codes {
        let end = meaning.find(if code == 2 { ':' } else { ';' });
        let meaning = meaning[..end.unwrap_or(meaning.len())].trim_end_matches(" |");
        let text = format!("{code} {}", meaning.replace('`', ""));
        assert!(help.contains(&text), "{text}: {help}");
        count += 1;
    }
    assert_eq!(count, 4);
}

#[test]
fn help_and_version_are_answers() {
    for args in [
        &["--help"][..],
        &["-h"],
        &["help"],
        &["help", "run"],
        &["run", "--help"],
        &["new", "--help"],
        &["design", "-h"],
        &["--version"],
        &["-V"],
    ] {
        let answer = call(args);
        assert_eq!(answer.code, Some(0), "{args:?}: {answer:?}");
        assert!(!answer.stdout.is_empty() && answer.stderr.is_empty());
    }
    let version = call(&["--version"]).stdout;
    assert_eq!(
        version.trim(),
        concat!("cageless ", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn what_the_command_line_does_not_know_is_bad_input() {
    let case = repository_case("zhao-d.toml");
    let case = case.to_str().unwrap();
    for (args, named) in [
        (&[][..], "Usage"),
        (&["fly"], "fly"),
        (&["--colour"], "--colour"),
        (&["run"], "CASE"),
        (&["run", case, "--steps", "3"], "--steps"),
        (&["run", case, case], "zhao-d.toml"),
        (&["run", case, "--set"], "--set"),
        (&["run", case, "--out"], "--out"),
        (&["new", "--simple"], "--simple"),
        (&["new", case], "zhao-d.toml"),
        (&["check"], "CASE"),
        (&["static", case, "--shard", "1/2"], "--shard"),
        (&["design"], "CASE"),
    ] {
        let answer = call(args);
        assert_eq!(answer.code, Some(2), "{args:?}: {answer:?}");
        assert_eq!(answer.stdout, "", "{args:?}");
        assert!(answer.stderr.contains(named), "{args:?}: {}", answer.stderr);
    }
}

#[test]
fn a_new_case_is_valid_and_commented() {
    let dir = tempfile::tempdir().unwrap();
    for (option, raceways) in [(&["new"][..], 1), (&["new", "--conventional"], 0)] {
        let new = call(option);
        assert_eq!((new.code, new.stderr.as_str()), (Some(0), ""));
        assert!(new.stdout.lines().filter(|l| l.contains('#')).count() > 30);
        let path = dir.path().join(format!("{raceways}.toml"));
        std::fs::write(&path, &new.stdout).unwrap();

        let check = call_on("check", &path, &[], &[]);
        assert_eq!((check.code, check.stderr.as_str()), (Some(0), ""));
        assert!(check.stdout.contains("is valid"), "{}", check.stdout);

        let check = call_on("check", &path, &[], &["--json"]).json();
        assert_eq!(check["valid"], true);
        let found = check["case"]["raceway"]["half_angle_deg"].as_f64();
        assert_eq!(found, (raceways == 1).then_some(25.2), "{check}");

        // The template is ready to run, not only valid.
        let run = call_on("run", &path, &["solver.duration_s=0.002"], &["--json"]);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    }
}

#[test]
fn every_case_of_the_repository_is_valid() {
    let files = |folder: &str| std::fs::read_dir(repository_case(folder)).unwrap();
    let mut count = 0;
    for entry in files("").chain(files("rotors")) {
        let path = entry.unwrap().path();
        if path.is_dir() {
            continue;
        }
        let answer = call_on("check", &path, &[], &[]);
        assert_eq!(
            answer.code,
            Some(0),
            "{}: {}",
            path.display(),
            answer.stderr
        );
        count += 1;
    }
    assert!(count >= 13, "{count}");
}

#[test]
fn static_equilibrium_holds_the_load() {
    let case = repository_case("zhao-d.toml");
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("made/on/the/way");
    let answer = call_on(
        "static",
        &case,
        &[],
        &["--json", "--out", out.to_str().unwrap()],
    );
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let e = answer.json();
    assert_eq!(json_file(&out.join("static.json")), e);
    let files = ["report.html", "static.csv", "static.json"];
    assert_eq!(names(&out), files);

    let list = |key: &str| -> Vec<f64> {
        let list = e[key].as_array().unwrap().iter();
        list.map(|v| v.as_f64().unwrap()).collect()
    };
    let (angle, inner, outer) = (
        list("ball_angle_deg"),
        list("inner_force_n"),
        list("outer_force_n"),
    );
    assert_eq!((angle.len(), inner.len(), outer.len()), (14, 14, 14));
    // The ring is at rest: load and weight on it are what the balls push back with,
    // each along the line from the ring's centre to its own.
    let ring_y_mm = 1e-3 * e["ring_y_um"].as_f64().unwrap();
    let up: f64 = (0..14)
        .map(|k| {
            let (sin, cos) = angle[k].to_radians().sin_cos();
            let (x, y) = (23.0025 * sin, -23.0025 * cos - ring_y_mm);
            -inner[k] * y / x.hypot(y)
        })
        .sum();
    let down = 1500.0 + 0.2 * 9.81;
    assert!((up - down).abs() < 0.05, "{up} {down}");
}

#[test]
fn run_keeps_results_and_progress_apart() {
    let case = repository_case("zhao-d.toml");
    let sets = ["solver.duration_s=0.004", "output.interval_us=50"];
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");

    let answer = call_on(
        "run",
        &case,
        &sets,
        &["--json", "--out", out.to_str().unwrap()],
    );
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let summary = answer.json();
    let mut kept = json_file(&out.join("summary.json"));
    // Which tables are its own.
    assert!(kept.as_object_mut().unwrap().remove("tables").is_some());
    assert_eq!(kept, summary);
    assert_eq!(names(&out), RUN_FILES);
    assert!(json_file(&out.join("report.json")).is_object());

    assert_eq!(summary["case"]["solver"]["duration_s"], 0.004);
    assert_eq!(summary["steps"], 4000);
    assert!(summary.get("stopped").is_none());
    let (_, rows) = table(&out.join("balls.parquet"));
    assert_eq!(rows.len(), 14 * 81);
    let (_, rows) = table(&out.join("ring.parquet"));
    assert_eq!(rows.len(), 81);
}

#[test]
fn set_takes_the_place_of_the_file() {
    let case = repository_case("zhao-d.toml");
    let sets = [
        "solver.duration_s=0.001",
        "raceway.half_angle_deg=24",
        "model.formulation=paper",
        "contact.friction_law=\"coulomb\"",
        "title=Versuch äöü",
        "start.lead_ball_angle_deg=-3.5",
        // The file has it in [solver].
        "seed=7",
        "solver.duration_s=0.002",
        "housing.mass_kg=1",
        "housing.stiffness_n_m=1e8",
        "housing.damping_n_s_m=500",
    ];
    let answer = call_on("run", &case, &sets, &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let case = &answer.json()["case"];
    assert_eq!(case["raceway"]["half_angle_deg"], 24.0);
    assert_eq!(case["model"]["formulation"], "paper");
    assert_eq!(case["contact"]["friction_law"], "coulomb");
    assert_eq!(case["title"], "Versuch äöü");
    assert_eq!(case["start"]["lead_ball_angle_deg"], -3.5);
    assert_eq!(case["solver"]["seed"], 7);
    assert_eq!(case["solver"]["duration_s"], 0.002);
    assert_eq!(case["housing"]["stiffness_n_m"], 1e8);
}

#[test]
fn defaults_are_listed() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    let text = call(&["new"]).stdout;
    let text = text
        .replace("schema = 1", "")
        .replace("title = ", "# title = ");
    std::fs::write(&path, text).unwrap();
    let answer = call_on("run", &path, &["solver.duration_s=0.0001"], &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let summary = answer.json();
    let defaults: Vec<&str> = summary["defaults"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v.as_str().unwrap())
        .collect();
    for key in [
        "schema",
        "title",
        "raceway.centre_angle_deg",
        "contact.ball_restitution",
        "contact.inner_stiffness_n_m1_5",
        "contact.outer_stiffness_n_m1_5",
        "contact.ball_stiffness_n_m1_5",
        "start.state",
        "start.gaps",
        "start.lead_ball_angle_deg",
        "solver.method",
        "solver.step_us",
        "solver.seed",
    ] {
        assert!(defaults.contains(&key), "{key}: {defaults:?}");
    }
    // What a default was is on record as well.
    assert_eq!(summary["case"]["contact"]["ball_restitution"], 0.95);
    assert_eq!(summary["case"]["start"]["state"], "settled");
    assert_eq!(summary["case"]["solver"]["method"], "verlet");
    assert!(summary["case"]["contact"]["inner_stiffness_n_m1_5"].as_f64() > Some(1e10));
}

/// A reader that stops reading (`cageless new | head -1`) is no failure.
#[test]
fn a_closed_pipe_is_no_failure() {
    let script = format!(
        "{} new | true; exit ${{PIPESTATUS[0]}}",
        env!("CARGO_BIN_EXE_cageless")
    );
    let status = std::process::Command::new("bash")
        .args(["-c", &script])
        .status();
    assert_eq!(status.unwrap().code(), Some(0));
}

/// A file may be a pipe, which can be read once.
#[test]
fn a_case_may_come_through_a_pipe() {
    let piped = |case: &Path, more: &str| -> Answer {
        let script = format!("cat {case:?} | {:?} {more}", env!("CARGO_BIN_EXE_cageless"));
        let mut command = std::process::Command::new("bash");
        command.args(["-c", &script]).output().unwrap().into()
    };
    let conventional = repository_case("touchdown-conventional.toml");
    for (case, more) in [
        (repository_case("zhao-d.toml"), "check /dev/stdin"),
        (repository_case("zhao-d.toml"), "static /dev/stdin"),
        (
            conventional,
            "drop /dev/stdin --set solver.duration_s=0.001 --json",
        ),
    ] {
        let answer = piped(&case, more);
        assert_eq!(answer.code, Some(0), "{answer:?}");
    }
}

/// 2 s in steps of 1 µs; twice 4 µs of interference; seven balls of 23.9° leave 216.6° open.
#[test]
fn check_names_the_cost_the_preload_and_a_ring_that_may_fall() {
    let case = repository_case("conventional.toml");
    let check = |sets: &[&str]| call_on("check", &case, sets, &[]);
    let plain = check(&["solver.duration_s=2", "solver.step_us=1"]);
    assert!(
        plain.stdout.contains("2.00 × 10⁶ of 1 µs"),
        "{}",
        plain.stdout
    );
    assert!(
        !plain.stdout.contains("warning") && !plain.stdout.contains("preload, "),
        "{}",
        plain.stdout
    );
    let slow = check(&[
        "bearing.inner_ring_damping_n_s_m=1e9",
        "solver.step_us=auto",
    ]);
    assert!(
        slow.stdout.contains("hours of computing"),
        "{}",
        slow.stdout
    );
    // The force and pressure are those of Hertz's integrals in another code.
    let pressed = check(&["bearing.inner_groove_bottom_radius_mm=18.244"]);
    assert!(
        pressed.stdout.contains("−8.000 µm (ISO 5753-1): preload"),
        "{}",
        pressed.stdout
    );
    assert!(
        pressed.stdout.contains("with 80.7 N, 982 MPa"),
        "{}",
        pressed.stdout
    );
    let few = check(&["bearing.balls=7"]);
    assert!(
        few.stdout.contains("leave 217° of the pitch circle open"),
        "{}",
        few.stdout
    );
    assert!(
        few.stdout.contains("9 or more (bearing.balls) hold it"),
        "{}",
        few.stdout
    );
    let json = call_on("check", &case, &["bearing.balls=7"], &["--json"]).json();
    assert_eq!(json["warnings"].as_array().unwrap().len(), 1);
    // A run of such a bearing that bunches says what happened, and when.
    let sets = [
        "bearing.balls=6",
        "start.gaps=bunched",
        "start.state=rolling",
        "solver.method=verlet",
        "solver.step_us=auto",
        "solver.duration_s=0.05",
    ];
    let fallen = call_on("run", &case, &sets, &[]);
    assert_eq!(fallen.code, Some(3), "{}", fallen.stderr);
    assert!(
        fallen
            .stderr
            .contains("fell between the balls and met the outer ring"),
        "{}",
        fallen.stderr
    );
}
