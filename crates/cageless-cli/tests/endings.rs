//! However a run ends, what it leaves can be read.
#![cfg(unix)]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::common::*;

fn run_to(out: &Path, sets: &[&str]) -> Answer {
    let case = repository_case("zhao-d.toml");
    call_on("run", &case, sets, &["--out", out.to_str().unwrap()])
}

/// Starts a run that would take hours.
fn start_long_run(out: &Path) -> Child {
    cageless()
        .arg("run")
        .arg(repository_case("zhao-d.toml"))
        // Many rows, so that the first come soon.
        .args(["--set", "output.interval_us=5"])
        .args(["--set", "solver.duration_s=5000", "--out"])
        .arg(out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts")
}

/// Sends a signal to a command.
pub fn signal(child: &Child, name: &str) {
    let status = Command::new("kill")
        .args([name, &child.id().to_string()])
        .status();
    assert!(status.unwrap().success());
}

/// Waits until the run has written rows.
fn wait_for_rows(child: &mut Child, out: &Path) {
    let partial = out.join(".balls.parquet.partial");
    let begin = Instant::now();
    while !std::fs::metadata(&partial).is_ok_and(|m| m.len() > 4) {
        assert!(begin.elapsed() < Duration::from_secs(60), "no rows");
        assert_eq!(child.try_wait().unwrap(), None, "ended at once");
        sleep(Duration::from_millis(20));
    }
    sleep(Duration::from_millis(300));
}

/// All tables are complete, times ascend and every number is one.
fn assert_readable(out: &Path) -> f64 {
    assert_eq!(names(out), RUN_FILES);
    let (_, balls) = table(&out.join("balls.parquet"));
    let (_, ring) = table(&out.join("ring.parquet"));
    table(&out.join("collisions.parquet"));
    assert_eq!(balls.len(), 14 * ring.len());
    assert!(ring.windows(2).all(|w| w[0][0] < w[1][0]));
    assert!(balls.iter().chain(&ring).flatten().all(|v| v.is_finite()));
    json_file(&out.join("report.json"));
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.trim_end().ends_with("</html>"));
    ring.last().unwrap()[0]
}

#[test]
fn a_run_that_leaves_the_physical_range_says_so_and_keeps_what_it_has() {
    let dir = tempfile::tempdir().unwrap();
    let sets = [
        "contact.damping_n_s_m1_5=0",
        "solver.step_us=2",
        "solver.duration_s=2",
    ];
    let answer = run_to(dir.path(), &sets);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    assert_eq!(answer.stderr.lines().count(), 1, "{}", answer.stderr);
    let message = &answer.stderr;
    // When, why, what to change.
    assert!(message.starts_with("error: at t = 0.0"), "{message}");
    assert!(message.contains("energy appeared"), "{message}");
    assert!(
        message.contains("To change: set solver.step_us to \"auto\", 0.5 µs in this case"),
        "{message}"
    );
    assert!(message.contains(dir.path().to_str().unwrap()), "{message}");

    let end = assert_readable(dir.path());
    let summary = json_file(&dir.path().join("summary.json"));
    let stopped = &summary["stopped"];
    let time = stopped["time_s"].as_f64().unwrap();
    assert!(time > 0.0 && time < 1.0 && end <= time && time - end < 2e-4);
    assert_eq!(summary["verdict"], "not-judged", "{summary}");
    for key in ["cause", "advice"] {
        assert!(!stopped[key].as_str().unwrap().is_empty(), "{summary}");
    }
    assert!(!summary["warnings"].as_array().unwrap().is_empty());

    // On stdout the summary is one JSON document all the same.
    let case = repository_case("zhao-d.toml");
    let answer = call_on("run", &case, &sets, &["--json"]);
    assert_eq!(answer.code, Some(3));
    assert!(answer.json()["stopped"].is_object());
}

