//! Tolerances: what trials deviate by, and what is made of their outcomes.

use crate::common::structure;
use cageless::Case;
use cageless::design::{PassageStatistics, RacewayVerdict};
use cageless::tolerance::{Influence, Outcome, Tolerances, Trial, assess, ball_grade, trials};

fn tolerances() -> Tolerances {
    Tolerances {
        groove_depth_m: 2e-6,
        axial_span_m: 20e-6,
        half_angle_rad: 0.002,
        section_angle_rad: 0.0,
        ball_grade: ball_grade(10),
        friction: 0.002,
        clearance_m: 5e-6,
        speed_fraction: 0.05,
        load_fraction: 0.2,
    }
}

fn case() -> Case {
    structure(5.1, 25.2)
}

/// Range of every influence in [`case`] as [`tolerances`] state it, SI units.
const RANGES: [(Influence, f64, f64); 8] = [
    (Influence::GrooveDepth, -2e-6, 2e-6),
    (Influence::AxialSpan, -20e-6, 20e-6),
    (Influence::HalfAngle, -0.002, 0.002),
    // A quarter of the 0.5 µm of ISO 3290-1 for G10: half of it in radius, to either side.
    (Influence::BallRadius, -0.125e-6, 0.125e-6),
    (Influence::Friction, -0.002, 0.002),
    // The paper's bearing has no clearance: less of it is interference.
    (Influence::Clearance, -5e-6, 5e-6),
    // 5 % of 12 000 rpm, 20 % of 1500 N.
    (
        Influence::Speed,
        -62.831_853_071_795_86,
        62.831_853_071_795_86,
    ),
    (Influence::Load, -300.0, 300.0),
];

/// Everything stays within its range, fills it, and is the same for the same seed.
#[test]
fn samples_fill_their_ranges() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 400, 7);
    assert_eq!(all, trials(&case, &tolerances, 400, 7));
    assert_ne!(all, trials(&case, &tolerances, 400, 8));
    let samples: Vec<&Trial> = all.iter().rev().take(400).collect();
    // The plane has all but the last.
    let planar = Influence::ALL.split_last().unwrap();
    assert_eq!(*planar.0, Influence::SectionAngle);
    assert_eq!(RANGES.map(|r| r.0), planar.1);
    for (influence, low, high) in RANGES {
        let [from, to] = tolerances.range(&case, influence);
        let span = high - low;
        assert!((from - low).abs() < 1e-9 * span && (to - high).abs() < 1e-9 * span);
        let values: Vec<f64> = match influence {
            Influence::BallRadius => {
                let radii = |t: &&Trial| t.deviation.ball_radius_m().to_vec();
                samples.iter().flat_map(radii).collect()
            }
            _ => samples
                .iter()
                .map(|t| t.deviation.value(influence))
                .collect(),
        };
        let name = influence.name();
        let fraction = |v: f64| (v - low) / span;
        assert!(values.iter().all(|v| (0.0..=1.0).contains(&fraction(*v))));
        let mean = values.iter().map(|v| fraction(*v)).sum::<f64>() / values.len() as f64;
        // Five standard errors of 400 uniform numbers.
        assert!((mean - 0.5).abs() < 0.072, "{name}: {mean}");
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(fraction(least) < 0.03 && fraction(most) > 0.97, "{name}");
        // Alone at both ends of the range that deviates at all.
        let alone = all.iter().filter(|t| t.influence == Some(influence));
        let alone: Vec<f64> = alone.map(|t| t.deviation.value(influence)).collect();
        let ends: &[f64] = match influence {
            Influence::BallRadius => &[0.0; 4],
            _ => &[from, to],
        };
        assert_eq!(alone, ends, "{name}");
    }
    // The paper's bearing has no clearance: less of it is interference, up to its limit.
    let range = |t: &Tolerances| t.range(&case, Influence::Clearance);
    assert_eq!(range(&tolerances), [-5e-6, 5e-6]);
    let wide = Tolerances {
        clearance_m: 2e-4,
        ..tolerances
    };
    assert!(
        (range(&wide)[0] + 146.32e-6).abs() < 0.04e-6,
        "{:?}",
        range(&wide)
    );
}

/// A trial is the case with just that deviation, whatever deviates in the case already.
#[test]
fn trials_change_what_they_say() {
    let tolerances = tolerances();
    let mut uneven = case();
    uneven.bearing = (uneven.bearing.clone())
        .with_ball_radius_deviations((0..14).map(|k| -1e-7 * f64::from(k)).collect())
        .unwrap();
    let shallow = uneven.raceways[0]
        .clone()
        .with_depth_error(-1.5e-6)
        .unwrap();
    let uneven = uneven.with_raceways(vec![shallow]);
    for case in [case(), uneven] {
        let all = trials(&case, &tolerances, 3, 1);
        assert_eq!(all[0].deviation.apply(&case).unwrap(), case);
        for trial in &all[1..] {
            let varied = trial.deviation.apply(&case).unwrap();
            assert_ne!(varied, case);
            let numbers = |case: &Case| {
                let raceway = &case.raceways[0];
                [
                    (Influence::GrooveDepth, raceway.depth_error_m()),
                    (Influence::AxialSpan, raceway.dimensions().axial_span_m),
                    (Influence::HalfAngle, raceway.half_angle_rad()),
                    (Influence::Friction, case.contact.friction.coefficient),
                    (
                        Influence::Clearance,
                        case.bearing.radial_internal_clearance_m(),
                    ),
                    (Influence::Speed, case.operation.inner_speed_rad_s),
                    (Influence::Load, case.operation.radial_load_n),
                ]
            };
            for ((influence, new), (_, old)) in numbers(&varied).into_iter().zip(numbers(&case)) {
                let by = trial.deviation.value(influence);
                let rounding = 1e-12 * (1e-3 + old.abs());
                let name = influence.name();
                assert!(
                    (new - old - by).abs() < rounding,
                    "{name}: {old} {new} {by}"
                );
                let deviates = trial.influence.is_none_or(|only| only == influence);
                assert_eq!(by != 0.0, deviates, "{name} of {trial:?}");
            }
            let deviates = trial
                .influence
                .is_none_or(|only| only == Influence::BallRadius);
            let lot = trial.deviation.ball_radius_m();
            assert_eq!(lot.len(), if deviates { 14 } else { 0 });
            for k in 0..14 {
                let by = lot.get(k).copied().unwrap_or(0.0);
                let [new, old] = [&varied, &case].map(|c| c.bearing.ball(k).radius_m);
                assert!((new - old - by).abs() < 1e-17, "{k}: {old} {new} {by}");
            }
        }
    }
}

