//! Verdicts: pass and fail, the margin, recommendations that keep their own verdict, and work
//! that ends when told to.

use crate::common::*;
use cageless::critical_gap::{CriticalGapError, PairTest, critical_gap_rad};
use cageless::design::search::{Job, Numbers, OperatingPoint, RacewayLayout, Task, run_jobs};
use cageless::design::{
    Criterion, Eq11, RacewayVerdict, judge, recommend, starting_point, theoretical_gap_rad,
};
use cageless::raceway::RacewayDimensions;
use cageless::simulation::Control;
use cageless::{BearingDimensions, Case, Raceway};

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
        inner_groove_curvature_radius_m: 4.128e-3,
        outer_groove_curvature_radius_m: 4.128e-3,
        inner_ring_mass_kg: 0.2,
        inner_ring_drag_n_s_m: 2000.0,
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
    let Some(Criterion::BothNeighbours(fraction)) = judgement.deciding else {
        panic!("{:?}", judgement.deciding);
    };
    assert!(fraction > 0.25, "{fraction}");
    let headline = judgement.headline();
    assert!(
        headline.starts_with("FAIL: hit from both sides; "),
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
