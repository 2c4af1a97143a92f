//! Bearings as engineers state them: diameters, conformities, clearance, materials by name,
//! cases in JSON.

use crate::common::refused;
use cageless::Gaps;
use cageless_io::case_file::MaterialHeat;
use cageless_io::case_file::{CaseFile, MaterialPreset};
use cageless_io::plan_file::PlanFile;

const SHORT: &str = "[bearing]\nballs = 14\nball_diameter_mm = 9.525\npitch_diameter_mm = 46.005\n\
    radial_internal_clearance_um = 12\n[operation]\ninner_speed_rpm = 12000\nradial_load_n = 1500\n";

fn parse(text: &str, sets: &[&str]) -> CaseFile {
    let sets: Vec<_> = sets.iter().map(|s| (*s).to_owned()).collect();
    CaseFile::parse(text, "case.toml", &sets).unwrap_or_else(|e| panic!("{e}"))
}

/// Ri + Ro = Dpw, 2 (Ro − Ri − 2 Rw) = Gr, groove radius = f Dw.
#[test]
fn diameters_conformities_and_clearance_stand_for_radii() {
    let file = parse(SHORT, &["bearing.inner_conformity=0.515"]);
    let d = file.case().bearing.dimensions().clone();
    let (inner, outer) = (
        d.inner_groove_bottom_radius_m,
        d.outer_groove_bottom_radius_m,
    );
    assert_eq!(d.ball_radius_m, 4.7625e-3);
    assert!((inner + outer - 46.005e-3).abs() < 1e-15);
    assert!((2.0 * (outer - inner - 2.0 * d.ball_radius_m) - 12e-6).abs() < 1e-15);
    assert!((file.case().bearing.radial_internal_clearance_m() - 12e-6).abs() < 1e-12);
    assert!((d.inner_groove_curvature_radius_m - 0.515 * 9.525e-3).abs() < 1e-15);
    assert!((d.outer_groove_curvature_radius_m - 0.52 * 9.525e-3).abs() < 1e-15);
    // What is estimated is said, with its value.
    let assumed: Vec<_> = file.assumptions().into_iter().map(|a| a.key).collect();
    let expected = [
        "bearing.outer_shoulder_radius_mm",
        "bearing.outer_conformity",
        "bearing.inner_ring_mass_kg",
    ];
    assert_eq!(assumed, expected);
    assert!(
        expected
            .iter()
            .all(|k| file.defaults().iter().any(|d| d == k))
    );
    assert!((d.outer_shoulder_radius_m - (outer - 0.2 * 9.525e-3)).abs() < 1e-7);
    assert!((0.05..0.2).contains(&d.inner_ring_mass_kg));
    // Higher shoulders are heavier.
    let shoulder = format!("bearing.inner_shoulder_radius_mm={}", 1e3 * inner + 2.5);
    let higher = parse(SHORT, &[&shoulder]);
    let high = higher.case().bearing.dimensions();
    assert!((high.inner_shoulder_radius_m.unwrap() - inner - 2.5e-3).abs() < 1e-9);
    let area = |height_m: f64| (inner + height_m).powi(2) - (inner - 0.3 * 9.525e-3).powi(2);
    let ratio = area(2.5e-3) / area(0.2 * 9.525e-3);
    assert!((high.inner_ring_mass_kg / d.inner_ring_mass_kg / ratio - 1.0).abs() < 1e-4);
}

