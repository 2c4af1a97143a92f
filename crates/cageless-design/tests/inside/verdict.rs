//! Verdicts: pass and fail, the margin, recommendations that keep their own verdict, and work
//! that ends when told to.

use std::f64::consts::TAU;

use crate::common::*;
use cageless::closed_forms::{Eq11, theoretical_gap_rad};
use cageless::passage::{Passage, PassageRecorder};
use cageless::raceway::RacewayDimensions;
use cageless::simulation::Control;
use cageless::{BearingDimensions, Case, Raceway};
use cageless_design::critical_gap::{CriticalGapError, PairTest, critical_gap_rad};
use cageless_design::search::{Job, Numbers, OperatingPoint, RacewayLayout, Task, run_jobs};
use cageless_design::{
    RacewayTallies, RacewayVerdict, RunEvidence, RunVerdict, judge, judge_watched, recommend,
    starting_point, steady_after_s, steady_case,
};

fn go_on(_: f64) -> Control {
    Control::Continue(())
}

fn with_raceway(case: &Case, dimensions: RacewayDimensions) -> Option<Case> {
    let raceway = Raceway::new(dimensions, &case.bearing).ok()?;
    Some(case.with_raceways(vec![raceway]))
}

/// A full-complement bearing of size 6008 without clearance, leapfrog.
fn full_6008(span_mm: f64, angle_deg: f64) -> Case {
    let dimensions = BearingDimensions {
        balls: 21,
        ball_radius_m: 3.969e-3,
        inner_groove_bottom_radius_m: 23.031e-3,
        outer_groove_bottom_radius_m: 30.974e-3,
        outer_shoulder_radius_m: 29e-3,
        inner_shoulder_radius_m: None,
        inner_groove_curvature_radius_m: 4.128e-3,
        outer_groove_curvature_radius_m: 4.128e-3,
        inner_ring_mass_kg: 0.2,
        inner_ring_damping_n_s_m: 2000.0,
    };
    let plain = conventional(dimensions);
    let raceway = raceway(&plain.bearing, span_mm, angle_deg, 0.0);
    OperatingPoint::from_case(&plain).case(&plain, vec![raceway])
}

#[test]
fn a_ring_without_raceway_is_not_judged() {
    let judgement = judge(&conventional(dimensions()), &mut go_on).unwrap();
    assert_eq!(judgement.verdict, RacewayVerdict::NotJudged);
    assert_eq!(
        (judgement.verdict.name(), judgement.passes()),
        ("not-judged", None)
    );
    let headline = judgement.headline();
    assert!(headline.starts_with("not judged: "), "{headline}");
}

/// The closed-form starting point of this bearing fails; what is recommended in its place passes,
/// and passes again when it is entered as the case's own.
#[test]
fn what_is_recommended_passes_its_own_verdict() {
    let case = full_6008(5.1, 25.2);
    let start = starting_point(&case, &mut go_on).unwrap().unwrap();
    let enter = |d: RacewayDimensions| {
        let raceway = Raceway::new(d, &case.bearing).ok()?;
        Some(OperatingPoint::from_case(&case).case(&case, vec![raceway]))
    };
    let mut fractions = vec![];
    let found = recommend(&case, &enter, &mut |fraction| {
        fractions.push(fraction);
        Control::Continue(())
    });
    let found = found.unwrap().unwrap();
    assert!(fractions.iter().all(|s| (0.0..=1.0).contains(s)));
    assert!(fractions.len() > 20, "progress is silent");
    assert_eq!(found.starting_point, start);
    assert!(found.passes(), "{}", found.judgement.headline());
    assert!(found.judged > 1 && found.judged <= 12, "{}", found.judged);
    // In numbers that can be printed.
    for value in [
        found.dimensions.axial_span_m * 1e6,
        found.dimensions.half_angle_rad.to_degrees() * 1e3,
    ] {
        assert!((value - value.round()).abs() < 1e-6, "{value}");
    }
    assert_eq!(
        judge(&enter(found.dimensions).unwrap(), &mut go_on).unwrap(),
        found.judgement
    );
    // It still spreads the balls.
    let own = enter(found.dimensions).unwrap();
    let beta0 = theoretical_gap_rad(&case.bearing, &own.raceways[0], Eq11::Published);
    assert!(beta0 > 0.84 * case.bearing.nominal_gap_rad());

    let middle = enter(RacewayDimensions {
        axial_span_m: start.axial_span_m,
        half_angle_rad: start.half_angle_rad,
        centre_angle_rad: 0.0,
    });
    let judgement = judge(&middle.unwrap(), &mut go_on).unwrap();
    assert_eq!(judgement.passes(), Some(false));
    let deciding = judgement.deciding.unwrap();
    assert_eq!(deciding.name(), "both-neighbours");
    assert!(deciding.value > 0.25, "{deciding}");
    let headline = judgement.headline();
    assert!(
        headline.starts_with("does not work from evenly spaced balls: double collision; "),
        "{headline}"
    );
    assert!(headline.contains("missed by"), "{headline}");
}

