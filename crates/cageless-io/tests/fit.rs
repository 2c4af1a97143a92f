//! `[fit]` moves the inner groove once, where a file becomes a bearing.

use cageless_io::case_file::{CaseFile, template};

const DIAMETERS: &str = "\n[fit]\nbore_diameter_mm = 30.0\noutside_diameter_mm = 62.0\n";

fn parse(text: &str, sets: &[&str]) -> Result<CaseFile, String> {
    let sets: Vec<String> = sets.iter().map(|s| (*s).to_owned()).collect();
    CaseFile::parse(text, "case.toml", &sets).map_err(|e| e.to_string())
}

#[test]
fn the_bearing_has_the_clearance_in_operation() {
    let bare = parse(&template(false), &[]).unwrap();
    let text = template(false) + DIAMETERS;
    let loose = parse(&text, &["operation.inner_speed_rpm=1"]).unwrap();
    let of = |file: &CaseFile| file.case().bearing.clone();
    let radii = [of(&loose).bore_radius_m(), of(&loose).outside_radius_m()];
    assert_eq!(radii, [Some(0.015), Some(0.031)]);
    let clearances = [&bare, &loose].map(|file| of(file).radial_internal_clearance_m());
    assert!(
        (clearances[0] - clearances[1]).abs() < 1e-13,
        "{clearances:?}"
    );
    assert_eq!(bare.particulars().fit, None);
    for clearance in ["", "bearing.radial_internal_clearance_um=20"] {
        let mut sets = vec![
            "fit.shaft_interference_um=10",
            "fit.inner_ring_temperature_c=60",
        ];
        sets.extend((!clearance.is_empty()).then_some(clearance));
        let file = parse(&text, &sets).unwrap();
        let (case, fit) = (file.case(), file.particulars().fit.unwrap());
        let found = case.bearing.radial_internal_clearance_m();
        assert!((found - fit.operating_m()).abs() < 1e-15, "{found} {fit:?}");
        assert!(found < fit.initial_m - 10e-6);
        let outer = |file: &CaseFile| {
            file.case()
                .bearing
                .dimensions()
                .outer_groove_bottom_radius_m
        };
        if clearance.is_empty() {
            assert_eq!(outer(&file), outer(&bare));
        } else {
            assert!((fit.initial_m - 20e-6).abs() < 1e-15);
        }
        // Written with all defaults and read again: the fit acts once.
        let written = file.document().to_toml().unwrap();
        assert_eq!(parse(&written, &[]).unwrap().case(), case, "{written}");
    }
}

/// The speed of the fit is the largest of the file; a drop meets an inner ring at rest.
#[test]
fn a_fit_takes_the_largest_speed_of_the_file() {
    let text = template(false) + DIAMETERS;
    let reduction_um = |sets: &[&str]| {
        let fit = parse(&text, sets).unwrap().particulars().fit.unwrap();
        1e6 * fit.speed_reduction_m
    };
    let fast = reduction_um(&["operation.inner_speed_rpm=30000"]);
    assert!((fast - 3.35).abs() < 0.01, "{fast}");
    for speeds in ["[[0, 1], [0.1, 30000]]", "[[0, -30000], [0.1, -10]]"] {
        let set = format!("operation.inner_speed_rpm={speeds}");
        assert_eq!(reduction_um(&[&set]), fast);
    }
    let drop = include_str!("../../../cases/touchdown-d.toml");
    let drop = parse(drop, &["fit.inner_ring_temperature_c=30"]).unwrap();
    assert_eq!(drop.particulars().fit.unwrap().speed_reduction_m, 0.0);
}

