//! Bearings by designation against load ratings of a catalogue and geometry published elsewhere.

use std::collections::HashMap;

use cageless::rating::{BasicRatings, PassingFrequencies, skf_friction_torque_n_m};
use cageless::{Assembly, Case};
use cageless_io::case_file::CaseFile;
use cageless_io::designation::{BallSource, designations, find};
use cageless_io::touchdown_template::touchdown_case;

fn case(designation: &str, full_complement: bool) -> Case {
    let text = find(designation).unwrap().case_file(full_complement);
    let file = CaseFile::parse(&text, designation, &[]);
    file.unwrap_or_else(|e| panic!("{designation}: {e}"))
        .case()
        .clone()
}

/// Cr and C0r in N and f0 of NSK, *Rolling bearings*, E1102f, single-row deep groove bearings.
/// Number and diameter of the balls were chosen to fit them, so the comparison is partly circular:
/// it is not in that balls have stock sizes and whole numbers, and three ratings fix the two.
fn ratings() -> HashMap<String, (f64, f64, Option<f64>)> {
    let lines = include_str!("reference/nsk-ratings.csv").lines().skip(1);
    let rows = lines.map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let kilonewton = |k: usize| 1e3 * fields[k].parse::<f64>().unwrap();
        let ratings = (kilonewton(1), kilonewton(2), fields[3].parse().ok());
        (fields[0].to_owned(), ratings)
    });
    rows.collect()
}

#[test]
fn load_ratings_are_those_of_the_catalogue() {
    let ratings = ratings();
    let mut usual = 0;
    for bearing in designations() {
        let name = &bearing.designation;
        let geometry = bearing.internal_geometry(false);
        let catalogue = ratings.get(name);
        assert_eq!(
            catalogue.is_some(),
            geometry.source == BallSource::Maker,
            "{name}"
        );
        let Some((dynamic, fixed, factor)) = catalogue else {
            continue;
        };
        // Where the inner ring would fall between the balls, there are more of them than with a cage.
        let sets = [format!("bearing.balls={}", geometry.caged_balls)];
        let file = CaseFile::parse(&bearing.case_file(false), name, &sets).unwrap();
        let b = &file.case().bearing;
        assert_eq!(b.assembly(), Assembly::WithoutSlot, "{name}");
        let rating = BasicRatings::new(b);
        let off = rating.dynamic_n / dynamic - 1.0;
        assert!(off.abs() < 0.01, "{name}: Cr {off}");
        // The catalogue's f0 of series 68 exceeds the greatest of ISO 76, 16.5.
        if let Some(f0) = factor.filter(|f0| *f0 <= 16.5) {
            let balls_mm2 = b.balls() as f64 * (2e3 * b.ball_radius_m()).powi(2);
            assert!((rating.static_n / balls_mm2 - f0).abs() < 0.25, "{name}");
            assert!((rating.static_n / fixed - 1.0).abs() < 0.025, "{name}: C0r");
            usual += 1;
        }
    }
    assert!(
        ratings.len() > 150 && usual > 100,
        "{} {usual}",
        ratings.len()
    );
}

/// Ratings of the case that `new` writes against the catalogue: within 1 % of Cr where it has the
/// catalogue's number of balls, else off by the percentages that its note and its head give.
#[test]
fn a_case_with_other_balls_states_how_far_its_ratings_are_off() {
    let ratings = ratings();
    let mut others = Vec::new();
    for bearing in designations() {
        let name = &bearing.designation;
        let Some((dynamic_n, ..)) = ratings.get(name) else {
            continue;
        };
        let text = bearing.case_file(false);
        let file = CaseFile::parse(&text, name, &[]).unwrap();
        let found_n = BasicRatings::new(&file.case().bearing).dynamic_n;
        let off = 100.0 * (found_n / dynamic_n - 1.0);
        let note = bearing.source_of_balls(false);
        let stated = |text: &str| {
            let (_, after) = text.split_once("Cr is ")?;
            let (percent, after) = after.split_once(" % ")?;
            let sign = if after.starts_with("below") {
                -1.0
            } else {
                1.0
            };
            Some(sign * percent.parse::<f64>().ok()?)
        };
        assert_eq!(stated(&note), stated(&text), "{name}");
        assert!(
            (off - stated(&note).unwrap_or(0.0)).abs() < 1.0,
            "{name}: {off} {note}"
        );
        assert_eq!(
            stated(&note).is_some(),
            !note.contains("as NSK"),
            "{name}: {note}"
        );
        others.extend(stated(&note).map(|_| name.clone()));
    }
    assert!(
        others.contains(&"16010".to_owned()) && others.len() == 22,
        "{others:?}"
    );
    let full = find("16010").unwrap();
    assert!(
        full.source_of_balls(true)
            .contains("28 fill the pitch circle"),
        "{}",
        full.source_of_balls(true)
    );
}

