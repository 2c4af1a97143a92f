//! `cageless sheet`: what it computes, its files, and what is refused.

use crate::common::*;

const OUTSIDE: [&str; 2] = [
    "bearing.outer_ring_outer_radius_mm=31",
    "bearing.outer_ring_width_mm=16",
];

/// The numbers are those of `static` and `tolerance`; the drawing lies beside the page.
#[test]
fn the_sheet_has_the_numbers_of_the_other_commands() {
    let quick = ["solver.method=verlet", "solver.step_us=auto"];
    let sets = [&OUTSIDE[..], &quick].concat();
    let case = repository_case("zhao-d.toml");
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("sheet");
    let tolerances = ["--groove-depth-um", "3", "--json"];
    let more = ["--without-benefit", "--out", out.to_str().unwrap()];
    let more = [&more[..], &tolerances].concat();
    let answer = call_on("sheet", &case, &sets, &more);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let found = answer.json();
    assert_eq!(json_file(&out.join("sheet.json")), found);
    let files = ["drawing.pdf", "drawing.svg", "report.html", "sheet.json"];
    assert_eq!(names(&out), files);
    let alone = call_on("static", &case, &sets, &["--json"]).json();
    assert_eq!(found["static"], alone);
    let more = [&tolerances[..], &["--samples", "0"]].concat();
    let alone = call_on("tolerance", &case, &sets, &more).json();
    assert_eq!(found["tolerance"], alone);
    assert!(found["tolerance"]["benefit"].is_null());
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("does not work at the ends of the range of: "));
    assert!(page.contains("class=\"drawing\""));
}

/// A ring without a raceway, a rotor and a case without the outside of its ring have what there is of it.
#[test]
fn what_has_no_raceway_has_a_sheet() {
    let dir = tempfile::tempdir().unwrap();
    for (case, drawn) in [
        ("full-6205.toml", true),
        ("touchdown-6205.toml", false),
        ("conventional.toml", false),
    ] {
        let out = dir.path().join(case);
        let more = ["--json", "--out", out.to_str().unwrap()];
        let answer = call_on("sheet", &repository_case(case), &[], &more);
        assert_eq!(answer.code, Some(0), "{case} {answer:?}");
        assert!(answer.json()["tolerance"].is_null(), "{case}");
        assert_eq!(
            names(&out).contains(&"drawing.pdf".to_owned()),
            drawn,
            "{case}"
        );
        let page = std::fs::read_to_string(out.join("report.html")).unwrap();
        let missing =
            page.contains("no drawing: ") && page.contains("outer_ring_outer_radius_mm is missing");
        assert_eq!(missing, !drawn, "{case}");
    }
}

/// The limits of a case stand at the head of its sheet, those exceeded first.
#[test]
fn limits_stand_at_the_head() {
    let dir = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(repository_case("full-6205.toml")).unwrap();
    let limits = "\n[[limit]]\nresult = \"static_safety_factor\"\nvalue = 1.5\nsource = \"ISO 76\"\n\
                  [[limit]]\nresult = \"l10_h\"\nvalue = 1e6\nsource = \"customer\"\n";
    let case = dir.path().join("case.toml");
    std::fs::write(&case, text + limits).unwrap();
    let answer = call_on(
        "sheet",
        &case,
        &[],
        &["--out", dir.path().join("out").to_str().unwrap()],
    );
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let page = std::fs::read_to_string(dir.path().join("out/report.html")).unwrap();
    let judged: Vec<&str> = page.split("class=\"judged ").skip(1).collect();
    assert!(
        judged[0].starts_with("fail") && judged[0].contains("customer"),
        "{}",
        judged[0]
    );
    assert!(
        judged[1].starts_with("pass") && judged[1].contains("ISO 76"),
        "{}",
        judged[1]
    );
    assert!(answer.stdout.contains("exceeded"), "{}", answer.stdout);
}

#[test]
fn impossible_tolerances_are_refused_before_anything_is_written() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    for (option, value) in [
        ("--axial-span-um", "-1"),
        ("--groove-depth-um", "1e9"),
        ("--centre-angle-deg", "nan"),
    ] {
        let more = [option, value, "--out", out.to_str().unwrap()];
        let answer = call_on("sheet", &repository_case("zhao-d.toml"), &OUTSIDE, &more);
        assert_eq!(answer.code, Some(2), "{option} {answer:?}");
        assert!(answer.stderr.contains(option), "{option} {}", answer.stderr);
        assert!(!out.exists(), "{option}");
    }
}
