//! Tolerances: what trials deviate by, and what is made of their outcomes.

use crate::common::oil;
use crate::common::structure;
use cageless::Case;
use cageless::ball_grade;
use cageless::film::Film;
use cageless::simulation::{Cause, Control, Stop};
use cageless_design::tolerance::{
    Assessment, Influence, InfluenceResult, Outcome, Tolerances, Trial, assess, trials,
};
use cageless_design::{PassageStatistics, RacewayVerdict, judge};

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
        viscosity_fraction: 0.3,
        supply_factor: 2.0,
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
    // The plane has all but those of space and oil.
    let (planar, others) = Influence::ALL.split_at(RANGES.len());
    let of_others = [
        Influence::SectionAngle,
        Influence::Viscosity,
        Influence::Supply,
    ];
    assert_eq!(others, of_others);
    assert_eq!(RANGES.map(|r| r.0), planar);
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
        steady_gap_rad: None,
        passages: Some(PassageStatistics {
            lag_fraction: 5.0 * number,
            double_collision_fraction: 10.0 * number,
            sliding_mean_m_s: 30.0 * number,
            ..PassageStatistics::default()
        }),
        reason: None,
        headline: format!("headline {number}"),
        dry: None,
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
    let found = assess(&all, &known(&outcomes));
    let samples = found.samples.as_ref().unwrap();
    assert_eq!(
        samples.critical_gap_quantiles_rad,
        Some([5.95, 50.5, 95.05]),
        "of 1 to 100"
    );
    assert_eq!((samples.count, samples.passed), (100, 99));
    assert_eq!(samples.pass_probability, Some(0.99));
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
        ("not-judged", 0),
        ("double-collision", 0),
        ("too-shallow", 0),
        ("too-deep", 0),
        ("film-outweighs", 0),
        ("film-queue", 0),
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

fn known(outcomes: &[Outcome]) -> Vec<Option<Outcome>> {
    outcomes.iter().cloned().map(Some).collect()
}

/// The nominal bearing with this verdict, and samples of which some slip.
fn sampled(count: u64, failing: usize, nominal: RacewayVerdict) -> Assessment {
    let all = trials(&case(), &tolerances(), count, 1);
    let mut outcomes = vec![outcome(RacewayVerdict::Smooth, 1.0); all.len()];
    outcomes[0] = outcome(nominal, 2.0);
    outcomes[all.len() - failing..].fill(outcome(RacewayVerdict::Slips, 1.0));
    assess(&all, &known(&outcomes))
}

/// The tolerances pass where the nominal bearing does and the interval of the probability lies above 95 %, fail
/// where it lies below, and are not judged in between.
#[test]
fn tolerances_are_judged_by_the_interval_of_the_probability() {
    use RacewayVerdict::{Slips, Smooth};
    // By R, prop.test(198, 200, correct = FALSE): 96.4 to 99.7 %; 178 of 200: 83.9 to 92.6 %.
    let rows = [
        (200, 2, Smooth, Some(true)),
        (200, 22, Smooth, Some(false)),
        (200, 0, Slips, Some(false)),
        (73, 0, Smooth, Some(true)),
        (72, 0, Smooth, None),
        (1, 0, Smooth, None),
        (100, 6, Smooth, None),
    ];
    for (count, failing, nominal, passes) in rows {
        let found = sampled(count, failing, nominal).passes();
        assert_eq!(found, passes, "{failing} of {count}");
    }
    for (count, failing, text) in [
        (
            200,
            22,
            "does not work: 178 of 200 bearings pass, probability of passing 89.0 % (95 % interval 83.9 to 92.6 %, \
             95 % needed); nominal design headline 2",
        ),
        (
            1,
            0,
            "not judged: 1 of 1 bearings pass, probability of passing 100.0 % (95 % interval 20.7 to 100.0 %, \
             95 % needed); at least 73 bearings are needed to show 95 %; nominal design headline 2",
        ),
        (
            100,
            6,
            "not judged: 94 of 100 bearings pass, probability of passing 94.0 % (95 % interval 87.5 to 97.2 %, \
             95 % needed); the interval includes 95 %, more bearings narrow it; nominal design headline 2",
        ),
    ] {
        assert_eq!(sampled(count, failing, Smooth).headline(), text);
    }
    let none = sampled(0, 0, Smooth);
    assert!(none.passes() == Some(true) && none.samples.is_none());
    // The nominal bearing alone is judged.
    assert_eq!(
        none.headline(),
        "works as drawn, all tolerances together are not judged; nominal design headline 2"
    );
}

