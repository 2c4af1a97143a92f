//! The numbers of a design in the units in which they are shown.

use cageless::closed_forms::steady_gap_rad;
use cageless::raceway::RacewayDimensions;
use cageless_design::{
    Judgement, PassageStatistics, RacewayJudgement, RacewayVerdict, Recommendation, STEADY_GAP,
    StartingPoint,
};
use cageless_io::case_file::{CaseFile, template};
use cageless_results::{Record, Results};
use cageless_study::design::DesignResult;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn statistics(number: f64) -> PassageStatistics {
    PassageStatistics {
        passages: number as usize,
        collisions_mean: 0.1 * number,
        double_collision_fraction: 0.01 * number,
        sliding_mean_m_s: 0.02 * number,
        speed_drop_fraction: 0.03 * number,
        lag_mean_rad: 0.04,
        lag_fraction: 0.9,
        gap_leave_max_rad: 0.05 * DEGREE * number,
        gap_leave_min_rad: 0.04 * DEGREE * number,
    }
}

fn judgement(verdict: RacewayVerdict, number: f64) -> Judgement {
    let raceway = |k: f64| RacewayJudgement {
        verdict,
        reasons: vec![],
        criteria: vec![],
        critical_gap_rad: Some((number + k) * DEGREE),
        passages: Some(statistics(number + k)),
    };
    Judgement {
        verdict,
        reasons: vec![format!("reason {number}")],
        deciding: Some(STEADY_GAP.of(0.6)),
        critical_gap_rad: Some(0.5 * number * DEGREE),
        pressure_at_rest_pa: Some(1e8 * number),
        steady_gap_rad: None,
        passages: Some(statistics(3.0 * number)),
        raceways: vec![raceway(1.0), raceway(2.0)],
        film: None,
        dry: None,
        stopped: None,
    }
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

fn assert_passages(record: &Record, number: f64) {
    let found = &record.part("passages").unwrap().results;
    assert_eq!(found.number("passages"), number.floor());
    close(found.number("collisions_mean"), 0.1 * number, 1e-12);
    close(
        found.number("double_collision_fraction"),
        0.01 * number,
        1e-12,
    );
    close(found.number("sliding_mean_m_s"), 0.02 * number, 1e-12);
    close(found.number("speed_drop_fraction"), 0.03 * number, 1e-12);
    close(found.number("gap_leave_min_deg"), 0.04 * number, 1e-12);
    close(found.number("gap_leave_max_deg"), 0.05 * number, 1e-12);
}

fn verdict(results: &Results) -> (&str, Option<bool>) {
    (results.text("verdict"), results.flag("passes"))
}

/// The bearing of Zhao 2022, Table 1, with structure (d) at the bottom and (h) at 90°.
#[test]
fn every_number_is_in_its_unit() {
    let two = template(false).replace("[raceway]", "[[raceway]]").replace(
        "[operation]",
        "[[raceway]]\naxial_span_mm = 5.6\nhalf_angle_deg = 15.774\ncentre_angle_deg = 90.0\n\
         [operation]",
    );
    let file = CaseFile::parse(&two, "case.toml", &[]).unwrap();
    let case = file.case();
    let recommendation = Recommendation {
        starting_point: StartingPoint {
            half_angle_min_rad: 21.0 * DEGREE,
            half_angle_max_rad: 26.0 * DEGREE,
            half_angle_rad: 23.456_789 * DEGREE,
            axial_span_m: 5.123_456e-3,
        },
        dimensions: RacewayDimensions {
            axial_span_m: 5.012e-3,
            half_angle_rad: 24.345 * DEGREE,
            centre_angle_rad: 0.0,
        },
        judgement: judgement(RacewayVerdict::Smooth, 7.0),
        judged: 9,
    };
    let result = DesignResult::new(
        &file,
        &judgement(RacewayVerdict::Slips, 5.0),
        Some(&recommendation),
    );
    let record = &result.record;
    let found = &record.results;
    // Zhao 2022, Section 2 and Table 2; the angle of (d) to the digits of the table.
    close(found.number("epsilon_deg"), 23.8982, 5e-5);
    close(found.number("uniform_gap_deg"), 1.8161, 5e-5);
    close(found.number("beta0_deg"), 1.8171, 5e-5);
    close(found.number("beta0_polar_deg"), 1.8304, 5e-5);
    close(found.number("axial_span_limit_mm"), 7.4017, 5e-5);
    close(found.number("half_angle_for_span_deg"), 25.2, 0.05);
    let steady = steady_gap_rad(&case.bearing, &case.raceways) / DEGREE;
    close(found.number("steady_gap_deg"), steady, 1e-9);
    // 50.4° are two ball angles and a bit.
    assert_eq!(found.number("balls_in_raceway_max"), 3.0);
    let kink = case.raceways[0].kink_angle_rad(45.0 * DEGREE) / DEGREE;
    close(found.number("slope_discontinuity_deg"), kink, 1e-12);
    close(found.number("critical_gap_deg"), 2.5, 1e-12);
    assert_eq!(verdict(found), ("slips", Some(false)));
    assert_eq!(found.text("criterion"), "steady-gap");
    close(found.number("margin"), -0.2, 1e-12);
    assert_eq!(record.sentences("reasons"), ["reason 5"]);
    assert!(
        found
            .text("headline")
            .starts_with("does not work from evenly spaced balls: ")
    );
    assert_passages(record, 15.0);
    for (raceway, (span, angle, centre, beta0, number)) in record.parts("raceways").iter().zip([
        (5.1, 25.2, 0.0, 1.8171, 6.0),
        (5.6, 15.774, 90.0, 1.8161, 7.0),
    ]) {
        close(raceway.results.number("axial_span_mm"), span, 1e-9);
        close(raceway.results.number("half_angle_deg"), angle, 1e-9);
        close(raceway.results.number("centre_angle_deg"), centre, 1e-9);
        close(raceway.results.number("beta0_deg"), beta0, 5.1e-5);
        close(raceway.results.number("critical_gap_deg"), number, 1e-12);
        assert_eq!(verdict(&raceway.results), ("slips", Some(false)));
        assert_passages(raceway, number);
    }
    let near = result.recommendation().unwrap();
    let r = &near.0.results;
    close(r.number("half_angle_min_deg"), 21.0, 1e-9);
    close(r.number("half_angle_max_deg"), 26.0, 1e-9);
    assert_eq!(near.dimensions(), [5.012, 24.345]);
    assert_eq!(r.number("starting_half_angle_deg"), 23.457);
    assert_eq!(r.number("starting_axial_span_mm"), 5.123);
    close(r.number("critical_gap_deg"), 3.5, 1e-12);
    assert_eq!(verdict(r), ("smooth", Some(true)));
    assert_eq!(r.number("judged"), 9.0);
    assert_eq!(near.0.sentences("reasons"), ["reason 7"]);
    let sentence = near.sentence();
    assert_eq!(
        sentence,
        "Recommended: lC 5.012 mm, θ 24.345° (best of 9 tried)"
    );
    let mut start = recommendation.clone();
    start.dimensions = RacewayDimensions {
        axial_span_m: 5.123e-3,
        half_angle_rad: 23.457 * DEGREE,
        centre_angle_rad: 0.0,
    };
    let sentence = |near: &Recommendation| {
        let result = DesignResult::new(&file, &judgement(RacewayVerdict::Slips, 5.0), Some(near));
        result.recommendation().unwrap().sentence()
    };
    let in_the_middle = "Recommended: lC 5.123 mm, θ 23.457° (the middle of the usable range of θ";
    assert!(sentence(&start).starts_with(in_the_middle));
    start.judgement = judgement(RacewayVerdict::Slips, 7.0);
    assert_eq!(
        sentence(&start),
        "No suggestion from the closed form: none of 9 raceways near lC 5.123 mm, θ 23.457° passes. Use design --search"
    );

    let curve = &record.part("curve").unwrap().results;
    let at = curve
        .values("axial_span_mm")
        .windows(2)
        .position(|w| w[0] <= 5.6 && 5.6 < w[1])
        .unwrap();
    for (angles, tolerance) in [
        (curve.values("half_angle_deg"), 0.0),
        (curve.values("half_angle_polar_deg"), 0.6),
    ] {
        let [a, b] = [angles[at], angles[at + 1]];
        assert!(b - tolerance < 15.774 && 15.774 < a + tolerance, "{a} {b}");
    }
    let at = |name| curve.values(name)[at];
    assert_ne!(at("half_angle_deg"), at("half_angle_polar_deg"));
}