fn outcome(verdict: RacewayVerdict, number: f64) -> Outcome {
    Outcome {
        verdict,
        critical_gap_rad: Some(number),
        passages: Some(PassageStatistics {
            lag_fraction: 5.0 * number,
            double_collision_fraction: 10.0 * number,
            sliding_mean_m_s: 30.0 * number,
            ..PassageStatistics::default()
        }),
        reason: None,
        headline: format!("headline {number}"),
    }
}

/// A row has the range over its trials and the nominal bearing; quantiles are those of all samples.
#[test]
fn rows_and_quantiles_are_those_of_their_outcomes() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 100, 1);
    let mut outcomes = vec![outcome(RacewayVerdict::Smooth, 200.0); all.len()];
    let rows = all.iter().filter(|t| t.influence.is_some()).count();
    for (k, outcome_of) in outcomes.iter_mut().enumerate().skip(1) {
        let number = if k > rows {
            // 1 to 100 in another order: 37 is prime to 101.
            (37 * (k - rows) % 101) as f64
        } else {
            k as f64
        };
        let verdict = match k {
            2 => RacewayVerdict::DoubleCollision,
            5 => RacewayVerdict::Slips,
            _ if number == 3.0 && k > rows => RacewayVerdict::Infeasible,
            _ => RacewayVerdict::Smooth,
        };
        *outcome_of = outcome(verdict, number);
    }
    let found = assess(&all, &outcomes);
    let samples = found.samples.as_ref().unwrap();
    assert_eq!(
        samples.critical_gap_quantiles_rad,
        Some([5.95, 50.5, 95.05]),
        "of 1 to 100"
    );
    assert_eq!((samples.count, samples.passed), (100, 99));
    assert_eq!(samples.pass_probability, 0.99);
    // Wilson's interval of 99 in 100.
    for (found, expected) in samples
        .pass_probability_interval
        .iter()
        .zip([0.9455, 0.9982])
    {
        assert!((found - expected).abs() < 1e-4, "{found}");
    }
    let counts = samples
        .verdicts
        .map(|(verdict, count)| (verdict.name(), count));
    let expected = [
        ("smooth", 99),
        ("double-collision", 0),
        ("slips", 0),
        ("loses-lag", 0),
        ("overloaded", 0),
        ("infeasible", 1),
    ];
    assert_eq!(counts, expected);
    assert_eq!(samples.outcomes, outcomes[rows + 1..]);
    let mut first = 1;
    for row in &found.influences {
        let last = first + row.trials - 1;
        let trials = &all[first..=last];
        assert!(trials.iter().all(|t| t.influence == Some(row.influence)));
        let range = |factor: f64| Some([factor * first as f64, factor * 200.0]);
        assert_eq!(row.critical_gap_rad, range(1.0), "{}", row.influence.name());
        assert_eq!(row.double_collision_fraction, range(10.0));
        assert_eq!(row.sliding_mean_m_s, range(30.0));
        let fails = [2, 5]
            .iter()
            .filter(|k| (first..=last).contains(*k))
            .count();
        assert_eq!(row.passed, row.trials - fails);
        let verdicts = outcomes[first..=last].iter().map(|o| o.verdict);
        assert!(verdicts.clone().all(|v| row.verdicts.contains(&v)));
        assert!(row.verdicts.windows(2).all(|w| w[0] < w[1]), "worst last");
        first = last + 1;
    }
    assert_eq!(first, rows + 1);
}

/// The tolerances pass from 95 % of the bearings on, if the nominal one does.
#[test]
fn tolerances_pass_from_their_share_on() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 100, 1);
    let assessment = |failing: usize, nominal| {
        let mut outcomes = vec![outcome(RacewayVerdict::Smooth, 1.0); all.len()];
        outcomes[0] = outcome(nominal, 2.0);
        outcomes[all.len() - failing..].fill(outcome(RacewayVerdict::Slips, 1.0));
        assess(&all, &outcomes)
    };
    assert!(assessment(5, RacewayVerdict::Smooth).passes());
    assert!(!assessment(6, RacewayVerdict::Smooth).passes());
    assert!(!assessment(0, RacewayVerdict::Slips).passes());
    assert_eq!(
        assessment(6, RacewayVerdict::Smooth).headline(),
        "FAIL: 94 of 100 bearings pass, probability of passing 94.0 % (95 % interval 87.5 to \
         97.2 %, 95 % needed); nominal design headline 2"
    );
    let none = trials(&case, &tolerances, 0, 1);
    let outcomes = vec![outcome(RacewayVerdict::Smooth, 1.0); none.len()];
    let without = assess(&none, &outcomes);
    assert!(without.passes() && without.samples.is_none());
    assert_eq!(without.headline(), "PASS; nominal design headline 1");
}
