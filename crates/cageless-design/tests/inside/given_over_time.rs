//! Verdicts on a run whose speed is given over time.

use crate::common::structure;
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::passage::{Passage, PassageRecorder};
use cageless::simulation::{Control, run};
use cageless::summary::ContactPeaks;
use cageless::summary::{SummaryRecorder, transient_s};
use cageless::{Case, FlankModel, IntegrationMethod, Start, StartState, TimeTable};
use cageless_design::{RacewayTallies, RunEvidence, RunVerdict};

fn table(times_s: &[f64], values: &[f64]) -> Option<TimeTable> {
    Some(TimeTable::new("inner_speed_rad_s", times_s.to_vec(), values.to_vec()).unwrap())
}

/// Slowing of the balls in a run, with its pressures and sliding.
fn judged(case: &Case) -> (RunVerdict, f64, ContactPeaks) {
    let (mut tallies, mut summary) = (RacewayTallies::new(case), SummaryRecorder::new());
    let settled_s = transient_s(case);
    {
        let mut recorder = PassageRecorder::new(|passage: Passage| {
            if passage.enter_s > settled_s {
                tallies.add(&passage);
            }
            Ok(())
        });
        let mut observers: [&mut dyn cageless::simulation::Observer; 2] =
            [&mut recorder, &mut summary];
        run(case, &mut observers, &mut |_| Control::Continue(())).unwrap();
    }
    let found = RunEvidence {
        passages: &tallies,
        pressure_max_pa: Some(1e9),
        half_turn_lag_rad: None,
    };
    let verdict = RunVerdict::new(case, &found);
    let slowing = verdict
        .deciding
        .filter(|c| ["deceleration", "lag"].contains(&c.name()))
        .map_or(f64::NAN, |criterion| criterion.value);
    (verdict, slowing, summary.summary().unwrap().peaks)
}

fn sliding() -> Case {
    let mut case = structure(5.1, 25.2);
    (case.solver.method, case.solver.step_s) = (IntegrationMethod::VelocityVerlet, 2e-6);
    case.solver.duration_s = 0.08;
    case.contact.friction.coefficient = 0.003;
    case
}

/// A speed that falls by 5 % is judged as the two constant speeds between which it lies, on rigid and elastic flanks; a
/// table of one value gives the bits of the constant.
#[test]
fn a_falling_speed_is_judged_as_the_constant_ones() {
    for flanks in [FlankModel::Rigid, FlankModel::Elastic] {
        let mut case = sliding();
        case.flanks = flanks;
        if flanks == FlankModel::Elastic {
            case.contact.friction.coefficient = 0.0008;
        }
        let fast = case.operation.inner_speed_rad_s;
        let at = |speed: f64| {
            let mut case = case.clone();
            case.operation.inner_speed_rad_s = speed;
            judged(&case)
        };
        let (constant, slower) = (at(fast), at(0.95 * fast));
        let mut falling = case.clone();
        falling.operation.inner_speed_table = table(&[0.0, 0.08], &[fast, 0.95 * fast]);
        let (verdict, slowing, _) = judged(&falling);
        for (reference, expected, _) in [&constant, &slower] {
            assert_eq!(verdict.verdict, reference.verdict, "{}", verdict.headline);
            assert!((slowing - expected).abs() < 0.06, "{slowing} {expected}");
        }
        let mut held = case.clone();
        held.operation.inner_speed_table = table(&[0.0, 1.0], &[fast, fast]);
        let counted = |case: &Case| {
            let mut passages = vec![];
            let mut recorder = PassageRecorder::new(|passage: Passage| {
                passages.push(passage);
                Ok(())
            });
            run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
            passages
        };
        held.solver.duration_s = 0.02;
        case.solver.duration_s = 0.02;
        for (found, expected) in counted(&held).iter().zip(counted(&case)) {
            // But for the rounding of the integral.
            let inside = found.inside_at_largest_s / expected.inside_at_largest_s;
            assert!((inside - 1.0).abs() < 1e-12);
            let same = (found.leave_s, found.slowest_at_largest_rad_s);
            assert_eq!(same, (expected.leave_s, expected.slowest_at_largest_rad_s));
        }
    }
}

/// In a run-up balls with friction enough roll: they are slowed as the geometry has it at the speed of each passage.
/// From rest nothing is judged by no number.
#[test]
fn a_run_up_is_judged_at_its_speeds() {
    for flanks in [FlankModel::Rigid, FlankModel::Elastic] {
        let mut case = sliding();
        case.flanks = flanks;
        case.contact.friction.coefficient = 0.1;
        case.solver.duration_s = 0.1;
        case.operation.inner_speed_rad_s = 1140.0;
        case.operation.inner_speed_table = table(&[0.0, 0.1], &[1140.0, 1200.0]);
        let (mut tallies, mut passages) = (RacewayTallies::new(&case), vec![]);
        let mut recorder = PassageRecorder::new(|passage: Passage| {
            tallies.add(&passage);
            passages.push(passage);
            Ok(())
        });
        run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        // 117 rad of the inner ring are 7.4 orbits; a faster run-up leaves balls without load behind.
        assert!(passages.len() > 70, "{}", passages.len());
        let rolling = |r: f64| rolling_orbit_speed_rad_s(&case.bearing, 1200.0, r);
        let raceway = &case.raceways[0];
        let middle = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
        let (plain, slowed) = (rolling(case.bearing.ball_radius_m()), rolling(middle));
        let mut sum = 0.0;
        for p in &passages {
            let middle_s = 0.5 * (p.enter_s + p.leave_s);
            let ratio = (1140.0 + 600.0 * middle_s) / 1200.0;
            let expected = (p.leave_s - p.enter_s) * ratio;
            assert!((p.inside_at_largest_s / expected - 1.0).abs() < 1e-9);
            sum += (plain - p.slowest_at_largest_rad_s) / (plain - slowed);
        }
        if flanks == FlankModel::Rigid {
            let drop = sum / passages.len() as f64;
            assert!((drop - 1.0).abs() < 0.1, "{drop}");
        }
        let lag = tallies.lag_fraction(&case, 0);
        let expected = if flanks == FlankModel::Rigid {
            1.0
        } else {
            0.9
        };
        assert!((lag - expected).abs() < 0.1, "{flanks:?} {lag}");
    }
    let mut case = sliding();
    case.operation.inner_speed_rad_s = 0.0;
    case.operation.inner_speed_table = table(&[0.0, 0.08], &[0.0, 1256.6]);
    let (verdict, ..) = judged(&case);
    let text = verdict.headline;
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
}

/// The surfaces pass a contact at the speed of its time: a speed table that begins at 0 changes no flash temperature by
/// orders of magnitude.
#[test]
fn flash_temperatures_are_those_of_their_times() {
    let mut case = sliding();
    case.solver.duration_s = 0.02;
    let (.., constant) = judged(&case);
    case.operation.inner_speed_rad_s = 0.0;
    case.operation.inner_speed_table = table(&[0.0, 1e-4], &[0.0, 1256.6]);
    case.start = Start::new(StartState::AtRest, cageless::Gaps::Uniform, 0.0);
    let (.., from_rest) = judged(&case);
    for (found, reference) in [
        (from_rest.inner, constant.inner),
        (from_rest.outer, constant.outer),
    ] {
        let per_load = |peak: cageless::summary::ContactPeak| {
            peak.flash_temperature_k / peak.pressure_velocity_pa_m_s
        };
        let ratio = per_load(found) / per_load(reference);
        assert!((0.5..4.0).contains(&ratio), "{ratio}");
    }
}
