//! `cageless tolerance`: its table, its probability, and what it refuses.

use crate::common::*;

const QUICK: [&str; 2] = ["solver.method=verlet", "solver.step_us=auto"];
/// Machining and balls alone.
const FEW: [&str; 12] = [
    "--axial-span-um",
    "0",
    "--half-angle-deg",
    "0",
    "--friction",
    "0",
    "--clearance-um",
    "0",
    "--speed-percent",
    "0",
    "--load-percent",
    "0",
];

#[test]
fn table_and_probability() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("tolerance");
    let case = repository_case("zhao-d.toml");
    let more = ["--samples", "3", "--json", "--out", out.to_str().unwrap()];
    let answer = call_on("tolerance", &case, &QUICK, &[&FEW[..], &more].concat());
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let json = answer.json();
    assert_eq!(json["nominal_verdict"], "smooth");
    let rows = json["influences"].as_array().unwrap();
    let influences: Vec<&str> = rows.iter().map(|r| r["name"].as_str().unwrap()).collect();
    assert_eq!(influences, ["groove depth", "ball radii"]);
    assert_eq!(
        (&rows[0]["high"], &rows[0]["trials"]),
        (&2.0.into(), &2.into())
    );
    // A deeper groove sets the balls further out, where the gap closes earlier or later.
    let gaps = rows[0]["critical_gap_deg"].as_array().unwrap();
    let nominal = json["nominal_critical_gap_deg"].as_f64().unwrap();
    let [low, high] = [0, 1].map(|k| gaps[k].as_f64().unwrap());
    assert!(low < nominal && nominal < high, "{low} {nominal} {high}");
    // G10: a lot varies by 0.5 µm in diameter.
    assert_eq!(rows[1]["high"], 0.125);
    let samples = &json["samples"];
    assert_eq!(samples["count"], 3);
    let passed = samples["passed"].as_u64().unwrap();
    assert_eq!(
        samples["pass_probability"].as_f64(),
        Some(passed as f64 / 3.0)
    );
    assert_eq!(json["nominal_passes"], true);
    // Three that pass are no proof of 95 %.
    assert_eq!((passed, &json["passes"]), (3, &serde_json::Value::Null));
    let headline = json["headline"].as_str().unwrap();
    assert!(headline.starts_with("not judged: 3 of 3"), "{headline}");
    assert!(
        headline.contains("at least 73 bearings are needed"),
        "{headline}"
    );
    assert_eq!(
        crate::common::names(&out),
        ["report.html", "tolerance.json"]
    );
    // The same bearings, whatever the number of threads.
    let again = cageless()
        .env("RAYON_NUM_THREADS", "1")
        .arg("tolerance")
        .arg(&case)
        .args([
            "--set",
            QUICK[0],
            "--set",
            QUICK[1],
            "--samples",
            "3",
            "--json",
        ])
        .args(FEW)
        .output()
        .unwrap();
    assert_eq!(Answer::from(again).stdout, answer.stdout);
}

/// A design that fails as drawn does not pass because it surely fails.
#[test]
fn the_probability_is_that_of_passing() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("tolerance");
    let case = repository_case("full-6205.toml");
    let sets = [
        "raceway.axial_span_mm=2.769",
        "raceway.half_angle_deg=15.779",
        "model.flanks=rigid",
    ];
    let more = ["--samples", "4", "--out", out.to_str().unwrap()];
    let answer = call_on("tolerance", &case, &sets, &[&FEW[..], &more].concat());
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let headline = answer.stdout.lines().next().unwrap();
    assert!(
        headline.starts_with("does not work: 0 of 4 bearings pass"),
        "{headline}"
    );
    assert!(
        headline
            .contains("nominal design does not work from evenly spaced balls: double collision"),
        "{headline}"
    );
    let json = json_file(&out.join("tolerance.json"));
    assert_eq!(
        (
            &json["passes"],
            &json["nominal_passes"],
            &json["nominal_verdict"]
        ),
        (&false.into(), &false.into(), &"double-collision".into())
    );
    let samples = &json["samples"];
    assert_eq!(samples["pass_probability"], 0.0);
    let [low, high] = [0, 1].map(|k| samples["pass_probability_interval"][k].as_f64().unwrap());
    assert!(low == 0.0 && high < 0.5, "{low} to {high}");
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("class=\"judged fail\""));
    assert!(page.contains("probability of passing 0.0 %"));
}