#[test]
fn what_says_the_same_twice_is_refused_and_a_later_one_replaces_it() {
    for (key, text) in [
        ("ball_radius_mm = 4.7625", "bearing.ball_diameter_mm"),
        (
            "inner_groove_bottom_radius_mm = 18.24",
            "bearing.pitch_diameter_mm",
        ),
    ] {
        let error = refused(
            &SHORT.replace("balls = 14", &format!("balls = 14\n{key}")),
            &[],
        );
        assert_eq!(error.key(), Some(text));
        let message = error.to_string();
        assert!(
            message.contains("both say the same, give one of them"),
            "{message}"
        );
    }
    let file = parse(SHORT, &["bearing.ball_radius_mm=4.7"]);
    assert_eq!(file.case().bearing.ball_radius_m(), 4.7e-3);
    // Interference is a clearance below zero, down to the pressure limit of ISO 76.
    let preloaded = parse(SHORT, &["bearing.radial_internal_clearance_um=-8"]);
    let clearance = 0.5 * preloaded.case().bearing.radial_internal_clearance_m();
    assert!((clearance + 4e-6).abs() < 1e-12, "{clearance:e}");
    let error = refused(SHORT, &["bearing.radial_internal_clearance_um=-800"]);
    assert_eq!(error.key(), Some("bearing.radial_internal_clearance_um"));
    let message = error.message();
    assert!(message.contains("= -800 is not possible"), "{message}");
    let number = message.split("at least ").nth(1).unwrap();
    let least: f64 = number.split(' ').next().unwrap().parse().unwrap();
    parse(
        SHORT,
        &[&format!(
            "bearing.radial_internal_clearance_um={}",
            least + 0.5
        )],
    );
    refused(
        SHORT,
        &[&format!(
            "bearing.radial_internal_clearance_um={}",
            least - 0.5
        )],
    );
    // What else a radius, a pitch diameter or a clearance needs is that of the file; two of --set must not be at odds.
    let bottoms_mm = |text: &str, set: &str| {
        let case = parse(text, &[set]).case().clone();
        let d = case.bearing.dimensions();
        [
            d.inner_groove_bottom_radius_m,
            d.outer_groove_bottom_radius_m,
        ]
        .map(|m| 1e3 * m)
    };
    let (inner, pitch) = (
        "bearing.inner_groove_bottom_radius_mm=18.23",
        "bearing.pitch_diameter_mm=47",
    );
    let by_radii = SHORT.replace(
        "pitch_diameter_mm = 46.005\nradial_internal_clearance_um = 12",
        "inner_groove_bottom_radius_mm = 18.24\nouter_groove_bottom_radius_mm = 27.765",
    );
    // 46.005/2 + 4.7625 + 0.003, and 47/2 ∓ 4.7625 as without clearance.
    for (text, set, expected) in [
        (SHORT, inner, [18.23, 27.768]),
        (&by_radii, pitch, [18.7375, 28.2625]),
    ] {
        let found = bottoms_mm(text, set);
        let near = (0..2).all(|k| (found[k] - expected[k]).abs() < 1e-8);
        assert!(near, "{set}: {found:?} {expected:?}");
    }
    let clearance = "bearing.radial_internal_clearance_um=20";
    for sets in [[inner, clearance], [clearance, inner], [pitch, inner]] {
        let error = refused(SHORT, &sets).to_string();
        assert!(error.contains("another --set gives "), "{sets:?}: {error}");
    }
    let error = refused(&SHORT.replace("radial_internal", "# "), &[]);
    assert_eq!(error.key(), Some("bearing.radial_internal_clearance_um"));
    // A value that follows from others names them.
    let error = refused(SHORT, &["bearing.inner_conformity=0.4"]);
    assert_eq!(error.key(), Some("bearing.inner_conformity"));
    assert!(
        error
            .message()
            .contains("inner_conformity times the ball diameter"),
        "{error}"
    );
}

/// The mass of the balls is of their material, and K ∝ E* with 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
#[test]
fn a_hybrid_bearing_has_light_balls_and_stiffer_contacts() {
    let hybrid = parse(SHORT, &["ball_material.preset=Si3N4"]);
    let steel = parse(SHORT, &[]);
    let [ours, theirs] = [&hybrid, &steel].map(|file| file.case().stiffness_n_m1_5());
    let (hybrid, steel) = (&hybrid.case().bearing, &steel.case().bearing);
    let [density, modulus, poisson] = MaterialPreset::SiliconNitride.numbers();
    let ratio = hybrid.ball_mass_kg() / steel.ball_mass_kg();
    assert!((ratio / (density / 7850.0) - 1.0).abs() < 1e-12);
    let ceramic = (1.0 - poisson * poisson) / (modulus * 1e9);
    let ring = (1.0 - 0.09) / 206e9;
    let raceway = 2.0 * ring / (ceramic + ring);
    let expected = [raceway, raceway, ring / ceramic];
    for ((one, other), expected) in ours.into_iter().zip(theirs).zip(expected) {
        let ratio = one / other;
        assert!((ratio / expected - 1.0).abs() < 1e-9, "{ratio} {expected}");
    }
}

