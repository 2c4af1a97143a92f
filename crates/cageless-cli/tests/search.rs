//! `design --search`: what it leaves, that it goes on where it was stopped, and what it refuses.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::common::*;

fn search_command(out: &Path) -> std::process::Command {
    let mut command = cageless();
    command.arg("design").arg(repository_case("zhao-d.toml"));
    for set in SMALL {
        command.args(["--set", set]);
    }
    command.args(["--search", "--json", "--out"]).arg(out);
    command
}

/// Killed in the middle on two threads, then continued: the same bytes as in one go on one.
#[test]
fn a_search_that_was_killed_goes_on_and_finds_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let (whole, parts) = (dir.path().join("whole"), dir.path().join("parts"));
    let answer: Answer = search_command(&whole)
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .unwrap()
        .into();
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    assert_eq!(
        names(&whole),
        [
            "case.toml",
            "design.csv",
            "design.json",
            "recommended.toml",
            "report.html",
            "report.json"
        ]
    );
    let found = std::fs::read_to_string(whole.join("design.json")).unwrap();
    let found: serde_json::Value = serde_json::from_str(&found).unwrap();
    let recommended = std::fs::read_to_string(whole.join("recommended.toml")).unwrap();
    let span = &found["search"]["recommended"]["axial_span_mm"];
    assert!(
        recommended.contains(&format!("axial_span_mm = {span}")),
        "{recommended}"
    );
    // What nobody gave is not written as if it were.
    assert!(
        !recommended.contains("lead_ball_angle_deg"),
        "{recommended}"
    );
    let path = whole.join("recommended.toml");
    let checked = call(&["check", path.to_str().unwrap()]);
    assert_eq!((checked.code, checked.stderr.as_str()), (Some(0), ""));

    let mut child = search_command(&parts)
        .env("RAYON_NUM_THREADS", "2")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let journal = parts.join("search.journal");
    let lines = || std::fs::read_to_string(&journal).map_or(0, |t| t.lines().count());
    let patience = Instant::now();
    while lines() < 12 && patience.elapsed() < Duration::from_secs(300) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(lines() >= 12, "killed too early");
    assert!(!parts.join("design.json").exists(), "killed too late");

    // Another case does not take this folder for its own.
    let other = call_on(
        "design",
        &repository_case("zhao-e.toml"),
        &SMALL,
        &["--search", "--out", parts.to_str().unwrap()],
    );
    assert_eq!(other.code, Some(2), "{other:?}");
    assert!(other.stderr.contains("search.journal"), "{}", other.stderr);
    let difference = "request: title was \"Zhao 2022, structure (d): lC 5.1 mm";
    assert!(other.stderr.contains(difference), "{}", other.stderr);
    let difference = "raceway.axial_span_mm was 5.1, is 5.15";
    assert!(other.stderr.contains(difference), "{}", other.stderr);
    let mut changed = search_command(&parts);
    let changed: Answer = (changed
        .args(["--set", "search.runs_max=33"])
        .output()
        .unwrap())
    .into();
    assert_eq!(changed.code, Some(2), "{changed:?}");
    let difference = "another request: search.runs_max was 32, is 33: remove it";
    assert!(changed.stderr.contains(difference), "{}", changed.stderr);
    assert_eq!(
        (other.stdout.as_str(), other.stderr.lines().count()),
        ("", 1)
    );

    let answer: Answer = search_command(&parts).output().unwrap().into();
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    assert_eq!(names(&parts), names(&whole));
    for name in ["design.json", "report.json"] {
        let read = |folder: &Path| std::fs::read(folder.join(name)).unwrap();
        assert!(read(&parts) == read(&whole), "{name} differs");
    }

    let search = &answer.json()["search"];
    let verdict = &search["recommended_verdicts"][0];
    assert_eq!(
        (&verdict["passes"], &verdict["verdict"]),
        (&true.into(), &"smooth".into())
    );
    for (name, passes) in [("recommended", true), ("own", true)] {
        assert_eq!(search[name]["passes"], passes, "{name}");
    }
    assert!(search["recommended"]["points"][0]["motion"]["friction_w"].as_f64() > Some(0.0));
    assert!(!search["front"].as_array().unwrap().is_empty());
    for row in search["maps"][0]["verdict"].as_array().unwrap() {
        for verdict in row.as_array().unwrap() {
            assert!(
                !verdict.as_str().unwrap().is_empty(),
                "a cell without reason"
            );
        }
    }
}