/// A raceway so deep that any gap closes has no critical gap, however near the last gap that is
/// tried comes to the largest.
#[test]
fn a_critical_gap_in_the_map_is_no_smaller_than_those_beside_it() {
    let case = full_6008(5.1, 25.2);
    let gap_deg = |span_mm: f64| {
        let job = Job {
            structure: RacewayLayout {
                axial_span_m: span_mm * 1e-3,
                half_angle_rad: 11.06f64.to_radians(),
                form: Default::default(),
                section_angle_rad: 0.0,
                centres_rad: vec![0.0],
            },
            point: OperatingPoint::from_case(&case),
            task: Task::PairSeparation,
        };
        match run_jobs(&case, &[&job], &mut go_on).swap_remove(0) {
            Some(Ok(Numbers::PairSeparation(spacing))) => spacing.critical_gap_rad.to_degrees(),
            other => panic!("{other:?}"),
        }
    };
    for span_mm in [5.17, 5.399, 5.63] {
        let gap = gap_deg(span_mm);
        assert!(gap > 0.3, "{gap}° at {span_mm} mm");
    }
}

/// Work that may take minutes at low speed ends within the passage of a pair.
#[test]
fn a_critical_gap_ends_when_told_to() {
    let mut case = full_6008(2.2, 11.5);
    case.operation.inner_speed_rad_s = 1.0;
    let interrupt = |calls: &mut u32| {
        *calls += 1;
        if *calls < 3 {
            Control::Continue(())
        } else {
            Control::Break(())
        }
    };
    let mut calls = 0;
    let gap = critical_gap_rad(&case, &PairTest::default(), &mut |_| interrupt(&mut calls));
    assert_eq!(gap, Err(CriticalGapError::Interrupted));
    assert_eq!(calls, 3);
    let mut calls = 0;
    let judgement = judge(&case, &mut |_| interrupt(&mut calls));
    assert_eq!(judgement, Err(CriticalGapError::Interrupted));
    let mut calls = 0;
    let enter = |d| with_raceway(&case, d);
    let found = recommend(&case, &enter, &mut |_| interrupt(&mut calls));
    assert_eq!(found, Err(CriticalGapError::Interrupted));
    let job = Job {
        structure: RacewayLayout::from_case(&case).unwrap(),
        point: OperatingPoint::from_case(&case),
        task: Task::PairSeparation,
    };
    let mut calls = 0;
    let outcomes = run_jobs(&case, &[&job], &mut |_| interrupt(&mut calls));
    assert_eq!(outcomes, [None]);
}