#[test]
fn materials_have_a_name_or_three_numbers() {
    for (sets, key, words) in [
        (
            vec!["material.preset=M51"],
            "material.preset",
            "\"100Cr6\", \"M50\"",
        ),
        (
            vec!["ball_material.density_kg_m3=3200"],
            "ball_material.youngs_modulus_gpa",
            "or give ball_material.preset",
        ),
        (
            vec![
                "ring_material.preset=M50",
                "ring_material.poisson_ratio=0.3",
                "ring_material.density_kg_m3=7850",
                "ring_material.youngs_modulus_gpa=206000",
            ],
            "ring_material.youngs_modulus_gpa",
            "at most 1300 GPa",
        ),
    ] {
        let error = refused(SHORT, &sets);
        assert_eq!(error.key(), Some(key), "{error}");
        assert!(error.message().contains(words), "{error}");
    }
    let both = format!("{SHORT}[material]\npreset = \"M50\"\ndensity_kg_m3 = 7000\n");
    let error = refused(&both, &[]);
    assert!(
        error
            .message()
            .contains("left out with material.preset = \"M50\""),
        "{error}"
    );
}

#[test]
fn balls_start_in_one_group_or_anywhere_by_seed() {
    let gaps = |sets: &[&str]| match parse(SHORT, sets).case().start.gaps.clone() {
        Gaps::List(gaps) => gaps,
        Gaps::Uniform => panic!("uniform"),
    };
    let bunched = gaps(&["start.gaps=bunched"]);
    let room: f64 = bunched.iter().sum();
    let within = 0.05 * room / 14.0;
    assert!(bunched[..13].iter().all(|g| (g - within).abs() < 1e-12) && bunched[13] > 0.4);
    let random = |seed: &str| gaps(&["start.gaps=random", seed]);
    let one = random("seed=1");
    assert_eq!(one, random("seed=1"));
    assert_ne!(one, random("seed=2"));
    assert!((one.iter().sum::<f64>() - room).abs() < 1e-12);
}

/// A result file with the case as it was run gives the same case, to the bit.
#[test]
fn a_case_is_repeated_from_the_json_of_its_result() {
    for sets in [
        &[
            "bearing.inner_ring_mass_kg=0.30000000000000004",
            "operation.radial_load_n=1499.9999999999998",
        ][..],
        &["ball_material.preset=Si3N4", "start.gaps=random", "seed=5"],
        &["bearing.ball_radius_deviation_um=[0.1,0.2,0,0,0,0,0,0,0,0,0,0,0,0]"],
        &["solver.step_us=1.7000000000000002"],
    ] {
        let file = parse(SHORT, sets);
        let json = serde_json::json!({
            "case": serde_json::to_value(file.document_as_run()).unwrap(),
            "defaults": file.defaults(),
        });
        let again = parse(&json.to_string(), &[]);
        assert_eq!(again.case(), file.case(), "{sets:?}");
        let bare = serde_json::to_string(file.document()).unwrap();
        assert_eq!(parse(&bare, &[]).case(), file.case());
        let faster = parse(&json.to_string(), &["operation.inner_speed_rpm=6000"]);
        assert_ne!(faster.case(), file.case());
    }
    let error = refused("{\"bearing\": {\"balls\": 14, \"colour\": 1}}", &[]);
    assert_eq!(error.key(), Some("bearing.colour"));
    assert!(
        refused("{\n\"bearing\": 1,}", &[])
            .to_string()
            .starts_with("case.toml:2: is not JSON")
    );
}

