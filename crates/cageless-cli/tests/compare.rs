//! `cageless compare`.

use crate::common::*;

const SETS: [&str; 2] = ["solver.duration_s=0.02", "output.interval_us=200"];

/// Two finished runs, and the case of one of them against the folder of the other.
#[test]
fn runs_stand_side_by_side() {
    let dir = tempfile::tempdir().unwrap();
    let folder = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    for (name, case) in [("a", "zhao-d.toml"), ("b", "conventional.toml")] {
        let done = call_on(
            "run",
            &repository_case(case),
            &SETS,
            &["--out", &folder(name)],
        );
        assert_eq!(done.code, Some(0), "{done:?}");
    }
    let (a, b, out) = (folder("a"), folder("b"), folder("out"));
    let done = call(&["compare", &a, &b, "--out", &out]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let found = json_file(&dir.path().join("out/compare.json"));
    let summaries = ["a", "b"].map(|name| json_file(&dir.path().join(name).join("summary.json")));
    let results = found["results"].as_array().unwrap();
    let loss = results
        .iter()
        .find(|r| r["name"] == "power_loss_w")
        .expect("the power loss");
    let of = |k: usize| summaries[k]["power_loss_w"].as_f64().unwrap();
    assert_eq!(loss["values"], serde_json::json!([of(0), of(1)]));
    assert_eq!(loss["differences"], serde_json::json!([0.0, of(1) - of(0)]));
    assert_eq!(loss["better"], serde_json::json!([null, of(1) < of(0)]));
    let page = std::fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    for part in [
        "Differences",
        "scatter-of-the-gaps",
        "largest-loads",
        "data-bearing=\"1\"",
    ] {
        assert!(page.contains(part), "{part}");
    }

    // A run repeated from its case has the numbers of its folder.
    let again = dir.path().join("a/summary.json");
    let same = call(&[
        "compare",
        again.to_str().unwrap(),
        &a,
        "--with-conventional",
        "--json",
    ]);
    assert_eq!(same.code, Some(0), "{same:?}");
    let same = same.json();
    assert_eq!(same["runs"].as_array().unwrap().len(), 3);
    for result in same["results"].as_array().unwrap() {
        assert_eq!(result["values"][0], result["values"][1], "{result}");
        assert!(result["better"][1].is_null(), "{result}");
    }
}

#[test]
fn what_is_neither_case_nor_run_is_refused_before_anything_is_computed() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let case = case.to_str().unwrap();
    let empty = dir.path().to_str().unwrap();
    let done = call(&["compare", case, empty]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.stderr.contains("report.json"), "{done:?}");
    std::fs::write(dir.path().join("report.json"), "{}").unwrap();
    let done = call(&["compare", case, empty]);
    assert_eq!(done.code, Some(2), "{done:?}");
    let done = call(&["compare", case, &format!("{empty}/missing.toml")]);
    assert_eq!(done.code, Some(2), "{done:?}");
}
