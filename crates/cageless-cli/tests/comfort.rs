//! Pages named and opened, quiet runs, completions, man pages and suggestions.

use std::path::Path;
use std::process::Command;

use crate::common::*;

const SHORT: &str = "solver.duration_s=0.0005";

/// A folder of programs with a browser that notes what it is given.
#[cfg(unix)]
fn browser(dir: &Path) -> Command {
    use std::os::unix::fs::PermissionsExt;
    let bin = dir.join("bin");
    std::fs::create_dir(&bin).unwrap();
    let program = bin.join("xdg-open");
    let note = dir.join("opened");
    let script = format!("#!/bin/sh\nprintf '%s' \"$1\" > {}\n", note.display());
    std::fs::write(&program, script).unwrap();
    std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).unwrap();
    let mut command = cageless();
    command.env("PATH", &bin).env_remove("BROWSER");
    command
}

#[cfg(target_os = "linux")]
#[test]
fn the_page_is_opened() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut command = browser(dir.path());
    command.arg("run").arg(repository_case("zhao-d.toml"));
    command.args(["--set", SHORT, "--open", "--quiet", "--out"]);
    let done: Answer = command.arg(&out).output().unwrap().into();
    assert_eq!((done.code, done.stdout.as_str()), (Some(0), ""), "{done:?}");
    let opened = dir.path().join("opened");
    // The browser runs by itself.
    for _ in 0..200 {
        if opened.exists() && !std::fs::read_to_string(&opened).unwrap().is_empty() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let page = out.join("report.html").display().to_string();
    assert_eq!(std::fs::read_to_string(opened).unwrap(), page);
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_browser_the_page_is_there_and_a_warning_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let mut command = cageless();
    command.env("PATH", dir.path()).env_remove("BROWSER");
    command.arg("run").arg(repository_case("zhao-d.toml"));
    command.args(["--set", SHORT, "--open", "--out"]);
    let done: Answer = command.arg(dir.path().join("out")).output().unwrap().into();
    assert_eq!(done.code, Some(0), "{done:?}");
    assert!(done.stderr.contains("could not be opened"), "{done:?}");
    assert!(dir.path().join("out/report.html").exists());
}

#[test]
fn a_page_to_open_needs_a_folder() {
    for command in ["static", "run", "design", "tolerance", "drop"] {
        let refused = call_on(command, &repository_case("zhao-d.toml"), &[], &["--open"]);
        assert_eq!(refused.code, Some(2), "{refused:?}");
        assert!(refused.stderr.contains("--out <DIR>"), "{refused:?}");
    }
}

#[test]
fn a_quiet_command_prints_json_and_errors_only() {
    let case = repository_case("zhao-d.toml");
    for command in ["static", "check", "run"] {
        let quiet = call_on(command, &case, &[SHORT], &["--quiet"]);
        assert_eq!(quiet.code, Some(0), "{quiet:?}");
        assert_eq!(quiet.stdout + &quiet.stderr, "", "{command}");
    }
    let json = call_on("static", &case, &[], &["-q", "--json"]);
    assert!(json.json().is_object());
    let refused = call_on("static", &case, &["bearing.balls=2"], &["--quiet"]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    assert!(refused.stderr.contains("bearing.balls"), "{refused:?}");
    // What is asked for is no remark.
    assert!(call(&["--quiet", "new"]).stdout.contains("[bearing]"));
}

#[test]
fn a_mistyped_command_gets_a_suggestion() {
    for (given, meant) in [("rnu", "run"), ("desing", "design"), ("swep", "sweep")] {
        let refused = call(&[given, "case.toml"]);
        assert_eq!(refused.code, Some(2), "{refused:?}");
        let tip = format!("'{meant}'");
        assert!(refused.stderr.contains(&tip), "{refused:?}");
    }
    let refused = call(&["frobnicate"]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    assert!(!refused.stderr.contains("tip:"), "{refused:?}");
}

/// Commands as `--help` lists them.
fn commands() -> Vec<String> {
    let help = call(&["--help"]).stdout;
    let list = help.split("Commands:").nth(1).unwrap();
    let list = list.split("\n\n").next().unwrap();
    let names = list.lines().filter(|line| {
        let text = line.trim_start();
        line.len() - text.len() == 2
    });
    names
        .map(|line| line.trim().split(' ').next().unwrap().to_owned())
        .filter(|name| name != "help")
        .collect()
}

#[test]
fn completions_know_every_command() {
    let all = commands();
    assert!(all.len() > 10, "{all:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let answer = call(&["completions", shell]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        for command in &all {
            assert!(answer.stdout.contains(command), "{shell}: {command}");
        }
        assert!(answer.stdout.contains("quiet"), "{shell}");
    }
    assert_eq!(call(&["completions", "tcsh"]).code, Some(2));
}

#[cfg(unix)]
#[test]
fn bash_takes_its_completions() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("completions");
    std::fs::write(&path, call(&["completions", "bash"]).stdout).unwrap();
    let script = "source \"$0\"; COMP_WORDS=(cageless ru); COMP_CWORD=1; \
                  _cageless cageless ru cageless; echo \"${COMPREPLY[@]}\"";
    let answer = Command::new("bash")
        .args(["-c", script])
        .arg(&path)
        .output();
    let Ok(answer) = answer else {
        // No bash, no completions.
        return;
    };
    let answer: Answer = answer.into();
    assert_eq!(answer.stdout.trim(), "run", "{answer:?}");
}

