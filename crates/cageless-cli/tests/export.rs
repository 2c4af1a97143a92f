//! `cageless export`: what it prints and writes where, and what it refuses.
//! What is in the files is checked by `tests/tools/cad.py`.

use std::path::Path;

use crate::common::*;

const SIZE: [&str; 2] = [
    "bearing.outer_ring_outer_radius_mm=31",
    "bearing.outer_ring_width_mm=16",
];

fn export(sets: &[&str], more: &[&str]) -> Answer {
    let sets = [&SIZE[..], sets].concat();
    call_on("export", &repository_case("zhao-d.toml"), &sets, more)
}

fn assert_refused(answer: &Answer, fragments: &[&str]) {
    assert_eq!(answer.code, Some(2), "{answer:?}");
    assert_eq!(answer.stdout, "", "{answer:?}");
    for fragment in fragments {
        assert!(answer.stderr.contains(fragment), "{fragment}: {answer:?}");
    }
}

#[test]
fn a_file_and_its_numbers() {
    let dir = tempfile::tempdir().unwrap();
    for (format, own) in [
        (
            "step",
            &["tolerance_um", "faces", "bspline_faces", "control_points"][..],
        ),
        (
            "stl",
            &["chord_um", "triangles", "vertices", "mesh_volume_mm3"],
        ),
        ("csv", &["spacing_mm", "surface_points", "contact_points"]),
    ] {
        let path = dir.path().join(format!("ring.{format}"));
        let out = path.to_str().unwrap();
        let answer = export(&[], &["--format", format, "--json", "--out", out]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        assert_eq!(answer.stderr, "");
        let d = answer.json();
        let number = |key: &str| d[key].as_f64().unwrap_or_else(|| panic!("{key}: {d}"));
        assert_eq!(d["format"], format);
        assert_eq!(d["file"], out);
        assert_eq!(
            number("bytes"),
            std::fs::metadata(&path).unwrap().len() as f64
        );
        for key in own {
            assert!(number(key) > 0.0, "{key}");
        }
        assert!((number("volume_mm3") - 12_767.968).abs() < 1e-3);
        let most = [("step", 0.01), ("stl", 5.0), ("csv", 1e-3)];
        let most = most.iter().find(|m| m.0 == format).unwrap().1;
        assert!(number("deviation_um") <= most, "{d}");
        assert_eq!(number("blend_mm"), 0.5);
        assert!((0.5..2.0).contains(&number("blend_deviation_um")));
        assert_eq!(number("slope_discontinuity_45_deg"), 0.0);
        assert!((number("design_slope_discontinuity_45_deg") - 0.654).abs() < 1e-3);
        // The same bytes again.
        let first = std::fs::read(&path).unwrap();
        export(&[], &["--format", format, "--out", out]);
        assert_eq!(std::fs::read(&path).unwrap(), first);
    }
    assert_eq!(names(dir.path()), ["ring.csv", "ring.step", "ring.stl"]);
}

#[test]
fn a_folder_gets_the_file_and_its_numbers() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("new").join("folder");
    let more = ["--format", "step", "--out", out.to_str().unwrap()];
    let answer = export(&[], &more);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert!(answer.stdout.contains("volume of the ring"));
    assert_eq!(names(&out), ["export.json", "outer_ring.step"]);
    assert_eq!(json_file(&out.join("export.json"))["bspline_faces"], 6);
}

/// The date of reproducible builds is one or is refused, and nothing is written.
#[test]
fn a_malformed_date_of_the_environment_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let sets = SIZE.map(|set| format!("--set={set}"));
    let answer = |date: &str, format: &str| {
        let mut command = cageless();
        command.env("SOURCE_DATE_EPOCH", date);
        command
            .arg("export")
            .arg(repository_case("zhao-d.toml"))
            .args(&sets);
        command
            .args(["--format", format, "--out"])
            .arg(dir.path().join("ring.step"));
        Answer::from(command.output().unwrap())
    };
    let refused = answer("2026-01-01", "step");
    let named =
        "SOURCE_DATE_EPOCH = \"2026-01-01\" is not possible: it must be a whole number of seconds";
    assert_refused(&refused, &[named]);
    assert!(names(dir.path()).is_empty());
    assert_eq!(answer("951782400", "step").code, Some(0));
    let text = std::fs::read_to_string(dir.path().join("ring.step")).unwrap();
    assert!(text.contains("'2000-02-29T00:00:00'"), "{}", &text[..400]);
}

