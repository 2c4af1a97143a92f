//! The numbers of a design in the units in which they are shown.

use cageless::design::{
    Criterion, Judgement, PassageStatistics, RacewayJudgement, RacewayVerdict, Recommendation,
    StartingPoint, steady_gap_rad,
};
use cageless::raceway::RacewayDimensions;
use cageless_io::case_file::{CaseFile, template};
use cageless_study::{DesignResult, PassageNumbers};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn statistics(number: f64) -> PassageStatistics {
    PassageStatistics {
        passages: number as usize,
        collisions_mean: 0.1 * number,
        double_collision_fraction: 0.01 * number,
        slip_mean_m_s: 0.02 * number,
        speed_drop_fraction: 0.03 * number,
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
        deciding: Some(Criterion::Deceleration(0.6)),
        critical_gap_rad: Some(0.5 * number * DEGREE),
        passages: Some(statistics(3.0 * number)),
        raceways: vec![raceway(1.0), raceway(2.0)],
        stopped: None,
    }
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

fn assert_passages(found: &PassageNumbers, number: f64) {
    assert_eq!(found.passages, number as usize);
    close(found.collisions_mean, 0.1 * number, 1e-12);
    close(found.double_collision_fraction, 0.01 * number, 1e-12);
    close(found.slip_mean_m_s, 0.02 * number, 1e-12);
    close(found.speed_drop_fraction, 0.03 * number, 1e-12);
    close(found.gap_leave_min_deg, 0.04 * number, 1e-12);
    close(found.gap_leave_max_deg, 0.05 * number, 1e-12);
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
    let found = DesignResult::new(
        case,
        judgement(RacewayVerdict::Slips, 5.0),
        Some(recommendation),
    );
    // Zhao 2022, Section 2 and Table 2; the angle of (d) to the digits of the table.
    close(found.epsilon_deg, 23.8982, 5e-5);
    close(found.uniform_gap_deg, 1.8161, 5e-5);
    close(found.beta0_deg.unwrap(), 1.8171, 5e-5);
    close(found.beta0_polar_deg.unwrap(), 1.8304, 5e-5);
    close(found.axial_span_limit_mm, 7.4017, 5e-5);
    close(found.half_angle_deg_for_span.unwrap(), 25.2, 0.05);
    let steady = steady_gap_rad(&case.bearing, &case.raceways) / DEGREE;
    close(found.steady_gap_deg, steady, 1e-9);
    // 50.4° are two ball angles and a bit.
    assert_eq!(found.balls_in_raceway_max, Some(3));
    let kink = case.raceways[0].kink_angle_rad(45.0 * DEGREE) / DEGREE;
    close(found.kink_deg.unwrap(), kink, 1e-12);
    close(found.critical_gap_deg.unwrap(), 2.5, 1e-12);
    assert_eq!((found.verdict, found.passes), ("slips", Some(false)));
    assert_eq!(found.criterion, Some("deceleration"));
    close(found.margin.unwrap(), -0.2, 1e-12);
    assert_eq!(found.reasons, ["reason 5"]);
    assert!(found.headline.starts_with("FAIL: "), "{}", found.headline);
    assert_passages(found.passages.as_ref().unwrap(), 15.0);
    for (raceway, (span, angle, centre, beta0, number)) in found.raceways.iter().zip([
        (5.1, 25.2, 0.0, 1.8171, 6.0),
        (5.6, 15.774, 90.0, 1.8161, 7.0),
    ]) {
        close(raceway.axial_span_mm, span, 1e-9);
        close(raceway.half_angle_deg, angle, 1e-9);
        close(raceway.centre_angle_deg, centre, 1e-9);
        close(raceway.beta0_deg, beta0, 5.1e-5);
        close(raceway.critical_gap_deg.unwrap(), number, 1e-12);
        assert_eq!((raceway.verdict, raceway.passes), ("slips", Some(false)));
        assert_passages(raceway.passages.as_ref().unwrap(), number);
    }
    let r = found.recommendation.unwrap();
    close(r.half_angle_min_deg, 21.0, 1e-9);
    close(r.half_angle_max_deg, 26.0, 1e-9);
    assert_eq!((r.half_angle_deg, r.axial_span_mm), (24.345, 5.012));
    assert_eq!(
        (r.starting_half_angle_deg, r.starting_axial_span_mm),
        (23.457, 5.123)
    );
    close(r.critical_gap_deg.unwrap(), 3.5, 1e-12);
    assert_eq!((r.verdict, r.passes, r.judged), ("smooth", Some(true), 9));
    assert_eq!(r.reasons, ["reason 7"]);
    assert!(
        !r.is_starting_point()
            && r.sentence()
                .starts_with("recommended: lC 5.012 mm, θ 24.345°, near")
    );
    let mut start = r.clone();
    start.half_angle_deg = r.starting_half_angle_deg;
    assert!(!start.is_starting_point());
    start.axial_span_mm = r.starting_axial_span_mm;
    assert!(start.is_starting_point());
    start.passes = Some(false);
    assert!(
        start.sentence().starts_with("nothing recommended"),
        "{}",
        start.sentence()
    );

    let curve = &found.curve;
    let at = curve
        .axial_span_mm
        .windows(2)
        .position(|w| w[0] <= 5.6 && 5.6 < w[1])
        .unwrap();
    for (angles, tolerance) in [
        (&curve.half_angle_deg, 0.0),
        (&curve.half_angle_polar_deg, 0.6),
    ] {
        let [a, b] = [angles[at].unwrap(), angles[at + 1].unwrap()];
        assert!(b - tolerance < 15.774 && 15.774 < a + tolerance, "{a} {b}");
    }
    assert_ne!(curve.half_angle_deg[at], curve.half_angle_polar_deg[at]);
}
