//! What `design` recommends passes its own verdict, and says so wherever it is shown.

use std::path::Path;

use crate::common::*;
use serde_json::Value;

fn design(case: &Path, sets: &[&str]) -> Value {
    let answer = call_on("design", case, sets, &["--json"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    answer.json()
}

/// The recommendation of a case, entered as its own, has the verdict that is stated; `None`
/// without one.
fn entered(case: &Path, sets: &[&str]) -> Option<Value> {
    let found = design(case, sets);
    let r = found["recommendation"].clone();
    if r.is_null() {
        return None;
    }
    let span = format!("raceway.axial_span_mm={}", r["axial_span_mm"]);
    let angle = format!("raceway.half_angle_deg={}", r["half_angle_deg"]);
    let again = design(case, &[sets, &[&span, &angle]].concat());
    for key in [
        "verdict",
        "passes",
        "headline",
        "critical_gap_deg",
        "reasons",
    ] {
        assert_eq!(
            again[key],
            r[key],
            "{} {span} {angle}: {key}",
            case.display()
        );
    }
    assert_eq!(r["passes"], r["verdict"] == "smooth");
    Some(r)
}

#[test]
fn full_complement_bearings_get_what_passes() {
    for name in ["full-6205.toml", "full-6203.toml"] {
        let rigid = ["model.flanks=rigid"];
        let r = entered(&repository_case(name), &rigid).expect("a recommendation");
        assert_eq!(r["passes"], true, "{name}: {r}");
        // Near the closed-form starting point, which fails.
        assert_ne!(r["axial_span_mm"], r["starting_axial_span_mm"], "{name}");
        assert!(r["judged"].as_u64() > Some(1));
    }
}

/// A starting point that passes is the recommendation.
#[test]
fn a_starting_point_that_passes_is_recommended() {
    let case = repository_case("zhao-d.toml");
    let r = entered(&case, &[]).expect("a recommendation");
    assert_eq!((&r["passes"], &r["judged"]), (&true.into(), &1.into()));
    assert_eq!(r["axial_span_mm"], r["starting_axial_span_mm"]);
    let answer = call_on("design", &case, &[], &[]);
    let line = |start: &str| {
        let mut lines = answer.stdout.lines();
        let found = lines.find(|l| l.trim_start().starts_with(start));
        found.unwrap_or_else(|| panic!("no {start}: {}", answer.stdout))
    };
    assert!(
        line("verdict").contains("works from evenly spaced balls: smooth; nearest to its limit: ")
    );
    assert!(line("Recommended: lC ").contains("(the middle of the usable range of θ on the curve"));
    assert!(line("- its verdict: ").contains("works from evenly spaced balls: smooth"));
}

/// All cases of the repository and twenty bearings drawn at random: takes minutes.
#[test]
#[ignore = "minutes: cargo test -p cageless-cli --test all verdicts -- --ignored --nocapture"]
fn every_recommendation_passes_or_is_called_a_starting_point() {
    let mut count = [0; 3];
    let mut look = |name: &str, case: &Path, sets: &[&str]| {
        let (kind, shown) = match entered(case, sets) {
            None => (2, "nothing to start from".to_owned()),
            Some(r) => {
                let kind = usize::from(r["passes"] != true);
                (
                    kind,
                    format!(
                        "lC {} mm, θ {}°, {}",
                        r["axial_span_mm"], r["half_angle_deg"], r["headline"]
                    ),
                )
            }
        };
        count[kind] += 1;
        println!("{name}: {shown}");
    };
    let folder = repository_case("");
    for name in names(&folder) {
        look(&name, &folder.join(&name), &[]);
    }
    let mut random = Random(1);
    let mut drawn = 0;
    while drawn < 20 {
        let sets = random.bearing();
        let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
        let case = folder.join("full-6205.toml");
        if call_on("check", &case, &sets, &[]).code != Some(0) {
            continue;
        }
        drawn += 1;
        look(&sets.join(" "), &case, &sets);
    }
    println!(
        "{} recommended, {} starting points, {} without",
        count[0], count[1], count[2]
    );
}

/// splitmix64, uniform from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / 2f64.powi(64)
    }

    /// A full-complement bearing: 8 to 30 balls of 3 to 20 mm with gaps of 0.15° to 2.5°, at
    /// 2000 to 15 000 rpm divided by its size, up to a twentieth of what its balls carry.
    fn bearing(&mut self) -> Vec<String> {
        let balls = (8.0 + 23.0 * self.next()).floor();
        let radius = 1.5 + 8.5 * self.next();
        let gap = 0.15 + 2.35 * self.next();
        let half = ((360.0 / balls - gap) / 2.0f64).to_radians();
        let pitch = radius / half.sin();
        let conformity = radius * (1.03 + 0.03 * self.next());
        let speed = (2000.0 + 13_000.0 * self.next()) * (25.0 / pitch).min(1.0);
        let load = (20.0 + 80.0 * self.next()) * radius * radius;
        let mm = |value: f64| (value * 1e4).round() / 1e4;
        vec![
            format!("bearing.balls={balls}"),
            format!("bearing.ball_radius_mm={}", mm(radius)),
            format!(
                "bearing.inner_groove_bottom_radius_mm={}",
                mm(pitch) - mm(radius)
            ),
            format!(
                "bearing.outer_groove_bottom_radius_mm={}",
                mm(pitch) + mm(radius)
            ),
            format!(
                "bearing.outer_shoulder_radius_mm={}",
                mm(pitch + 0.6 * radius)
            ),
            format!(
                "bearing.inner_groove_curvature_radius_mm={}",
                mm(conformity)
            ),
            format!(
                "bearing.outer_groove_curvature_radius_mm={}",
                mm(conformity)
            ),
            format!("operation.inner_speed_rpm={}", speed.round()),
            format!("operation.radial_load_n={}", load.round()),
            format!("raceway.axial_span_mm={}", mm(0.6 * radius)),
            "raceway.half_angle_deg=12".to_owned(),
        ]
    }
}

