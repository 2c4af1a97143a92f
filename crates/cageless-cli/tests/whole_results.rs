//! Results that stay together: one computation in a folder, which repeats from its own files.
#![cfg(unix)]

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::common::*;

/// A folder of results as text.
fn folder(dir: &tempfile::TempDir, name: &str) -> String {
    dir.path().join(name).to_str().unwrap().to_owned()
}

/// Drops the rotor of `file`.
fn drop_of(file: &Path, sets: &[&str], out: &str) -> Answer {
    let done = call_on("drop", file, sets, &["--out", out, "--quiet"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    done
}

/// Times at the ends of the motion that the files of a drop in two bearings tell.
fn ends_of(out: &Path) -> (Option<f64>, BTreeSet<u64>) {
    let summary = std::fs::read_to_string(out.join("summary.json")).ok();
    let summary = summary.map(|text| serde_json::from_str::<Value>(&text).unwrap());
    let told = summary.map(|values| {
        values["bearings"][0]["case"]["solver"]["duration_s"]
            .as_f64()
            .unwrap()
    });
    let tables = ["bearing-1", "bearing-2"].into_iter().flat_map(|bearing| {
        ["ring", "rotor"].map(|name| out.join(bearing).join(name).with_extension("parquet"))
    });
    let last = tables.filter(|path| path.exists()).map(|path| {
        let (_, rows) = table(&path);
        (1e6 * rows.last().unwrap()[0]).round() as u64
    });
    (told, last.collect())
}

/// Killed while its files take the places of older ones, a drop leaves the old result or the new one, or
/// tables of one of them without a summary.
#[test]
fn a_killed_drop_never_leaves_tables_under_the_summary_of_another() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let case = repository_case("rotors/two-bearings.toml");
    for kill in 0..8 {
        drop_of(&case, &["solver.duration_s=0.0005"], out.to_str().unwrap());
        let mut child = cageless()
            .arg("drop")
            .arg(&case)
            .args(["--quiet", "--set", "solver.duration_s=0.0007", "--out"])
            .arg(&out)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("starts");
        // The last file that is written before all take their names.
        let begin = Instant::now();
        while !out.join(".summary.json.partial").exists() && child.try_wait().unwrap().is_none() {
            assert!(begin.elapsed() < Duration::from_secs(60), "no files");
        }
        sleep(Duration::from_micros(400 * kill));
        let _ = child.kill();
        child.wait().unwrap();
        let (told, tables) = ends_of(&out);
        let whole = told.map(|end| BTreeSet::from([(1e6 * end).round() as u64]));
        assert!(tables.len() <= 1, "{kill}: {told:?} {tables:?}");
        assert!(
            whole.is_none_or(|whole| whole == tables),
            "{kill}: {told:?} {tables:?}"
        );
    }
    // The next one has no trace of them.
    drop_of(&case, &["solver.duration_s=0.0005"], out.to_str().unwrap());
    let all = [
        "bearing-1",
        "bearing-2",
        "report.html",
        "rotor.toml",
        "summary.json",
    ];
    assert_eq!(names(&out), all);
}

/// A drop repeats to the bit from what it leaves; with another modulus its stiffnesses are those of the new one.
#[test]
fn a_drop_repeats_from_its_own_files() {
    let dir = tempfile::tempdir().unwrap();
    let sets = [
        "solver.duration_s=0.001",
        "contact.friction_coefficient=0.08",
    ];
    let softer = "material.youngs_modulus_gpa=103";
    let numbers = |out: &str| {
        let mut values = json_file(&Path::new(out).join("summary.json"));
        values.sort_all_objects();
        // What was filled in is given in the repetition.
        let mut text = values.to_string();
        while let Some(at) = text.find("\"defaults\":[") {
            let end = at + text[at..].find(']').unwrap();
            text.replace_range(at..=end, "");
        }
        text
    };
    for (file, own) in [
        ("touchdown-d.toml", "summary.json"),
        ("rotors/two-bearings.toml", "rotor.toml"),
    ] {
        let file = repository_case(file);
        let [one, again, soft, soft_again] =
            ["one", "again", "soft", "soft-again"].map(|name| folder(&dir, name));
        drop_of(&file, &sets, &one);
        let own = Path::new(&one).join(own);
        drop_of(&own, &[], &again);
        assert!(numbers(&one) == numbers(&again), "{}", file.display());
        drop_of(&file, &[sets[0], sets[1], softer], &soft);
        drop_of(&own, &[softer], &soft_again);
        assert!(numbers(&soft) == numbers(&soft_again), "{}", file.display());
        assert!(numbers(&one) != numbers(&soft));
    }
}

/// Tables of another run beside a summary are refused, by name.
#[test]
fn tables_of_another_run_are_not_compared() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let [a, b] = ["a", "b"].map(|name| folder(&dir, name));
    for (out, end) in [
        (&a, "solver.duration_s=0.002"),
        (&b, "solver.duration_s=0.0021"),
    ] {
        let done = call_on("run", &case, &[end], &["--out", out]);
        assert_eq!(done.code, Some(0), "{done:?}");
    }
    let foreign = Path::new(&a).join("balls.parquet");
    std::fs::copy(Path::new(&b).join("balls.parquet"), &foreign).unwrap();
    let done = call(&["compare", &a, &b]);
    assert_eq!(done.code, Some(2), "{done:?}");
    let said = [
        format!("{}: is of another computation than ", foreign.display()),
        Path::new(&a).join("summary.json").display().to_string(),
    ];
    assert!(
        said.iter().all(|part| done.stderr.contains(part)),
        "{done:?}"
    );
}