/// A bearing whose run stopped neither passes nor fails: the interval holds whichever it would do, and nothing is
/// the mean or the range of the rest.
#[test]
fn a_run_that_stopped_is_neither_a_pass_nor_a_failure() {
    use RacewayVerdict::{NotJudged, Slips, Smooth};
    let all = trials(&case(), &tolerances(), 200, 1);
    let rows = all.iter().filter(|t| t.influence.is_some()).count();
    let stopped = Outcome {
        critical_gap_rad: None,
        steady_gap_rad: None,
        passages: None,
        reason: Some("the run stopped at t = 0.1 s".to_owned()),
        ..outcome(NotJudged, 1.0)
    };
    let found = |passed: usize, open: usize, in_row: bool| {
        let mut outcomes = vec![outcome(Smooth, 1.0); all.len()];
        outcomes[rows + 1 + passed..].fill(outcome(Slips, 1.0));
        outcomes[rows + 1 + passed..][..open].fill(stopped.clone());
        if in_row {
            outcomes[2] = stopped.clone();
        }
        assess(&all, &known(&outcomes))
    };
    // By R, prop.test without correction: 197 of 200: 95.7 to 99.5 %, 190 of 200: 91.0 to 97.3 %.
    let one = found(197, 3, true);
    let samples = one.samples.as_ref().unwrap();
    let [low, high] = samples.pass_probability_interval;
    assert!((low - 0.957).abs() < 5e-4 && high == 1.0, "{low} {high}");
    assert_eq!((samples.open, samples.pass_probability), (3, None));
    assert_eq!(samples.critical_gap_quantiles_rad, None);
    assert_eq!(one.passes(), Some(true), "whatever the three do");
    assert_eq!(one.stopped(), Some((4, "the run stopped at t = 0.1 s")));
    let row = &one.influences[0];
    assert_eq!((row.critical_gap_rad, row.sliding_mean_m_s), (None, None));
    assert_eq!(row.open.len(), 1);
    assert!(one.influences[1].critical_gap_rad.is_some());
    assert!(
        one.headline()
            .starts_with("works: 197 of 200 bearings pass, 3 are not judged, probability of")
    );
    // Fails if the stopped ones fail, passes if they pass.
    let open = found(190, 10, false);
    assert_eq!(open.passes(), None);
    assert_eq!(found(170, 10, false).passes(), Some(false));
    let nominal = {
        let mut outcomes = vec![outcome(Smooth, 1.0); all.len()];
        outcomes[0] = stopped.clone();
        assess(&all, &known(&outcomes))
    };
    assert_eq!(nominal.passes(), None);
    assert_eq!(open.stopped().map(|(count, _)| count), Some(10));
    assert_eq!(found(200, 0, false).stopped(), None);
}

/// What was interrupted is not judged unless the nominal bearing fails, and rows that lack a bearing are named
/// in place of being shown.
#[test]
fn an_interrupted_analysis_is_not_judged() {
    let all = trials(&case(), &tolerances(), 100, 1);
    let rows = all.iter().filter(|t| t.influence.is_some()).count();
    let interrupted = |nominal, judged: usize| {
        let mut outcomes = vec![Some(outcome(RacewayVerdict::Smooth, 1.0)); all.len()];
        outcomes[0] = Some(outcome(nominal, 2.0));
        outcomes[judged..].fill(None);
        assess(&all, &outcomes)
    };
    // The nominal bearing, both ends of one influence and one of the next.
    let found = interrupted(RacewayVerdict::Smooth, 4);
    assert_eq!(
        (found.passes(), found.judged, found.asked),
        (None, 4, all.len())
    );
    let of_all = all.len();
    assert_eq!(
        found.headline(),
        format!("not judged: interrupted after 4 of {of_all} bearings; nominal design headline 2")
    );
    let shown: Vec<Influence> = found.influences.iter().map(|row| row.influence).collect();
    assert_eq!(shown, [all[1].influence.unwrap()]);
    assert_eq!(found.incomplete[0], all[3].influence.unwrap());
    assert_eq!(shown.len() + found.incomplete.len(), assess_all(&all).len());
    // All rows, and as many samples as would pass on their own.
    let found = interrupted(RacewayVerdict::Smooth, rows + 1 + 99);
    assert!(found.passes().is_none() && found.incomplete.is_empty());
    let text = format!(
        "not judged: interrupted after {} of {of_all} bearings; 99 of 99",
        rows + 100
    );
    assert!(found.headline().starts_with(&text), "{}", found.headline());
    let fails = interrupted(RacewayVerdict::Slips, 4);
    assert_eq!(fails.passes(), Some(false));
    assert!(
        fails.headline().starts_with("does not work: interrupted"),
        "{}",
        fails.headline()
    );
}