/// A drop that stops outside the physical range says so before the pressures that it reached, and its page says what
/// to change.
#[test]
fn a_drop_that_stops_says_so_in_verdict_and_page() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("touchdown-d.toml");
    let sets = ["solver.duration_s=0.0005", "rotor.vx_m_s=30"];
    let answer = call_on(
        "drop",
        &case,
        &sets,
        &["--out", dir.path().to_str().unwrap()],
    );
    assert_eq!(answer.code, Some(3), "{answer:?}");
    let summary = json_file(&dir.path().join("summary.json"));
    let headline = summary["headline"].as_str().unwrap();
    assert!(
        headline.starts_with("FAIL: stopped at t = 0.00"),
        "{headline}"
    );
    assert!(headline.contains("contact pressure"), "{headline}");
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(page.contains("To change: set solver.step_us to"));
}

/// Dry friction takes an explicit method to far shorter steps than contacts alone, on a slot as on flanks. The advice
/// of a run at a step that is too long for it is followed once, and the energy balance closes.
#[test]
fn the_advice_of_a_run_at_too_long_a_step_leads_to_one_that_ends() {
    let case = repository_case("zhao-d.toml");
    let slot = [
        "contact.friction_coefficient=0.1",
        "raceway.shape=slot",
        "raceway.edge_radius_mm=1.2",
        "raceway.axial_span_mm=4",
        "raceway.half_angle_deg=30",
        "solver.duration_s=0.02",
    ];
    let answer = call_on("run", &case, &slot, &["--json"]);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    // At its end alone, with 5.8 % of all energy flows unaccounted for.
    assert_eq!(answer.json()["stopped"]["time_s"], 0.02);
    let advised = "To change: set solver.step_us to \"auto\", 0.1 µs in this case";
    assert!(answer.stderr.contains(advised), "{}", answer.stderr);
    for sets in [
        &["solver.step_us=auto", "solver.duration_s=0.006"][..],
        &["solver.step_us=auto", "solver.method=verlet"],
        &["solver.step_us=2", "solver.method=verlet"],
    ] {
        let answer = call_on("run", &case, &[&slot, sets].concat(), &["--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        let residual = answer.json()["energy_residual_relative"].as_f64().unwrap();
        assert!(residual.abs() < 0.01, "{sets:?}: {residual}");
    }
}

#[test]
fn ctrl_c_ends_a_run_in_good_order() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut child = start_long_run(&out);
    wait_for_rows(&mut child, &out);
    signal(&child, "-INT");
    let answer: Answer = child.wait_with_output().unwrap().into();
    assert_eq!(answer.code, Some(1), "{answer:?}");
    assert!(answer.stderr.contains("interrupted at t = "), "{answer:?}");
    assert!(answer.stdout.contains("simulated"), "{answer:?}");
    let end = assert_readable(&out);
    assert!(end > 0.01, "{end}");
    let summary = json_file(&out.join("summary.json"));
    assert!(summary["steps"].as_u64() > Some(10_000));
    // The summary alone tells that it is not of the whole run, and why.
    let stopped = &summary["stopped"];
    assert_eq!(stopped["cause"], "interrupted", "{summary}");
    assert!(stopped["time_s"].as_f64().unwrap() >= end, "{summary}");
    let advice = stopped["advice"].as_str().unwrap();
    assert!(advice.contains("to its end at 5000 s"), "{advice}");
    let judged = ["verdict", "passes"].map(|key| &summary[key]);
    assert_eq!(judged, [&"not-judged".into(), &serde_json::Value::Null]);
    let headline = summary["headline"].as_str().unwrap();
    assert!(
        headline.starts_with("not judged: interrupted after "),
        "{headline}"
    );
    assert!(answer.stdout.contains(headline), "{answer:?}");
    let page = json_file(&out.join("report.json"));
    let warnings = page["warnings"].to_string();
    assert_eq!(warnings.matches("interrupted").count(), 1, "{warnings}");
}

/// By SIGTERM a batch system ends a run, by the others it warns of the end, perhaps more than once.
#[test]
fn signals_of_batch_systems_end_a_run_in_good_order() {
    let dir = tempfile::tempdir().unwrap();
    for name in ["-TERM", "-USR1", "-USR2", "-XCPU"] {
        let out = dir.path().join(name);
        let mut child = start_long_run(&out);
        wait_for_rows(&mut child, &out);
        for _ in 0..if name == "-TERM" { 1 } else { 3 } {
            signal(&child, name);
        }
        let answer: Answer = child.wait_with_output().unwrap().into();
        assert_eq!(answer.code, Some(1), "{name}: {answer:?}");
        assert!(answer.stderr.contains("interrupted"), "{name}: {answer:?}");
        assert_readable(&out);
    }
}

#[test]
fn a_killed_run_leaves_nothing_half_written_under_a_final_name() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path();
    // Results of an earlier run, which must survive.
    let sets = ["solver.duration_s=0.002"];
    assert_eq!(run_to(out, &sets).code, Some(0));
    let before = std::fs::read(out.join("balls.parquet")).unwrap();

    let mut child = start_long_run(out);
    wait_for_rows(&mut child, out);
    // No other command may write there meanwhile, and what is there stays.
    for command in ["run", "static"] {
        let case = repository_case("zhao-d.toml");
        let answer = call_on(command, &case, &sets, &["--out", out.to_str().unwrap()]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        assert!(
            answer
                .stderr
                .contains("another process is writing a result there"),
            "{answer:?}"
        );
    }
    signal(&child, "-KILL");
    child.wait().unwrap();
    for name in names(out) {
        assert!(
            RUN_FILES.contains(&name.as_str())
                || name == ".cageless.lock"
                || (name.starts_with('.') && name.ends_with(".partial")),
            "{name}"
        );
    }
    assert_eq!(std::fs::read(out.join("balls.parquet")).unwrap(), before);

    // The next run takes over and cleans up.
    assert_eq!(run_to(out, &sets).code, Some(0));
    assert_readable(out);
}

/// Files that grow beyond a limit cannot be written, as on a disk that is full: while rows
/// come, or when the tables are closed, of which only one is too large then.
#[test]
fn a_full_disk_leaves_the_files_of_one_run() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path();
    assert_eq!(run_to(out, &["solver.duration_s=0.002"]).code, Some(0));
    let read = || -> Vec<Vec<u8>> {
        let names = RUN_FILES.iter();
        names.map(|f| std::fs::read(out.join(f)).unwrap()).collect()
    };
    let before = read();
    for (blocks, duration) in [(16, "0.002"), (2000, "1")] {
        let mut command = on_full_disk(blocks);
        command
            .arg("run")
            .arg(repository_case("zhao-d.toml"))
            .arg("--out")
            .arg(out);
        command.args(["--set", "operation.inner_speed_rpm=9000"]);
        command.args(["--set", &format!("solver.duration_s={duration}")]);
        let answer = Answer::from(command.output().unwrap());
        assert_eq!(answer.code, Some(1), "{answer:?}");
        assert_eq!(answer.stderr.lines().count(), 1, "{answer:?}");
        let message = &answer.stderr;
        assert!(message.contains("cannot write ") && message.contains("balls.parquet: "));
        assert!(!message.contains("ring.parquet"), "{message}");
        assert!(message.contains("is as it was"), "{message}");
        assert!(
            message.contains("balls.parquet: file too large;"),
            "{message}"
        );
        assert_eq!(names(out), RUN_FILES);
        assert!(read() == before, "{blocks}");
    }
}

