//! Bad input ends in exit code 2 and one line that names file, line and key.

use std::path::Path;

use crate::common::*;

/// What replaces what in the case file of `cageless new`, and the key that the message must name: a
/// missing key, a wrong type, a slip of the pen, a limit and what is no TOML. All others are tested
/// where case files are read. The line is that of the replacement, or of the section if a key is
/// missing.
#[rustfmt::skip]
const FILES: &[(&str, &str, &str)] = &[
    ("balls = 14 ", "# none ", "bearing.balls"),
    ("radial_load_n = 1500.0 ", "radial_load_n = \"1500 N\" ", "operation.radial_load_n"),
    ("axial_span_mm = 5.1 ", "axial_spam_mm = 5.1 ", "raceway.axial_spam_mm"),
    ("# [start] ", "[start]\ngaps = [1.8, 1.8] ", "start.gaps"),
    ("interval_us = 100.0 ", "interval_us = 100,0 ", "interval_us"),
];

fn edited(from: &str, to: &str) -> String {
    let new = call(&["new"]).stdout;
    // A value that a comment repeats counts once.
    let lines = new
        .lines()
        .filter(|line| line.starts_with('#') == from.starts_with('#'));
    assert_eq!(
        lines.filter(|line| line.contains(from)).count(),
        1,
        "`{from}` stands once in the file"
    );
    new.replace(from, to)
}

/// Exit code 2, nothing on stdout, one line on stderr.
fn assert_refused(answer: &Answer, what: &str) {
    assert_eq!(answer.code, Some(2), "{what}: {answer:?}");
    assert_eq!(answer.stdout, "", "{what}");
    assert!(
        answer.stderr.starts_with("error: "),
        "{what}: {}",
        answer.stderr
    );
    assert_eq!(
        answer.stderr.lines().count(),
        1,
        "{what}: {}",
        answer.stderr
    );
}

#[test]
fn bad_case_files() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    for &(from, to, key) in FILES {
        let text = edited(from, to);
        std::fs::write(&path, &text).unwrap();
        let answer = call_on("check", &path, &[], &[]);
        assert_refused(&answer, to);
        assert!(answer.stderr.contains(key), "{to}: {}", answer.stderr);

        let place = format!("error: {}:", path.display());
        let line: Option<usize> = answer
            .stderr
            .strip_prefix(&place)
            .and_then(|rest| rest.split(':').next()?.parse().ok());
        let line = line.unwrap_or_else(|| panic!("{to}: no line: {}", answer.stderr));
        let last = key.rsplit('.').next().unwrap();
        let shown = text.lines().nth(line - 1).unwrap();
        let section = key.split('.').next().unwrap();
        assert!(
            shown.contains(last) || shown.starts_with(&format!("[{section}]")),
            "{to}: line {line} is `{shown}`: {}",
            answer.stderr
        );
    }
}

/// Every command refuses it alike, and before it makes the folder of `--out`.
#[test]
fn all_commands_check_first() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("case.toml");
    std::fs::write(
        &path,
        edited("axial_span_mm = 5.1 ", "axial_span_mm = 7.5 "),
    )
    .unwrap();
    let out = dir.path().join("out");
    for command in ["check", "static", "design", "run"] {
        for more in [&["--json", "--out", out.to_str().unwrap()][..], &[]] {
            let answer = call_on(command, &path, &[], more);
            assert_refused(&answer, command);
            let message = "raceway.axial_span_mm = 7.5 ";
            assert!(answer.stderr.contains(message), "{}", answer.stderr);
            assert!(answer.stderr.contains("7.4017"), "{}", answer.stderr);
        }
    }
    assert!(!out.exists());
}

#[test]
fn bad_overrides() {
    let case = repository_case("zhao-d.toml");
    for (set, named) in [
        ("solver.step_us", "section.key=value"),
        // Unstable for the stiffest contact.
        ("solver.step_us=20", "it must be at most 3."),
        ("solver.stepp_us=1", "solver.stepp_us"),
        ("größe.ß=1", "größe"),
    ] {
        let answer = call_on("run", &case, &[set], &[]);
        assert_refused(&answer, set);
        assert!(answer.stderr.contains(named), "{set}: {}", answer.stderr);
        let place = format!("error: --set {set}: ");
        assert!(answer.stderr.starts_with(&place), "{}", answer.stderr);
    }
}

#[test]
fn files_that_are_no_case() {
    let dir = tempfile::tempdir().unwrap();
    let file = |name: &str, bytes: &[u8]| {
        let path = dir.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    for (path, named) in [
        (
            dir.path().join("missing.toml"),
            "missing.toml: cannot be opened",
        ),
        (dir.path().to_owned(), "is a directory"),
        (file("empty.toml", b""), "bearing.balls is missing"),
        (
            file("bom.toml", b"\xef\xbb\xbf"),
            "bearing.balls is missing",
        ),
        (file("latin.toml", b"title = \"\xe4\""), "not UTF-8"),
        (file("nul.toml", b"\0\0\0\0"), "nul.toml:1"),
        (file("words.toml", b"a bearing, please\n"), "words.toml:1"),
        (
            file("json.toml", b"{\"balls\": 14}\n"),
            "balls is not a key",
        ),
    ] {
        for command in ["check", "run"] {
            let answer = call_on(command, &path, &[], &[]);
            assert_refused(&answer, named);
            assert!(answer.stderr.contains(named), "{named}: {}", answer.stderr);
            let name = path.to_str().unwrap();
            assert!(answer.stderr.contains(name), "{named}: {}", answer.stderr);
        }
    }
}

/// What Windows editors leave is no mistake.
#[test]
fn byte_order_mark_and_crlf_are_read() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("windows.toml");
    let windows = |text: &str| format!("\u{feff}{}", text.replace('\n', "\r\n"));
    std::fs::write(&path, windows(&call(&["new"]).stdout)).unwrap();
    let answer = call_on("check", &path, &[], &[]);
    assert_eq!(answer.code, Some(0), "{answer:?}");

    std::fs::write(&path, windows(&edited("balls = 14 ", "balls = 1 "))).unwrap();
    let answer = call_on("check", &path, &[], &[]);
    assert_refused(&answer, "crlf");
    let line = edited("balls = 14 ", "balls = 1 ")
        .lines()
        .position(|l| l.starts_with("balls ="));
    let place = format!("windows.toml:{}: bearing.balls = 1 ", line.unwrap() + 1);
    assert!(answer.stderr.contains(&place), "{}", answer.stderr);
}