#[test]
fn fits_that_cannot_be_are_named() {
    let text = template(false) + DIAMETERS;
    for (sets, words) in [
        (
            &["fit.bore_diameter_mm=40"][..],
            ["fit.bore_diameter_mm = 40", "36.48 mm"],
        ),
        (
            &["fit.shaft_interference_um=200"],
            ["[fit] leaves a radial", "at least -"],
        ),
        (
            &["fit.shaft_interference_um=5000"],
            ["[fit] leaves a radial", "elastic"],
        ),
        (
            &["fit.ball_temperature_c=-300"],
            ["fit.ball_temperature_c", "more than -273.15 °C"],
        ),
        (
            &[
                "ball_material.density_kg_m3=3200",
                "ball_material.youngs_modulus_gpa=310",
                "ball_material.poisson_ratio=0.27",
                "fit.ball_temperature_c=60",
            ],
            ["fit.ball_expansion_per_k is missing", "balls"],
        ),
    ] {
        let message = parse(&text, sets).unwrap_err();
        for word in words {
            assert!(message.contains(word), "{sets:?}: {message}");
        }
    }
    let message = parse(&template(false), &["fit.shaft_interference_um=8"]);
    let message = message.unwrap_err();
    assert!(
        message.contains("fit.bore_diameter_mm is missing"),
        "{message}"
    );
}

/// Bore and outside diameter have one place: the fit takes those of the bearing, and refuses others.
#[test]
fn bore_and_outside_are_given_once() {
    let rings = [
        "bearing.inner_ring_bore_radius_mm=15",
        "bearing.outer_ring_outer_radius_mm=31",
        "bearing.outer_ring_width_mm=16",
    ];
    let fits = [
        "fit.shaft_interference_um=8",
        "fit.housing_interference_um=5",
    ];
    let with = |more: &[&str]| parse(&template(false), &[&fits, more].concat());
    let [of_rings, of_fit] = [
        with(&rings).unwrap(),
        with(&["fit.bore_diameter_mm=30", "fit.outside_diameter_mm=62"]).unwrap(),
    ];
    assert_eq!(of_rings.particulars().fit, of_fit.particulars().fit);
    assert!(of_rings.particulars().fit.unwrap().shaft_reduction_m > 0.0);
    let outside = |file: &CaseFile| file.case().bearing.outside_radius_m();
    assert_eq!(outside(&of_rings), outside(&of_fit));
    // Both, and the same.
    with(&[&rings[..], &["fit.bore_diameter_mm=30"]].concat()).unwrap();
    for (other, key, own) in [
        (
            "fit.bore_diameter_mm=28",
            "fit.bore_diameter_mm = 28",
            "30 mm, twice bearing.inner_ring_bore_radius_mm",
        ),
        (
            "fit.outside_diameter_mm=60",
            "fit.outside_diameter_mm = 60",
            "62 mm, twice bearing.outer_ring_outer_radius_mm",
        ),
    ] {
        let message = with(&[&rings[..], &[other]].concat()).unwrap_err();
        assert!(message.contains(key) && message.contains(own), "{message}");
    }
}

/// Kelvin in the place of degrees Celsius, of steel; of ceramics the temperature may be one.
#[test]
fn steel_is_not_that_warm() {
    for part in ["inner_ring", "outer_ring", "ball"] {
        let set = format!("fit.{part}_temperature_c=293");
        let message = parse(&template(false), &[&set]).unwrap_err();
        assert!(
            message.contains("at most 290 °C") && message.contains("293 K"),
            "{message}"
        );
    }
    let hot = [
        "fit.inner_ring_temperature_c=290",
        "fit.outer_ring_temperature_c=290",
    ];
    parse(&template(false), &hot).unwrap();
    let balls = [
        "ball_material.preset=Si3N4",
        "fit.ball_temperature_c=353",
        "fit.ball_expansion_per_k=3e-6",
    ];
    parse(&template(false), &balls).unwrap();
}

/// kN of a catalogue in the place of N.
#[test]
fn fatigue_load_limits_are_of_the_bearing() {
    let lubricant = [
        "lubrication.viscosity_mm2_s=13",
        "lubrication.contamination_factor=0.5",
    ];
    let with = |set: &str| parse(&template(false), &[&lubricant[..], &[set]].concat());
    with("lubrication.fatigue_load_limit_n=335").unwrap();
    let message = with("lubrication.fatigue_load_limit_n=0.335").unwrap_err();
    for part in ["lubrication.fatigue_load_limit_n = 0.335", "between", "kN"] {
        assert!(message.contains(part), "{message}");
    }
}

