//! Bearings side by side.

use crate::common::{conventional, dimensions, raceway, structure};
use cageless::ball::BallMotion;
use cageless::contact::FrictionTable;
use std::sync::Arc;

use cageless::dynamics::{InstructionSet, Model, RightHandSide};
use cageless::film::{Film, Oil, Traction};
use cageless::initial_conditions::initial_state;
use cageless::integrator::System;
use cageless::numerics::lanes::BATCH_WIDTH;
use cageless::simulation::{Control, Observer, batches, run, run_batch};
use cageless::summary::{Summary, SummaryRecorder};
use cageless::{
    Case, FlankModel, Formulation, FrictionModel, Gaps, IntegrationMethod, Start, StartState,
};

/// Cases that differ in everything that may differ side by side.
fn mixed(count: usize) -> Vec<Case> {
    mixed_of(14, count)
}

fn mixed_of(balls: usize, count: usize) -> Vec<Case> {
    let with_balls = |case: Case| {
        let mut d = case.bearing.dimensions().clone();
        d.balls = balls;
        let bearing = cageless::Bearing::new(d, *case.bearing.materials()).unwrap();
        Case { bearing, ..case }
    };
    (0..count)
        .map(|k| {
            let mut case = match k % 3 {
                0 => conventional(dimensions()),
                1 => structure(5.1, 25.2),
                _ => {
                    let case = structure(5.6, 15.774);
                    let top = raceway(&case.bearing, 4.95, 35.0, 160.0);
                    let raceways = vec![case.raceways[0].clone(), top];
                    case.with_raceways(raceways)
                }
            };
            case = with_balls(case);
            case.operation.radial_load_n = 500.0 + 100.0 * k as f64;
            case.operation.inner_speed_rad_s *= 1.0 + 0.02 * k as f64;
            let n = case.bearing.balls();
            let room = n as f64 * case.bearing.nominal_gap_rad();
            let mut gaps = vec![(room - 0.002) / (n - 1) as f64; n];
            gaps[k % n] = 0.002;
            case.start = Start::new(StartState::Settled, Gaps::List(gaps), 0.1 * k as f64);
            case.solver.method = IntegrationMethod::VelocityVerlet;
            case.solver.step_s = 1e-6;
            case.solver.duration_s = 0.003;
            case
        })
        .collect()
}

fn alone(case: &Case) -> (Vec<f64>, Option<Summary>) {
    let mut summary = SummaryRecorder::new();
    let outcome = run(case, &mut [&mut summary], &mut |_| Control::Continue(())).unwrap();
    (outcome.state.values().to_vec(), summary.summary())
}

fn together(cases: &[&Case]) -> Vec<(Vec<f64>, Option<Summary>)> {
    let mut summaries: Vec<SummaryRecorder> =
        cases.iter().map(|_| SummaryRecorder::new()).collect();
    let mut observers: Vec<Vec<&mut dyn Observer>> = summaries
        .iter_mut()
        .map(|s| vec![s as &mut dyn Observer])
        .collect();
    let outcomes = run_batch(cases, &mut observers, &mut |_| Control::Continue(()));
    outcomes
        .into_iter()
        .zip(&summaries)
        .map(|(o, s)| (o.unwrap().state.values().to_vec(), s.summary()))
        .collect()
}

/// Checks that states and summaries are equal; a mean that there is none of is no number in both.
fn same(one: &[(Vec<f64>, Option<Summary>)], other: &[(Vec<f64>, Option<Summary>)], what: &str) {
    for ((a, summary_a), (b, summary_b)) in one.iter().zip(other) {
        assert!(a == b, "states, {what}");
        assert_eq!(format!("{summary_a:?}"), format!("{summary_b:?}"), "{what}");
    }
    assert_eq!(one.len(), other.len());
}