/// A slot has no blend; its width, depth and edges are numbers of the ring in every format.
#[test]
fn the_ring_of_a_slot_is_written() {
    let sets = [
        "raceway.shape=slot",
        "raceway.edge_radius_mm=0.3",
        "raceway.axial_span_mm=2.4",
    ];
    for format in ["step", "stl", "csv"] {
        let answer = export(&sets, &["--format", format, "--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
        let d = answer.json();
        let slot = &d["slots"][0];
        let number = |key: &str| slot[key].as_f64().unwrap_or_else(|| panic!("{key}: {d}"));
        assert!((number("width_mm") - 1.951_181).abs() < 1e-6, "{d}");
        assert!((number("depth_mm") - 0.606_110).abs() < 1e-6, "{d}");
        assert_eq!(number("edge_radius_mm"), 0.3);
        assert!((number("straight_half_angle_deg") - 22.567_695).abs() < 1e-6);
        assert!((d["volume_mm3"].as_f64().unwrap() - 12_735.061_549).abs() < 1e-5);
        assert_eq!(d["blend_mm"], 0.0);
        assert!(d["blend_not_simulated"].is_null(), "{d}");
    }
    let deeper = [&sets[..], &["raceway.slot_depth_mm=1"]].concat();
    let answer = export(&deeper, &["--format", "csv"]);
    assert!(
        answer
            .stderr
            .contains("1.951181 mm wide, floor 1.000000 mm below")
    );
    let kinds = |kind: &str| {
        answer
            .stdout
            .lines()
            .filter(|l| l.starts_with(kind))
            .count()
    };
    assert!(["edge,", "wall,", "floor,"].iter().all(|k| kinds(k) > 50));
    let through = [&sets[..], &["raceway.slot_depth_mm=3.3"]].concat();
    let refused = export(&through, &["--format", "step"]);
    assert_refused(
        &refused,
        &["raceway.slot_depth_mm = 3.3", "less than 3.235 mm"],
    );
}

/// Without `--out` the file itself, and the numbers beside it; with `--json` the numbers.
#[test]
fn stdout_takes_one_thing() {
    let answer = export(&[], &["--format", "csv"]);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert!(
        answer
            .stdout
            .starts_with("kind,side,psi_deg,eta_deg,x_mm,y_mm,z_mm,nx,ny,nz\n")
    );
    assert!(answer.stderr.contains("deviation from the surface"));
    let answer = export(&[], &["--format", "step"]);
    assert!(answer.stdout.starts_with("ISO-10303-21;\n"));
    assert!(answer.stdout.ends_with("END-ISO-10303-21;\n"));
    let answer = export(&[], &["--format", "stl", "--json"]);
    assert!(answer.json()["file"].is_null());
}

/// The user chooses: blended over a stated length, or the kink left and its angle stated.
#[test]
fn the_kink_is_blended_or_stated() {
    let numbers =
        |blend: &str| export(&[], &["--format", "step", "--json", "--blend-mm", blend]).json();
    let left = numbers("0");
    assert_eq!(
        left["slope_discontinuity_45_deg"],
        left["design_slope_discontinuity_45_deg"]
    );
    assert_eq!(left["blend_deviation_um"], 0.0);
    assert_eq!(left["bspline_faces"], 2);
    let blended = numbers("1.25");
    assert_eq!(blended["blend_mm"], 1.25);
    assert_eq!(blended["slope_discontinuity_shoulder_deg"], 0.0);
    let text = export(&[], &["--format", "step", "--json", "--blend-mm", "0"]);
    assert_eq!(text.code, Some(0));
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("ring.step");
    let more = [
        "--format",
        "step",
        "--blend-mm",
        "0",
        "--out",
        out.to_str().unwrap(),
    ];
    assert!(export(&[], &more).stdout.contains("not blended: 0.6544°"));
}

#[test]
fn what_only_export_needs_is_asked_for() {
    let case = repository_case("zhao-d.toml");
    for (set, missing) in [
        (SIZE[0], "outer_ring_width_mm"),
        (SIZE[1], "outer_ring_outer_radius_mm"),
    ] {
        let answer = call_on("export", &case, &[set], &["--format", "step"]);
        let key = format!(
            "bearing.{missing} is missing in [bearing], and the shape of the outer ring needs it"
        );
        assert_refused(&answer, &[&key, "zhao-d.toml:6:", "in mm"]);
        assert_eq!(answer.stderr.lines().count(), 1, "{}", answer.stderr);
    }
}

#[test]
fn rings_that_cannot_be() {
    for (set, fragments) in [
        // Deeper in the raceway than Ro.
        (
            "bearing.outer_ring_outer_radius_mm=27.78",
            &["outer_ring_outer_radius_mm = 27.78", "more than 27.793"][..],
        ),
        (
            "bearing.outer_ring_outer_radius_mm=27",
            &["more than 27.765 mm"],
        ),
        (
            "bearing.outer_ring_width_mm=7.5",
            &["outer_ring_width_mm = 7.5", "more than 7.58"],
        ),
        (
            "bearing.outer_ring_width_mm=nan",
            &["a finite number of mm"],
        ),
    ] {
        let dir = tempfile::tempdir().unwrap();
        let out = dir.path().join("out");
        let answer = export(
            &[set],
            &["--format", "step", "--out", out.to_str().unwrap()],
        );
        assert_refused(&answer, fragments);
        assert!(!out.exists());
        assert!(
            answer.stderr.starts_with(&format!("error: --set {set}: ")),
            "{answer:?}"
        );
    }
}

#[test]
fn flags_that_cannot_be() {
    for (more, fragments) in [
        (
            &["--format", "step", "--blend-mm", "-1"][..],
            &["--blend-mm -1 mm", "at least 0"][..],
        ),
        (
            &["--format", "step", "--blend-mm", "7"],
            &["--blend-mm 7 mm", "6.10", "or 0"],
        ),
        (
            &["--format", "step", "--blend-mm", "0.001"],
            &["--blend-mm 0.001 mm", "0.0244"],
        ),
        (&["--format", "step", "--blend-mm", "nan"], &["--blend-mm"]),
        (
            &["--format", "step", "--tolerance-um", "0"],
            &["--tolerance-um 0", "0.0001"],
        ),
        (
            &["--format", "step", "--tolerance-um", "inf"],
            &["--tolerance-um inf"],
        ),
        (
            &["--format", "step", "--chord-um", "5"],
            &["--chord-um 5", "--format stl"],
        ),
        (
            &["--format", "stl", "--json", "--chord-um", "0.001"],
            &["--chord-um 0.001 µm", "0.05 µm"],
        ),
        (
            &["--format", "stl", "--json", "--chord-um", "500"],
            &["--chord-um 500 µm", "100 µm"],
        ),
        (
            &["--format", "csv", "--spacing-mm", "0"],
            &["--spacing-mm 0", "0.01"],
        ),
        (
            &["--format", "csv", "--spacing-mm", "nan"],
            &["--spacing-mm NaN"],
        ),
        (&["--format", "iges"], &["iges", "step, stl, csv"]),
        (&[], &["--format"]),
        (
            &["--format", "stl", "--out", "ring.step"],
            &["ring.step", "--format step"],
        ),
    ] {
        assert_refused(&export(&[], more), fragments);
    }
}

#[test]
fn places_that_cannot_be_written_to() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("file");
    std::fs::write(&file, "keep me").unwrap();
    let folder = dir.path().join("there.step").join("outer_ring.step");
    std::fs::create_dir_all(&folder).unwrap();
    let text = |p: &Path| p.to_str().unwrap().to_owned();
    for out in [
        text(&file),
        text(&file.join("below")),
        text(&file.join("ring.step")),
        text(&dir.path().join("missing").join("ring.step")),
        // A folder in spite of its name, in which another has the name of the file.
        text(folder.parent().unwrap()),
    ] {
        let answer = export(&[], &["--format", "step", "--out", &out]);
        assert_refused(&answer, &["--out", &out]);
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "keep me");
    assert_eq!(names(dir.path()), ["file", "there.step"]);
}

/// A raceway so short that half a millimetre would be most of it is blended over less.
#[test]
fn short_raceways_have_short_blends() {
    let answer = export(
        &["raceway.half_angle_deg=3", "raceway.axial_span_mm=6"],
        &["--format", "step", "--json"],
    );
    assert_eq!(answer.code, Some(0), "{answer:?}");
    let blend = answer.json()["blend_mm"].as_f64().unwrap();
    assert!(
        (blend - 0.2 * 3f64.to_radians() * 27.765).abs() < 1e-9,
        "{blend}"
    );
}

/// The header has the date of the export, or that of reproducible builds.
#[test]
fn a_step_file_has_its_date() {
    let answer = export(&[], &["--format", "step"]);
    assert!(
        answer.stdout.contains(",'2000-02-29T00:00:00',"),
        "{answer:?}"
    );
}

/// An end at a right angle is no matter of the tolerance.
#[test]
fn ends_at_right_angles_need_a_blend() {
    let ellipse = ["raceway.shape=ellipse"];
    for format in ["stl", "csv"] {
        let answer = export(&ellipse, &["--format", format, "--blend-mm", "0", "--json"]);
        assert_eq!(answer.code, Some(0), "{answer:?}");
    }
    let answer = export(&ellipse, &["--format", "step", "--blend-mm", "0"]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    let said = ["--blend-mm 0", "such as 0.5", "right angle"];
    assert!(
        said.iter().all(|part| answer.stderr.contains(part)),
        "{answer:?}"
    );
    assert!(!answer.stderr.contains("tolerance"), "{answer:?}");
    let answer = export(
        &ellipse,
        &["--format", "step", "--blend-mm", "0.5", "--json"],
    );
    assert_eq!(answer.code, Some(0), "{answer:?}");
}

/// The option replaces a blend that the file leaves to its default, not one that it states.
#[test]
fn a_default_blend_gives_way_to_the_option() {
    let case = repository_case("full-6205.toml");
    let raceway = ["raceway.axial_span_mm=2.9", "raceway.half_angle_deg=16.8"];
    let asked = ["--format", "csv", "--json", "--blend-mm", "0.3"];
    let answer = call_on("export", &case, &raceway, &asked);
    assert_eq!(answer.code, Some(0), "{answer:?}");
    assert_eq!(answer.json()["blend_mm"], 0.3);
    let stated = [&raceway[..], &["raceway.blend_mm=0.4"]].concat();
    let answer = call_on("export", &case, &stated, &asked);
    assert_refused(&answer, &["--blend-mm", "raceway.blend_mm"]);
}