/// A material by name expands by its own coefficient: balls of silicon nitride, 3.2e-6 1/K, in rings of
/// 440C, 10.2e-6 1/K; a key of the file decides before that.
#[test]
fn materials_by_name_expand_by_their_own_coefficients() {
    let text = template(false) + DIAMETERS;
    let change_m = |more: &[&str]| {
        let sets = [
            "material.preset=440C",
            "ball_material.preset=Si3N4",
            "fit.inner_ring_temperature_c=70",
            "fit.ball_temperature_c=60",
            "fit.outer_ring_temperature_c=50",
        ];
        let file = parse(&text, &[&sets[..], more].concat()).unwrap();
        file.particulars().fit.unwrap().thermal_change_m
    };
    let expected = |ring: f64, ball: f64| {
        2.0 * (ring * (27.765e-3 * 30.0 - 18.24e-3 * 50.0) - ball * 2.0 * 4.7625e-3 * 40.0)
    };
    for (more, ring, ball) in [
        (&[][..], 10.2e-6, 3.2e-6),
        (&["fit.ball_expansion_per_k=3e-6"], 10.2e-6, 3e-6),
    ] {
        let (found, expected) = (change_m(more), expected(ring, ball));
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{found:e} {expected:e}"
        );
    }
}

const PAIR: &str = include_str!("../../../cases/preloaded-pair.toml");

/// Rows of a pair stay where they are along the axis: a warm inner ring presses them harder, by the stretched
/// distance of the centres of the grooves, A cos α0 − ΔG/2 along the radius and A sin α0 + u along the axis.
#[test]
fn a_warm_inner_ring_preloads_a_pair() {
    let text = PAIR.to_owned() + DIAMETERS;
    let mut sets = vec![
        "raceway=[]",
        "operation.radial_load_n=0",
        "operation.gravity_m_s2=0",
        "operation.inner_speed_rpm=1",
    ];
    let cold = parse(&text, &sets).unwrap();
    assert!((cold.case().rows[0].preload_m - 15e-6).abs() < 1e-13);
    sets.push("fit.inner_ring_temperature_c=40");
    let warm = parse(&text, &sets).unwrap();
    let (case, fit) = (warm.case(), warm.particulars().fit.unwrap());
    let room = 2.0 * (4.953e-3 - 4.7625e-3);
    let angle = 15f64.to_radians();
    // Opened by the angle before anything warms.
    let by_itself = 2.0 * room * (1.0 - angle.cos());
    assert!((fit.initial_m - by_itself).abs() < 1e-12, "{fit:?}");
    assert!(fit.change_m() < -5e-6, "{fit:?}");
    let (radial, axial) = (
        room * angle.cos() - 0.5 * fit.change_m(),
        room * angle.sin() + 15e-6,
    );
    let free = case.bearing.contact_angle_rad();
    assert!((radial - room * free.cos()).abs() < 1e-12);
    let deflection = radial.hypot(axial) - room;
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let both = (inner.powf(-2.0 / 3.0) + outer.powf(-2.0 / 3.0)).powf(-1.5);
    let expected = both * deflection.powf(1.5);
    let solved = cageless::equilibrium::space::solve(case).unwrap();
    for force in solved.rest.inner_force_n {
        assert!((force / expected - 1.0).abs() < 1e-6, "{force} {expected}");
    }
}

/// A pair that a warm outer ring leaves without preload is refused; a single row has another free angle.
#[test]
fn a_warm_outer_ring_takes_preload() {
    let text = PAIR.to_owned() + DIAMETERS;
    let error = parse(&text, &["fit.outer_ring_temperature_c=80"]).unwrap_err();
    assert!(
        error.contains("[fit] changes the preload of row 1 by -"),
        "{error}"
    );
    let single = text.split("[[row]]").next().unwrap().to_owned()
        + "[operation]"
        + text.split("[operation]").nth(1).unwrap();
    let single = parse(&single, &["fit.outer_ring_temperature_c=80"]).unwrap();
    assert!(single.case().bearing.contact_angle_rad() > 16f64.to_radians());
}

