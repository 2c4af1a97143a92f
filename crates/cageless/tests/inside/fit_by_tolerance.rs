//! Fits by tolerance classes: limits against published tables, and the range of the clearance.

use crate::common::{dimensions, steel, structure};
use cageless::{
    BearingClass, BearingDimensions, ClearanceRange, Fit, HoleClass, OperatingClearance, ShaftClass,
};

const PUBLISHED: &str = include_str!("../reference/limit_deviations.txt");

fn limits_um(class: &str, mm: f64) -> Option<[f64; 2]> {
    let found = match class.starts_with(char::is_lowercase) {
        true => ShaftClass::from_name(class)?.limits_m(mm * 1e-3),
        false => HoleClass::from_name(class)?.limits_m(mm * 1e-3),
    };
    found.map(|limits| limits.map(|m| m * 1e6))
}

fn check(class: &str, mm: f64, expected: [f64; 2]) {
    let found = limits_um(class, mm).unwrap();
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-9,
            "{class} at {mm}: {found} for {expected}"
        );
    }
}

/// 629 limits of two catalogues.
#[test]
fn limits_are_those_of_catalogues() {
    let mut count = 0;
    for line in PUBLISHED.lines().filter(|line| !line.starts_with('#')) {
        let (mm, items) = line.split_once(": ").unwrap();
        for item in items.split(", ") {
            let mut words = item.split(' ');
            let class = words.next().unwrap();
            let limits: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
            check(class, mm.parse().unwrap(), [limits[0], limits[1]]);
            count += 1;
        }
    }
    assert_eq!(count, 629);
}

/// What catalogues of bearings leave out: ISO 286-2:2010, tables 8 to 10.
#[test]
fn limits_of_coarse_holes_are_those_of_the_standard() {
    for (class, mm, limits) in [
        ("K8", 40.0, [-27.0, 12.0]),
        ("J8", 40.0, [-15.0, 24.0]),
        ("M8", 40.0, [-34.0, 5.0]),
        ("N8", 40.0, [-42.0, -3.0]),
        ("N9", 40.0, [-62.0, 0.0]),
        ("P9", 40.0, [-88.0, -26.0]),
        ("N9", 3.0, [-29.0, -4.0]),
        ("K6", 3.0, [-6.0, 0.0]),
        ("M7", 3.0, [-12.0, -2.0]),
        ("R7", 3.0, [-20.0, -10.0]),
        ("k6", 3.0, [0.0, 6.0]),
        ("k8", 40.0, [0.0, 39.0]),
        ("D8", 40.0, [80.0, 119.0]),
    ] {
        check(class, mm, limits);
    }
    let sizes = [
        6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0,
    ];
    let upper = [
        [-2.0, -12.0],
        [-3.0, -15.0],
        [-3.0, -18.0],
        [-3.0, -22.0],
        [-3.0, -26.0],
        [-4.0, -32.0],
        [-4.0, -37.0],
        [-4.0, -43.0],
        [-5.0, -50.0],
        [-5.0, -56.0],
        [-5.0, -62.0],
        [-6.0, -68.0],
    ];
    for (mm, [n8, p9]) in sizes.into_iter().zip(upper) {
        for (class, expected) in [("N8", n8), ("P9", p9)] {
            let [_, found] = limits_um(class, mm).unwrap();
            assert!((found - expected).abs() < 1e-9, "{class} at {mm}");
        }
    }
}

/// A range of sizes ends with its largest size, whatever the last digit of metres is.
#[test]
fn ranges_of_sizes_end_with_their_largest() {
    for (mm, next) in [(30.0, 30.001), (50.0, 50.001), (120.0, 120.001)] {
        assert!(limits_um("h6", mm) != limits_um("h6", next));
        for nearly in [mm * (1.0 + 1e-12), mm * (1.0 - 1e-12)] {
            assert_eq!(limits_um("h6", nearly), limits_um("h6", mm));
        }
    }
    for mm in [0.999, 500.001, f64::NAN, f64::INFINITY, -40.0] {
        assert_eq!(limits_um("h6", mm), None);
        assert_eq!(limits_um("H7", mm), None);
    }
}

/// The width is the standard tolerance, whatever the letters; a coarser grade has a wider one.
#[test]
fn width_depends_on_the_grade_alone() {
    let letters = ["d", "e", "f", "g", "h", "js", "k", "m", "n", "p", "r"];
    for mm in [1.0, 3.0, 5.0, 17.0, 30.0, 65.0, 180.0, 300.0, 500.0] {
        let mut before = 0.0;
        for grade in 4..=9 {
            let width = |class: &str| {
                let [lower, upper] = limits_um(class, mm).unwrap();
                upper - lower
            };
            let tolerance = width(&format!("h{grade}"));
            assert!(tolerance > before);
            before = tolerance;
            for letters in letters {
                let shaft = format!("{letters}{grade}");
                let hole = shaft.to_uppercase();
                assert!((width(&shaft) - tolerance).abs() < 1e-9, "{shaft}");
                if hole != "K9" {
                    assert!((width(&hole) - tolerance).abs() < 1e-9, "{hole}");
                }
            }
        }
    }
}

