//! Drops of new cases and what the command prints of drops.

use crate::common::{call, call_on, repository_case};

#[test]
fn a_new_touch_down_case_drops_at_once() {
    for (name, full) in [
        ("6008", false),
        ("61808", true),
        ("6304", false),
        ("6000", true),
    ] {
        let mut args = vec!["new", "--bearing", name, "--touchdown"];
        args.extend(full.then_some("--full-complement"));
        let text = call(&args).stdout;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("case.toml");
        std::fs::write(&path, &text).unwrap();
        let path = path.to_str().unwrap();
        let answer = call(&["drop", path, "--json", "--set", "solver.duration_s=0.008"]);
        assert_eq!(answer.code, Some(0), "{name}: {answer:?}\n{text}");
        let json: serde_json::Value = serde_json::from_str(&answer.stdout).unwrap();
        assert_eq!(json["file"], "case", "{name}");
        let found = &json["bearings"][0];
        assert!(found["impacts"].as_u64().unwrap() > 0, "{name}");
        assert!(found["clearance_margin_um"].is_f64(), "{name}");
        // Each value that the bearing does not fix is marked.
        let sections = text.split("[contact]").nth(1).unwrap();
        let lines = sections
            .lines()
            .filter(|l| l.contains(" = ") && !l.contains("duration_s"));
        for line in lines {
            assert!(line.contains("(assumed)"), "{line}");
        }
        // A steel cylinder about its axis: J/m between the squares of its radii.
        let bearing = &found["case"]["bearing"];
        let of = |key: &str| bearing[key].as_f64().unwrap();
        let gyration = (of("inner_ring_polar_inertia_kg_m2") / of("inner_ring_mass_kg")).sqrt();
        let bore = 1e-3 * of("inner_ring_bore_radius_mm");
        assert!(
            gyration > bore && gyration < 1.6 * bore,
            "{name}: {gyration} {bore}"
        );
    }
}

/// Fewer drops than were asked for are a partial result: exit code 3, its numbers, and the reason.
#[test]
fn drops_that_are_not_possible_are_missed() {
    let case = repository_case("touchdown-d.toml");
    let sets = ["solver.duration_s=0.002"];
    let answer = call_on("drop", &case, &sets, &["--drops", "2", "--json"]);
    assert_eq!(answer.code, Some(3), "{answer:?}");
    assert_eq!(answer.json()["succession"].as_array().unwrap().len(), 1);
    let reason =
        "drop 2 needs the temperatures after drop 1: the rotor has not touched every inner ring";
    assert!(answer.stderr.contains(reason), "{answer:?}");
}

/// A drop has results for one screen, those without a value or with a zero by symmetry in its files alone.
#[test]
fn a_drop_prints_at_most_forty_results_and_headings() {
    for (name, most) in [
        ("touchdown-6205.toml", 40),
        ("rotors/two-bearings.toml", 42),
    ] {
        let case = repository_case(name);
        let text = call_on("drop", &case, &["solver.duration_s=0.05"], &[]).stdout;
        let lines = text
            .lines()
            .filter(|line| !line.is_empty() && !line.starts_with("warning"));
        let results: Vec<&str> = lines
            .skip_while(|line| *line != "Motion of the rotor")
            .collect();
        assert!(
            results.len() > 30 && results.len() <= most,
            "{}: {text}",
            results.len()
        );
        let empty = |line: &&str| line.ends_with('–') || line.ends_with("  0");
        // What one bearing of several has stands for all.
        let one = !name.starts_with("rotors");
        assert!(!one || !results.iter().any(empty), "{text}");
        assert!(!results.iter().any(|line| line.contains("N·m ")), "{text}");
    }
}

#[test]
fn what_is_printed_of_drops_has_words_numbers_and_a_verdict() {
    let path = |name: &str| repository_case(name).display().to_string();
    let case = path("touchdown-d.toml");
    let short = "solver.duration_s=0.01";
    let rotor = path("rotors/two-bearings.toml");
    for args in [
        vec![
            "drop",
            &case,
            "--set",
            short,
            "--samples",
            "2",
            "--compare",
            "conventional",
        ],
        vec!["drop", &case, "--set", "solver.duration_s=0.001"],
        vec![
            "drop",
            &case,
            "--set",
            short,
            "--set",
            "operation.gravity_m_s2=1e-6",
        ],
        vec!["drop", &rotor, "--set", short, "--samples", "2"],
        vec![
            "drop",
            &rotor,
            "--set",
            short,
            "--set",
            "bearing.1.axial_mm=0",
        ],
        vec!["run", &case, "--set", short],
        vec!["check", &case],
        vec!["check", &rotor],
    ] {
        let answer = call(&args);
        assert_eq!(answer.code, Some(0), "{args:?}: {answer:?}");
        let text = answer.stdout + &answer.stderr;
        let mut words = text.split(|c: char| !c.is_alphabetic());
        assert!(
            !words.any(|word| ["inf", "NaN", "nan"].contains(&word)),
            "{args:?}: {text}"
        );
        assert!(
            !text.contains("ledger") && !text.contains("bouncing"),
            "{args:?}: {text}"
        );
        if args[0] == "drop" {
            assert!(text.starts_with("verdict"), "{args:?}: {text}");
        }
    }
    let text = call(&["drop", &case, "--set", short]).stdout;
    assert!(text.contains("not reached ("), "{text}");
    let refused = call(&["drop", &path("zhao-d.toml")]).stderr;
    for key in [
        "[rotor]",
        "contact_stiffness_n_mp",
        "[support]",
        "stiffness_n_m",
        "[contact]",
        "--touchdown",
    ] {
        assert!(refused.contains(key), "{key}: {refused}");
    }
}