/// The page of a run has a verdict on its passages.
#[test]
fn a_run_is_judged_by_its_passages() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("run");
    let case = repository_case("full-6205.toml");
    let sets = [
        "raceway.axial_span_mm=2.769",
        "raceway.half_angle_deg=15.779",
        "model.flanks=rigid",
        "solver.duration_s=0.1",
    ];
    let answer = call_on("run", &case, &sets, &["--out", out.to_str().unwrap()]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let data = json_file(&out.join("report.json"));
    let headline = data["headline"].as_str().unwrap();
    assert_eq!(data["passes"], false, "{headline}");
    assert!(
        headline
            .starts_with("does not work in this run from evenly spaced balls: double collision; "),
        "{headline}"
    );
    assert!(answer.stdout.contains(headline), "{}", answer.stdout);
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(
        page.contains("class=\"judged fail\"")
            && page
                .contains("does not work in this run from evenly spaced balls: double collision; ")
    );
}

/// The raceway that is recommended has the shape of the case, also in the text that the page offers.
#[test]
fn a_recommended_raceway_has_the_shape_of_its_case() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let sets = ["raceway.shape=steady", "raceway.blend_mm=1"];
    let more = ["--json", "--out", out.to_str().unwrap()];
    let answer = call_on("design", &repository_case("zhao-d.toml"), &sets, &more);
    assert_eq!(
        answer.json()["recommendation"]["passes"],
        true,
        "{answer:?}"
    );
    for name in ["report.html", "recommended.toml"] {
        let text = std::fs::read_to_string(out.join(name)).unwrap();
        let has = |line: &str| text.contains(line);
        let shape = has("shape = &quot;steady&quot;") || has("shape = \"steady\"");
        assert!(shape && has("\nblend_mm = 1"), "{name}");
    }
}
