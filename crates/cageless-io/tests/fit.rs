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
    assert_eq!(loose.case().bearing, bare.case().bearing);
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
