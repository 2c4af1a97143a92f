//! What the command states to a reader: the scope of the model, the origin of values, what a
//! folder or a file name stands for.

use crate::common::*;

#[test]
fn check_and_the_readme_state_the_limits_of_the_model() {
    let case = repository_case("zhao-d.toml");
    let text = call_on("check", &case, &[], &["--all"]).stdout;
    let answer = call_on("check", &case, &[], &["--json"]).json();
    let scope: Vec<&str> = (answer["scope"].as_array().expect("a list").iter())
        .map(|statement| statement.as_str().expect("text"))
        .collect();
    assert_eq!(scope, cageless::SCOPE);
    let readme = std::fs::read_to_string(repository_case("../README.md")).expect("README.md");
    let (_, limits) = readme
        .split_once("## Limits of the model")
        .expect("its limits");
    let (limits, _) = limits.split_once("##").expect("a further section");
    let words = |item: &str| item.split_whitespace().collect::<Vec<_>>().join(" ");
    let listed: Vec<String> = limits.split("\n- ").skip(1).map(words).collect();
    assert_eq!(listed, cageless::SCOPE);
    for statement in cageless::SCOPE {
        assert!(text.contains(statement), "{statement}: {text}");
    }
    for word in [
        "in the plane",
        "axial load",
        "tilt",
        "preload",
        "the outer ring is fixed",
        "speed and load prescribed",
        "dry friction laws",
        "heat",
    ] {
        assert!(scope.iter().any(|s| s.contains(word)), "{word}");
    }
}

#[test]
fn the_case_table_of_a_page_has_sources_and_units() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().to_str().unwrap();
    let sets = ["raceway.axial_span_mm=5.2", "solver.duration_s=0.002"];
    let case = repository_case("zhao-d.toml");
    let answer = call_on("run", &case, &sets, &["--out", out]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let data = json_file(&dir.path().join("report.json"));
    let lines = data["parameters"].as_array().expect("a table");
    let line = |name: &str| {
        let line = lines.iter().find(|line| line["name"] == name);
        let line = line.unwrap_or_else(|| panic!("{name} is missing"));
        [&line["value"], &line["unit"], &line["source"]].map(|v| v.as_str().unwrap_or("?"))
    };
    assert_eq!(line("raceway.axial_span_mm"), ["5.2", "mm", "--set"]);
    assert_eq!(line("solver.duration_s"), ["0.002", "s", "--set"]);
    assert_eq!(line("raceway.half_angle_deg"), ["25.2", "°", "case file"]);
    assert_eq!(line("raceway.depth_error_um"), ["0.0", "µm", "default"]);
}