#[test]
fn names_that_are_none_are_refused() {
    for name in [
        "", "k", "5", "k3", "k10", "k05", "k+5", "K5", "c6", "s6", "j4", "j8", "kk5", "k5 ", "Js6",
        "ä5",
    ] {
        assert_eq!(ShaftClass::from_name(name), None, "{name}");
    }
    for name in [
        "", "H", "7", "h7", "H3", "H10", "J5", "J9", "K9", "Js7", "S7", "HH7", "H-7",
    ] {
        assert_eq!(HoleClass::from_name(name), None, "{name}");
    }
}

/// NTN 2203/E, table 6.4 (ISO 492).
#[test]
fn bearings_have_the_limits_of_their_class() {
    let classes = BearingClass::ALL;
    for (mm, bore, outside) in [
        (10.0, [8.0, 7.0, 5.0], [8.0, 7.0, 5.0]),
        (30.0, [10.0, 8.0, 6.0], [9.0, 8.0, 6.0]),
        (40.0, [12.0, 10.0, 8.0], [11.0, 9.0, 7.0]),
        (80.0, [15.0, 12.0, 9.0], [13.0, 11.0, 9.0]),
        (150.0, [25.0, 18.0, 13.0], [18.0, 15.0, 11.0]),
        (180.0, [25.0, 18.0, 13.0], [25.0, 18.0, 13.0]),
        (250.0, [30.0, 22.0, 15.0], [30.0, 20.0, 15.0]),
        (400.0, [40.0, 30.0, 23.0], [40.0, 28.0, 20.0]),
    ] {
        for (k, class) in classes.into_iter().enumerate() {
            let near = |found: Option<[f64; 2]>, um: f64| {
                let [lower, upper] = found.unwrap();
                assert!(
                    upper == 0.0 && (lower * 1e6 + um).abs() < 1e-9,
                    "{mm} {class:?}"
                );
            };
            near(class.bore_limits_m(mm * 1e-3), bore[k]);
            near(class.outside_limits_m(mm * 1e-3), outside[k]);
        }
    }
    assert_eq!(BearingClass::Five.bore_limits_m(0.45), None);
    assert_eq!(BearingClass::Normal.bore_limits_m(0.501), None);
}

/// 6208 with the mean raceway diameters of NTN: Di = 50.4 mm, De = 68.4 mm.
fn clearance(fit: &Fit) -> OperatingClearance {
    let ntn_6208 = BearingDimensions {
        inner_groove_bottom_radius_m: 25.2e-3,
        outer_groove_bottom_radius_m: 34.2e-3,
        ..dimensions()
    };
    fit.operating_clearance(&ntn_6208, &steel().into(), 0.0)
        .unwrap()
}

fn in_6208(shaft: &str, housing: &str) -> Fit {
    Fit {
        bore_diameter_m: Some(40e-3),
        outside_diameter_m: Some(80e-3),
        shaft: Some(ShaftClass::from_name(shaft).unwrap()),
        housing: Some(HoleClass::from_name(housing).unwrap()),
        ..Fit::default()
    }
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() < 1e-12,
        "{found:e} for {expected:e}"
    );
}

/// NTN 2203/E, Eq. (8.3): Δf = Δ0 − λi Δd − λo ΔD ± 3σ with σ² = σ0² + λi² σd² + λo² σD², each σ a sixth of a tolerance.
/// m5 of 40 mm: +9 to +20, bore −12 to 0; P6 of 80 mm: −45 to −26, outside −13 to 0.
#[test]
fn range_is_that_of_the_closed_forms() {
    let fit = Fit {
        clearance_tolerance_m: 7e-6,
        ..in_6208("m5", "P6")
    };
    let found = clearance(&fit);
    let [inner, outer] = [40.0 / 50.4, 68.4 / 80.0];
    let [on_shaft, in_housing] = [14.5 + 6.0 - 1.75, 35.5 - 6.5 - 1.75];
    let mean = found.initial_m - 1e-6 * (inner * on_shaft + outer * in_housing);
    near(found.operating_m(), mean);
    let ClearanceRange {
        probable_m,
        extreme_m,
    } = found.range.unwrap();
    let shaft = inner * 5.5f64.hypot(6.0);
    let housing = outer * 9.5f64.hypot(6.5);
    let probable = 1e-6 * (49.0 + shaft * shaft + housing * housing).sqrt();
    near(probable_m[0], mean - probable);
    near(probable_m[1], mean + probable);
    let extreme = 1e-6 * (7.0 + inner * 11.5 + outer * 16.0);
    near(extreme_m[0], mean - extreme);
    near(extreme_m[1], mean + extreme);
}

