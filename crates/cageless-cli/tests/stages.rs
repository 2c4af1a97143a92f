//! Exit codes of commands that compute in stages, wherever they end.
#![cfg(unix)]

use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use serde_json::Value;

use crate::common::*;
use crate::endings::signal;

/// Without damping and with a step that is too long energy comes from nowhere.
const UNSTABLE: [&str; 2] = ["contact.damping_n_s_m1_5=0", "solver.step_us=2"];

/// Whatever computes the run that leaves the physical range: exit code 3, one line with time, cause and advice, and of
/// what judges it a verdict that is none.
#[test]
fn what_stops_ends_with_exit_code_3_in_every_command() {
    let soft = ["rotor.contact_stiffness_n_mp=1e4", "solver.duration_s=0.05"];
    let long = [&UNSTABLE[..], &["solver.duration_s=2"]].concat();
    for (command, case, sets, verdict, cause) in [
        (
            "run",
            "zhao-d.toml",
            &long[..],
            "not-judged",
            "energy appeared",
        ),
        (
            "design",
            "zhao-d.toml",
            &UNSTABLE,
            "not-judged",
            "energy appeared",
        ),
        (
            "drop",
            "touchdown-d.toml",
            &soft,
            "not-judged",
            "the rotor went through",
        ),
        (
            "drop",
            "rotors/vertical.toml",
            &soft[..1],
            "not-judged",
            "the rotor went through",
        ),
    ] {
        let answer = call_on(command, &repository_case(case), sets, &["--json"]);
        assert_eq!(answer.code, Some(3), "{command} {case}: {answer:?}");
        let mut errors = answer.stderr.lines().filter(|l| l.starts_with("error: "));
        let (error, more) = (errors.next().unwrap(), errors.next());
        assert_eq!(more, None);
        for part in ["at t = 0.0", cause, "To change: "] {
            assert!(error.contains(part), "{command}: {error}");
        }
        let json = answer.json();
        assert_eq!(json["verdict"], verdict, "{command} {case}");
        assert_ne!(json["passes"], true, "{command} {case}");
        let headline = json["headline"].as_str().unwrap();
        assert!(!headline.starts_with("works"), "{headline}");
        assert!(headline.contains("stopped at "), "{headline}");
    }
}

/// The answer of a command that is ended by a signal in what follows its first result: `says` is part of the message
/// then, and earlier endings say something else.
fn interrupted_after(command: &str, case: &str, more: &[&str], says: &str) -> Answer {
    let mut wait = Duration::from_millis(300);
    loop {
        let mut child = cageless()
            .arg(command)
            .arg(repository_case(case))
            .args(more)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("starts");
        sleep(wait);
        assert_eq!(child.try_wait().unwrap(), None, "{command} ended at once");
        signal(&child, "-INT");
        let answer: Answer = child.wait_with_output().unwrap().into();
        assert_eq!(answer.code, Some(1), "{answer:?}");
        if answer.stderr.contains(says) {
            return answer;
        }
        // Before its first result, on a slow machine.
        wait *= 2;
        assert!(wait < Duration::from_secs(60), "{answer:?}");
    }
}

/// A command that is interrupted after its first result has that result with its verdict, and exit code 1.
#[test]
fn what_is_interrupted_later_has_its_first_result() {
    for (command, case, more, says) in [
        (
            "drop",
            "touchdown-d.toml",
            &["--set", "solver.duration_s=0.008", "--samples", "100000"][..],
            "interrupted: the drop itself is complete",
        ),
        (
            "run",
            "zhao-d.toml",
            &["--set", "solver.duration_s=0.3", "--verify", "--json"],
            "interrupted while verifying: the run itself is complete",
        ),
    ] {
        let out = tempfile::tempdir().unwrap();
        let folder = out.path().to_str().unwrap();
        let answer = interrupted_after(command, case, &[more, &["--out", folder]].concat(), says);
        let message = answer.stderr.lines().last().unwrap();
        assert!(
            message.starts_with("error: ") && message.contains(folder),
            "{answer:?}"
        );
        let summary = json_file(&out.path().join("summary.json"));
        let of_bearing = match command {
            "drop" => &summary["bearings"][0],
            _ => &summary,
        };
        assert_eq!(of_bearing["stopped"], Value::Null, "{command}");
        assert!(of_bearing["case"].is_object(), "{command}");
        // The drop is too short for a verdict, and says so rather than that it was interrupted.
        let headline = summary["headline"].as_str().unwrap();
        match command {
            "drop" => assert!(headline.contains("it ends too early"), "{headline}"),
            _ => assert_ne!(summary["verdict"], "not-judged", "{command}"),
        }
        assert!(out.path().join("report.html").is_file(), "{command}");
    }
}