/// A bearing has the same bits alone and beside any others, in either formulation, with equal and
/// unequal balls, lubricated and dry, on every instruction set.
#[test]
fn company_changes_no_bit() {
    let kinds: [fn(&mut Case); 7] = [
        |_| {},
        |case| case.formulation = Formulation::Paper,
        |case| {
            let n = case.bearing.balls();
            let deviations = (0..n).map(|k| 1e-7 * (k % 5) as f64).collect();
            let bearing = case.bearing.clone();
            case.bearing = bearing.with_ball_radius_deviations(deviations).unwrap();
            // Their angles take more of the turn.
            case.start = Start::new(
                StartState::Settled,
                Gaps::Uniform,
                case.start.lead_ball_angle_rad,
            );
        },
        // Friction that is implicit.
        |case| case.contact.friction.coefficient = 1e-4 * case.operation.radial_load_n,
        |case| {
            let mu = 1e-4 * case.operation.radial_load_n;
            let table = vec![[0.0, 2.0 * mu], [mu, 1.5 * mu], [3.0 * mu, mu]];
            case.contact.friction.coefficient = mu;
            case.contact.friction_law = FrictionModel::Table;
            case.contact.friction.table = Some(FrictionTable::new(table).unwrap());
        },
        |case| case.flanks = FlankModel::Elastic,
        // Films of different oils.
        |case| {
            let oil = Oil::mineral(1e-6 * case.operation.radial_load_n, 0.035);
            case.film = Some(Film {
                traction: Traction::Film,
                ..Film::flooded(oil)
            });
        },
    ];

    // An odd number leaves a lane of each bearing empty.
    for (balls, changes) in [
        (14, vec![0]),
        (13, vec![0]),
        (14, vec![1]),
        (13, vec![2]),
        (13, vec![3]),
        (14, vec![4]),
        (14, vec![5]),
        (13, vec![5, 2]),
        (14, vec![5, 4]),
        (14, vec![5, 3]),
        (13, vec![6]),
        (14, vec![5, 6]),
    ] {
        let mut cases = mixed_of(balls, 11);
        for case in &mut cases {
            changes.iter().for_each(|k| kinds[*k](case));
        }
        let expected: Vec<_> = cases.iter().map(alone).collect();
        assert!(
            expected
                .iter()
                .any(|(_, s)| s.as_ref().unwrap().collisions.all > 0)
                || !cases[0].bearing.ball_radius_deviations_m().is_empty()
        );
        for isa in InstructionSet::ALL.into_iter().filter(|i| i.available()) {
            isa.limit_to();
            let all: Vec<&Case> = cases.iter().collect();
            same(&together(&all[..8]), &expected[..8], isa.name());
            // Other company, other lanes.
            same(&together(&all[5..]), &expected[5..], isa.name());
        }
    }
}

/// A bearing that cannot start, or leaves the physical range, ends alone.
#[test]
fn one_bearing_does_not_take_the_others_along() {
    let mut cases = mixed(5);
    // A step as short as the overlap of the rolling start below asks for, and friction that is
    // implicit whatever the load: one kind.
    for case in &mut cases {
        case.solver.step_s = 0.4e-6;
        case.contact.friction_law = FrictionModel::Coulomb;
    }
    let expected: Vec<_> = cases.iter().map(alone).collect();
    cases[1].contact.friction.coefficient = f64::NAN;
    cases[3].start = Start::new(
        // Deep in the balls: they are pressed through a raceway at once.
        StartState::Rolling {
            ring_x_m: 0.0,
            ring_y_m: -400e-6,
        },
        Gaps::Uniform,
        0.0,
    );
    let all: Vec<&Case> = cases.iter().collect();
    let mut observers: Vec<Vec<&mut dyn Observer>> = all.iter().map(|_| vec![]).collect();
    let outcomes = run_batch(&all, &mut observers, &mut |_| Control::Continue(()));
    assert!(outcomes[1].is_err());
    for k in [0, 2, 4] {
        let outcome = outcomes[k].as_ref().unwrap();
        assert_eq!(outcome.state.values(), expected[k].0);
        assert_eq!(outcome.end_s, 0.003);
    }
    let stopped = outcomes[3].as_ref().unwrap();
    assert!(stopped.end_s < 0.001, "{:?}", stopped.ending);
}

