//! `cageless compare`.

use crate::common::*;

// More rows than an animation has, so that it does not begin with the run.
const SETS: [&str; 2] = ["solver.duration_s=0.02", "output.interval_us=5"];

/// Numbers and page are of one comparison: without room for the page the folder stays as it was.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_files_of_one_comparison() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let compare = |mut command: std::process::Command, speed: &str| -> Answer {
        command.arg("compare").arg(&case).arg("--with-conventional");
        command.args(["--starts", "2", "--set", "solver.duration_s=0.01"]);
        command.args(["--set", &format!("operation.inner_speed_rpm={speed}")]);
        command.arg("--out").arg(dir.path());
        command.output().unwrap().into()
    };
    assert_eq!(compare(cageless(), "12000").code, Some(0));
    let read =
        || ["compare.json", "report.html"].map(|f| std::fs::read(dir.path().join(f)).unwrap());
    let before = read();
    // Room for the numbers, none for the page.
    let kilobytes = 1 + before[0].len() as u32 / 512;
    assert!(before[1].len() as u32 > 1024 * kilobytes);
    let answer = compare(on_full_disk(kilobytes), "9000");
    assert_eq!(answer.code, Some(1), "{answer:?}");
    assert_eq!(answer.stderr.lines().count(), 1, "{answer:?}");
    let message = &answer.stderr;
    assert!(
        message.contains("report.html: cannot be written to: file too large"),
        "{message}"
    );
    assert!(read() == before);
    assert_eq!(names(dir.path()), ["compare.json", "report.html"]);
}

/// Two finished runs: their numbers as they are, and nothing judged.
#[test]
fn finished_runs_are_shown_and_not_judged() {
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
    assert!(
        done.stdout.contains("keep their gaps with any ring"),
        "{done:?}"
    );
    let found = json_file(&dir.path().join("out/compare.json"));
    let summaries = ["a", "b"].map(|name| json_file(&dir.path().join(name).join("summary.json")));
    let loss = result(&found, "power_loss_w");
    let of = |k: usize| summaries[k]["power_loss_w"].as_f64().unwrap();
    assert_eq!(loss["values"][0]["mean"], of(0));
    assert_eq!(loss["values"][1]["mean"], of(1));
    assert_eq!(loss["values"][1]["starts"], 1);
    assert_eq!(loss["differences"][1]["mean"], of(1) - of(0));
    assert_eq!(loss["better"], serde_json::json!([null, null]));
    for (verdict, summary) in found["verdicts"].as_array().unwrap().iter().zip(&summaries) {
        for key in ["verdict", "passes", "headline", "criterion", "margin"] {
            assert_eq!(verdict[key], summary[key], "{key}");
        }
        assert!(verdict["standard_error"].is_null());
    }
    let page = std::fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    for part in [
        "Differences",
        "scatter-of-the-gaps",
        "largest-loads",
        "data-bearing=\"1\"",
        // The clock of the animation is that of the runs.
        "A from t = 0.0075",
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
    assert_eq!(same["runs"], serde_json::json!(["conventional", "A", "B"]));
    for result in same["results"].as_array().unwrap() {
        assert_eq!(result["values"][1], result["values"][2], "{result}");
    }
    let done = call(&["compare", &a, &b, "--set", "solver.duration_s=0.01"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.stderr.contains("is a finished run"), "{done:?}");

    // Numbers that were changed are not taken for others.
    let file = dir.path().join("a/report.json");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(
        &file,
        text.replacen("\"passes\":true", "\"passes\":null", 1),
    )
    .unwrap();
    let done = call(&["compare", &a, &b]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.stderr.contains("is damaged"), "{done:?}");
}

fn result<'r>(found: &'r serde_json::Value, name: &str) -> &'r serde_json::Value {
    let results = found["results"].as_array().unwrap();
    let mut found = results.iter().filter(|r| r["name"] == name);
    found.next().unwrap_or_else(|| panic!("{name}"))
}

/// From the same uneven starts the raceway of the paper evens out the gaps: the number of the
/// comparison is that of a run of one start by hand.
#[test]
fn a_ring_is_compared_with_its_conventional_one_from_uneven_starts() {
    let dir = tempfile::tempdir().unwrap();
    let sets = ["solver.duration_s=0.25", "output.interval_us=500"];
    let out = dir.path().join("out");
    let done = call_on(
        "compare",
        &repository_case("zhao-d.toml"),
        &sets,
        &[
            "--with-conventional",
            "--starts",
            "4",
            "--out",
            out.to_str().unwrap(),
        ],
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let found = json_file(&out.join("compare.json"));
    assert_eq!(found["runs"], serde_json::json!(["conventional", "A"]));
    assert_eq!(found["starts"]["count"], 4);
    let scatter = result(&found, "gap_deviation_deg");
    assert_eq!(
        scatter["better"],
        serde_json::json!([null, true]),
        "{scatter}"
    );
    assert_eq!(scatter["values"][1]["starts"], 4);
    let statement = found["statement"].as_str().unwrap();
    let said = "The discrete raceway of A lowers the standard deviation of the gaps from ";
    assert!(statement.starts_with(said), "{statement}");
    assert!(done.stdout.contains(said), "{done:?}");
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for part in [
        "What a raceway changes",
        "start 1 of 4",
        "the same 4 starts",
    ] {
        assert!(page.contains(part), "{part}");
    }
}

/// The verdict is that on the means over the starts, wherever it is given: here start 1 passes and the mean fails.
#[test]
fn a_ring_is_judged_by_the_means_over_its_starts() {
    let dir = tempfile::tempdir().unwrap();
    let sets = [
        "solver.method=verlet",
        "solver.step_us=auto",
        "solver.duration_s=0.05",
    ];
    let out = dir.path().to_str().unwrap();
    let more = ["--with-conventional", "--starts", "3", "--out", out];
    let done = call_on("compare", &repository_case("zhao-d.toml"), &sets, &more);
    assert_eq!(done.code, Some(0), "{done:?}");
    let found = json_file(&dir.path().join("compare.json"));
    let [conventional, ring] = [0, 1].map(|k| &found["verdicts"][k]);
    assert_eq!(conventional["passes"], serde_json::Value::Null);
    let twice = &result(&found, "double_collision_fraction")["values"][1];
    let [mean, error] = ["mean", "standard_error"].map(|name| twice[name].as_f64().unwrap());
    assert!(mean > 0.25, "{twice}");
    assert_eq!(ring["verdict"], "double-collision");
    assert_eq!(
        (&ring["passes"], &ring["criterion"]),
        (&false.into(), &"both-neighbours".into())
    );
    assert!((ring["margin"].as_f64().unwrap() - (0.25 - mean)).abs() < 1e-12);
    assert!((ring["standard_error"].as_f64().unwrap() - error).abs() < 1e-12);
    let headline = ring["headline"].as_str().unwrap();
    let start = format!(
        "FAIL in the mean of 3 starts: double collision; {:.1} %",
        100.0 * mean
    );
    assert!(headline.starts_with(&start), "{headline}");
    assert!(done.stdout.contains(headline), "{done:?}");
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(page.contains(&format!("A: {start}")) && !page.contains("PASS in this run"));
    assert!(page.contains("A, start 1 of 3"));
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

/// A conventional ring is not compared with itself.
#[test]
fn a_conventional_ring_has_no_conventional_one_beside_it() {
    let case = repository_case("conventional.toml");
    let done = call(&["compare", case.to_str().unwrap(), "--with-conventional"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(done.stderr.contains("is conventional itself"), "{done:?}");
}
