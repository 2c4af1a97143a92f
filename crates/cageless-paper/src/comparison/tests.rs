//! The comparison of rings: starts, lots, bits.

use super::*;
use cageless_study::{Progress, Silent};

/// A combination run for a few orbits, in a batch and again: the same numbers; another start
/// gives others.
#[test]
fn a_small_cell_is_reproduced() {
    let mut plan = plans(&GRADES).unwrap().remove(10);
    let grade = plan.grade.map(|g| g.number);
    assert_eq!((grade, plan.ring), (Some(28), STRUCTURE_D));
    plan.case.operation.inner_speed_rad_s *= 4.0;
    plan.case.solver.duration_s = 0.2;
    plan.case.solver.step_s = 2e-6;
    let silent: &dyn Progress = &Silent;
    let progress = silent.begin("comparison", 1.0);
    let numbers = |outcomes: &[Outcome]| -> Vec<[f64; 4]> {
        outcomes
            .iter()
            .map(|o| {
                [
                    o.mean_square,
                    o.at_passing,
                    o.gap_deviation_deg,
                    o.impulse_rate_n,
                ]
            })
            .collect()
    };
    let first = outcomes(&plan, &progress, 0.0).unwrap();
    assert_eq!(first.len(), STARTS as usize);
    assert_eq!(
        numbers(&first),
        numbers(&outcomes(&plan, &progress, 0.0).unwrap())
    );
    assert_ne!(numbers(&first)[0], numbers(&first)[1]);
    for o in &first {
        assert!(o.mean_square > 0.0 && o.at_passing >= 0.0 && o.between >= 0.0);
        assert!(o.contacts_per_s > 0.0 && o.impulse_rate_n > 0.0);
        assert!(o.from_contacts > 0.0);
    }
    // Alone, not beside others.
    let case = plan.start(3).unwrap();
    let alone = side_by_side(&[&case], &plan, &progress, 0.0).unwrap();
    assert_eq!(numbers(&alone)[0], numbers(&first)[3]);
}

/// Evenly spaced equal balls in a conventional ring do not touch; hardly anything lies
/// between the passing frequencies.
#[test]
fn without_contacts_all_is_at_passing() {
    let mut plan = plans(&GRADES).unwrap().remove(0);
    plan.case.operation.inner_speed_rad_s *= 4.0;
    plan.case.solver.duration_s = 0.2;
    let mut case = plan.start(0).unwrap();
    case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.0);
    let silent: &dyn Progress = &Silent;
    let progress = silent.begin("comparison", 1.0);
    let one = side_by_side(&[&case], &plan, &progress, 0.0).unwrap();
    assert_eq!(one[0].contacts_per_s, 0.0);
    assert_eq!(one[0].from_contacts, 0.0);
    assert!(one[0].at_passing > 0.0);
    assert!(one[0].between < 0.05 * one[0].at_passing);
}

#[test]
fn starts_are_bunches_that_fill_the_room() {
    let plan = plans(&GRADES).unwrap().remove(9);
    assert_eq!(plan.grade.map(|g| g.number), Some(28));
    let starts: Vec<Vec<f64>> = (0..STARTS)
        .map(|k| {
            let case = plan.start(k).unwrap();
            assert!(
                case.bearing
                    .ball_radius_deviations_m()
                    .iter()
                    .any(|d| *d != 0.0)
            );
            let Gaps::List(gaps) = case.start.gaps.clone() else {
                panic!("a list of gaps");
            };
            gaps
        })
        .collect();
    for gaps in &starts {
        let wide = gaps.iter().filter(|g| g.to_degrees() > 6.0).count();
        assert_eq!((wide, gaps.len()), (BUNCHES, 14));
    }
    assert_ne!(starts[0], starts[1]);
}