#[test]
fn bad_tolerances_are_refused() {
    let case = repository_case("zhao-d.toml");
    for (more, fragments) in [
        (
            &["--friction", "0.5"][..],
            &["--friction 0.5", "from 0 to 0.007\n"][..],
        ),
        (&["--ball-grade", "7"], &["--ball-grade 7", "3, 5, 10, 16"]),
        (
            &["--groove-depth-um", "nan"],
            &["--groove-depth-um NaN", "from 0 to 19.05 µm\n"],
        ),
        (
            &["--clearance-um", "1e4"],
            &["--clearance-um 10000", "from 0 to 952.5 µm\n"],
        ),
        (
            &["--samples", "1000000"],
            &["--samples 1000000", "at most 100000"],
        ),
    ] {
        let answer = call_on("tolerance", &case, &[], more);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        for fragment in fragments {
            assert!(answer.stderr.contains(fragment), "{fragment}: {answer:?}");
        }
    }
    let answer = call_on("tolerance", &repository_case("conventional.toml"), &[], &[]);
    assert_eq!(answer.code, Some(2));
    assert!(answer.stderr.contains("no [raceway]"), "{answer:?}");
}

/// A raceway that works in oil and is too deep without it says both at the head of every answer.
#[test]
fn a_raceway_for_oil_that_fails_dry_says_so() {
    let case = repository_case("zhao-d.toml");
    let deep = [
        "film.viscosity_mpa_s=5",
        "film.viscosity_temperature_1_k=0.035",
        "film.supply=flooded",
        "raceway.axial_span_mm=5.422",
        "raceway.half_angle_deg=29.63",
    ];
    let sets = [&QUICK[..], &deep].concat();
    let nominal = ["--groove-depth-um", "0"];
    let of_machining = [&nominal[..], &FEW[..4], &["--without-benefit"]].concat();
    let oil = ["--viscosity-percent", "0", "--supply-factor", "1"];
    let of_all = [&nominal[..], &FEW, &oil, &["--ball-grade", "0"]].concat();
    let of_all = [&of_all[..], &["--samples", "0"]].concat();
    let dry = "does not work from evenly spaced balls: too deep";
    for (command, options, facts) in [
        ("design", vec![], "/dry_headline"),
        ("sheet", of_machining, "/tolerance/dry_headline"),
        ("tolerance", of_all, "/dry_headline"),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let out = ["--out", dir.path().to_str().unwrap()];
        let answer = call_on(command, &case, &sets, &[&options[..], &out].concat());
        assert_eq!(answer.code, Some(0), "{command}: {answer:?}");
        let lines: Vec<&str> = answer.stdout.lines().collect();
        let own = lines
            .iter()
            .position(|line| line.contains("works from evenly spaced"));
        let beside = lines[own.expect("a verdict") + 1];
        assert!(beside.starts_with("without oil"), "{command}: {beside}");
        assert!(beside.contains(dry), "{command}: {beside}");
        let read = |name: &str| std::fs::read_to_string(dir.path().join(name)).unwrap();
        let page = read("report.html");
        let head = page.split("</header>").next().unwrap();
        assert!(head.contains(&format!("✘ without oil: {dry}")), "{command}");
        let json: serde_json::Value =
            serde_json::from_str(&read(&format!("{command}.json"))).unwrap();
        let headline = json.pointer(facts).and_then(|text| text.as_str());
        assert!(
            headline.is_some_and(|text| text.starts_with(dry)),
            "{command}"
        );
        let passes = facts.replace("headline", "passes");
        assert_eq!(json.pointer(&passes), Some(&false.into()), "{command}");
    }
}
