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
    let loose = parse(&text, &[]).unwrap();
    let of = |file: &CaseFile| file.case().bearing.clone();
    let bored = of(&bare).with_boundary_radii(Some(0.015), Some(0.031));
    assert_eq!(of(&loose), bored.unwrap());
    assert_eq!(bare.case().fit, None);
    for clearance in ["", "bearing.radial_internal_clearance_um=20"] {
        let mut sets = vec![
            "fit.shaft_interference_um=10",
            "fit.inner_ring_temperature_c=60",
        ];
        sets.extend((!clearance.is_empty()).then_some(clearance));
        let file = parse(&text, &sets).unwrap();
        let (case, fit) = (file.case(), file.case().fit.unwrap());
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
            ["fit.ball_temperature_c", "more than -273.15 C"],
        ),
        (
            &["ball_material.preset=Si3N4", "fit.ball_temperature_c=60"],
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
    assert_eq!(cold.case().rows[0].preload_m, 15e-6);
    sets.push("fit.inner_ring_temperature_c=40");
    let warm = parse(&text, &sets).unwrap();
    let (case, fit) = (warm.case(), warm.case().fit.unwrap());
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
