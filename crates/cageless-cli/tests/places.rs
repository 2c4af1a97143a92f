//! What others have put where a file of the program's own is to be.
#![cfg(unix)]

use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::common::*;

const SHORT: [&str; 1] = ["solver.duration_s=0.0005"];

fn run_into(out: &Path) -> Answer {
    let out = ["--out", out.to_str().unwrap()];
    call_on("run", &repository_case("zhao-d.toml"), &SHORT, &out)
}

fn assert_occupied(answer: &Answer, what: &str) {
    assert_eq!(answer.code, Some(2), "{answer:?}");
    for said in [".balls.parquet.partial", what, "remove it"] {
        assert!(answer.stderr.contains(said), "{answer:?}");
    }
}

/// Whoever can write into the folder of the results cannot lead them into another file.
#[test]
fn links_are_not_followed() {
    let dir = tempfile::tempdir().unwrap();
    let (victim, out) = (dir.path().join("victim"), dir.path().join("out"));
    let partial = out.join(".balls.parquet.partial");
    std::fs::create_dir(&out).unwrap();
    std::fs::write(&victim, "precious").unwrap();

    symlink("../victim", &partial).unwrap();
    assert_occupied(&run_into(&out), "is a symbolic link");
    std::fs::remove_file(&partial).unwrap();
    symlink("../none", &partial).unwrap();
    assert_occupied(&run_into(&out), "is a symbolic link");
    assert!(!dir.path().join("none").exists());
    std::fs::remove_file(&partial).unwrap();
    std::fs::hard_link(&victim, &partial).unwrap();
    assert_occupied(&run_into(&out), "by a hard link");
    assert_eq!(std::fs::read_to_string(&victim).unwrap(), "precious");

    // What a killed run left is taken over.
    std::fs::remove_file(&partial).unwrap();
    std::fs::write(&partial, "half a table").unwrap();
    let answer = run_into(&out);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert_eq!(names(&out), RUN_FILES);
}

#[test]
fn pipes_are_not_waited_for() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    std::fs::create_dir(&out).unwrap();
    let pipe = |name: &str| {
        let path = out.join(name);
        let made = Command::new("mkfifo").arg(&path).status().unwrap();
        assert!(made.success());
        path
    };
    let in_time = |mut command: Command| -> Answer {
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let begin = Instant::now();
        while child.try_wait().unwrap().is_none() {
            if begin.elapsed() > Duration::from_secs(60) {
                child.kill().unwrap();
                panic!("it waits");
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        child.wait_with_output().unwrap().into()
    };
    pipe(".balls.parquet.partial");
    let mut run = cageless();
    run.arg("run").arg(repository_case("zhao-d.toml"));
    run.args(["--set", SHORT[0], "--out"]).arg(&out);
    assert_occupied(&in_time(run), "is not a regular file");

    let mut report = cageless();
    report.arg("report").arg(pipe("sweep.parquet"));
    let answer = in_time(report);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert!(answer.stderr.contains("it is not a file"), "{answer:?}");
}