#[test]
fn the_same_case_gives_the_same_bits() {
    let dir = tempfile::tempdir().unwrap();
    let sets = ["solver.duration_s=0.05", "output.interval_us=37"];
    let run = |name: &str, threads: &str| {
        let out = dir.path().join(name);
        let mut command = cageless();
        command.env("RAYON_NUM_THREADS", threads).arg("run");
        command
            .arg(repository_case("zhao-a.toml"))
            .arg("--out")
            .arg(&out);
        for set in sets {
            command.args(["--set", set]);
        }
        assert!(command.output().unwrap().status.success());
        ["balls.parquet", "ring.parquet", "collisions.parquet"].map(|f| {
            let (_, rows) = table(&out.join(f));
            let bits = rows.into_iter().flatten().map(f64::to_bits);
            bits.collect::<Vec<u64>>()
        })
    };
    let (one, other) = (run("one", "1"), run("other", "2"));
    assert!(one[0].len() > 14 * 15 * 1300 && !one[2].is_empty());
    assert!(one == other);
}

/// Rows stand at whole multiples of the interval, from 0 on, and at the end of the run.
#[test]
fn rows_stand_at_multiples_of_the_interval_and_at_the_end() {
    let dir = tempfile::tempdir().unwrap();
    for (duration, interval, rows) in [
        ("0.003", "100", 31),
        ("0.00105", "100", 12),
        ("0.0001", "7", 16),
        ("0.0001", "0.25", 401),
        ("0.00001", "100", 2),
    ] {
        let sets = [
            &format!("solver.duration_s={duration}")[..],
            &format!("output.interval_us={interval}"),
        ];
        assert_eq!(run_to(dir.path(), &sets).code, Some(0));
        let (_, ring) = table(&dir.path().join("ring.parquet"));
        assert_eq!(ring.len(), rows, "{sets:?}");
        let interval = 1e-6 * interval.parse::<f64>().unwrap();
        let end = duration.parse::<f64>().unwrap();
        for (k, row) in ring.iter().enumerate() {
            let expected = (k as f64 * interval).min(end);
            assert!((row[0] - expected).abs() < 1e-12, "{row:?}");
        }
    }
}