/// Case Western Reserve University publishes multiples of the speed of its two bearings; they
/// give Z and Dw/Dpw without any rating. Paderborn's 6203 has the same BPFI and BPFO.
#[test]
fn balls_are_those_of_bearings_in_test_rigs() {
    for (name, bpfi, bpfo, ftf, tolerance) in [
        ("6205", 5.4152, 3.5848, 0.39828, 6e-3),
        ("6203", 4.9469, 3.0530, 0.3817, 2e-4),
        ("6203", 4.95, 3.05, 0.3817, 2e-3),
    ] {
        let case = case(name, false);
        let turns = case.operation.inner_speed_rad_s / std::f64::consts::TAU;
        let of = PassingFrequencies::new(&case);
        for (ours, published) in [(of.bpfi_hz, bpfi), (of.bpfo_hz, bpfo), (of.ftf_hz, ftf)] {
            let off = ours / turns / published - 1.0;
            assert!(off.abs() < tolerance, "{name}: {published} {off}");
        }
    }
    let dw = |name: &str| {
        find(name)
            .unwrap()
            .internal_geometry(false)
            .ball_diameter_mm
    };
    assert_eq!((dw("6205"), dw("6204")), (7.9375, 7.9375)); // 7.94 of CWRU, 7.92 of XJTU-SY
}

#[test]
fn every_designation_gives_a_case() {
    let mut count = 0;
    for bearing in designations() {
        let name = &bearing.designation;
        for full_complement in [false, true] {
            let text = bearing.case_file(full_complement);
            let case = case(name, full_complement);
            let b = &case.bearing;
            let d = b.dimensions();
            // The balls run between the bore of the inner and the outside of the outer ring.
            assert!(
                d.inner_groove_bottom_radius_m > bearing.bore_mm * 5e-4,
                "{name}"
            );
            assert!(
                d.outer_groove_bottom_radius_m < bearing.outside_mm * 5e-4,
                "{name}"
            );
            assert!(
                !full_complement || b.nominal_gap_rad() < b.ball_angle_rad() / b.balls() as f64
            );
            // The inner ring cannot fall through the gap that bunched balls leave.
            let filled = (b.balls() - 1) as f64 * b.ball_angle_rad().to_degrees();
            assert!(filled > 180.0, "{name}: {filled}");
            assert_eq!(full_complement, text.contains("filling-slot"), "{name}");
            if full_complement {
                assert_eq!(b.assembly(), Assembly::FillingSlot, "{name}");
            }
            let values = text
                .lines()
                .filter(|l| !l.starts_with('#'))
                .filter_map(|l| l.split(['=', '#']).nth(1));
            let digits = values.filter_map(|v| v.trim().split_once('.'));
            assert!(digits.map(|(_, d)| d.len()).max() <= Some(6), "{text}");
            count += 1;
        }
    }
    assert_eq!(count, 2 * 159);
    let bearing = find("6008").unwrap();
    assert_eq!(
        (bearing.bore_mm, bearing.outside_mm, bearing.width_mm),
        (40.0, 68.0, 15.0)
    );
    assert_eq!(bearing.internal_geometry(true).balls, 21);
    assert_eq!(
        find("61808").unwrap().internal_geometry(false),
        find("6808").unwrap().internal_geometry(false)
    );
    let message = find("6021").unwrap_err();
    assert!(
        message.contains("of 63 from 10 mm or of 160") && message.contains("did you mean 60"),
        "{message}"
    );
}