fn assess_all(all: &[Trial]) -> Vec<InfluenceResult> {
    let outcomes = vec![Some(outcome(RacewayVerdict::Smooth, 1.0)); all.len()];
    assess(all, &outcomes).influences
}

/// ISO 3290-1:2014: balls of a lot of grade G differ by G/20 µm in diameter, of G3 by 0.13 µm; half of half of it to either
/// side in radius. Other numbers are no grades.
#[test]
fn grades_of_balls_are_those_of_iso_3290() {
    let known: Vec<u32> = (0..1000).filter(|n| ball_grade(*n).is_some()).collect();
    assert_eq!(known, [3, 5, 10, 16, 20, 24, 28, 40, 60, 100, 200]);
    for number in known {
        let lot_um = match number {
            3 => 0.13,
            number => f64::from(number) / 20.0,
        };
        let grade = ball_grade(number).unwrap();
        assert_eq!(grade.number, number);
        assert!(
            (1e6 * grade.lot_variation_m / lot_um - 1.0).abs() < 1e-12,
            "G{number}"
        );
        assert!(
            (4e6 * grade.radius_deviation_m() / lot_um - 1.0).abs() < 1e-12,
            "G{number}"
        );
    }
}

/// A bearing that gives way has its verdict; one whose computation fails has none.
#[test]
fn a_bearing_whose_computation_fails_is_not_judged() {
    let judged = judge(&case(), &mut |_| Control::Continue(())).unwrap();
    let outcome = |cause: Cause| {
        let mut judged = judged.clone();
        judged.stopped = Some(Stop {
            time_s: 0.01,
            step_s: 1e-6,
            automatic_step_s: 1e-6,
            drop: false,
            cause,
        });
        Outcome::judged(&judged)
    };
    let gave_way = outcome(Cause::OffSupport);
    assert_eq!(gave_way.verdict, judged.verdict);
    let failed = outcome(Cause::NotFinite);
    assert_eq!(failed.verdict, RacewayVerdict::NotJudged);
    assert!(failed.reason.unwrap().contains("finite"));
    assert!(judged.verdict != RacewayVerdict::NotJudged);
}

/// Viscosity by 30 % and supply by a factor of 2 to either side, within a flooded contact; dry bearings are drawn as
/// before, and those with oil as dry ones but for their oil.
#[test]
fn oil_has_tolerances_of_its_own() {
    let tolerances = tolerances();
    let dry = case();
    let all_dry = trials(&dry, &tolerances, 50, 7);
    for (supply, expected) in [
        (1.0, [-0.5, 0.0]),
        (0.65, [-0.325, 0.35]),
        (0.1, [-0.05, 0.1]),
    ] {
        let mut wet = dry.clone();
        let film = Film {
            supply,
            ..Film::flooded(oil(5.0))
        };
        wet.film = Some(film);
        let range = tolerances.range(&wet, Influence::Supply);
        for (found, expected) in range.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{supply}: {range:?}");
        }
        assert_eq!(
            tolerances.range(&wet, Influence::Viscosity),
            [-1.5e-3, 1.5e-3]
        );
        let all = trials(&wet, &tolerances, 50, 7);
        let alone = |of: Influence| all.iter().filter(|t| t.influence == Some(of)).count();
        assert_eq!(alone(Influence::Viscosity), 2);
        assert_eq!(alone(Influence::Supply), if supply == 1.0 { 1 } else { 2 });
        let mut drawn = [f64::INFINITY, f64::NEG_INFINITY];
        for (wet_trial, dry_trial) in all.iter().rev().zip(all_dry.iter().rev()).take(50) {
            for influence in &Influence::ALL[..8] {
                let of = |trial: &Trial| trial.deviation.value(*influence);
                assert_eq!(of(wet_trial), of(dry_trial));
            }
            let varied = wet_trial.deviation.apply(&wet).unwrap().film.unwrap();
            assert!((0.0..=1.0).contains(&varied.supply));
            let relative = varied.oil.viscosity_pa_s / film.oil.viscosity_pa_s - 1.0;
            assert!(relative.abs() <= 0.3 + 1e-12, "{relative}");
            drawn = [drawn[0].min(relative), drawn[1].max(relative)];
        }
        assert!(drawn[0] < -0.2 && drawn[1] > 0.2, "{drawn:?}");
    }
}
