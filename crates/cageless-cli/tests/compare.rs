//! `cageless compare`.

use crate::common::*;

// More rows than an animation has, so that it does not begin with the run.
const SETS: [&str; 2] = ["solver.duration_s=0.02", "output.interval_us=5"];
/// A few orbits.
const SHORT: [&str; 2] = ["steady.transient_orbits=1", "steady.measured_orbits=3"];

/// Numbers and page are of one comparison: without room for the page the folder stays as it was.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_files_of_one_comparison() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let compare = |mut command: std::process::Command, speed: &str| -> Answer {
        command.arg("compare").arg(&case).arg("--with-conventional");
        command.args(["--draws", "2", "--set", "solver.duration_s=0.01"]);
        for set in SHORT {
            command.args(["--set", set]);
        }
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
        text.replacen("\"passes\":null", "\"passes\":true", 1),
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

/// With the same balls the raceway of the paper helps against a plain ring, in which the balls run into one queue.
#[test]
fn the_raceway_of_the_paper_helps_in_steady_operation() {
    let dir = tempfile::tempdir().unwrap();
    let sets = [
        "solver.method=verlet",
        "solver.step_us=2",
        "solver.duration_s=0.02",
        "steady.transient_orbits=100",
        "steady.measured_orbits=120",
    ];
    let out = dir.path().join("out");
    let more = [
        "--with-conventional",
        "--draws",
        "8",
        "--out",
        out.to_str().unwrap(),
    ];
    let done = call_on("compare", &repository_case("zhao-d.toml"), &sets, &more);
    assert_eq!(done.code, Some(0), "{done:?}");
    let found = json_file(&out.join("compare.json"));
    assert_eq!(found["runs"], serde_json::json!(["conventional", "A"]));
    assert_eq!(
        (&found["draws"]["count"], &found["draws"]["grade"]),
        (&8.into(), &10.into())
    );
    let benefit = &found["benefits"][1];
    assert_eq!(benefit["benefit"], "helps", "{benefit}");
    assert!(found["benefits"][0].is_null());
    for (name, least, most) in [
        ("gap_deviation_deg", 0.08, 0.2),
        ("outer_ring_force_deviation_n", 0.1, 0.2),
        ("contact_rate_hz", 0.15, 0.7),
    ] {
        let compared = result(&found, name);
        assert_eq!(
            compared["better"],
            serde_json::json!([null, true]),
            "{compared}"
        );
        let [plain, ring] = [0, 1].map(|k| compared["values"][k]["mean"].as_f64().unwrap());
        assert!(
            (least..most).contains(&(ring / plain)),
            "{name}: {ring} {plain}"
        );
    }
    // What harms stands beside what helps.
    let pressure = result(&found, "ball_pressure_max_mpa");
    assert_eq!(pressure["better"], serde_json::json!([null, false]));
    let said = "A: helps against conventional: contacts ";
    let statement = found["statement"].as_str().unwrap();
    assert!(statement.starts_with(said), "{statement}");
    assert!(
        statement.contains("; at the cost of pressure between balls ")
            && statement.contains(", losses "),
        "{statement}"
    );
    assert!(done.stdout.contains(said), "{done:?}");
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    for part in [
        "What a remedy changes",
        "draw 1 of 8",
        "8 draws of balls of grade G10",
        said,
    ] {
        assert!(page.contains(part), "{part}");
    }
}