#[test]
fn nothing_to_recommend_is_an_outcome_with_a_reason() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let case = repository_case("zhao-d.toml");
    // Too shallow to spread anything.
    let sets = [
        "solver.method=verlet",
        "solver.step_us=auto",
        "search.axial_span_mm=1",
        "search.half_angle_deg=[10,14]",
        "search.runs_max=32",
    ];
    let more = ["--search", "--json", "--out", out.to_str().unwrap()];
    let answer = call_on("design", &case, &sets, &more);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    assert_eq!(answer.stderr.lines().count(), 1, "{}", answer.stderr);
    let maps = format!("{} has the maps", out.join("report.html").display());
    for said in [
        "no raceway meets every requirement. Reasons against other raceways",
        "too shallow: balls leave too close together (",
        "To change: ",
        &maps,
    ] {
        assert!(answer.stderr.contains(said), "{}", answer.stderr);
    }
    // The map shows why, and the numbers are there for programs.
    assert!(out.join("report.html").exists() && !out.join("search.journal").exists());
    let numbers = std::fs::read_to_string(out.join("design.json")).unwrap();
    assert!(answer.stdout == numbers);
    let numbers: serde_json::Value = serde_json::from_str(&numbers).unwrap();
    assert!(numbers["search"]["recommended"].is_null());
    for (set, said) in [
        ("search.axial_span_mm=[7.5,8]", ["Eq. (8)", "7.4017 mm"]),
        ("search.radial_load_n=[100,100000]", ["ISO 76", "100000 N"]),
    ] {
        let answer = call_on("design", &case, &[set], &["--search"]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        for said in said {
            assert!(answer.stderr.contains(said), "{}", answer.stderr);
        }
    }
}

/// One recommendation, with what it says of its starts; a few raceways are named as such.
#[test]
fn a_search_recommends_one_raceway_in_plain_words() {
    let case = repository_case("zhao-d.toml");
    let answer = call_on("design", &case, &SMALL, &["--search"]);
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let text = answer.stdout.as_str();
    assert_eq!(text.matches("ecommended: ").count(), 1, "{text}");
    for said in [
        "Confirmed from 2 random starts and a bunched one: double collisions in ",
        " of the passages in the mean of the random starts, in ",
        " from the bunch after 128 orbits.",
        "every requirement from 1 random start; the recommended one is the best compromise.",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
    for internal in ["Pareto", "excessive-separation", "eq-9", "exclusion: ."] {
        assert!(!text.contains(internal), "{internal}: {text}");
    }
}

/// Two raceways are both judged, and the worse verdict counts.
#[test]
fn every_raceway_of_a_case_is_judged() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("two.toml");
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let second = "[[raceway]]\naxial_span_mm = 6.0\nhalf_angle_deg = 12.717\n\
                  centre_angle_deg = 60.0\n\n[operation]";
    let text = text
        .replace("[raceway]", "[[raceway]]")
        .replace("[operation]", second);
    std::fs::write(&path, text).unwrap();
    let answer = call_on("design", &path, &[], &["--json"]);
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let d = answer.json();
    let raceways = d["raceways"].as_array().unwrap();
    let verdicts: Vec<&str> = raceways
        .iter()
        .map(|r| r["verdict"].as_str().unwrap())
        .collect();
    assert_eq!(verdicts.len(), 2);
    assert_eq!(verdicts[1], "slips", "short, deep and hardly loaded");
    assert_eq!(d["verdict"], "slips");
    let gaps: Vec<f64> = raceways
        .iter()
        .map(|r| r["critical_gap_deg"].as_f64().unwrap())
        .collect();
    assert!(gaps[1] < gaps[0]);
    assert_eq!(d["critical_gap_deg"].as_f64(), Some(gaps[0]));
    let reasons = d["reasons"].as_array().unwrap();
    assert!(
        reasons
            .iter()
            .any(|r| r.as_str().unwrap().starts_with("raceway 2:"))
    );
}