/// Only cases of one kind, step and duration share a batch; none is lost.
#[test]
fn batches_hold_every_case_once() {
    let mut cases = mixed(40);
    cases[2].solver.method = IntegrationMethod::Abm4;
    cases[3].solver.duration_s = 0.002;
    for case in &mut cases[20..25] {
        case.formulation = Formulation::Paper;
    }
    for (k, case) in cases[4..19].iter_mut().enumerate() {
        case.film = Some(Film::flooded(Oil::mineral(5e-3, 0.035)));
        if k >= 5 {
            case.film.as_mut().unwrap().traction = Traction::Film;
        }
        if k >= 10 {
            case.flanks = FlankModel::Elastic;
        }
    }
    let batches = batches(&cases);
    let mut all: Vec<usize> = batches.iter().flatten().copied().collect();
    all.sort();
    assert_eq!(all, (0..40).collect::<Vec<_>>());
    for batch in &batches {
        let kind = |k: usize| {
            (
                cases[k].formulation,
                cases[k].solver.duration_s,
                cases[k].solver.method,
                cases[k].film,
                cases[k].flanks,
            )
        };
        assert!(batch.iter().all(|k| kind(*k) == kind(batch[0])));
    }
    assert!(batches.contains(&vec![2]) && batches.contains(&vec![3]));
    for first in [4, 9, 14, 20] {
        let batch: Vec<usize> = (first..first + 5).collect();
        assert!(batches.contains(&batch), "{batches:?}");
    }
}

/// Every pair of neighbours is seen to touch from the first nanometre on and to be apart again,
/// whichever lanes they are in.
#[test]
fn every_pair_is_seen_to_touch() {
    for balls in [7, 14, 15] {
        let cases = mixed_of(balls, BATCH_WIDTH);
        let models: Vec<Arc<Model>> = cases.iter().map(|case| Model::new(case).unwrap()).collect();
        let (start, _) = initial_state(&cases[0]).unwrap();
        let alone = RightHandSide::new(&models[0]);
        let isa = InstructionSet::chosen();
        let together =
            RightHandSide::side_by_side(std::array::from_fn(|k| Arc::clone(&models[k])), isa);
        for mut rhs in [alone, together] {
            let width = rhs.layout().width();
            let (mut y, mut rates) = (vec![0.0; rhs.layout().len()], vec![0.0; rhs.layout().len()]);
            for bearing in 0..width {
                for k in 0..balls {
                    let next = (k + 1) % balls;
                    let [x, y_m] = [start.x_m()[k], start.y_m()[k]];
                    let mut state = start.clone();
                    for (gap_m, touch) in [(-1e-9, true), (1e-9, false)] {
                        let distance = models[bearing].pair_distance_m(k) + gap_m;
                        let motion = state.ball_motion(next);
                        let moved = BallMotion {
                            x: x + distance,
                            y: y_m,
                            ..motion
                        };
                        state.set_ball(next, moved);
                        for other in 0..width {
                            start.write_to(rhs.layout().of_bearing(other), &mut y);
                        }
                        state.write_to(rhs.layout().of_bearing(bearing), &mut y);
                        rhs.derivative(0.0, &y, &mut rates);
                        let contacts = rhs.contacts_of(bearing);
                        let depth = contacts.pair_deflection_m(k);
                        assert_eq!(depth > 0.0, touch, "{balls} {bearing} {k} {depth}");
                        assert!(!touch || (depth - 1e-9).abs() < 1e-16, "{depth}");
                        assert!(!touch || contacts.balls_touch());
                    }
                }
            }
        }
    }
}
