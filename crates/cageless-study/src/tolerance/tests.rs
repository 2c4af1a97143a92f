use cageless_design::{PassageStatistics, RacewayVerdict};
use cageless_io::case_file::{CaseFile, template};
use cageless_results::TOLERANCE_SHAPE;

use super::*;

fn file() -> CaseFile {
    CaseFile::parse(&template(false), "case.toml", &[]).unwrap()
}

fn case() -> Case {
    file().case().clone()
}

const REQUEST: Request = Request {
    samples: 2,
    groove_depth_um: 3.0,
    axial_span_um: 21.0,
    half_angle_deg: 0.5,
    contact_angle_deg: 0.1,
    ball_grade: 20,
    friction: 0.004,
    clearance_um: 6.0,
    speed_percent: 7.0,
    load_percent: 40.0,
    viscosity_percent: 30.0,
    supply_factor: 2.0,
    benefit: false,
};

#[test]
fn tolerances_are_those_of_the_request_in_si_units() {
    let t = REQUEST.check(&case(), "case").unwrap();
    let expected = [
        (t.groove_depth_m, 3e-6),
        (t.axial_span_m, 21e-6),
        (t.half_angle_rad, 0.5 * std::f64::consts::PI / 180.0),
        (t.friction, 0.004),
        (t.clearance_m, 6e-6),
        (t.speed_fraction, 0.07),
        (t.load_fraction, 0.4),
        (t.ball_grade.unwrap().lot_variation_m, 1e-6),
    ];
    for (found, expected) in expected {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    // The section of a raceway is turned in space alone.
    assert_eq!(t.section_angle_rad, 0.0);
    let spatial = Case {
        motion: cageless::Motion::Space,
        ..case()
    };
    let request = Request {
        contact_angle_deg: 0.3,
        ..REQUEST
    };
    assert!(request.check(&case(), "case").is_err());
    let t = request.check(&spatial, "case").unwrap();
    let expected = 0.3 * std::f64::consts::PI / 180.0;
    assert!((t.section_angle_rad / expected - 1.0).abs() < 1e-12);
    let none = Request {
        ball_grade: 0,
        ..REQUEST
    };
    assert!(none.check(&case(), "case").unwrap().ball_grade.is_none());
}

/// Each option is taken up to its limit and refused beyond it and below 0, by name.
#[test]
fn each_option_has_its_limits() {
    let case = case();
    let raceway = &case.raceways[0];
    type Set = fn(&mut Request, f64);
    let rows: [(&str, Set, f64); 7] = [
        (
            "groove_depth_um",
            |r, v| r.groove_depth_um = v,
            1e6 * raceway.depth_error_max_m(),
        ),
        ("axial_span_um", |r, v| r.axial_span_um = v, 5100.0),
        ("half_angle_deg", |r, v| r.half_angle_deg = v, 25.2),
        (
            "friction",
            |r, v| r.friction = v,
            case.contact.friction.coefficient,
        ),
        // A tenth of the ball radius of 4.7625 mm.
        ("clearance_um", |r, v| r.clearance_um = v, 952.5),
        ("speed_percent", |r, v| r.speed_percent = v, 100.0),
        ("load_percent", |r, v| r.load_percent = v, 100.0),
    ];
    for (name, set, most) in rows {
        let refused = |value: f64| {
            let mut request = REQUEST;
            set(&mut request, value);
            match request.check(&case, "case") {
                Ok(_) => None,
                Err(StudyError::Option(error)) => Some(error.option),
                Err(other) => panic!("{other:?}"),
            }
        };
        for value in [0.0, most * (1.0 - 1e-12)] {
            assert_eq!(refused(value), None, "{name} = {value}");
        }
        for value in [-1e-9, most * (1.0 + 1e-12), f64::NAN, f64::INFINITY] {
            assert_eq!(refused(value), Some(name), "{name} = {value}");
        }
    }
    let samples = |samples| Request { samples, ..REQUEST }.check(&case, "case").is_ok();
    assert!(samples(100_000) && !samples(100_001));
    let grade = |ball_grade| {
        Request {
            ball_grade,
            ..REQUEST
        }
        .check(&case, "case")
        .is_ok()
    };
    assert!(grade(100) && !grade(4));
    let plain = case.with_raceways(vec![]);
    assert!(matches!(
        REQUEST.check(&plain, "case"),
        Err(StudyError::Input(_))
    ));
}

/// The viscosity deviates within the oils that can be, and is refused beyond, before anything is computed.
#[test]
fn the_viscosity_stays_that_of_an_oil() {
    let wet = |viscosity_mpa_s: &str| {
        let sets = [
            format!("film.viscosity_mpa_s={viscosity_mpa_s}"),
            "film.viscosity_temperature_1_k=0.035".to_owned(),
            "film.supply=\"flooded\"".to_owned(),
        ];
        let text = template(false).replace("formulation = \"paper\"", "formulation = \"physical\"");
        CaseFile::parse(&text, "case.toml", &sets)
            .unwrap()
            .case()
            .clone()
    };
    let judged = |viscosity_mpa_s: &str, viscosity_percent: f64| {
        let request = Request {
            viscosity_percent,
            ..REQUEST
        };
        request.check(&wet(viscosity_mpa_s), "case").map(|_| ())
    };
    for (viscosity_mpa_s, most) in [("0.105", "4.7619"), ("9000", "11.1111")] {
        let error = judged(viscosity_mpa_s, 30.0).unwrap_err().to_string();
        for fragment in [
            "viscosity_percent = 30",
            most,
            "0.1 to 10000 mPa·s",
            &format!("has {viscosity_mpa_s} mPa·s (film.viscosity_mpa_s)"),
        ] {
            assert!(error.contains(fragment), "{error}: no {fragment}");
        }
        assert!(judged(viscosity_mpa_s, 4.7).is_ok());
    }
    assert!(judged("5", 90.0).is_ok());
}

/// Rows and samples in the units of the drawing, every number in its place.
#[test]
fn results_are_in_the_units_of_the_drawing() {
    let case = case();
    let tolerances = REQUEST.check(&case, "case").unwrap();
    let all = trials(&case, &tolerances, 3, 5);
    let outcome = |number: f64, verdict| Outcome {
        verdict,
        critical_gap_rad: Some(1e-3 * number),
        steady_gap_rad: None,
        passages: Some(PassageStatistics {
            lag_fraction: 1e-4 * number,
            double_collision_fraction: 1e-2 * number,
            sliding_mean_m_s: 1e-1 * number,
            ..PassageStatistics::default()
        }),
        reason: (verdict == RacewayVerdict::Infeasible).then(|| format!("reason {number}")),
        headline: String::new(),
        dry: None,
    };
    let verdict = |k: usize| match all.len() - k {
        3 => RacewayVerdict::Slips,
        2 => RacewayVerdict::Infeasible,
        _ => RacewayVerdict::Smooth,
    };
    let outcomes: Vec<_> = (0..all.len())
        .map(|k| Some(outcome((k + 1) as f64, verdict(k))))
        .collect();
    let found = tolerance_record(
        &case,
        file().particulars(),
        20,
        &tolerances,
        &assess(&all, &outcomes),
        vec![],
    );
    let near = |found: f64, expected: f64| {
        assert!(
            (found - expected).abs() < 1e-9 * (1e-3 + expected.abs()),
            "{found} {expected}"
        );
    };
    let degrees = |milliradians: f64| 0.18 * milliradians / std::f64::consts::PI;
    near(found.number("nominal_critical_gap_deg"), degrees(1.0));
    near(found.number("nominal_double_collision_fraction"), 0.01);
    near(found.number("nominal_sliding_m_s"), 0.1);
    let ball_angle = 2.0 * (4.7625 / (0.5 * (18.24 + 27.765f64))).asin();
    near(
        found.number("uniform_gap_deg"),
        360.0 / 14.0 - ball_angle * 180.0 / std::f64::consts::PI,
    );
    assert_eq!(found.number("ball_grade"), 20.0);
    assert_eq!(found.text("nominal_verdict"), "smooth");
    let rows = [
        ("groove depth", -3.0, 3.0, "µm", 2.0),
        ("axial span", -21.0, 21.0, "µm", 2.0),
        ("half angle", -0.5, 0.5, "°", 2.0),
        ("ball radii", -0.25, 0.25, "µm", 4.0),
        ("friction coefficient", -0.004, 0.004, "", 2.0),
        ("radial internal clearance", -6.0, 6.0, "µm", 2.0),
        // 7 % of 12 000 rpm, 40 % of 1500 N.
        ("speed", -840.0, 840.0, "rpm", 2.0),
        ("load", -600.0, 600.0, "N", 2.0),
    ];
    let mut last = 1.0;
    assert_eq!(found.parts("influences").len(), rows.len());
    for (row, (name, low, high, unit, trials)) in found.parts("influences").iter().zip(rows) {
        assert_eq!((row.text("name"), row.text("unit")), (name, unit));
        near(row.number("low"), low);
        near(row.number("high"), high);
        assert_eq!(
            (row.number("trials"), row.number("passed")),
            (trials, trials)
        );
        last += trials;
        for (k, number) in [1.0, last].into_iter().enumerate() {
            near(row.values("critical_gap_deg")[k], degrees(number));
            near(row.values("double_collision_fraction")[k], 1e-2 * number);
            near(row.values("sliding_mean_m_s")[k], 1e-1 * number);
        }
    }
    let samples = found.part("samples").unwrap();
    let counts = ["count", "passed", "seed"].map(|name| samples.number(name));
    assert_eq!(counts, [3.0, 1.0, file().particulars().seed as f64]);
    near(samples.number("pass_probability"), 1.0 / 3.0);
    let quantiles = samples.values("critical_gap_quantiles_deg");
    for (quantile, number) in quantiles.iter().zip([1.1, 2.0, 2.9]) {
        near(*quantile, degrees(last + number));
    }
    let verdicts = samples.parts("verdicts");
    let counts: Vec<f64> = verdicts.iter().map(|v| v.number("count")).collect();
    assert_eq!(counts, [1.0, 0.0, 1.0, 1.0]);
    near(
        verdicts[2].values("critical_gap_deg")[0],
        degrees(last + 1.0),
    );
    assert_eq!(
        samples.text("first_impossible"),
        format!("reason {}", last + 2.0)
    );
    let json = serde_json::to_value(&found).unwrap();
    assert_eq!(Record::read(&TOLERANCE_SHAPE, &json), Ok(found));
}
