//! Texts of others are shown on a terminal and do not command it.

use crate::common::*;

fn assert_harmless(text: &str) {
    let commands = |c: char| c.is_control() && !matches!(c, '\n' | '\t');
    assert!(!text.contains(commands), "{text:?}");
}

#[test]
fn titles_and_excerpts_do_not_command_the_terminal() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let (before, title) = text.split_once("\ntitle").unwrap();
    let after = title.split_once('\n').unwrap().1;
    let with = |line: &str| std::fs::write(&path, format!("{before}\n{line}\n{after}")).unwrap();

    with("title = \"\\u001b]0;owned\\u0007\\u009b2J\"");
    let sets = ["solver.duration_s=0.0005"];
    let run = call_on("run", &path, &sets, &[]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_harmless(&run.stdout);
    assert!(
        run.stdout.contains("\\u001b]0;owned\\u0007\\u009b2J"),
        "{run:?}"
    );
    // In JSON it means the title itself.
    let check = call_on("check", &path, &[], &["--json"]);
    assert_harmless(&check.stdout);
    assert_eq!(check.json()["case"]["title"], "\u{1b}]0;owned\u{7}\u{9b}2J");

    with("title = 7 \u{1b}[2J");
    let refused = call_on("check", &path, &[], &[]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    assert_harmless(&refused.stderr);
    let refused = call_on("check", &path, &["title=\u{1b}[2J"], &[]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
    assert_harmless(&refused.stderr);
}

/// Where nothing reads stderr, messages are lost and exit codes stay.
#[test]
fn a_closed_stderr_changes_no_exit_code() {
    for (args, code) in [
        (&["static", "nofile.toml"][..], 2),
        (&["new", "--bearing", "6205", "--out", "OUT"], 0),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = cageless();
        command.current_dir(dir.path()).args(args);
        command.stdout(std::process::Stdio::null()).stderr(writer);
        assert_eq!(command.status().unwrap().code(), Some(code), "{args:?}");
    }
}