/// A run that stops before there are statistics shows none, rather than NaN.
#[test]
fn no_statistics_are_no_numbers() {
    let dir = tempfile::tempdir().unwrap();
    // The ring presses balls further into the raceway than any contact survives.
    let sets = [
        "start.state=rolling",
        "start.ring_y_um=-450",
        "solver.step_us=0.5",
    ];
    let answer = run_to(dir.path(), &sets);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    let text = page.split("<script").next().unwrap();
    for shown in [&answer.stdout[..], &answer.stderr, text] {
        assert!(!shown.contains("NaN") && !shown.contains("inf"), "{shown}");
    }
    let summary = json_file(&dir.path().join("summary.json"));
    assert!(summary["gap_min_deg"].is_null());
    let warnings = summary["warnings"].to_string();
    assert!(warnings.contains("no statistics"), "{warnings}");
}

/// A case whose critical gap alone takes minutes: a small bearing with many balls at low speed,
/// integrated with error control.
const SLOW: [&str; 6] = [
    "operation.inner_speed_rpm=30",
    "operation.radial_load_n=0",
    "contact.damping_n_s_m1_5=0",
    "model.formulation=paper",
    "solver.method=adaptive",
    "bearing.ball_radius_deviation_um=[2,-3,4,1,5,4,-1,2,3,2,1,-3,4,-2]",
];

/// The first passage of a pair is left as soon as that is asked for, whatever looks for it.
#[test]
fn a_critical_gap_can_be_interrupted() {
    for more in [&["design"][..], &["tolerance", "--samples", "2"]] {
        let mut command = cageless();
        command.arg(more[0]).arg(repository_case("zhao-d.toml"));
        for set in SLOW {
            command.args(["--set", set]);
        }
        let mut child = command
            .args(&more[1..])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("starts");
        sleep(Duration::from_millis(1500));
        assert_eq!(child.try_wait().unwrap(), None, "ended at once");
        signal(&child, "-TERM");
        let begin = Instant::now();
        while child.try_wait().unwrap().is_none() {
            if begin.elapsed() > Duration::from_secs(20) {
                child.kill().unwrap();
                panic!("{more:?} goes on");
            }
            sleep(Duration::from_millis(20));
        }
        let answer: Answer = child.wait_with_output().unwrap().into();
        assert_eq!(answer.code, Some(1), "{answer:?}");
        assert_eq!(answer.stdout, "");
        assert!(
            answer
                .stderr
                .contains("interrupted before there was a result"),
            "{answer:?}"
        );
    }
}