/// A verdict rests on the passages of all balls from the 16th to the 32nd orbit, raceway by
/// raceway: the same numbers from an observer of one's own on the same run.
#[test]
fn a_verdict_rests_on_the_steady_passages_of_each_raceway() {
    let case = structure(4.5, 25.0);
    let raceways = [(4.5, 25.0, -45.0), (4.9, 22.0, 45.0)];
    let raceways =
        raceways.map(|(span, angle, centre)| raceway(&case.bearing, span, angle, centre));
    let case = OperatingPoint::from_case(&case).case(&case, raceways.to_vec());
    let mut all: Vec<Passage> = vec![];
    let judgement = {
        let mut recorder = PassageRecorder::new(|passage| {
            all.push(passage);
            Ok(())
        });
        judge_watched(&case, &mut [&mut recorder], &mut go_on).unwrap()
    };
    // Ω = ωi·Ri/(2Rm) on the plain ring; one orbit of rolling balls.
    let speed = case.operation.inner_speed_rad_s * 18.24 / (18.24 + 27.765);
    let orbit_s = TAU / speed;
    let plain = steady_case(&case).solver.duration_s / orbit_s;
    assert!((plain - 32.0).abs() < 1e-9, "{plain}");
    assert!((steady_after_s(&case) / orbit_s - 16.0).abs() < 1e-9);
    for (r, judged) in judgement.raceways.iter().enumerate() {
        let of_raceway: Vec<&Passage> = (all.iter())
            .filter(|p| p.raceway == r && p.enter_s > 16.0 * orbit_s)
            .collect();
        let found = judged
            .passages
            .unwrap_or_else(|| panic!("{:?}", judged.reasons));
        let count = of_raceway.len();
        assert_eq!(found.passages, count);
        assert!(
            count.abs_diff(16 * 14) <= 14,
            "{count} of {} in all",
            all.len()
        );
        let mean = |of: &dyn Fn(&Passage) -> f64| {
            of_raceway.iter().map(|p| of(p)).sum::<f64>() / count as f64
        };
        let near = |found: f64, expected: f64, what: &str| {
            assert!(
                (found - expected).abs() <= 1e-9 * expected.abs(),
                "{what}: {found} {expected}"
            );
        };
        let touched = |p: &Passage| f64::from(p.collisions_ahead + p.collisions_behind);
        near(found.collisions_mean, mean(&touched), "collisions");
        let twice = |p: &Passage| f64::from(u8::from(p.collisions_ahead * p.collisions_behind > 0));
        near(found.double_collision_fraction, mean(&twice), "double");
        near(found.sliding_mean_m_s, mean(&|p| p.sliding_max_m_s), "slip");
        let raceway = &case.raceways[r];
        let depth = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
        let slowed = 2.0 * speed * (1.0 - 4.7625e-3 / (depth + 4.7625e-3));
        let slowest = mean(&|p| p.orbit_speed_range_rad_s[0]);
        near(
            found.speed_drop_fraction,
            (speed - slowest) / (speed - slowed),
            "drop",
        );
        let leaving = of_raceway.iter().map(|p| p.gap_leave_rad);
        near(
            found.gap_leave_max_rad,
            leaving.clone().fold(f64::MIN, f64::max),
            "largest",
        );
        near(
            found.gap_leave_min_rad,
            leaving.fold(f64::MAX, f64::min),
            "smallest",
        );
        // The critical gap is that of the raceway alone.
        let alone = case.with_raceways(vec![raceway.clone()]);
        let steady = cageless::closed_forms::steady_gap_rad(&alone.bearing, &alone.raceways);
        let test = PairTest::of_raceways(&alone, 0, steady);
        let gap = critical_gap_rad(&alone, &test, &mut go_on).unwrap();
        assert_eq!(judged.critical_gap_rad, Some(gap));
    }
    let [a, b] = [0, 1].map(|r| judgement.raceways[r].passages.unwrap());
    assert_ne!(a.sliding_mean_m_s, b.sliding_mean_m_s);
}

/// Evidence of a run whose pressures are in order.
fn evidence(passages: &RacewayTallies) -> RunEvidence<'_> {
    RunEvidence {
        passages,
        pressure_max_pa: Some(1e9),
        half_turn_lag_rad: None,
    }
}

