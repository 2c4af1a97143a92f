//! Tolerances: what trials deviate by, and what is made of their outcomes.

use crate::common::structure;
use cageless::Case;
use cageless::design::RacewayVerdict;
use cageless::tolerance::{Influence, Outcome, Tolerances, Trial, assess, ball_grade, trials};

fn tolerances() -> Tolerances {
    Tolerances {
        groove_depth_m: 2e-6,
        axial_span_m: 20e-6,
        half_angle_rad: 0.002,
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

/// Everything stays within its range, fills it, and is the same for the same seed.
#[test]
fn samples_fill_their_ranges() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 400, 7);
    assert_eq!(all, trials(&case, &tolerances, 400, 7));
    assert_ne!(all, trials(&case, &tolerances, 400, 8));
    let samples: Vec<&Trial> = all.iter().rev().take(400).collect();
    for influence in Influence::ALL {
        let [low, high] = tolerances.range(&case, influence);
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
        let fraction = |v: f64| (v - low) / (high - low);
        assert!(values.iter().all(|v| (0.0..=1.0).contains(&fraction(*v))));
        let mean = values.iter().map(|v| fraction(*v)).sum::<f64>() / values.len() as f64;
        // Five standard errors of 400 uniform numbers.
        assert!((mean - 0.5).abs() < 0.072, "{}: {mean}", influence.name());
    }
    // The paper's bearing has no clearance: less of it is interference, up to its limit.
    let range = |t: &Tolerances| t.range(&case, Influence::Clearance);
    assert_eq!(range(&tolerances), [-5e-6, 5e-6]);
    let wide = Tolerances {
        clearance_m: 1e-4,
        ..tolerances
    };
    assert!(
        (range(&wide)[0] + 73.16e-6).abs() < 0.02e-6,
        "{:?}",
        range(&wide)
    );
}

/// A trial is the case with just that deviation.
#[test]
fn trials_change_what_they_say() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 3, 1);
    assert_eq!(all[0].deviation.apply(&case).unwrap(), case);
    for trial in &all[1..] {
        let varied = trial.deviation.apply(&case).unwrap();
        assert_ne!(varied, case);
        let of = |influence| trial.deviation.value(influence);
        let clearance = varied.bearing.radial_clearance_m() - case.bearing.radial_clearance_m();
        assert!((clearance - of(Influence::Clearance)).abs() < 1e-12);
        let (new, old) = (
            varied.raceways[0].dimensions(),
            case.raceways[0].dimensions(),
        );
        assert_eq!(
            new.axial_span_m,
            old.axial_span_m + of(Influence::AxialSpan)
        );
        assert_eq!(
            varied.raceways[0].depth_error_m(),
            of(Influence::GrooveDepth)
        );
        let radii = varied.bearing.ball_radius_deviations_m();
        assert_eq!(radii, trial.deviation.ball_radius_m());
    }
}

#[test]
fn outcomes_are_counted() {
    let (case, tolerances) = (case(), tolerances());
    let all = trials(&case, &tolerances, 10, 1);
    let outcome = |verdict, gap: f64| Outcome {
        verdict,
        critical_gap_rad: Some(gap),
        double_collision_fraction: None,
        collisions_mean: None,
        slip_mean_m_s: None,
        reason: None,
        headline: String::new(),
    };
    let mut outcomes = vec![outcome(RacewayVerdict::Smooth, 0.03); all.len()];
    // The low end of the friction, and three of the samples.
    let friction = all
        .iter()
        .position(|t| t.influence == Some(Influence::Friction))
        .unwrap();
    outcomes[friction] = outcome(RacewayVerdict::Slips, 0.02);
    let n = all.len();
    outcomes[n - 3..].fill(outcome(RacewayVerdict::Slips, 0.01));
    let assessment = assess(&all, &outcomes);
    for row in &assessment.influences {
        let expected = if row.influence == Influence::Friction {
            1
        } else {
            0
        };
        assert_eq!(
            row.trials - row.passed,
            expected,
            "{}",
            row.influence.name()
        );
    }
    let samples = assessment.samples.unwrap();
    assert_eq!((samples.count, samples.passed), (10, 7));
    assert_eq!(samples.critical_gap_quantiles_rad, Some([0.01, 0.03, 0.03]));
    let [low, high] = samples.pass_probability_interval;
    assert!(low < 0.7 && 0.7 < high);
}