#[test]
fn a_case_states_where_its_balls_are_from() {
    let text = |name: &str| find(name).unwrap().case_file(false);
    assert!(text("6208").contains("ball_diameter_mm = 11.90625 "));
    assert!(text("6208").contains("as NSK"));
    // 29 steps of 1/64 inch would be 11.509374999999999 mm.
    assert!(
        text("6810").contains("formula") && text("6810").contains("ball_diameter_mm = 4.365625 ")
    );
    assert!(text("626").contains("with one 6") && text("626").contains("balls = 7 "));
    assert!(
        find("6208")
            .unwrap()
            .source_of_balls(false)
            .contains("as NSK")
    );
    assert!(
        find("6810")
            .unwrap()
            .source_of_balls(false)
            .contains("formula")
    );
}

/// Angular contact bearings have the boundary dimensions of deep groove ones of their size, the contact angle of
/// their suffix, and come as a preloaded pair that carries and runs.
#[test]
fn angular_contact_bearings_are_pairs_at_the_angle_of_their_suffix() {
    for (name, of_size, angle_deg) in [
        ("7205B", "6205", 40.0),
        ("7008AC", "6008", 25.0),
        ("71905C", "61905", 15.0),
        ("7311C", "6311", 15.0),
    ] {
        let (bearing, deep) = (find(name).unwrap(), find(of_size).unwrap());
        assert_eq!(
            [bearing.bore_mm, bearing.outside_mm, bearing.width_mm],
            [deep.bore_mm, deep.outside_mm, deep.width_mm]
        );
        let geometry = bearing.internal_geometry(false);
        assert!(geometry.caged_balls > deep.internal_geometry(false).caged_balls);
        for full in [false, true] {
            let case = case(name, full);
            assert!((case.bearing.contact_angle_rad().to_degrees() - angle_deg).abs() < 1e-9);
            assert_eq!(case.rows.len(), 2, "{name}");
            case.check_motion().unwrap();
            let rest = cageless::equilibrium::space::solve(&case).unwrap();
            let [first, second] = [rest.row_axial_force_n[0], rest.row_axial_force_n[1]];
            assert!(first > 50.0 && second < -50.0, "{name}: {first} {second}");
            let warned = rest.warnings(&case);
            assert!(warned.is_empty(), "{name}: {warned:?}");
        }
        let text = bearing.case_file(true);
        let drop = cageless_io::touchdown_template::touchdown_case(&bearing, true, &text);
        let file = CaseFile::parse(&drop, name, &[]).unwrap();
        file.case().check_motion().unwrap();
    }
    let error = find("7205").unwrap_err();
    assert!(
        error.ends_with("did you mean 7205C, 7205AC or 7205B?"),
        "{error}"
    );
}

/// Every bearing of the table has a case, and one of a drop, that passes; with its bore, which SKF's rules take:
/// ½ · 0.0015 · 1000 N · 25 mm of 6205.
#[test]
fn every_template_passes() {
    for bearing in designations() {
        for full_complement in [false, true] {
            let name = &bearing.designation;
            let text = bearing.case_file(full_complement);
            let drop = touchdown_case(&bearing, full_complement, &text);
            for text in [&text, &drop] {
                let file = CaseFile::parse(text, name, &[]).unwrap_or_else(|e| panic!("{e}"));
                let bore_m = file.case().bearing.bore_radius_m().unwrap();
                assert!(
                    (2e3 * bore_m / bearing.bore_mm - 1.0).abs() < 1e-12,
                    "{name}"
                );
            }
        }
    }
    let bearing = find("6205").unwrap();
    let sets = ["operation.radial_load_n=1000".to_owned()];
    let file = CaseFile::parse(&bearing.case_file(false), "6205", &sets).unwrap();
    let torque_n_m = skf_friction_torque_n_m(file.case()).unwrap();
    assert!((torque_n_m - 0.01875).abs() < 1e-12, "{torque_n_m}");
}