/// Long work says before it starts how long it will take, then how far it is, in plain lines.
#[test]
fn a_long_search_says_how_long_it_takes() {
    let long = |out: &Path, more: &[&str]| {
        (cageless().env("RAYON_NUM_THREADS", "1"))
            .arg("design")
            .arg(repository_case("zhao-d.toml"))
            .args(["--search", "--set", "search.runs_max=2000"])
            .args(more)
            .arg("--out")
            .arg(out)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    };
    let dir = tempfile::tempdir().unwrap();
    let mut child = long(dir.path(), &[]);
    let [mut first, mut second] = [String::new(), String::new()];
    let mut lines = BufReader::new(child.stderr.take().unwrap());
    lines.read_line(&mut first).unwrap();
    lines.read_line(&mut second).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(first.starts_with("takes about "), "{first}");
    assert!(first.ends_with(" on 1 thread\n"), "{first}");
    assert!(second.starts_with("progress: "), "{second}");
    let times: Vec<&str> = second.trim_end().rsplit(", ").take(2).collect();
    let [left, so_far] = times[..] else {
        panic!("{second}");
    };
    assert!(
        left.ends_with(" left") && !left.starts_with("00:00:0"),
        "{second}"
    );
    assert!(
        so_far.starts_with("00:00:") && so_far.ends_with(" elapsed"),
        "{second}"
    );
    assert!(!(first + &second).contains(['\u{1b}', '\r']));

    // Quiet, it has begun once there is a journal, and has said nothing.
    let dir = tempfile::tempdir().unwrap();
    let mut child = long(dir.path(), &["--quiet"]);
    let patience = Instant::now();
    while !dir.path().join("search.journal").exists() && patience.elapsed().as_secs() < 300 {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    let said = child.wait_with_output().unwrap();
    assert!(
        dir.path().join("search.journal").exists(),
        "killed too early"
    );
    assert_eq!(String::from_utf8(said.stderr).unwrap(), "");
}

/// A search over all shapes enters the shape that it found, blended as that of the case, and judges
/// the case with it.
#[test]
fn a_search_over_shapes_enters_the_shape_that_it_found() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let of_shapes = [
        "--set",
        "search.shapes=all",
        "--set",
        "search.half_angle_deg=[22,24]",
        "--set",
        "search.axial_span_mm=5",
        "--set",
        "raceway.blend_mm=1",
    ];
    let answer: Answer = search_command(&out)
        .args(of_shapes)
        .output()
        .unwrap()
        .into();
    assert_eq!((answer.code, answer.stderr.as_str()), (Some(0), ""));
    let found: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
    let search = &found["search"];
    let tried = search["band"].as_array().unwrap();
    let count = |shape: &str| tried.iter().filter(|s| s["shape"] == shape).count();
    let counts = ["quartic", "ellipse", "shuttle", "steady", "measured"].map(count);
    assert!(
        counts[..4].iter().all(|n| *n > 0) && counts[4] == 0,
        "{counts:?}"
    );
    let shape = search["recommended"]["shape"].as_str().unwrap();
    assert_ne!(shape, "quartic");
    let path = out.join("recommended.toml");
    let recommended = std::fs::read_to_string(&path).unwrap();
    for line in [format!("shape = \"{shape}\""), "blend_mm = 1".to_owned()] {
        assert!(recommended.contains(&line), "{line}: {recommended}");
    }
    let judged = call(&["design", path.to_str().unwrap(), "--json"]);
    let judged: serde_json::Value = serde_json::from_str(&judged.stdout).unwrap();
    let verdict = &search["recommended_verdicts"][0];
    assert_eq!(judged["critical_gap_deg"], verdict["critical_gap_deg"]);
}