/// A clockwise bearing is the counter-clockwise one seen from its other face.
#[test]
fn a_negative_speed_turns_clockwise() {
    let plain = parse(SHORT, &[]);
    let file = parse(SHORT, &["operation.inner_speed_rpm=-12000"]);
    assert!(!plain.case().operation.clockwise && plain.case().operation.view().is_empty());
    let operation = &file.case().operation;
    assert!(operation.clockwise && operation.view().contains("other face"));
    assert_eq!(
        operation.inner_speed_rad_s,
        plain.case().operation.inner_speed_rad_s
    );
    // The file keeps what was asked for.
    let again = parse(&file.document().to_toml().unwrap(), &[]);
    assert_eq!(again.case(), file.case());

    let table = "operation.inner_speed_rpm=[[0.0, 0.0], [1.0, -6000.0]]";
    let file = parse(SHORT, &[table]);
    let operation = &file.case().operation;
    assert!(operation.clockwise);
    let speeds = operation.inner_speed_table.as_ref().expect("a table");
    assert_eq!(speeds.value(1.0), 6000.0 * std::f64::consts::TAU / 60.0);

    let both = "operation.inner_speed_rpm=[[0.0, 100.0], [1.0, -6000.0]]";
    let error = refused(SHORT, &[both]).to_string();
    assert!(error.contains("inner_speed_rpm"), "{error}");
    assert!(error.contains("one sense of rotation"), "{error}");
}

/// A clearance given for a bearing with groove radii keeps its pitch diameter.
#[test]
fn a_clearance_takes_the_place_of_the_groove_radii() {
    let radii = SHORT.replace(
        "pitch_diameter_mm = 46.005\nradial_internal_clearance_um = 12",
        "inner_groove_bottom_radius_mm = 18.24\nouter_groove_bottom_radius_mm = 27.765",
    );
    let file = parse(&radii, &["bearing.radial_internal_clearance_um=5"]);
    let bearing = &file.case().bearing;
    assert!((bearing.radial_internal_clearance_m() - 5e-6).abs() < 1e-12);
    assert!((2.0 * bearing.pitch_radius_m() - 46.005e-3).abs() < 1e-12);
}

#[test]
fn a_friction_table_gives_the_coefficient() {
    let table = format!(
        "{SHORT}[contact]\nfriction_law = \"table\"\nfriction_table = [[0, 0.3], [0.5, 0.2]]\n"
    );
    assert_eq!(parse(&table, &[]).case().contact.friction.coefficient, 0.2);
    let zero = parse(SHORT, &["contact.friction_coefficient=-0.0"]);
    let mu = zero.case().contact.friction.coefficient;
    assert!(mu == 0.0 && mu.is_sign_positive());
    let error = refused(SHORT, &["bearing.outer_conformity=1e308"]);
    assert_eq!(error.key(), Some("bearing.outer_conformity"));
    assert!(error.message().contains("at most 1"), "{error}");
}

#[test]
fn keys_of_a_plan_may_stand_in_quotes() {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases"));
    let plan = |set: &str| {
        let text = format!("case = \"zhao-d.toml\"\ncompute = [\"static\"]\n[set]\n{set}\n");
        PlanFile::parse(&text, "plan.toml", folder)
    };
    let quoted = plan("\"solver.duration_s\" = 0.125\n\"raceway.half_angle_deg\" = 24.5").unwrap();
    let plain = plan("solver.duration_s = 0.125\nraceway.half_angle_deg = 24.5").unwrap();
    let case = |plan: &PlanFile| plan.base_file.cases()[0].case().clone();
    assert_eq!(case(&quoted), case(&plain));
    assert_eq!(case(&quoted).solver.duration_s, 0.125);
    let error = plan("\"solver.durations_s\" = 0.1").unwrap_err();
    assert!(
        error.message().contains("did you mean duration_s"),
        "{error}"
    );
    let error = plan("\"solver.duration_s\" = 0.1\nsolver.duration_s = 0.2").unwrap_err();
    assert!(error.message().contains("given twice"), "{error}");
}