/// A run that the program itself warns of does not pass: with contact pressures beyond ISO 76 it fails.
#[test]
fn no_run_passes_over_its_own_warnings() {
    let case = full_6008(5.1, 25.2);
    let mut tallies = RacewayTallies::new(&case);
    let mut recorder = PassageRecorder::new(|passage: Passage| {
        tallies.add(&Passage {
            collisions_ahead: 0,
            slowest_at_largest_rad_s: passage.orbit_speed_range_rad_s[0],
            ..passage
        });
        Ok(())
    });
    let mut long = case.clone();
    long.contact.friction.coefficient = 0.1;
    long.solver.duration_s = 5.0 * case.rolling_orbit_s();
    cageless::simulation::run(&long, &mut [&mut recorder], &mut go_on).unwrap();
    let verdict = |pressure_max_pa| {
        let run = RunEvidence {
            passages: &tallies,
            pressure_max_pa,
            half_turn_lag_rad: None,
        };
        RunVerdict::new(&case, &run)
    };
    let kept = verdict(Some(4.2e9));
    assert_eq!(kept.verdict, RacewayVerdict::Smooth, "{}", kept.headline);
    let over = verdict(Some(4.2e9f64.next_up()));
    assert_eq!(over.verdict, RacewayVerdict::Overloaded);
    assert!(
        over.headline
            .contains("the contact pressure of the motion reaches 4200")
    );
    // Of several starts the worst pressure counts.
    let starts = [verdict(Some(1e9)), verdict(Some(5e9))];
    let found = RunVerdict::of_starts(&case, &starts);
    assert_eq!(found.verdict, RacewayVerdict::Overloaded);
    let starts = [
        verdict(Some(1e9)),
        RunVerdict::unfinished(&case, "a run that stopped"),
    ];
    assert_eq!(
        RunVerdict::of_starts(&case, &starts).verdict,
        RacewayVerdict::NotJudged
    );
}