/// The fit of the middles is one with its interferences given; a better class and less smoothing make another.
#[test]
fn mean_is_that_of_the_interferences_by_hand() {
    let named = in_6208("k5", "J7");
    // k5: +2 to +13; J7 of 80 mm: −12 to +18, a gap that has no effect.
    let typed = |shaft_um: f64, housing_um: f64| Fit {
        shaft: None,
        housing: None,
        tolerance_class: None,
        smoothing_m: None,
        shaft_interference_m: Some(shaft_um * 1e-6),
        housing_interference_m: Some(housing_um * 1e-6),
        ..named.clone()
    };
    let same = |fit: &Fit, typed: &Fit| {
        let [found, expected] = [fit, typed].map(clearance);
        near(found.operating_m(), expected.operating_m());
        near(found.shaft_interference_m, expected.shaft_interference_m);
        near(
            found.housing_interference_m,
            expected.housing_interference_m,
        );
        assert_eq!(expected.range, None);
    };
    same(&named, &typed(7.5 + 6.0 - 1.75, -6.5 - 3.0 - 1.75));
    let fine = Fit {
        tolerance_class: Some(BearingClass::Five),
        smoothing_m: Some(0.0),
        ..named.clone()
    };
    same(&fine, &typed(7.5 + 4.0, -4.5 - 3.0));
}

/// A gap takes no clearance: the range of a loose housing has nothing of it but where its limits press the ring.
#[test]
fn gaps_have_no_part_in_the_range() {
    let exact = Fit {
        smoothing_m: Some(0.0),
        ..in_6208("k5", "H7")
    };
    let free = Fit {
        housing: None,
        ..exact.clone()
    };
    assert_eq!(clearance(&exact).range, clearance(&free).range);
    // js6 of 80 mm at the worst presses by 9.5 µm.
    let transition = Fit {
        housing: HoleClass::from_name("JS6"),
        ..exact
    };
    let [pressed, loose] = [&transition, &free].map(|fit| clearance(fit).range.unwrap());
    near(
        loose.extreme_m[0] - pressed.extreme_m[0],
        9.5e-6 * 68.4 / 80.0,
    );
    assert!(pressed.probable_m[0] < loose.probable_m[0]);
    assert_eq!(pressed.probable_m[1], loose.probable_m[1]);
}

#[test]
fn what_a_class_excludes_is_refused() {
    let named = Fit {
        bore_diameter_m: Some(30e-3),
        outside_diameter_m: Some(62e-3),
        ..in_6208("k5", "H7")
    };
    let typed = Fit {
        shaft: None,
        housing: None,
        ..named.clone()
    };
    for (field, fit) in [
        (
            "shaft_interference_m",
            Fit {
                shaft_interference_m: Some(0.0),
                ..named.clone()
            },
        ),
        (
            "housing_interference_m",
            Fit {
                housing_interference_m: Some(1e-6),
                ..named.clone()
            },
        ),
        (
            "tolerance_class",
            Fit {
                tolerance_class: Some(BearingClass::Six),
                ..typed.clone()
            },
        ),
        (
            "smoothing_m",
            Fit {
                smoothing_m: Some(1e-6),
                ..typed.clone()
            },
        ),
        (
            "clearance_tolerance_m",
            Fit {
                clearance_tolerance_m: -1e-6,
                ..typed.clone()
            },
        ),
        (
            "smoothing_m",
            Fit {
                smoothing_m: Some(f64::NAN),
                ..named.clone()
            },
        ),
        (
            "bore_diameter_m",
            Fit {
                bore_diameter_m: None,
                ..named.clone()
            },
        ),
        (
            "outside_diameter_m",
            Fit {
                outside_diameter_m: Some(0.6),
                ..named.clone()
            },
        ),
    ] {
        let error = fit
            .operating_clearance(&dimensions(), &steel().into(), 0.0)
            .unwrap_err();
        assert_eq!(error.field, field, "{error}");
    }
}

/// Another clearance is that of the bearing, with all else as it is.
#[test]
fn a_case_takes_another_clearance() {
    let case = structure(5.1, 25.2);
    let found = case.with_operating_clearance(12e-6).unwrap();
    near(found.bearing.radial_internal_clearance_m(), 12e-6);
    assert_eq!(found.bearing.assembly(), case.bearing.assembly());
    assert_eq!(found.raceways, case.raceways);
    let same = case.with_operating_clearance(case.bearing.radial_internal_clearance_m());
    assert_eq!(same.unwrap(), case);
    assert!(case.with_operating_clearance(-1e-3).is_err());
}
