//! Inputs that ask for much: refused, or done in bounded time and memory.
#![cfg(unix)]

use std::process::Command;
use std::time::{Duration, Instant};

use crate::common::*;

#[test]
fn threads_of_the_environment_have_the_limit_of_the_option() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let plan = dir.path().join("plan.toml");
    let text = format!(
        "case = {case:?}\ncompute = [\"static\"]\n[grid]\noperation.radial_load_n = [500, 900]\n"
    );
    std::fs::write(&plan, text).unwrap();
    let sweep = |threads: &str, name: &str| -> Answer {
        let mut command = cageless();
        command
            .arg("sweep")
            .arg(&plan)
            .arg("--out")
            .arg(dir.path().join(name));
        command
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap()
            .into()
    };
    for threads in ["1025", "20000", "99999999999999999999999", "-1", "1e9"] {
        let answer = sweep(threads, "refused");
        assert_eq!(answer.code, Some(2), "{answer:?}");
        let said = format!("RAYON_NUM_THREADS = {threads} is not possible: 1 to 1024 are");
        assert!(answer.stderr.contains(&said), "{answer:?}");
        assert!(!dir.path().join("refused").exists());
    }
    assert_eq!(sweep("2", "done").code, Some(0));
}

/// Time grows with the length of a file, not with its square.
#[test]
fn long_files_are_read_in_time() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let plan = dir.path().join("plan.toml");
    let loads: Vec<String> = (0..100_000)
        .map(|k| format!("{}.5", 100 + k % 900))
        .collect();
    // The last key does not exist: the plan is read and refused.
    let text = format!(
        "case = {case:?}\ncompute = [\"static\"]\n[grid]\n\
         operation.radial_load_n = [\n{}\n]\nnone = [1]\n",
        loads.join(",\n")
    );
    std::fs::write(&plan, text).unwrap();
    let begin = Instant::now();
    let answer = call(&["sweep", plan.to_str().unwrap(), "--out", "nowhere"]);
    let taken = begin.elapsed();
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(answer.stderr.contains("plan.toml:100006: "), "{answer:?}");
    assert!(taken < Duration::from_secs(5), "{taken:?}");
}

#[test]
fn raceways_are_limited_in_number() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let raceway = "\n[[raceway]]\naxial_span_mm = 5.1\nhalf_angle_deg = 25\n";
    let (head, tail) = text.split_once("[raceway]").unwrap();
    let rest = tail.split_once("\n[").map_or("", |(_, rest)| rest);
    std::fs::write(
        &path,
        format!("{head}{}[{rest}", raceway.repeat(10_000) + "\n"),
    )
    .unwrap();
    let begin = Instant::now();
    let answer = call_on("check", &path, &[], &[]);
    let taken = begin.elapsed();
    assert_eq!(answer.code, Some(2), "{answer:?}");
    let said = "10000 sections [[raceway]] are not possible: there may be at most 64";
    assert!(answer.stderr.contains(said), "{answer:?}");
    assert!(taken < Duration::from_secs(5), "{taken:?}");
}

/// Points are written as they are computed: 77 MB of them where there is no room for so many.
#[test]
fn points_need_no_memory() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("points.csv");
    let mut command = Command::new("bash");
    let limited = "ulimit -v 80000; exec \"$@\"";
    command.args([
        "-c",
        limited,
        "bash",
        env!("CARGO_BIN_EXE_cageless"),
        "export",
    ]);
    command.arg(repository_case("zhao-d.toml"));
    command.args(["--set", "bearing.outer_ring_outer_radius_mm=31"]);
    command.args(["--set", "bearing.outer_ring_width_mm=16"]);
    command
        .args(["--format", "csv", "--spacing-mm", "0.05", "--out"])
        .arg(&out);
    let answer = Answer::from(command.output().unwrap());
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let bytes = std::fs::metadata(&out).unwrap().len();
    assert!(bytes > 70_000_000, "{bytes}");
    assert!(
        answer.stdout.contains(&format!("{bytes} bytes")),
        "{answer:?}"
    );
}
