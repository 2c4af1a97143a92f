use super::*;
use crate::common::{raceway, structure};
use crate::{DECELERATION, SEPARATION};
use cageless::Motion;

/// A steady-state gap, rad, and a contact pressure at rest, Pa.
const STEADY: f64 = 0.034;
const PRESSURE: f64 = 1.41e9;

/// Statistics of which every number is another.
fn statistics() -> PassageStatistics {
    PassageStatistics {
        passages: 231,
        collisions_mean: 0.61,
        double_collision_fraction: 0.12,
        sliding_mean_m_s: 0.34,
        speed_drop_fraction: 0.93,
        lag_mean_rad: 0.04,
        lag_fraction: 0.9,
        gap_leave_max_rad: 0.045,
        gap_leave_min_rad: 0.016,
    }
}

fn measured(critical: f64, pressure_pa: f64) -> Measured {
    Measured {
        critical,
        largest: critical,
        steady: STEADY,
        pressure_pa,
        film: None,
    }
}

/// The judgement of structure (d) with a critical gap of this fraction of β0.
fn decided(gap_fraction: f64, statistics: PassageStatistics) -> RacewayJudgement {
    let case = structure(5.1, 25.2);
    let beta0 = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
    decide(
        &case,
        &case.raceways[0],
        measured(gap_fraction * beta0, PRESSURE),
        statistics,
    )
}

/// Each criterion alone, just on either side of its limit; what is better than ideal passes.
#[test]
fn each_criterion_decides_at_its_limit() {
    let with = |change: fn(&mut PassageStatistics, f64), value: f64| {
        let mut all = statistics();
        change(&mut all, value);
        decided(1.0, all).verdict
    };
    let gap = |fraction: f64| decided(fraction, statistics()).verdict;
    assert_eq!(gap(0.95 + 1e-9), RacewayVerdict::Smooth);
    assert_eq!(gap(0.95 - 1e-9), RacewayVerdict::Slips);
    // β0 is 0.933 of the steady-state gap: less than that spreads too little, more lets evenly spaced balls collide.
    assert_eq!(gap(1.07), RacewayVerdict::Smooth);
    assert_eq!(gap(1.075), RacewayVerdict::TooDeep);
    let drop = |value| with(|s, v| s.speed_drop_fraction = v, value);
    assert_eq!(drop(0.8), RacewayVerdict::Smooth);
    assert_eq!(drop(0.8f64.next_down()), RacewayVerdict::Slips);
    assert_eq!(drop(1.1), RacewayVerdict::Smooth);
    assert_eq!(drop(f64::NAN), RacewayVerdict::NotJudged);
    let both = |value| with(|s, v| s.double_collision_fraction = v, value);
    assert_eq!(both(0.25), RacewayVerdict::Smooth);
    assert_eq!(both(0.25f64.next_up()), RacewayVerdict::DoubleCollision);
    // Sliding comes first: a critical gap measured on sliding balls means nothing.
    let mut all = statistics();
    all.double_collision_fraction = 0.9;
    all.speed_drop_fraction = 0.2;
    assert_eq!(decided(1.0, all).verdict, RacewayVerdict::Slips);
}

/// In oil two more criteria decide at their limits, and the critical gap may be a tenth larger.
#[test]
fn oil_has_limits_of_its_own() {
    let case = structure(5.1, 25.2);
    let beta0 = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
    let of = |largest: f64, deficit_of_free: f64, opening_of_critical: f64| {
        let oil = Measured {
            largest: largest * STEADY,
            film: Some(FilmEvidence {
                lag_rad: 0.02,
                speed_deficit: 0.07 * deficit_of_free,
                opening_gap_rad: opening_of_critical * largest * STEADY,
                free_share: 0.07,
            }),
            ..measured(beta0, PRESSURE)
        };
        decide(&case, &case.raceways[0], oil, statistics()).verdict
    };
    assert_eq!(of(1.0, 1.3 - 1e-9, 0.65 - 1e-9), RacewayVerdict::Smooth);
    assert_eq!(of(1.0, 1.3 + 1e-9, 0.65 + 1e-9), RacewayVerdict::FilmQueue);
    assert_eq!(of(1.0, 1.0, 0.65 + 1e-9), RacewayVerdict::FilmOutweighs);
    assert_eq!(of(0.79, 1.0, 0.65 + 1e-9), RacewayVerdict::FilmOutweighs);
    assert_eq!(of(1.1 - 1e-9, 1.0, 0.3), RacewayVerdict::Smooth);
    assert_eq!(of(1.1 + 1e-9, 1.0, 0.3), RacewayVerdict::TooDeep);
    assert_eq!(of(0.79, 1.0, 0.3), RacewayVerdict::TooShallow);
    assert_eq!(of(1.0, f64::NAN, 0.3), RacewayVerdict::NotJudged);
}

