//! A plan that cannot be computed is refused before anything is, with a reason.

use std::path::Path;

use crate::common::*;

/// What follows `case = …`, the line at fault (0: none), and what the message must have.
type Row = (&'static str, usize, &'static [&'static str]);

const STATIC: &str = "compute = [\"static\"]\n";

#[rustfmt::skip]
const PLANS: &[Row] = &[
    // Line 1 is the case, line 2 what is computed.
    ("[grid]\nraceway.axial_span_mm = { from = 4.9, to = 5.4, count = 1000000 }\noperation.radial_load_n = { from = 1, to = 2, count = 1000000 }", 5, &["1000000000000 variants", "at most 1000000000"]),
    ("[grid]\nraceway.axial_spam_mm = [5.0]", 4, &["raceway.axial_spam_mm", "did you mean axial_span_mm?"]),
    ("[grid]\nracewey.axial_span_mm = [5.0]", 4, &["racewey", "did you mean [raceway]?"]),
    ("[grid]\nhalf_angle_deg = [25.0]", 4, &["did you mean raceway.half_angle_deg?"]),
    ("[grid]\nbearing.schema = [1]", 4, &["bearing.schema is not a key of [bearing]"]),
    ("[grid]\nraceway.half_angle_deg = { from = 95.0, to = 120.0, count = 300 }", 4, &["none of the 300 variants is a possible case", "less than 90°"]),
    ("[grid]\nraceway.half_angle_deg = [\"wide\"]", 4, &["none of the 1 variants", "a number in °"]),
    ("[grid]\nraceway.half_angle_deg = { from = 95.0, to = 120.0, count = 300000 }", 4, &["none of 20000 variants spread over the 300000"]),
    ("[grid]\nraceway.half_angle_deg = []", 4, &["a list of numbers or of names, at least one"]),
    ("[grid]\nraceway.half_angle_deg = 25.0", 4, &["= 25.0 is not possible", "a list, or { from"]),
    ("[grid]\nraceway.half_angle_deg = { from = 20.0, to = 30.0 }", 4, &["raceway.half_angle_deg.count is missing"]),
    ("[grid]\nraceway.half_angle_deg = { from = 20.0, count = 3 }", 4, &["raceway.half_angle_deg.to is missing"]),
    ("[grid]\nraceway.half_angle_deg = { from = 20.0, to = 30.0, count = 1 }", 4, &["a whole number, 2 or more"]),
    ("[grid]\nraceway.half_angle_deg = { from = 20.0, to = inf, count = 3 }", 4, &["= inf", "a finite number"]),
    ("[grid]\nraceway.half_angle_deg = { from = 20.0, to = 30.0, steps = 3 }", 4, &["raceway.half_angle_deg.steps is not part of an axis"]),
    ("[grid]\noperation.radial_load_n = { from = 0.0, to = 30.0, count = 3, scale = \"log\" }", 4, &["above 0 at both ends"]),
    ("[grid]\noperation.radial_load_n = { from = 1.0, to = 30.0, count = 3, scale = \"cubic\" }", 4, &["\"linear\" or \"log\""]),
    ("[grid]\nstart.gaps = [[1.0, 2.0]]", 4, &["start.gaps has a value for each ball", "[scatter]"]),
    ("[grid]\noperation.radial_load_n = [1.0]\n[samples]\nmethod = \"sobol\"\ncount = 4\noperation.radial_load_n = { from = 1.0, to = 2.0 }", 8, &["varies on line 4 already"]),
    ("[set]\nraceway.axial_span_mm = 5.2\n[grid]\nraceway.axial_span_mm = [5.0, 5.1]", 4, &["raceway.axial_span_mm varies on line 6", "[set] has no effect"]),
    ("[samples]\nmethod = \"sobol\"\ncount = 4\noperation.radial_load_n = { from = 1.0, to = 2.0 }\n[set]\noperation.radial_load_n = 1.0", 8, &["varies on line 6", "[set] has no effect"]),
    ("[grid]\nbearing.ball_radius_mm = [4.7, 4.72]\nbearing.ball_diameter_mm = [9.525, 9.4]", 5, &["bearing.ball_diameter_mm and bearing.ball_radius_mm on line 4 both say the same"]),
    ("[grid]\nbearing.outer_conformity = [0.52, 0.53]\n[samples]\nmethod = \"sobol\"\ncount = 4\nbearing.outer_groove_curvature_radius_mm = { from = 4.9, to = 5.0 }", 8, &["both say the same"]),
    ("[grid]\nmaterial.preset = [\"M50\"]\nmaterial.youngs_modulus_gpa = [100.0, 210.0]", 5, &["material.youngs_modulus_gpa and material.preset on line 4 both say the same"]),
    ("[grid]\nbearing.ball_diameter_mm = [9.5, 9.525]\n[scatter]\nbearing.ball_radius_mm = { normal = 0.01 }", 6, &["both say the same"]),
    ("[set]\nbearing.ball_diameter_mm = 9.5\n[grid]\nbearing.ball_radius_mm = [4.75, 4.7625]", 4, &["bearing.ball_diameter_mm is given by bearing.ball_radius_mm, which varies on line 6", "[set] has no effect"]),
    ("[grid]\nraceway.axial_span_mm = [5.0]\nraceway.1.axial_span_mm = [5.1]", 4, &["are one key"]),
    ("[grid]\nsearch.runs_max = [4, 8]", 4, &["search.runs_max is for `cageless design --search`"]),
    ("[set]\nsearch.starts = 2\n[grid]\nraceway.axial_span_mm = [5.0, 5.1]", 4, &["changes nothing that a sweep computes"]),
    ("[scatter]\nsearch.critical_gap_min_fraction = { normal = 0.1 }", 4, &["changes nothing that a sweep computes"]),
    ("[samples]\ncount = 4\noperation.radial_load_n = { from = 1.0, to = 2.0 }", 3, &["samples.method is missing"]),
    ("[samples]\nmethod = \"halton\"\ncount = 4\noperation.radial_load_n = { from = 1.0, to = 2.0 }", 4, &["\"sobol\", \"latin-hypercube\" or \"random\""]),
    ("[samples]\nmethod = \"sobol\"\ncount = 0\noperation.radial_load_n = { from = 1.0, to = 2.0 }", 5, &["a whole number, 1 or more"]),
    ("[samples]\nmethod = \"sobol\"\ncount = 8", 3, &["samples has no axes"]),
    ("[scatter]\nrepeats = 3", 3, &["scatter has no keys"]),
    ("[scatter]\nstart.gaps = \"all\"", 4, &["or \"random\""]),
    ("[scatter]\noperation.radial_load_n = { normal = -1.0 }", 4, &["operation.radial_load_n.normal = -1.0", "0 or more"]),
    ("[scatter]\nbearing.balls = { normal = 1.0 }", 4, &["a whole number: it cannot be scattered"]),
    ("[scatter]\nhousing.mass_kg = { normal = 0.1 }", 4, &["housing.mass_kg has no number in the case"]),
    ("[set]\nbearing.ball_radius_mm = \"thick\"", 4, &["bearing.ball_radius_mm = \"thick\"", "a number in mm"]),
    ("[set]\nhousing.mass_kg = 1.0", 4, &["housing.stiffness_n_m is missing"]),
    ("[gird]\nraceway.half_angle_deg = [25.0]", 3, &["gird is not a key of a plan", "did you mean grid?"]),
    ("schema = 2", 3, &["1, the only schema of plans"]),
    ("keep = [\"run_collisions\"]", 3, &["compute leaves out \"run\""]),
    ("keep = [\"static_torque\"]", 3, &["there are static_ring_x_um"]),
    ("seed = -1", 3, &["a whole number, 0 or more"]),
    ("seed = = 1", 3, &["is not TOML"]),
];

fn refused(dir: &Path, text: &str) -> Answer {
    let plan = dir.join("plan.toml");
    std::fs::write(&plan, text).unwrap();
    let out = dir.join("out");
    let (plan, out) = (plan.to_str().unwrap(), out.to_str().unwrap());
    let answer = call(&["sweep", plan, "--out", out]);
    assert_eq!(answer.code, Some(2), "{text}\n{answer:?}");
    assert!(answer.stdout.is_empty(), "{text}\n{answer:?}");
    assert!(!Path::new(out).exists(), "{text} left something");
    answer
}

#[test]
fn every_wrong_plan_is_refused_with_its_place_and_reason() {
    let dir = tempfile::tempdir().unwrap();
    let case = format!("case = {:?}\n", repository_case("zhao-d.toml"));
    for (text, line, fragments) in PLANS {
        let answer = refused(dir.path(), &format!("{case}{STATIC}{text}\n"));
        let place = format!("plan.toml:{line}: ");
        for fragment in fragments.iter().copied().chain([place.as_str()]) {
            assert!(
                answer.stderr.contains(fragment),
                "{text}\nlacks {fragment:?}: {answer:?}"
            );
        }
    }
}

#[test]
fn a_plan_needs_a_case_that_is_there_and_possible() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |text: &str| refused(dir.path(), text).stderr;
    assert!(refused(STATIC).contains("case is missing"));
    assert!(refused("case = 1\n").contains("the path of a case file"));
    let missing = refused(&format!("{STATIC}case = \"no.toml\"\n"));
    assert!(
        missing.contains("plan.toml:2: ") && missing.contains("cannot be opened"),
        "{missing}"
    );
    let without = refused(&format!("case = {:?}\n", repository_case("zhao-d.toml")));
    assert!(without.contains("compute is missing"), "{without}");
    let broken = dir.path().join("broken.toml");
    std::fs::write(&broken, "[bearing]\nballs = 2\n").unwrap();
    let message = refused(&format!("{STATIC}case = \"broken.toml\"\n"));
    assert!(message.contains("broken.toml"), "{message}");
    let nothing = call(&["sweep", "/nowhere/plan.toml"]);
    assert_eq!(nothing.code, Some(2));
    assert!(nothing.stderr.contains("cannot be opened"), "{nothing:?}");
}

#[test]
fn a_place_that_cannot_be_written_to_is_refused_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let plan = dir.path().join("plan.toml");
    let case = repository_case("zhao-d.toml");
    // Hours of work, if it began.
    let text = format!(
        "case = {case:?}\ncompute = [\"verdict\"]\n[grid]\n\
         operation.radial_load_n = {{ from = 100, to = 2000, count = 1000000 }}\n"
    );
    std::fs::write(&plan, text).unwrap();
    let file = dir.path().join("file");
    std::fs::write(&file, "").unwrap();
    let occupied = dir.path().join("occupied");
    std::fs::create_dir_all(occupied.join("sweep.parquet")).unwrap();
    let foreign = dir.path().join("foreign");
    std::fs::create_dir_all(&foreign).unwrap();
    std::fs::write(foreign.join("sweep.parquet"), "not a table").unwrap();
    let places = [
        file.join("below"),
        occupied,
        foreign.clone(),
        "/proc/nothing".into(),
    ];
    for out in places {
        let answer = call(&[
            "sweep",
            plan.to_str().unwrap(),
            "--out",
            out.to_str().unwrap(),
        ]);
        assert_eq!(answer.code, Some(2), "{out:?}: {answer:?}");
        assert!(answer.stderr.contains(out.to_str().unwrap()), "{answer:?}");
    }
    assert_eq!(names(&foreign), ["sweep.parquet"]);
}

/// What varies may need a value in `[set]` all the same: the case must be possible as it stands.
#[test]
fn a_value_that_the_case_lacks_may_be_set_and_varied() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let case = std::fs::read_to_string(case).unwrap();
    let case: String = (case.split_inclusive('\n'))
        .filter(|line| !line.starts_with("axial_span_mm"))
        .collect();
    std::fs::write(dir.path().join("case.toml"), case).unwrap();
    let plan = dir.path().join("plan.toml");
    let text = "case = \"case.toml\"\ncompute = [\"static\"]\n[set]\nraceway.axial_span_mm = 5.2\n\
                [grid]\nraceway.axial_span_mm = [5.0, 5.1]\n";
    std::fs::write(&plan, text).unwrap();
    let out = dir.path().join("out");
    let answer = call(&[
        "sweep",
        plan.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
}