/// Every material by name with its numbers, one by one: density, E and ν of data sheets (100Cr6: 7.81 g/cm³, 210 GPa; M50:
/// 7.87 g/cm³, 203 GPa; 440C: 7.7 g/cm³, 200 GPa; Cronidur 30: 7.72 g/cm³, 213 GPa; Si3N4: 3.24 g/cm³, 310 GPa), specific
/// heat, expansion and the temperature that softens it by the sources at `MaterialPreset`.
#[test]
fn materials_by_name_have_the_numbers_of_their_sources() {
    let steel = Some(200.0);
    let known = [
        ("100Cr6", [7810.0, 210.0, 0.3], [460.0, 12.5e-6], steel),
        ("M50", [7870.0, 203.0, 0.29], [470.0, 11.8e-6], Some(316.0)),
        ("440C", [7700.0, 200.0, 0.28], [460.0, 10.2e-6], steel),
        (
            "X30CrMoN15-1",
            [7720.0, 213.0, 0.28],
            [460.0, 10.5e-6],
            steel,
        ),
        ("Si3N4", [3240.0, 310.0, 0.27], [800.0, 3.2e-6], None),
    ];
    let names: Vec<&str> = MaterialPreset::all().map(|(name, _)| name).collect();
    assert_eq!(names, known.map(|(name, ..)| name));
    for ((name, numbers, [specific, expansion], softening_c), (_, preset)) in
        known.into_iter().zip(MaterialPreset::all())
    {
        assert_eq!(preset.numbers(), numbers, "{name}");
        let heat = MaterialHeat {
            specific_heat_j_kg_k: specific,
            expansion_per_k: expansion,
            softening_c,
        };
        assert_eq!(preset.heat(), heat, "{name}");
        // As a case has them, of the balls alone and of all.
        let [density, gigapascals, ratio] = numbers;
        let found = |sets: &[&str]| {
            let file = parse(SHORT, sets);
            let materials = *file.case().bearing.materials();
            (
                materials,
                file.particulars().thermal.clone(),
                file.softening_c(),
            )
        };
        let key = format!("ball_material.preset={name}");
        let (materials, thermal, softening) = found(&[&key]);
        let own = materials.ball;
        let expected = [density, 1e9 * gigapascals, ratio];
        assert_eq!(
            [own.density_kg_m3, own.youngs_modulus_pa, own.poisson_ratio],
            expected,
            "{name}"
        );
        assert_eq!(materials.ring.youngs_modulus_pa, 206e9, "{name}");
        assert_eq!(thermal.ball_specific_heat_j_kg_k, Some(specific), "{name}");
        assert_eq!(thermal.ring_specific_heat_j_kg_k, None, "{name}");
        assert_eq!(softening, [steel, softening_c, steel], "{name}");
        let key = format!("material.preset={name}");
        let (materials, thermal, softening) = found(&[&key]);
        let [ring, ball] = [materials.ring, materials.ball];
        assert_eq!(ring, ball, "{name}");
        assert_eq!(ring.youngs_modulus_pa, 1e9 * gigapascals, "{name}");
        assert_eq!(thermal.ring_specific_heat_j_kg_k, Some(specific), "{name}");
        assert_eq!(softening, [softening_c; 3], "{name}");
    }
    // Another material than steel by numbers needs its thermal ones, with the speed of regularisation given or not.
    let ceramic = [
        "ball_material.density_kg_m3=3200",
        "ball_material.youngs_modulus_gpa=300",
        "ball_material.poisson_ratio=0.26",
    ];
    for more in [&[][..], &["contact.regularisation_speed_m_s=0.02"]] {
        let file = parse(SHORT, &[&ceramic, more].concat());
        let missing = [
            "thermal.ball_specific_heat_j_kg_k",
            "fit.ball_expansion_per_k",
        ];
        assert_eq!(file.missing_of_heat(true), missing);
        assert_eq!(file.missing_of_heat(false), missing[..1]);
        assert_eq!(file.softening_c(), [steel, None, steel]);
    }
    // Bearing steel where nothing is said.
    let steel = parse(SHORT, &[]);
    let own = steel.case().bearing.materials().ring;
    assert_eq!(
        [own.density_kg_m3, own.youngs_modulus_pa, own.poisson_ratio],
        [7850.0, 206e9, 0.3]
    );
}
