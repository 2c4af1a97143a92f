//! Commands where the system starts no thread.
#![cfg(target_os = "linux")]

use crate::common::*;

/// One thread computes the same numbers.
#[test]
fn without_threads_one_does_all() {
    let case = repository_case("zhao-d.toml");
    let drop = repository_case("touchdown-d.toml");
    let short = ["--set", "solver.duration_s=0.001", "--json"];
    for (command, file, more) in [
        (
            "compare",
            &case,
            &[
                "--with-conventional",
                "--draws",
                "2",
                "--set",
                "steady.transient_orbits=0",
                "--set",
                "steady.measured_orbits=1",
            ][..],
        ),
        ("run", &case, &["--verify"]),
        ("drop", &drop, &["--samples", "3"]),
        ("drop", &drop, &["--verify"]),
        ("static", &case, &[]),
    ] {
        let answer = |mut process: std::process::Command| -> Answer {
            process.arg(command).arg(file).args(short).args(more);
            process.output().expect("starts").into()
        };
        let (alone, with) = (answer(without_threads()), answer(cageless()));
        assert_eq!(alone.code, with.code, "{alone:?}");
        let words = |answer: &Answer| answer.json().as_object().unwrap().len();
        assert!(words(&alone) > 3, "{alone:?}");
        for line in alone.stdout.lines().filter(|line| !line.contains("wall_s")) {
            assert!(with.stdout.contains(line), "{command} {more:?}: {line}");
        }
    }
}

/// What can do nothing without threads says so.
#[test]
fn servers_and_sweeps_name_the_threads() {
    use std::os::unix::fs::PermissionsExt;
    let out = tempfile::tempdir().unwrap();
    std::fs::set_permissions(out.path(), PermissionsExt::from_mode(0o777)).unwrap();
    let plan = repository_case("../plans/span-and-angle.toml");
    let case = repository_case("zhao-d.toml");
    let mut sweep = without_threads();
    sweep.arg("sweep").arg(plan).arg("--out").arg(out.path());
    let mut studio = without_threads();
    studio.arg("studio").arg(case).arg("--no-browser");
    for mut process in [sweep, studio] {
        let answer: Answer = process.output().unwrap().into();
        assert_eq!(answer.code, Some(1), "{answer:?}");
        assert!(
            answer.stderr.starts_with("error: cannot start threads: "),
            "{answer:?}"
        );
    }
}
