//! What a good case file becomes, and what no file may do.

use std::collections::BTreeSet;
use std::path::Path;

use crate::common::{edited, without_film};
use cageless::{
    FlankModel, Formulation, FrictionModel, Gaps, IntegrationMethod, Start, StartState,
};
use cageless_io::case_file::{CaseFile, CaseValue, Source, template, unit};
use proptest::prelude::*;

fn parse(text: &str) -> CaseFile {
    CaseFile::parse(text, "case.toml", &[]).unwrap_or_else(|e| panic!("{e}"))
}

fn cases() -> Vec<std::path::PathBuf> {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let entries = std::fs::read_dir(dir).unwrap().map(|e| e.unwrap().path());
    let mut files: Vec<_> = entries
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

#[test]
fn the_template_is_the_bearing_of_the_paper_in_si_units() {
    let file = parse(&template(false));
    let (case, particulars) = (file.case(), file.particulars());
    let d = case.bearing.dimensions();
    assert_eq!(d.balls, 14);
    assert_eq!(d.ball_radius_m, 4.7625e-3);
    assert_eq!(d.inner_groove_bottom_radius_m, 18.24e-3);
    assert_eq!(d.outer_groove_bottom_radius_m, 27.765e-3);
    assert_eq!(d.outer_shoulder_radius_m, 26e-3);
    assert_eq!(d.inner_groove_curvature_radius_m, 4.953e-3);
    assert_eq!(d.outer_groove_curvature_radius_m, 4.953e-3);
    assert_eq!(
        (d.inner_ring_mass_kg, d.inner_ring_damping_n_s_m),
        (0.2, 2000.0)
    );
    let m = case.bearing.materials().ball;
    assert_eq!(
        (m.density_kg_m3, m.youngs_modulus_pa, m.poisson_ratio),
        (7850.0, 206e9, 0.3)
    );
    let r = case.raceways[0].dimensions();
    assert_eq!((r.axial_span_m, r.centre_angle_rad), (5.1e-3, 0.0));
    assert_eq!(r.half_angle_rad, 25.2f64.to_radians());
    let o = &case.operation;
    assert!((o.inner_speed_rad_s - 400.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!((o.radial_load_n, o.gravity_m_s2), (1500.0, 9.81));
    let c = &case.contact;
    assert_eq!(
        (c.friction.coefficient, c.friction.regularisation_speed_m_s),
        (0.007, 0.02)
    );
    assert_eq!(
        (c.friction_law, c.damping_n_s_m1_5),
        (FrictionModel::Smooth, 2e5)
    );
    assert_eq!((c.ball_restitution, c.inner_stiffness_n_m1_5), (0.95, None));
    assert_eq!(case.formulation, Formulation::Physical);
    assert_eq!(
        case.start,
        Start::new(StartState::Settled, Gaps::Uniform, 0.0)
    );
    assert_eq!(
        (case.solver.method, case.solver.step_s),
        (IntegrationMethod::VelocityVerlet, 2e-6)
    );
    assert_eq!(
        (case.solver.duration_s, particulars.interval_s),
        (0.5, 1e-4)
    );
    assert_eq!((particulars.seed, &case.housing), (0, &None));
}

/// A file that says nothing of flanks and ends is a real bearing, as it is machined; one in the paper's formulation, or
/// with a law that sticks, has the rigid flanks that alone these have, and rigid flanks have sharp ends.
#[test]
fn flanks_and_ends_are_those_of_a_real_bearing_unless_given() {
    let silent = template(false)
        .replace("flanks = ", "# flanks = ")
        .replace("blend_mm = ", "# blend_mm = ");
    let read = |sets: &[&str]| {
        let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
        let file = CaseFile::parse(&silent, "case.toml", &sets).unwrap();
        let run = file.document_as_run();
        assert_eq!(
            run.number("raceway.blend_mm"),
            Some(file.case().raceways[0].blend_m() / 1e-3)
        );
        assert!(file.defaults().iter().any(|key| key == "raceway.blend_mm"));
        (file.case().flanks, file.case().raceways[0].blend_m())
    };
    assert_eq!(read(&[]), (FlankModel::Elastic, 0.5e-3));
    assert_eq!(
        read(&["operation.axial_load_n=100"]),
        (FlankModel::Elastic, 0.5e-3)
    );
    assert_eq!(read(&["model.flanks=rigid"]), (FlankModel::Rigid, 0.0));
    assert_eq!(read(&["model.formulation=paper"]), (FlankModel::Rigid, 0.0));
    assert_eq!(
        read(&["contact.friction_law=coulomb"]),
        (FlankModel::Rigid, 0.0)
    );
    let (_, short_m) = read(&["raceway.half_angle_deg=4", "raceway.axial_span_mm=3"]);
    assert!((short_m - 0.2 * 4f64.to_radians() * 27.765e-3).abs() < 1e-15);
}

/// Without a regularisation speed it is a thousandth of the speed of rolling balls, ωi Ri/(Ri + Ro)·Rm, at most
/// 0.02 m/s, at any speed that replaces the one of the file; a drop, in which balls slide, has 0.02.
#[test]
fn the_regularisation_speed_follows_the_rolling_speed() {
    let silent = template(false).replace(
        "\nregularisation_speed_m_s = ",
        "\n# regularisation_speed_m_s = ",
    );
    let read = |text: &str, sets: &[&str]| {
        let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
        CaseFile::parse(text, "case.toml", &sets).unwrap()
    };
    let knee = |file: &CaseFile| file.case().contact.friction.regularisation_speed_m_s;
    // Rm = (Ro + Ri)/2.
    let rolling = |rpm: f64| rpm * std::f64::consts::TAU / 60.0 * 18.24e-3 / 2.0;
    let file = read(&silent, &[]);
    assert!((knee(&file) / (1e-3 * rolling(12_000.0)) - 1.0).abs() < 1e-12);
    let run = file.document_as_run();
    assert_eq!(
        run.number("contact.regularisation_speed_m_s"),
        Some(knee(&file))
    );
    // The document keeps it open, for another speed.
    let mut slow = file.document().clone();
    slow.set("operation.inner_speed_rpm", 600.0);
    let slow = CaseFile::from_document(slow, "case").unwrap();
    assert!((knee(&slow) / (1e-3 * rolling(600.0)) - 1.0).abs() < 1e-12);
    assert_eq!(
        knee(&read(&silent, &["operation.inner_speed_rpm=60000"])),
        0.02
    );
    assert_eq!(
        knee(&read(&template(false), &["operation.inner_speed_rpm=600"])),
        0.02
    );
    let drop = include_str!("../../../cases/touchdown-d.toml");
    assert!(
        !drop
            .split("[rotor]")
            .next()
            .unwrap()
            .contains("\nregularisation")
    );
    assert_eq!(knee(&read(drop, &[])), 0.02);
}

#[test]
fn defaults_that_were_filled_in_are_listed() {
    assert_eq!(
        parse(&template(false)).defaults(),
        [
            "bearing.assembly",
            "raceway.centre_angle_deg",
            "raceway.shape",
            "raceway.depth_um",
            "raceway.depth_error_um",
            "contact.regularisation",
            "contact.outer_friction_factor",
            "contact.ball_friction_factor",
            "contact.friction_strips",
            "contact.ball_restitution",
            "contact.inner_stiffness_n_m1_5",
            "contact.outer_stiffness_n_m1_5",
            "contact.ball_stiffness_n_m1_5",
            "model.motion",
            "start.state",
            "start.gaps",
            "start.lead_ball_angle_deg",
            "solver.method",
            "solver.step_us",
            "solver.tolerance",
            "solver.seed",
        ]
    );
    let bare = edited("schema = 1 ", "# ")
        .replace("title = ", "# ")
        .replace("method = ", "# ")
        .replace("# [start]", "[start]\nstate = \"rolling\" #");
    let file = parse(&bare);
    for key in [
        "schema",
        "title",
        "start.ring_x_um",
        "start.ring_y_um",
        "solver.method",
    ] {
        assert!(
            file.defaults().iter().any(|d| d == key),
            "{key}: {:?}",
            file.defaults()
        );
    }
    assert_eq!(
        (file.value("schema"), file.value("title")),
        (Some(1.into()), Some("".into()))
    );
    assert_eq!(file.document().number("start.ring_x_um"), Some(0.0));
}

#[test]
fn the_commented_lines_of_the_template_are_good_keys() {
    // "# key = value" is a key; "#  text" and the words of the head are not.
    let key = |line: &str| {
        let line = line.strip_prefix("# ")?;
        let named = line
            .split_once(" = ")
            .is_some_and(|(key, _)| !key.contains(' '));
        (named || line.starts_with('[')).then(|| line.to_owned())
    };
    let all: Vec<_> = without_film(&template(false))
        .lines()
        .map(|l| key(l).unwrap_or_else(|| l.to_owned()))
        .collect();
    let text = all
        .join("\n")
        .replace("state = \"settled\"", "state = \"rolling\"");
    let file = parse(&text);
    assert_eq!(file.defaults(), <[String; 0]>::default());
    assert_eq!(
        file.case().housing.as_ref().map(|h| h.stiffness_n_m),
        Some(1e8)
    );
    let width = file.document().number("bearing.outer_ring_width_mm");
    assert_eq!(width, Some(16.0));
}

#[test]
fn a_conventional_template_differs_in_nothing_but_the_raceway() {
    let conventional = parse(&template(true));
    assert!(conventional.case().raceways.is_empty());
    assert!(!template(true).contains("\naxial_span_mm"));
    let with = parse(&template(false));
    assert_eq!(conventional.case().bearing, with.case().bearing);
    assert_eq!(conventional.case().contact, with.case().contact);
}

#[test]
fn every_case_that_comes_with_cageless_is_good() {
    let files = cases();
    assert!(!files.is_empty());
    for path in files {
        let file = CaseFile::read(&path, &[]).unwrap_or_else(|e| panic!("{e}"));
        assert!(!file.particulars().title.is_empty(), "{}", path.display());
        let name = path.to_string_lossy();
        let conventional = ["conventional", "full-", "6205"]
            .iter()
            .any(|part| name.contains(part));
        assert_eq!(
            file.case().raceways.is_empty(),
            conventional,
            "{}",
            path.display()
        );
    }
}

#[test]
fn the_ten_structures_are_those_of_table_2() {
    let table = [
        (4.95, 35.0),
        (5.0, 30.5),
        (5.05, 27.5),
        (5.1, 25.2),
        (5.15, 23.5),
        (5.2, 22.0),
        (5.4, 18.167),
        (5.6, 15.774),
        (5.8, 14.062),
        (6.0, 12.717),
    ];
    let files: Vec<_> = cases()
        .into_iter()
        .filter(|p| p.to_string_lossy().contains("zhao-"))
        .collect();
    assert_eq!(files.len(), table.len());
    for (path, (span, angle)) in files.iter().zip(table) {
        let file = CaseFile::read(path, &[]).unwrap();
        let number = |key: &str| file.document().number(key);
        assert_eq!(
            (
                number("raceway.axial_span_mm"),
                number("raceway.half_angle_deg")
            ),
            (Some(span), Some(angle))
        );
        let letter = path.to_string_lossy().replace(".toml", "").pop().unwrap();
        let title = format!("Zhao 2022, structure ({letter}): lC {span} mm, θ {angle}°");
        let numbers = |s: &str| s.replace(".0 ", " ").replace(".0°", "°");
        assert_eq!(numbers(&file.particulars().title), numbers(&title));
    }
}

#[test]
fn a_document_goes_to_toml_and_back() {
    let mut texts: Vec<String> = cases()
        .iter()
        .map(|p| std::fs::read_to_string(p).unwrap())
        .collect();
    let gap = parse(&template(false))
        .case()
        .bearing
        .nominal_gap_rad()
        .to_degrees();
    texts.push(edited(
        "# [start]",
        &format!("[start]\ngaps = {:?} #", [gap; 14]),
    ));
    texts.push(edited(
        "[raceway]",
        "[[raceway]]\naxial_span_mm = 5.2\nhalf_angle_deg = 20\ncentre_angle_deg = 180\n[[raceway]]",
    ));
    texts.push(edited(
        "balls = 14",
        &format!("balls = 14\nball_radius_deviation_um = {:?}", [0.0; 14]),
    ));
    texts.push(edited(
        "balls = 14",
        &format!("balls = 14\nball_radius_deviation_um = {:?}", [-0.25; 14]),
    ));
    for text in texts {
        let file = parse(&text);
        let toml = file.document().to_toml().unwrap();
        let back = parse(&toml);
        assert_eq!(back.case(), file.case(), "{toml}");
        assert_eq!(back.document(), file.document(), "{toml}");
        // Without defaults they are taken again, and known as such.
        let given = file.document().to_toml_without(file.defaults()).unwrap();
        let given = parse(&given);
        assert_eq!(given.case(), file.case(), "{toml}");
        // Raceways and rows are complete, so theirs are given, but for what follows from the rest.
        let of_lists = |key: &str| ["raceway", "row."].iter().any(|own| key.starts_with(own));
        let [defaults, given] = [&file, &given].map(|file| {
            let mut defaults = file.defaults().to_vec();
            defaults.retain(|key| !of_lists(key));
            defaults
        });
        assert_eq!(given, defaults, "{toml}");
        let again = CaseFile::from_document(file.document().clone(), "document").unwrap();
        assert_eq!(again.case(), file.case());
        // What is recorded as run parses too, and its stiffnesses are those of Hertz.
        let run = parse(&file.document_as_run().to_toml().unwrap());
        assert_eq!(run.case().bearing, file.case().bearing);
        let [_, used, _] = file.case().stiffness_n_m1_5();
        assert_eq!(run.case().contact.outer_stiffness_n_m1_5, Some(used));
    }
}

#[test]
fn the_document_has_exactly_the_keys_of_the_file() {
    fn keys(prefix: &str, value: &serde_json::Value, all: &mut BTreeSet<String>) {
        match value {
            serde_json::Value::Object(map) => {
                map.iter()
                    .for_each(|(k, v)| keys(&format!("{prefix}.{k}"), v, all));
            }
            _ => {
                all.insert(prefix.trim_start_matches('.').to_owned());
            }
        }
    }
    let file = parse(&template(false));
    let json = serde_json::to_value(file.document()).unwrap();
    assert_eq!(json["raceway"]["axial_span_mm"], 5.1);
    assert_eq!(json["start"]["gaps"], "uniform");
    assert_eq!(json["model"]["formulation"], "physical");
    assert_eq!(json["bearing"]["balls"], 14);
    let mut all = BTreeSet::new();
    keys("", &json, &mut all);
    // Every key of the document can be set.
    for key in &all {
        let value = key.split('.').fold(&json, |value, part| &value[part]);
        let set = format!("{key}={value}");
        let again = CaseFile::parse(&template(false), "t", std::slice::from_ref(&set));
        let again = again.unwrap_or_else(|error| panic!("{set}: {error}"));
        assert_eq!(again.case(), file.case(), "{set}");
        assert_eq!(again.particulars(), file.particulars(), "{set}");
    }
    assert_eq!(all.len(), 47, "{all:?}");
}

#[test]
fn overrides_win_over_the_file_and_the_last_over_the_first() {
    let sets = |sets: &[&str]| {
        let sets: Vec<_> = sets.iter().map(|s| (*s).to_owned()).collect();
        CaseFile::parse(&template(true), "case.toml", &sets).unwrap_or_else(|e| panic!("{e}"))
    };
    let file = sets(&[
        "operation.inner_speed_rpm=3000",
        "raceway.axial_span_mm = 5.0",
        "raceway.axial_span_mm=5.2",
        "raceway.half_angle_deg=22",
        "model.formulation=paper",
        "contact.friction_law=\"coulomb\"",
        "title=as a test",
        "start.state=rolling",
        "start.ring_y_um=-10",
        "solver.seed=0x10",
        "contact.outer_stiffness_n_m1_5=1.3e10",
    ]);
    let case = file.case();
    assert_eq!(file.value("operation.inner_speed_rpm"), Some(3000.0.into()));
    assert_eq!(case.raceways[0].dimensions().axial_span_m, 5.2e-3);
    assert_eq!(
        (case.formulation, case.contact.friction_law),
        (Formulation::Paper, FrictionModel::Coulomb)
    );
    let named = file.particulars();
    assert_eq!((named.title.as_str(), named.seed), ("as a test", 16));
    assert_eq!(case.contact.outer_stiffness_n_m1_5, Some(1.3e10));
    assert!(
        matches!(
            case.start.state,
            StartState::Rolling {
                ring_y_m: -1e-5,
                ..
            }
        ),
        "{:?}",
        case.start
    );
    let gap = case.bearing.nominal_gap_rad().to_degrees();
    let file = sets(&[&format!("start.gaps={:?}", vec![gap; 14])]);
    assert_eq!(
        file.value("start.gaps"),
        Some(CaseValue::Numbers(vec![gap; 14]))
    );
}

#[test]
fn fifteen_balls_just_fit() {
    assert_eq!(
        parse(&edited("balls = 14", "balls = 15.0"))
            .case()
            .bearing
            .balls(),
        15
    );
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let text = String::from_utf8_lossy(&bytes);
        let _ = CaseFile::parse(&text, "noise", &[]);
        let _ = CaseFile::parse(&template(false), "template", &[text.into_owned()]);
    }

    #[test]
    fn no_mutation_of_the_template_makes_the_reader_panic(
        edits in proptest::collection::vec((any::<prop::sample::Index>(), 0usize..4, any::<u8>()), 1..6)
    ) {
        let mut bytes = template(false).into_bytes();
        for (index, kind, byte) in edits {
            let at = index.index(bytes.len());
            match kind {
                0 => bytes[at] = byte % 128,
                1 => bytes.insert(at, byte % 128),
                2 => { bytes.remove(at); }
                // Numbers grow and shrink.
                _ => bytes.splice(at..at, *b"9e9").for_each(drop),
            }
        }
        let _ = CaseFile::parse(&String::from_utf8_lossy(&bytes), "mutant", &[]);
    }

    #[test]
    fn no_value_of_any_key_makes_the_reader_panic(
        key in prop::sample::select(numeric_keys()),
        value in prop_oneof![
            any::<f64>().prop_map(|v| format!("{v:e}")),
            any::<i64>().prop_map(|v| v.to_string()),
            (-300i32..300).prop_map(|e| format!("1e{e}")),
            (0.5f64..2.0).prop_map(|v| v.to_string()),
            Just("[]".to_owned()),
            Just("{}".to_owned()),
            Just("[[1, 2], {}]".to_owned()),
        ],
    ) {
        let set = format!("{key}={value}");
        if let Err(error) = CaseFile::parse(&template(false), "template", &[set]) {
            prop_assert!(error.key().is_some());
        }
    }
}

fn numeric_keys() -> Vec<String> {
    let mut section = String::new();
    let mut keys = Vec::new();
    for line in template(false).lines() {
        let line = line.trim_start_matches("# ");
        if let Some(name) = line.strip_prefix('[') {
            section = format!("{}.", name.split(']').next().unwrap());
        } else if let Some((key, _)) = line.split_once(" = ")
            && !key.contains(' ')
        {
            keys.push(format!("{section}{key}"));
        }
    }
    keys
}

/// Text of the template without the lines that `left_out` names.
fn template_without(left_out: impl Fn(&str, &str) -> bool) -> String {
    let mut section = String::new();
    let text = template(false);
    let kept = text.lines().filter(|line| {
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.split(']').next()) {
            section = name.to_owned();
        }
        !left_out(&section, line)
    });
    kept.map(|line| format!("{line}\n")).collect()
}

#[test]
fn sections_that_are_left_out_take_the_values_of_the_template() {
    let optional = ["material", "contact", "model", "solver", "output"];
    let short = template_without(|section, line| {
        optional.contains(&section) || line.starts_with("gravity_m_s2")
    });
    assert!(!short.contains("youngs_modulus_gpa =") && !short.contains("\n[output]"));
    let short = CaseFile::parse(&short, "short.toml", &[]).unwrap();
    // The flanks of the paper are not those of a real bearing, the regularisation speed is one for all.
    let real = template(false).replace("flanks = ", "# flanks = ").replace(
        "\nregularisation_speed_m_s = ",
        "\n# regularisation_speed_m_s = ",
    );
    let full = CaseFile::parse(&real, "full.toml", &[]).unwrap();
    assert_eq!(short.document(), full.document());
    assert_eq!(short.case(), full.case());
    for key in [
        "material.youngs_modulus_gpa",
        "operation.gravity_m_s2",
        "contact.damping_n_s_m1_5",
        "model.formulation",
        "solver.duration_s",
        "output.interval_us",
    ] {
        assert!(short.defaults().iter().any(|d| d == key), "{key}");
        assert!(!full.defaults().iter().any(|d| d == key), "{key}");
    }
}

#[test]
fn coulomb_friction_needs_no_scale_of_the_smooth_law() {
    let text = template_without(|_, line| line.starts_with("regularisation_speed_m_s"))
        .replace("friction_law = \"smooth\"", "friction_law = \"coulomb\"");
    let file = CaseFile::parse(&text, "case.toml", &[]).unwrap();
    assert!(
        file.defaults()
            .contains(&"contact.regularisation_speed_m_s".to_owned())
    );
}

#[test]
fn every_value_has_its_source_and_unit() {
    let sets = ["raceway.half_angle_deg=24".to_owned(), "seed=7".to_owned()];
    let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
    for (key, source) in [
        ("raceway.half_angle_deg", Source::Override),
        ("solver.seed", Source::Override),
        ("raceway.axial_span_mm", Source::CaseFile),
        ("title", Source::CaseFile),
        ("contact.ball_restitution", Source::Default),
        ("contact.inner_stiffness_n_m1_5", Source::Default),
    ] {
        assert_eq!(file.source(key), source, "{key}");
    }
    for (key, printed) in [
        ("raceway.2.half_angle_deg", "°"),
        ("output.interval_us", "µs"),
        ("contact.damping_n_s_m1_5", "N·s/m^1.5"),
        ("model.formulation", ""),
    ] {
        assert_eq!(unit(key), printed, "{key}");
    }
}

/// The raceway of a profile: lC and θ are its own unless they are given, also in a file with several.
#[test]
fn a_profile_has_its_own_dimensions() {
    let shuttle = |psi: f64| 20.0 * (1.0 - (psi / 25.0).powi(2));
    let rows = [0.0, 5.0, 10.0, 15.0, 20.0, 25.0].map(|psi| format!("[{psi}, {}]", shuttle(psi)));
    let profile = format!("shape = \"measured\"\nprofile = [{}]", rows.join(", "));
    let raceway = |own: &str| {
        let text = template(false);
        let given = |line: &&str| !line.starts_with("half_angle_deg");
        let own = |line| {
            if str::starts_with(line, "axial_span_mm") {
                own
            } else {
                line
            }
        };
        parse(
            &text
                .lines()
                .filter(given)
                .map(own)
                .collect::<Vec<_>>()
                .join("\n"),
        )
    };
    let file = raceway(&profile);
    let dimensions = *file.case().raceways[0].dimensions();
    let span = 2.0 * 4.7625e-3 * 20f64.to_radians().sin();
    assert!((dimensions.axial_span_m - span).abs() < 1e-12);
    assert!((dimensions.half_angle_rad.to_degrees() - 25.0).abs() < 1e-12);
    assert_eq!(file.document().value("raceway.axial_span_mm"), None);
    let run = file.document_as_run();
    assert!((run.number("raceway.axial_span_mm").unwrap() - span * 1e3).abs() < 1e-4);
    assert_eq!(run.number("raceway.half_angle_deg"), Some(25.0));
    let again = CaseFile::from_document(run, "run").unwrap();
    let stretched = raceway(&format!(
        "{profile}\naxial_span_mm = 5.0\nhalf_angle_deg = 20"
    ));
    for (file, span, half_angle) in [(&again, span, 25.0), (&stretched, 5e-3, 20.0)] {
        let d = *file.case().raceways[0].dimensions();
        assert!((d.axial_span_m - span).abs() < 1e-7);
        assert!((d.half_angle_rad.to_degrees() - half_angle).abs() < 1e-12);
    }
}

/// Rows are a list in JSON and TOML, also one of them; a single raceway is a section.
#[test]
fn one_row_is_a_list() {
    let text = template(false) + "\n[[row]]\naxial_position_mm = 0\n";
    let file = CaseFile::parse(&text, "template", &[]).unwrap();
    let json = serde_json::to_value(file.document()).unwrap();
    assert_eq!(json["row"].as_array().map(Vec::len), Some(1), "{json}");
    assert!(json["raceway"].is_object(), "{json}");
    for text in [json.to_string(), file.document().to_toml().unwrap()] {
        let again = CaseFile::parse(&text, "again", &[]).unwrap();
        assert_eq!(again.case(), file.case(), "{text}");
    }
}

/// Bunched balls sit at different contact angles under an axial load, and touch a little deeper than in the plane.
#[test]
fn bunched_balls_settle_under_an_axial_load() {
    for axial in ["300", "2000"] {
        let sets = [
            "start.gaps=bunched".to_owned(),
            format!("operation.axial_load_n={axial}"),
            "model.motion=space".to_owned(),
        ];
        let file = CaseFile::parse(&template(false), "template", &sets).unwrap();
        cageless::initial_state(file.case()).unwrap();
    }
}

/// What a file leaves out is what the library takes: the same case from a file and from the builder.
#[test]
fn defaults_of_files_are_those_of_the_library() {
    let text = "[bearing]\nballs = 14\nball_radius_mm = 4.7625\npitch_diameter_mm = 46\n\
        radial_internal_clearance_um = 0\n[operation]\ninner_speed_rpm = 12000\nradial_load_n = 1500\n";
    let file = CaseFile::parse(text, "a case", &[]).unwrap();
    let (case, operation) = (file.case(), &file.case().operation);
    let built = cageless::CaseBuilder::of(case.bearing.clone())
        .inner_speed_rad_s(operation.inner_speed_rad_s)
        .radial_load_n(operation.radial_load_n);
    assert_eq!(case, &built.build().unwrap());
    let estimated = cageless::BearingDimensions::estimated(14, 4.7625e-3, 23e-3);
    let found = case.bearing.dimensions();
    let masses = [estimated.inner_ring_mass_kg, found.inner_ring_mass_kg];
    // Files state six digits of a mass.
    assert!((masses[0] / masses[1] - 1.0).abs() < 1e-6, "{masses:?}");
    let shoulders = [
        estimated.outer_shoulder_radius_m,
        found.outer_shoulder_radius_m,
    ];
    assert!((shoulders[0] - shoulders[1]).abs() < 1e-9, "{shoulders:?}");
}

/// The summary of a drop is the case of its only bearing; of a rotor file it has no rotor to drop again.
#[test]
fn a_summary_of_a_drop_is_the_case_that_was_dropped() {
    let file = CaseFile::parse(&template(false), "case.toml", &[]).unwrap();
    let case = serde_json::to_string(&file.document_as_run()).unwrap();
    let read = |kind: &str| {
        let bearing =
            format!("{{\"case\": {case}, \"defaults\": [\"contact.inner_stiffness_n_m1_5\"]}}");
        let summary = format!("{{\"file\": \"{kind}\", \"bearings\": [{bearing}]}}");
        CaseFile::parse(&summary, "summary.json", &[])
    };
    let of_case = read("case").unwrap();
    assert_eq!(of_case.case().bearing, file.case().bearing);
    // Derived, so it is derived again.
    let stiffness = |end: &str| format!("contact.{end}_stiffness_n_m1_5");
    let given = |end: &str| of_case.document().number(&stiffness(end));
    assert!(given("inner").is_none() && given("outer").is_some());
    let refused = read("rotor").unwrap_err().to_string();
    assert!(
        refused.contains("rotor.toml of the same folder"),
        "{refused}"
    );
}