/// A shallow raceway beside one that spreads the balls is none too many: the largest critical gap counts.
#[test]
fn the_largest_critical_gap_counts() {
    let case = structure(5.1, 25.2);
    let beta0 = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
    let of = |fraction: f64| {
        let alone = Measured {
            largest: fraction * STEADY,
            ..measured(beta0, PRESSURE)
        };
        decide(&case, &case.raceways[0], alone, statistics()).verdict
    };
    assert_eq!(of(0.79), RacewayVerdict::TooShallow);
    assert_eq!(of(0.81), RacewayVerdict::Smooth);
    assert_eq!(of(1.01), RacewayVerdict::TooDeep);
}

/// In plane and space a pressure above the limit is worse than all motion, and the limit itself passes.
#[test]
fn an_overload_decides() {
    for in_space in [false, true] {
        let mut case = structure(5.1, 25.2);
        case.motion = if in_space {
            Motion::Space
        } else {
            Motion::BySymmetry
        };
        let beta0 = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Published);
        let under = |pressure_pa: f64, statistics| {
            decide(
                &case,
                &case.raceways[0],
                measured(beta0, pressure_pa),
                statistics,
            )
            .verdict
        };
        assert_eq!(under(4.2e9, statistics()), RacewayVerdict::Smooth);
        let beyond = 4.2e9f64.next_up();
        assert_eq!(under(beyond, statistics()), RacewayVerdict::Overloaded);
        let sliding = PassageStatistics {
            speed_drop_fraction: 0.2,
            lag_fraction: 0.2,
            ..statistics()
        };
        assert_eq!(under(6.3e9, sliding), RacewayVerdict::Overloaded);
        assert_eq!(under(f64::NAN, statistics()), RacewayVerdict::NotJudged);
        assert_eq!(under(f64::NAN, sliding).passes(), Some(false));
    }
}