#[test]
fn every_command_has_a_man_page() {
    let page = call(&["man"]);
    assert!(page.stdout.contains(".TH cageless 1"), "{page:?}");
    let page = call(&["man", "run"]);
    assert_eq!(page.code, Some(0), "{page:?}");
    assert!(page.stdout.contains(".TH cageless-run 1"), "{page:?}");
    assert!(page.stdout.contains("\\-\\-verify"), "{page:?}");
    let refused = call(&["man", "rnu"]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    assert!(refused.stderr.contains("design"), "{refused:?}");

    let dir = tempfile::tempdir().unwrap();
    let all = call(&["man", "--out", dir.path().to_str().unwrap()]);
    assert_eq!(all.code, Some(0), "{all:?}");
    let written = names(dir.path());
    for command in commands() {
        assert!(
            written.contains(&format!("cageless-{command}.1")),
            "{written:?}"
        );
    }
    assert!(
        written.contains(&"cageless-sweep-merge.1".to_owned()),
        "{written:?}"
    );
}

/// CSV beside Parquet has its numbers, and goes with the run that it belongs to.
#[test]
fn tables_are_written_as_csv() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().to_str().unwrap();
    let case = repository_case("zhao-d.toml");
    let done = call_on("run", &case, &[SHORT], &["--csv", "--out", out]);
    assert_eq!(done.code, Some(0), "{done:?}");
    for name in ["balls", "ring"] {
        let (names, rows) = table(&dir.path().join(name).with_extension("parquet"));
        let text = std::fs::read_to_string(dir.path().join(name).with_extension("csv")).unwrap();
        let mut lines = text.lines();
        assert_eq!(lines.next().unwrap(), names.join(","));
        let read: Vec<Vec<f64>> = lines
            .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
            .collect();
        assert_eq!(read, rows);
    }
    assert!(dir.path().join("collisions.csv").exists());
    let again = call_on("run", &case, &[SHORT], &["--out", out]);
    assert_eq!(again.code, Some(0), "{again:?}");
    assert!(!dir.path().join("balls.csv").exists());
}

/// A case that a user may have edited is not replaced.
#[test]
fn a_new_case_replaces_no_file() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    let name = path.to_str().unwrap();
    let new = || call(&["new", "--bearing", "6205", "--out", name]);
    assert_eq!(new().code, Some(0));
    std::fs::write(&path, "mine").unwrap();
    let refused = new();
    assert_eq!(refused.code, Some(2), "{refused:?}");
    let said = format!("--out {name}: this file exists");
    assert!(refused.stderr.contains(&said), "{refused:?}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
}