#[test]
fn folders_that_cannot_be_made() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("file");
    std::fs::write(&file, "keep me").unwrap();
    let case = repository_case("zhao-d.toml");
    let below = |p: &Path| p.join("below").to_str().unwrap().to_owned();
    for out in [below(&file), file.to_str().unwrap().to_owned()] {
        for command in ["check", "static", "run"] {
            let sets = ["solver.duration_s=0.001"];
            let answer = call_on(command, &case, &sets, &["--out", &out]);
            assert_refused(&answer, command);
            assert!(answer.stderr.contains("--out"), "{}", answer.stderr);
            assert!(answer.stderr.contains(&out), "{}", answer.stderr);
            assert!(answer.stderr.contains("is a file, "), "{}", answer.stderr);
            assert!(!answer.stderr.contains("os error"), "{}", answer.stderr);
        }
        let answer = call_on("design", &case, &[], &["--search", "--out", &out]);
        assert_refused(&answer, "design");
        assert!(answer.stderr.contains("is a file, "), "{}", answer.stderr);
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "keep me");
}

/// Found before the work is done, not after it.
#[test]
fn a_folder_where_a_file_is_to_be() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    for (command, name) in [
        ("check", "check.json"),
        ("static", "static.json"),
        ("run", "balls.parquet"),
        ("run", "summary.json"),
        ("run", "report.html"),
    ] {
        let out = dir.path().join(name);
        std::fs::create_dir_all(out.join(name)).unwrap();
        let sets = ["solver.duration_s=0.001"];
        let answer = call_on(command, &case, &sets, &["--out", out.to_str().unwrap()]);
        assert_refused(&answer, name);
        assert!(answer.stderr.contains(name), "{}", answer.stderr);
        let system = answer.stderr.matches("directory").count();
        assert_eq!(system, 1, "said once: {}", answer.stderr);
        assert_eq!(names(&out), [name]);
    }
}

/// What parses the options has words of its own; the answer says what is allowed.
#[test]
fn options_that_are_no_numbers() {
    let case = repository_case("zhao-d.toml");
    let case = case.to_str().unwrap();
    for (args, allowed) in [
        (
            &["sweep", "plan.toml", "--threads", "0"][..],
            "1 to 1024 are allowed",
        ),
        (
            &["sweep", "plan.toml", "--threads=two"],
            "1 to 1024 are allowed",
        ),
        (
            &["tolerance", case, "--ball-grade=2.5"],
            "0 for balls all equal, 3, 5, 10, 16",
        ),
        (
            &["tolerance", case, "--samples=-1"],
            "a whole number, 0 or more",
        ),
        (
            &["tolerance", case, "--samples", "-1"],
            "a whole number, 0 or more",
        ),
        (
            &["tolerance", case, "--friction", "-0.1"],
            "--friction -0.1 is not possible: it must be from 0 to 0.007",
        ),
        (
            &["tolerance", case, "--contact-angle-deg", "0.2"],
            "it must be 0 in the plane",
        ),
        (
            &["drop", case, "--samples", "-1"],
            "a whole number, 0 or more",
        ),
        (
            &["drop", case, "--drops", "-1"],
            "a whole number, 0 or more",
        ),
        (
            &["compare", case, case, "--draws", "-1"],
            "a whole number, 0 or more",
        ),
        (
            &["sweep", "plan.toml", "--threads", "-1"],
            "1 to 1024 are allowed",
        ),
        (&["tolerance", case, "--friction=some"], "must be a number"),
        (
            &["export", case, "--format=step", "--blend-mm=x"],
            "must be a number",
        ),
    ] {
        let answer = call(args);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        assert!(answer.stderr.contains(allowed), "{}", answer.stderr);
    }
}

/// Files that are no tables are said to be none in the words of users.
#[test]
fn tables_that_are_none() {
    let dir = tempfile::tempdir().unwrap();
    let (text, folder) = (dir.path().join("plan.toml"), dir.path().join("x.parquet"));
    std::fs::write(&text, "seed = 1\n".repeat(100)).unwrap();
    std::fs::create_dir_all(folder.join("sweep.parquet")).unwrap();
    let (text, folder) = (text.to_str().unwrap(), folder.to_str().unwrap());
    for (args, said) in [
        (
            &["report", text][..],
            "plan.toml: cannot be read: it is not a Parquet file",
        ),
        (
            &["sweep", "merge", text],
            "plan.toml: cannot be read: it is not a Parquet file",
        ),
        (
            &["report", folder],
            "sweep.parquet: cannot be read: is a directory",
        ),
        (
            &["sweep", "merge", folder],
            "x.parquet: cannot be read: is a directory",
        ),
        (
            &["report", "none.parquet"],
            "none.parquet: cannot be read: no such file",
        ),
    ] {
        let answer = call(args);
        assert_refused(&answer, said);
        assert!(answer.stderr.contains(said), "{}", answer.stderr);
        for word in ["External", "Parquet error", "os error"] {
            assert!(!answer.stderr.contains(word), "{}", answer.stderr);
        }
    }
}