/// The numbers of a judgement are in its reasons, each in the unit that it is shown in.
#[test]
fn reasons_have_the_numbers() {
    let judged = decided(0.97, statistics());
    assert_eq!(judged.passages, Some(statistics()));
    let expected = [
        PRESSURE_AT_REST.of(1410.0 / 4200.0),
        SEPARATION.of(0.03),
        DECELERATION.of(0.93),
        STEADY_GAP.of(0.97 * 1.8171f64.to_radians() / STEADY),
        BOTH_NEIGHBOURS.of(0.12),
    ];
    assert_eq!(judged.criteria.len(), expected.len());
    for (found, expected) in judged.criteria.iter().zip(expected) {
        assert_eq!(found.name(), expected.name());
        assert!((found.value - expected.value).abs() < 1e-4);
    }
    let text = judged.reasons.join("\n");
    for part in [
        "sliding lowers the critical gap by 3.0 % of β0 (limit 5 %",
        "12.0 % of the passages have a double collision (limit 25 %",
        "pressure at rest reaches 1410 MPa (limit 4200 MPa of ISO 76",
        "balls reach 93.0 % of the kinematic deceleration (80 % needed",
        // Two balls are 2·(360°/14 − 23.898°) + 2·23.898° = 51.43° apart: three from there.
        "2θ = 50.40°: up to 2 evenly spaced balls inside at once (three from 51.43°)",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let above = decided(1.02, statistics()).reasons.join("\n");
    assert!(
        above.contains("sliding does not lower the critical gap"),
        "{above}"
    );
}

/// Of several raceways: the worst verdict, its first raceway's criterion and passages, and the
/// largest critical gap of all.
#[test]
fn the_worst_raceway_decides() {
    let mut judged: Vec<RacewayJudgement> = [(0.99, 0.9), (0.97, 0.81), (1.0, 0.95)]
        .into_iter()
        .enumerate()
        .map(|(k, (gap, drop))| {
            let mut all = statistics();
            all.speed_drop_fraction = drop;
            all.passages = 100 + k;
            decided(gap, all)
        })
        .collect();
    let all = summary(judged.clone(), None);
    assert_eq!(all.verdict, RacewayVerdict::Smooth);
    // Nearest to its limit: 0.01 of 0.2.
    assert_eq!(all.deciding, Some(DECELERATION.of(0.81)));
    assert_eq!(all.critical_gap_rad, judged[2].critical_gap_rad);
    assert_eq!(all.passages.map(|p| p.passages), Some(100));
    let headline = all.headline();
    assert!(
        headline.starts_with(
            "works from evenly spaced balls: smooth; nearest to its limit: balls reach 81.0 %"
        ),
        "{headline}"
    );
    for (k, number) in [(0, "raceway 1: "), (2, "raceway 3: ")] {
        assert!(all.reasons[6 * k].starts_with(number), "{:?}", all.reasons);
    }

    for (k, fraction) in [(1, 0.7), (2, 0.4)] {
        let mut worse = statistics();
        worse.double_collision_fraction = fraction;
        worse.passages = 100 + k;
        judged[k] = decided(0.86 + 0.08 * k as f64, worse);
    }
    // The third collides twice, the second slips as well: it is the worst.
    let all = summary(judged.clone(), None);
    assert_eq!(all.verdict, RacewayVerdict::Slips);
    let deciding = all.deciding.unwrap();
    assert_eq!(deciding.name(), "separation");
    assert!((deciding.value - 0.06).abs() < 1e-9);
    // Missed by 1 percentage point, double collisions by 45.
    let headline = all.headline();
    assert!(
        headline.contains("; missed by most: 70.0 % of the passages"),
        "{headline}"
    );
    assert_eq!(all.passages.map(|p| p.passages), Some(101));
    assert_eq!(all.passes(), Some(false));
    judged.remove(1);
    let all = summary(judged.clone(), None);
    assert_eq!(all.verdict, RacewayVerdict::DoubleCollision);
    assert_eq!(all.deciding, Some(BOTH_NEIGHBOURS.of(0.4)));
    let headline = all.headline();
    assert!(
        headline.starts_with("does not work from evenly spaced balls: double collision; 40.0 %"),
        "{headline}"
    );
    // A raceway that is not judged keeps all from passing, not from failing.
    let unjudged = not_judged("stopped".to_owned(), None);
    let all = summary(vec![decided(0.99, statistics()), unjudged.clone()], None);
    assert_eq!(
        (all.verdict, all.passes()),
        (RacewayVerdict::NotJudged, None)
    );
    assert_eq!(all.headline(), "not judged: stopped");
    let all = summary(vec![judged[1].clone(), unjudged], None);
    assert_eq!(all.passes(), Some(false));
    judged.push(infeasible("no passage".to_owned(), None));
    let all = summary(judged, None);
    assert_eq!(all.verdict, RacewayVerdict::Infeasible);
    assert_eq!((all.deciding, all.passages), (None, None));
    assert!(all.critical_gap_rad.is_some());
}

/// The deceleration is measured between Ω on the plain ring and Ω at the depth of the raceway:
/// Zhao 2022, Eq. (3).
#[test]
fn decelerations_are_fractions_of_the_kinematic_one() {
    let case = structure(5.1, 25.2);
    for (span_mm, angle_deg, centre_deg) in [(5.1, 25.2, 0.0), (5.6, 15.774, 70.0)] {
        let raceway = raceway(&case.bearing, span_mm, angle_deg, centre_deg);
        // Two points of a ball of radius Rw touch a span lC: r = √(Rw² − (lC/2)²) at the middle.
        let r = (4.7625f64.powi(2) - (span_mm / 2.0).powi(2)).sqrt() * 1e-3;
        let middle = raceway.effective_radius_m(centre_deg.to_radians());
        assert!((middle - r).abs() < 1e-4, "{middle} {r}");
        let speed = |r: f64| {
            case.operation.inner_speed_rad_s * 18.24 / (0.5 * (18.24 + 27.765))
                * (1.0 - 4.7625e-3 / (r + 4.7625e-3))
        };
        let (plain, slowed) = (speed(4.7625e-3), speed(middle));
        for fraction in [0.0, 0.3, 1.0] {
            let slowest = plain + fraction * (slowed - plain);
            let found = speed_drop_fraction(&case, &raceway, slowest);
            assert!((found - fraction).abs() < 1e-9, "{found} {fraction}");
        }
    }
}