/// d and D are those that the case gives, by any of its keys, to which a fit makes no difference.
#[test]
fn bore_and_outside_are_those_of_the_case() {
    let text = find("6205").unwrap().case_file(false);
    let text = text
        .replace("inner_ring_bore_radius_mm = 12.5", "#")
        .replace("outer_ring_outer_radius_mm = 26", "#");
    let of = |sets: &[&str]| {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
        let file = CaseFile::parse(&text, "6205", &sets).unwrap();
        let bearing = &file.case().bearing;
        [bearing.bore_radius_m(), bearing.outside_radius_m()]
    };
    assert_eq!(of(&[]), [None, None]);
    assert_eq!(
        of(&[
            "bearing.inner_ring_bore_radius_mm=12.5",
            "bearing.outer_ring_outer_radius_mm=26"
        ]),
        [Some(0.0125), Some(0.026)]
    );
    let fitted = [
        "fit.bore_diameter_mm=25",
        "fit.outside_diameter_mm=52",
        "fit.shaft_interference_um=5",
    ];
    assert_eq!(of(&fitted), [Some(0.0125), Some(0.026)]);
}

/// The note on ratings by the formula names the number of balls that catalogues rate, where it is another.
#[test]
fn ratings_by_the_formula_are_of_the_balls_of_a_cage() {
    let note = |name: &str| find(name).unwrap().source_of_balls(false);
    assert!(
        note("623").contains("with the 6 that a cage leaves room for"),
        "{}",
        note("623")
    );
    assert!(
        note("623").contains("this bearing has 7"),
        "{}",
        note("623")
    );
    assert!(
        !note("6810").contains("a cage leaves room for"),
        "{}",
        note("6810")
    );
}

/// A bore below 10 mm stands behind a stroke in the long spelling of the series 68 and 69.
#[test]
fn bores_below_ten_have_a_stroke() {
    for (long, short) in [("618/4", "684"), ("619/9", "699")] {
        let [long, short] = [long, short].map(|name| find(name).unwrap());
        assert_eq!(
            [long.bore_mm, long.outside_mm, long.width_mm],
            [short.bore_mm, short.outside_mm, short.width_mm]
        );
    }
    let message = find("635").unwrap_err();
    assert!(message.contains("of 63 from 10 mm"), "{message}");
}

/// Suffixes of makers: what they say, what has no effect, and what is not known.
#[test]
fn suffixes_are_understood_or_named() {
    use cageless_io::designation::ClearanceGroup;
    let of = |name: &str| find(name).unwrap();
    for (name, group, hybrid, without_effect) in [
        ("6205-2RS1/C3", ClearanceGroup::C3, false, vec!["2RS1"]),
        ("6205ZZC4", ClearanceGroup::C4, false, vec!["ZZ"]),
        (
            "6205-2RSLTN9/HC5C3",
            ClearanceGroup::C3,
            true,
            vec!["2RSL", "TN9"],
        ),
        ("60/22 P6", ClearanceGroup::Normal, false, vec!["P6"]),
        ("618/4-2Z", ClearanceGroup::Normal, false, vec!["2Z"]),
        ("6205 c2", ClearanceGroup::C2, false, vec![]),
    ] {
        let found = of(name).suffixes;
        assert_eq!(
            (found.clearance_group, found.hybrid),
            (group, hybrid),
            "{name}"
        );
        let suffixes: Vec<_> = found
            .without_effect
            .iter()
            .map(|(suffix, _)| *suffix)
            .collect();
        assert_eq!(suffixes, without_effect, "{name}");
        let text = of(name).case_file(false);
        let file = CaseFile::parse(&text, name, &[]).unwrap();
        assert_eq!(
            file.case().bearing.materials().ball.is_steel(),
            !hybrid,
            "{name}"
        );
    }
    // The C of a contact angle, and that of a clearance.
    assert_eq!(of("7014 C").contact_angle_deg, 15.0);
    assert_eq!(of("7205AC").contact_angle_deg, 25.0);
    // 25 mm: C3 is 13 to 28 µm (ISO 5753-1).
    assert_eq!(of("6205/C3").internal_geometry(false).clearance_um, 20.5);
    for (name, said) in [
        ("6205XYZ", "`XYZ` is not known"),
        ("7205BECBP", "`ECBP` is not known"),
        ("604/C4", "no group C4"),
    ] {
        let error = find(name).unwrap_err();
        assert!(error.contains(said), "{error}");
    }
}