#[test]
fn a_file_name_of_another_format_makes_no_folder() {
    let dir = tempfile::tempdir().unwrap();
    let case = repository_case("zhao-d.toml");
    let ring = [
        "bearing.outer_ring_outer_radius_mm=31",
        "bearing.outer_ring_width_mm=16",
    ];
    for (format, name, said) in [
        ("stl", "r.obj", "a file of --format stl ends in .stl"),
        ("csv", "ring.txt", "a file of --format csv ends in .csv"),
        ("step", "ring.stl", "is the name of a file of --format stl"),
    ] {
        let out = dir.path().join(name);
        let out = out.to_str().unwrap();
        let answer = call_on("export", &case, &ring, &["--format", format, "--out", out]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        assert!(answer.stderr.contains(said), "{}", answer.stderr);
        assert!(names(dir.path()).is_empty(), "{name} was made");
    }
    // A folder is marked by a slash, or is there.
    let out = format!("{}/ring.v2/", dir.path().display());
    let answer = call_on("export", &case, &ring, &["--format", "csv", "--out", &out]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert_eq!(names(&dir.path().join("ring.v2")).len(), 2);
}

#[test]
fn the_folder_of_a_run_is_no_sweep_and_report_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let (run, design) = (dir.path().join("run"), dir.path().join("design"));
    let case = repository_case("zhao-d.toml");
    let out = ["--out", run.to_str().unwrap()];
    let answer = call_on("run", &case, &["solver.duration_s=0.001"], &out);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    std::fs::create_dir(&design).unwrap();
    std::fs::write(design.join("design.json"), "{}").unwrap();
    let summary = run.join("summary.json");
    let motion = "run` or `drop";
    for (path, command) in [(&run, motion), (&summary, motion), (&design, "design")] {
        let answer = call(&["report", path.to_str().unwrap()]);
        assert_eq!(answer.code, Some(2), "{answer:?}");
        let said = format!(
            "is the result of `cageless {command}`, not of a sweep: its page is report.html in that folder"
        );
        assert!(answer.stderr.contains(&said), "{}", answer.stderr);
    }
}

/// `check` states the expansion of a fast inner ring that the clearance leaves out: above 1 µm, or a tenth of the
/// clearance; a fit takes it off, but not of a ring that a drop meets at rest.
#[test]
fn check_states_the_expansion_that_the_clearance_leaves_out() {
    let of = |case: &str, sets: &[&str]| {
        let answer = call_on("check", &repository_case(case), sets, &["--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        let sentence = answer.json()["speed_expansion_left_out"]
            .as_str()
            .map(str::to_owned);
        sentence.unwrap_or_default()
    };
    let fast = "operation.inner_speed_rpm=30000";
    assert!(of("zhao-d.toml", &[fast]).starts_with("3.5 µm at the largest speed"));
    assert_eq!(of("zhao-d.toml", &[]), "");
    assert_eq!(of("zhao-d.toml", &[fast, "fit.bore_diameter_mm=30"]), "");
    assert!(of("touchdown-d.toml", &[]).contains("the clearance is that at rest"));
    let radii = [
        "bearing.inner_groove_bottom_radius_mm=18.239",
        "bearing.outer_groove_bottom_radius_mm=27.765",
    ];
    // 0.56 µm of a clearance of 2.
    assert!(of("zhao-d.toml", &radii).starts_with("0.6 µm"));
}

/// A limit of a user stands before the results of each command that has the result, and in its file.
#[test]
fn limits_of_a_user_are_judged_where_the_result_is() {
    let folder = tempfile::tempdir().unwrap();
    let case = folder.path().join("case.toml");
    let limit = |result: &str, value: &str| {
        format!("\n[[limit]]\nresult = \"{result}\"\nvalue = {value}\nsource = \"us\"\n")
    };
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap()
        + &limit("l10_h", "20000")
        + &limit("lag_per_pass_deg", "0.1")
        + &limit("outer_pressure_max_mpa", "1000")
        + &limit("critical_gap_deg", "1.7");
    std::fs::write(&case, text).unwrap();
    let quick = ["solver.duration_s=0.05", "solver.transient_s=0.01"];
    let print = |command: &str, more: &[&str]| call_on(command, &case, &quick, more);

    let answer = print("static", &[]).stdout;
    let first: Vec<&str> = answer.lines().take(2).collect();
    assert!(
        first[0].starts_with("limit exceeded") && first[0].contains("at least 20000 h (us)"),
        "{answer}"
    );
    assert!(first[1].contains("at most 1000 MPa (us)"), "{answer}");
    assert!(!answer.contains("lag of a ball"), "{answer}");

    let answer = print("run", &[]).stdout;
    assert!(answer.contains("limit exceeded"), "{answer}");
    let kept = answer.lines().find(|line| line.starts_with("limit kept"));
    assert!(
        kept.is_some_and(|line| line.contains("at least 0.1°")),
        "{answer}"
    );
    assert!(!answer.contains("20000 h"), "{answer}");
    let json = print("run", &["--json"]).json();
    assert_eq!(json["limits_exceeded"].as_array().unwrap().len(), 1);
    assert_eq!(json["limits_kept"].as_array().unwrap().len(), 1);

    // The heads of pages have them.
    let short = ["steady.transient_orbits=1", "steady.measured_orbits=3"];
    for (command, more, expected) in [
        ("design", &[][..], "critical gap"),
        (
            "compare",
            &["--with-conventional", "--draws=2"],
            "A: peak contact pressure, outer raceway",
        ),
    ] {
        let out = folder.path().join(command);
        let more = [more, &["--out", out.to_str().unwrap()]].concat();
        let sets = [&quick[..], &short].concat();
        let answer = call_on(command, &case, &sets, &more);
        assert_eq!(answer.code, Some(0), "{command} {answer:?}");
        let page = std::fs::read_to_string(out.join("report.html")).unwrap();
        let (header, _) = page.split_once("</header>").unwrap();
        assert!(
            header.contains(expected) && header.contains("(us)"),
            "{command} {header}"
        );
    }

    let wrong = std::fs::read_to_string(&case).unwrap() + &limit("statik_safety_factor", "1");
    std::fs::write(&case, wrong).unwrap();
    let answer = print("check", &[]);
    assert_eq!(answer.code, Some(2));
    assert!(
        answer.stderr.contains("did you mean static_safety_factor?"),
        "{}",
        answer.stderr
    );
}