/// The verdict of a run has the limits of `judge`, on the worst of the raceways that balls pass.
#[test]
fn a_verdict_of_a_run_changes_at_its_limits() {
    let case = full_6008(5.1, 25.2);
    let raceways = [(5.1, 25.2, 0.0), (4.6, 12.0, 80.0)];
    let raceways =
        raceways.map(|(span, angle, centre)| raceway(&case.bearing, span, angle, centre));
    let case = case.with_raceways(raceways.to_vec());
    let speed = case.operation.inner_speed_rad_s * 23.031 / (23.031 + 30.974);
    // Four passages of each of 21 balls: how far the balls slow down, and how many sevens of them are hit twice.
    let tally = |r: usize, drop: f64, twice: u32| {
        let raceway = &case.raceways[r];
        let depth = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
        let slowed = 2.0 * speed * (1.0 - 3.969e-3 / (depth + 3.969e-3));
        let passage = |k: u32| Passage {
            ball: k as usize % 21,
            raceway: r,
            enter_s: 0.0,
            leave_s: 1e-3,
            gap_enter_rad: 0.03,
            gap_behind_rad: 0.03,
            gap_min_rad: 0.01,
            gap_leave_rad: 0.03,
            collisions_ahead: u32::from(k / 7 < twice),
            collisions_behind: u32::from(k / 7 < twice),
            sliding_max_m_s: 0.1,
            unloaded_s: 0.0,
            orbit_speed_range_rad_s: [speed + drop * (slowed - speed), speed],
            inside_at_largest_s: 1e-3,
            slowest_at_largest_rad_s: speed + drop * (slowed - speed),
            angle_rad: 0.5,
            way_here: None,
        };
        (0..84).map(passage).collect::<Vec<_>>()
    };
    let verdict = |passages: [Vec<Passage>; 2]| {
        let mut tallies = RacewayTallies::new(&case);
        passages.iter().flatten().for_each(|p| tallies.add(p));
        RunVerdict::new(&case, &evidence(&tallies))
    };
    let good = |r| tally(r, 0.98, 0);
    for (tallies, expected, start) in [
        (
            [good(0), good(1)],
            RacewayVerdict::Smooth,
            "works in this run from evenly spaced balls: smooth; nearest to its limit: balls reach 98.0 %",
        ),
        (
            [tally(0, 0.8 + 1e-9, 0), good(1)],
            RacewayVerdict::Smooth,
            "works",
        ),
        (
            [tally(0, 0.8 - 1e-9, 0), good(1)],
            RacewayVerdict::Slips,
            "does not work in this run from evenly spaced balls: excessive sliding; balls reach",
        ),
        (
            [good(0), tally(1, 0.8 - 1e-9, 0)],
            RacewayVerdict::Slips,
            "does not work",
        ),
        // 3 of 12 are a quarter.
        (
            [good(0), tally(1, 0.98, 3)],
            RacewayVerdict::Smooth,
            "works in this run from evenly spaced balls: smooth; nearest to its limit: 25.0 %",
        ),
        (
            [good(0), tally(1, 0.98, 4)],
            RacewayVerdict::DoubleCollision,
            "does not work in this run from evenly spaced balls: double collision; 33.3 %",
        ),
        (
            [vec![], good(1)],
            RacewayVerdict::NotJudged,
            "not judged: every ball has to pass every discrete raceway 2 times",
        ),
        // The last ball is one passage short.
        (
            [good(0), good(1)[..41].to_vec()],
            RacewayVerdict::NotJudged,
            "not judged: every ball has to pass every discrete raceway 2 times after the transient (t > 0.0100 s), \
             and one has passed 1 (solver.duration_s of 0.059 or more)",
        ),
        (
            [good(0), good(1)[..42].to_vec()],
            RacewayVerdict::Smooth,
            "works",
        ),
        (
            [vec![], vec![]],
            RacewayVerdict::NotJudged,
            "not judged: every ball has to pass every discrete raceway 2 times",
        ),
    ] {
        let found = verdict(tallies);
        assert_eq!(found.verdict, expected, "{}", found.headline);
        assert!(found.headline.starts_with(start), "{}", found.headline);
    }
    // Over starts the means decide: one of three has a double collision in every passage, 4 of 12 in the mean of
    // the second raceway, whose deviation over n − 1 is 1/√3 and standard error a third.
    let from = |twice: u32| verdict([good(0), tally(1, 0.98, twice)]);
    let starts = [from(0), from(12), from(0)];
    assert_eq!(starts[0].verdict, RacewayVerdict::Smooth);
    let found = RunVerdict::of_starts(&case, &starts);
    assert_eq!(found.verdict, RacewayVerdict::DoubleCollision);
    assert!((found.deciding.unwrap().value - 1.0 / 3.0).abs() < 1e-12);
    assert!((found.standard_error.unwrap() - 1.0 / 3.0).abs() < 1e-12);
    assert_eq!(
        found.headline,
        "does not work in the mean of 3 runs from evenly spaced balls: double collision; 33.3 % of the passages have a double collision (limit \
         25 %, missed by 8.3 percentage points), standard error 33.3 percentage points; for the critical gap run \
         `cageless design`"
    );
    let none = verdict([vec![], vec![]]);
    // One start that is not judged leaves nothing judged.
    let found = RunVerdict::of_starts(&case, &[from(2), none.clone(), from(4)]);
    assert_eq!(
        (found.verdict, found.deciding),
        (RacewayVerdict::NotJudged, None)
    );
    let start = "not judged: draw 2 of 3: every ball has to pass";
    assert!(found.headline.starts_with(start), "{}", found.headline);
    let ended = RunVerdict::unfinished(&case, "interrupted after 1 s of 2 s");
    assert_eq!(
        (ended.verdict, ended.headline.as_str()),
        (
            RacewayVerdict::NotJudged,
            "not judged: interrupted after 1 s of 2 s"
        )
    );
    let plain = case.with_raceways(vec![]);
    let found = RunVerdict::new(&plain, &evidence(&RacewayTallies::new(&plain)));
    assert_eq!(
        (found.verdict, found.deciding),
        (RacewayVerdict::NotJudged, None)
    );
    assert!(
        found.headline.starts_with("not judged: the outer ring"),
        "{}",
        found.headline
    );
}