/// Fits by tolerance classes, and what they exclude; `--set` of one takes the other out.
#[test]
fn fits_are_given_by_name() {
    let text = template(false) + DIAMETERS + "shaft = \"k5\"\nhousing = \"J7\"\n";
    let named = parse(&text, &[]).unwrap();
    let range = named.particulars().fit.unwrap().range.unwrap();
    let operating_m = named.case().bearing.radial_internal_clearance_m();
    assert!(range.probable_m[0] < operating_m && operating_m < range.probable_m[1]);
    // k5 of 30 mm: +2 to +11, its bore −10 to 0; J7 of 62 mm: −12 to +18, its outside −13 to 0.
    let typed = [
        "fit.shaft_interference_um=9.75",
        "fit.housing_interference_um=-11.25",
    ];
    let typed = parse(&text, &typed).unwrap();
    assert_eq!(typed.particulars().fit.unwrap().range, None);
    let typed = typed.case();
    let clearance_m = typed.bearing.radial_internal_clearance_m();
    assert!((clearance_m - operating_m).abs() < 1e-15);
    let written = named.document().to_toml().unwrap();
    assert_eq!(parse(&written, &[]).unwrap().case(), named.case());
    let fine = parse(&text, &["fit.tolerance_class=5", "fit.smoothing_um=0"]).unwrap();
    let loss_m = 1e-6 * (9.75 - (6.5 + 3.0));
    let [fine, usual] =
        [&fine, &named].map(|file| file.particulars().fit.unwrap().shaft_interference_m);
    assert!((usual - fine - loss_m).abs() < 1e-15);

    let exclusive = text.clone() + "shaft_interference_um = 0.0\n";
    for (text, sets, words) in [
        (
            &exclusive,
            &[][..],
            ["fit.shaft_interference_um = 0.0", "with fit.shaft: both"],
        ),
        (
            &text,
            &["fit.shaft=K5"],
            ["fit.shaft = \"K5\"", "\"k5\" say"],
        ),
        (
            &text,
            &["fit.shaft=5"],
            ["fit.shaft = 5", "js, k, m, n, p or r"],
        ),
        (
            &text,
            &["fit.housing=H10"],
            ["fit.housing = \"H10\"", "grade 4 to 9"],
        ),
        (
            &text,
            &["fit.tolerance_class=4"],
            ["fit.tolerance_class = 4", "\"normal\", \"6\" or \"5\""],
        ),
        (
            &text,
            &[
                "bearing.outer_ring_outer_radius_mm=255",
                "fit.outside_diameter_mm=510",
            ],
            ["fit.outside_diameter_mm = 510", "at most 500 mm"],
        ),
    ] {
        let message = parse(text, sets).unwrap_err();
        for word in words {
            assert!(message.contains(word), "{sets:?}: {message}");
        }
    }
    let typed = template(false) + DIAMETERS;
    for (set, key) in [
        ("fit.smoothing_um=2", "fit.smoothing_um = 2"),
        ("fit.tolerance_class=6", "fit.tolerance_class = 6"),
    ] {
        let message = parse(&typed, &[set]).unwrap_err();
        assert!(
            message.contains(key) && message.contains("left out"),
            "{message}"
        );
    }
    let message = parse(&template(false), &["fit.shaft=k5"]).unwrap_err();
    assert!(
        message.contains("fit.bore_diameter_mm is missing"),
        "{message}"
    );
}

/// Another clearance of a pair has the free angle and the preload of a fit that leaves it.
#[test]
fn a_pair_has_the_preload_of_its_clearance() {
    let text = PAIR.to_owned() + DIAMETERS;
    let with_fit = |um: f64| {
        let set = format!("fit.shaft_interference_um={um:?}");
        let sets = ["raceway=[]", "operation.inner_speed_rpm=1", &set];
        parse(&text, &sets).unwrap().case().clone()
    };
    let [loose, tight] = [5.0, 9.0].map(with_fit);
    let found = loose.with_operating_clearance(tight.bearing.radial_internal_clearance_m());
    let found = found.unwrap();
    let [angle, expected] = [&found, &tight].map(|case| case.bearing.contact_angle_rad());
    assert!((angle - expected).abs() < 1e-9, "{angle} {expected}");
    for (row, expected) in found.rows.iter().zip(&tight.rows) {
        let change_m = row.preload_m - expected.preload_m;
        assert!(change_m.abs() < 1e-12, "{row:?} {expected:?}");
    }
    assert!(tight.rows[0].preload_m > loose.rows[0].preload_m + 1e-6);
    let wide = loose.with_operating_clearance(0.2e-3).unwrap_err();
    assert_eq!(wide.field, "preload_m");
}