/// A queue that is still spreading is not stationary, and one draw fewer than two is none.
#[test]
fn what_is_not_stationary_is_not_judged() {
    let sets = [
        "solver.step_us=2",
        "solver.duration_s=0.01",
        "steady.transient_orbits=0",
        "steady.measured_orbits=8",
    ];
    let case = repository_case("zhao-d.toml");
    let done = call_on(
        "compare",
        &case,
        &sets,
        &["--with-conventional", "--draws", "2", "--json"],
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let benefit = &done.json()["benefits"][1];
    assert_eq!(benefit["benefit"], "not-judged", "{benefit}");
    assert!(benefit["score"].is_null());
    let reasons = benefit["benefit_reasons"].to_string();
    assert!(
        reasons.contains("from the first to the second half"),
        "{reasons}"
    );
    assert!(reasons.contains("steady.measured_orbits"), "{reasons}");
    let done = call_on(
        "compare",
        &case,
        &SHORT,
        &["--with-conventional", "--draws", "1"],
    );
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(
        done.stderr.contains("--draws 1 is not possible"),
        "{done:?}"
    );
}

/// A judgement in oil asks for the dry one, which a supply of 0 is.
#[test]
fn a_comparison_in_oil_asks_for_the_dry_one() {
    let case = repository_case("zhao-d.toml");
    let text = |supply: &str| {
        let supply = format!("film.supply={supply}");
        let oil = [
            "film.viscosity_mpa_s=5",
            "film.viscosity_temperature_1_k=0.035",
        ];
        let sets = [&SHORT[..], &oil, &[&supply, "solver.duration_s=0.005"]].concat();
        let done = call_on(
            "compare",
            &case,
            &sets,
            &["--with-conventional", "--draws", "2"],
        );
        assert_eq!(done.code, Some(0), "{done:?}");
        done.stdout
    };
    assert!(text("0.65").contains("in oil (film.supply = 0.65)"));
    assert!(!text("0").contains("in oil"));
}

/// Two cases that differ in the film alone are told apart.
#[test]
fn cases_with_other_films_say_which() {
    let dir = tempfile::tempdir().unwrap();
    let dry = repository_case("zhao-d.toml");
    let wet = dir.path().join("wet.toml");
    let oil = "\n[film]\nviscosity_mpa_s = 5\nviscosity_temperature_1_k = 0.035\nsupply = \"two-drops\"\n";
    std::fs::write(&wet, std::fs::read_to_string(&dry).unwrap() + oil).unwrap();
    let out = ["--draws", "2", "--out", dir.path().to_str().unwrap()];
    let sets = [&SHORT[..], &["solver.duration_s=0.005"]].concat();
    let done = call_on(
        "compare",
        &dry,
        &sets,
        &[&[wet.to_str().unwrap()], &out[..]].concat(),
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    for film in ["; no film", "; film: 5 mPa·s, supply 0.65"] {
        assert!(done.stdout.contains(film), "{film}: {}", done.stdout);
        assert!(page.contains(film), "{film}");
    }
}

/// Every key in which cases differ stands in terminal, page and file; of many the last ones by name.
#[test]
fn cases_say_in_which_keys_they_differ() {
    let dir = tempfile::tempdir().unwrap();
    let one = repository_case("zhao-d.toml");
    let other = dir.path().join("other.toml");
    let oil = "\n[film]\noil = \"iso-vg-32\"\ntemperature_c = 70\nsupply = \"two-drops\"\n";
    let text = std::fs::read_to_string(&one).unwrap().replace("5.1", "5.2") + oil;
    std::fs::write(&other, text).unwrap();
    let sets = [&SHORT[..], &["solver.duration_s=0.005"]].concat();
    let out = ["--draws", "2", "--out", dir.path().to_str().unwrap()];
    let args = [&[other.to_str().unwrap()], &out[..]].concat();
    let done = call_on("compare", &one, &sets, &args);
    assert_eq!(done.code, Some(0), "{done:?}");
    let lines: Vec<Vec<&str>> = (done.stdout.lines())
        .map(|line| line.split_whitespace().collect())
        .collect();
    for line in [
        "Keys that differ: A | B",
        "film.oil – | iso-vg-32",
        "film.supply – | two-drops",
        "film.temperature_c – | 70",
        "raceway.axial_span_mm 5.1 | 5.2",
    ] {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert!(lines.contains(&words), "{line}: {}", done.stdout);
    }
    let page = std::fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(page.contains("two-drops") && page.contains("Keys that differ"));
    let json = std::fs::read_to_string(dir.path().join("compare.json")).unwrap();
    assert!(json.contains("\"differing_keys\""), "{json}");
}

/// Steady operation under a falling rotor is refused before anything is computed, with the command for a drop.
#[test]
fn a_case_with_a_rotor_is_compared_by_its_drop() {
    let case = repository_case("touchdown-d.toml");
    for options in [
        &["--remedies"][..],
        &["--with-conventional", "--starts", "2"],
    ] {
        let done = call_on("compare", &case, &[], options);
        assert_eq!((done.code, done.stdout.as_str()), (Some(2), ""));
        let said = "[rotor] must be left out: rings are compared in steady operation. `cageless drop --compare \
                    conventional --samples N` judges a raceway in a drop";
        assert!(done.stderr.contains(said), "{}", done.stderr);
        assert!(!done.stderr.contains("takes about"), "{}", done.stderr);
    }
}

/// A case beside its remedies: all with the same balls, fewer of them where fewer fit.
#[test]
fn a_case_is_compared_with_its_remedies() {
    let sets = [
        "solver.duration_s=0.005",
        SHORT[0],
        SHORT[1],
        "steady.grade=100",
    ];
    let case = repository_case("zhao-d.toml");
    let done = call_on(
        "compare",
        &case,
        &sets,
        &["--remedies", "--draws", "2", "--json"],
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let found = done.json();
    let runs = [
        "plain, 14 balls",
        "raceway, 14 balls",
        "raceway, 13 balls",
        "plain, 13 balls",
        "plain, 12 balls",
    ];
    assert_eq!(found["runs"], serde_json::json!(runs));
    let rating = result(&found, "basic_static_rating_n");
    let of = |k: usize| rating["values"][k]["mean"].as_f64().unwrap();
    for (k, balls) in [(1, 14.0), (2, 13.0), (3, 13.0), (4, 12.0)] {
        assert!((of(k) / of(0) - balls / 14.0).abs() < 1e-12, "{rating}");
    }
    let done = call_on("compare", &case, &["steady.grade=7"], &["--remedies"]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(
        done.stderr.contains("a grade of ISO 3290-1: 3, 5, 10"),
        "{done:?}"
    );
    let done = call(&["compare", case.to_str().unwrap()]);
    assert_eq!(done.code, Some(2), "{done:?}");
    assert!(
        done.stderr.contains("--with-conventional or --remedies"),
        "{done:?}"
    );
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
