//! `design --benefit`: whether a raceway helps, first on the terminal and on the page.

use crate::common::*;

/// Steady operation that is too short to be judged.
const TOO_SHORT: [&str; 2] = ["steady.transient_orbits=1", "steady.measured_orbits=3"];

/// The case's own raceway beside the plain ring and one ball fewer. A raceway that works is not one that helps.
#[test]
fn a_design_says_first_whether_its_raceway_helps() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let case = repository_case("zhao-d.toml");
    let done = call_on(
        "design",
        &case,
        &TOO_SHORT,
        &["--benefit", "--out", out.to_str().unwrap()],
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let first = done.stdout.lines().next().unwrap();
    assert!(
        first.starts_with("raceway: not judged against plain, 14 balls: "),
        "{first}"
    );
    assert!(done.stdout.contains("works from evenly spaced balls"));
    assert!(!done.stdout.contains("--remedies"));
    let found = json_file(&out.join("design.json"));
    let benefit = &found["benefit"];
    assert_eq!(benefit["benefit"], "not-judged");
    assert_eq!(
        benefit["comparison"]["runs"],
        serde_json::json!(["plain, 14 balls", "plain, 13 balls", "raceway"])
    );
    assert_eq!(benefit["candidates"], serde_json::json!([]));
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    let (header, body) = page.split_once("</header>").unwrap();
    assert!(header.contains("raceway: not judged against plain, 14 balls"));
    assert!(body.contains("Does it help?"));
}

/// Without the question the answer is left open, on a line of its own.
#[test]
fn a_raceway_that_works_leaves_its_benefit_open() {
    let case = repository_case("zhao-d.toml");
    let done = call_on("design", &case, &[], &[]);
    let line = done.stdout.lines().find(|line| line.starts_with("benefit"));
    assert!(line.unwrap().contains("cageless compare CASE --remedies"));
    let plain = call_on("design", &repository_case("conventional.toml"), &[], &[]);
    assert!(!plain.stdout.contains("--remedies"), "{plain:?}");
}

/// A search by benefit recommends nothing that is not shown to help, says so with exit code 3, and keeps the table.
#[test]
fn a_search_recommends_nothing_whose_benefit_is_not_judged() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let sets = [&SMALL[..], &TOO_SHORT].concat();
    let case = repository_case("zhao-d.toml");
    let options = ["--search", "--benefit", "--out", out.to_str().unwrap()];
    let done = call_on("design", &case, &sets, &options);
    assert_eq!(done.code, Some(3), "{done:?}");
    assert!(
        done.stderr.contains("no raceway is recommended. lC 5.1"),
        "{done:?}"
    );
    assert!(done.stdout.contains("contacts between balls per second"));
    assert!(!out.join("recommended.toml").exists());
    let found = json_file(&out.join("design.json"));
    let benefit = &found["benefit"];
    let runs = benefit["comparison"]["runs"].as_array().unwrap().len();
    let candidates = benefit["candidates"].as_array().unwrap();
    // Short runs leave the best of many, and one that is not clearly worse.
    assert!(
        (3..=4).contains(&runs) && candidates.len() == 8,
        "{benefit}"
    );
    let scores: Vec<f64> = (candidates.iter())
        .map(|c| c["score"].as_f64().unwrap())
        .collect();
    assert!(scores.is_sorted(), "{scores:?}");
    assert!(benefit.get("recommended").is_none());
}

/// The smallest bearing has none with one ball fewer.
#[test]
fn three_balls_are_too_few_to_leave_one_out() {
    let case = repository_case("conventional.toml");
    let done = call_on("design", &case, &["bearing.balls=3"], &["--benefit"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.stderr.contains("fewer too few are left"), "{done:?}");
}

/// The raceways at both ends of the machining tolerances stand beside the one as drawn.
#[test]
fn a_tolerance_says_first_whether_its_raceways_help() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let case = repository_case("zhao-d.toml");
    let options = [
        "--benefit",
        "--samples=0",
        "--friction=0",
        "--clearance-um=0",
        "--speed-percent=0",
        "--load-percent=0",
        "--ball-grade=0",
        "--out",
        out.to_str().unwrap(),
    ];
    let done = call_on("tolerance", &case, &TOO_SHORT, &options);
    assert_eq!(done.code, Some(0), "{done:?}");
    let first = done.stdout.lines().next().unwrap();
    let words =
        "Raceway as drawn not judged, weakest not judged, strongest not judged; strongest: ";
    assert!(first.starts_with(words), "{first}");
    let found = json_file(&out.join("tolerance.json"));
    assert_eq!(found["benefit"]["benefit"], "not-judged");
    let comparison = &found["benefit"]["comparison"];
    let runs = serde_json::json!([
        "plain",
        "as drawn",
        "weakest",
        "strongest",
        "plain, 13 balls"
    ]);
    assert_eq!(comparison["runs"], runs);
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    let (header, body) = page.split_once("</header>").unwrap();
    assert!(header.contains("weakest not judged") && body.contains("Does it help?"));
}
