//! The numbers of the runs of a search, against observers of one's own on the same runs.

use std::f64::consts::TAU;

use crate::common::*;
use cageless::dynamics::EnergyTerm;
use cageless::film::{Film, Oil};
use cageless::passage::{Passage, PassageRecorder};
use cageless::simulation::Control;
use cageless::{Case, ContactTally, FlankModel, Gaps, Start, StartState};
use cageless_design::pressure_at_rest_pa;
use cageless_design::search::{
    Job, Numbers, OperatingPoint, RacewayLayout, Task, UnevenStart, perturbed_runs, run_jobs,
};

fn go_on(_: f64) -> Control {
    Control::Continue(())
}

/// The structure of a case at its own operating point, by the search's own method.
fn as_searched(span_mm: f64, angle_deg: f64) -> Case {
    let case = structure(span_mm, angle_deg);
    OperatingPoint::from_case(&case).case(&case, case.raceways.clone())
}

/// Every number of a perturbed run against observers of one's own on the same run: two raceways,
/// equal balls that start unevenly, 32 orbits, the second half steady.
#[test]
fn the_numbers_of_a_perturbed_run_are_those_of_its_motion() {
    let case = as_searched(4.9, 24.0);
    let raceways = [(4.9, 24.0, 20.0), (4.7, 20.0, -70.0)];
    let raceways =
        raceways.map(|(span, angle, centre)| raceway(&case.bearing, span, angle, centre));
    let case = case.with_raceways(raceways.to_vec());
    let start = UnevenStart::Drawn {
        seed: 11,
        number: 3,
    };
    let found = perturbed_runs(&[(&case, start)], &mut go_on)
        .swap_remove(0)
        .unwrap();

    let mut same = case.clone();
    same.start = Start::new(
        StartState::Settled,
        Gaps::List(Gaps::uneven_rad(&case.bearing, 11, 3)),
        0.0,
    );
    // Ω = ωi·Ri/(2Rm) of rolling balls.
    let speed = case.operation.inner_speed_rad_s * 18.24 / (18.24 + 27.765);
    same.solver.duration_s = case.rolling_orbit_s() * 32.0;
    assert!((same.solver.duration_s * speed / TAU - 32.0).abs() < 1e-9);
    let half_s = same.solver.duration_s / 2.0;
    let (mut contacts, mut late) = (ContactTally::new(half_s), vec![]);
    let outcome = {
        let mut recorder = PassageRecorder::new(|passage: Passage| {
            if passage.enter_s > half_s {
                late.push(passage);
            }
            Ok(())
        });
        cageless::simulation::run(&same, &mut [&mut contacts, &mut recorder], &mut go_on).unwrap()
    };
    let near = |found: f64, expected: f64, what: &str| {
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{what}: {found} {expected}"
        );
    };
    let ball_orbits = 14.0 * 32.0;
    let (begun, begun_late) = (contacts.begun, contacts.begun_late);
    assert!(begun_late > 0.0 && begun > 1.2 * begun_late);
    near(found.collisions, begun / ball_orbits, "collisions");
    near(
        found.collisions_late,
        begun_late / (0.5 * ball_orbits),
        "late collisions",
    );
    near(
        found.impulse_n_s,
        contacts.impulse_n_s / ball_orbits,
        "impulse",
    );

    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let deviation = |values: &[f64]| {
        let middle = mean(values);
        let squares: Vec<f64> = values.iter().map(|v| (v - middle).powi(2)).collect();
        mean(&squares).sqrt()
    };
    let arrivals: Vec<f64> = (late.iter())
        .filter(|p| p.raceway == 0)
        .map(|p| p.gap_behind_rad)
        .collect();
    assert!(arrivals.len().abs_diff(16 * 14) < 14 && late.len() > 2 * arrivals.len() - 14);
    near(found.gap_mean_rad, mean(&arrivals), "mean gap");
    near(
        found.gap_deviation_rad,
        deviation(&arrivals),
        "deviation of the gaps",
    );
    let least = arrivals.iter().copied().fold(f64::INFINITY, f64::min);
    near(found.gap_min_rad, least, "smallest gap");
    let of_all = |of: &dyn Fn(&Passage) -> f64| mean(&late.iter().map(of).collect::<Vec<_>>());
    near(found.sliding_m_s, of_all(&|p| p.sliding_max_m_s), "slip");
    let twice = |p: &Passage| f64::from(u8::from(p.collisions_ahead * p.collisions_behind > 0));
    assert!((found.double_collision_fraction - of_all(&twice)).abs() < 1e-12);
    let drops = [0, 1].map(|r| {
        let slowest = late.iter().filter(|p| p.raceway == r);
        let slowest: Vec<f64> = slowest.map(|p| p.orbit_speed_range_rad_s[0]).collect();
        let raceway = &case.raceways[r];
        let depth = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
        let slowed = 2.0 * speed * (1.0 - 4.7625e-3 / (depth + 4.7625e-3));
        (speed - mean(&slowest)) / (speed - slowed)
    });
    assert!((drops[0] - drops[1]).abs() > 1e-3, "{drops:?}");
    near(found.speed_drop_fraction, drops[0].min(drops[1]), "drop");
    assert_eq!(found.force_deviation_n, contacts.force_deviation_n());
    let friction: f64 = [
        EnergyTerm::InnerFriction,
        EnergyTerm::OuterFriction,
        EnergyTerm::BallFriction,
    ]
    .map(|term| outcome.state.energy_term_j(term))
    .iter()
    .sum();
    assert_eq!(found.rolling_resistance_w, 0.0);
    near(
        found.friction_w,
        friction / same.solver.duration_s,
        "friction",
    );
}

/// The film of 5 mPa·s takes 61 W from structure (d), less before the transient has ended.
#[test]
fn a_film_takes_its_power_from_a_perturbed_run() {
    let mut case = as_searched(5.1, 25.2);
    case.film = Some(Film::flooded(Oil::mineral(5e-3, 0.035)));
    let start = UnevenStart::Drawn {
        seed: 11,
        number: 3,
    };
    let found = perturbed_runs(&[(&case, start)], &mut go_on).swap_remove(0);
    let film_w = found.unwrap().rolling_resistance_w;
    assert!((55.0..63.0).contains(&film_w), "{film_w}");
}

/// The stress of a structure is the largest at its outer raceway while the balls go by.
#[test]
fn stress_is_the_largest_while_the_balls_go_by() {
    let case = as_searched(5.1, 25.2);
    let [inner, outer] = pressure_at_rest_pa(&case).unwrap();
    let mut largest = [0.0f64; 2];
    for k in 0..40 {
        let mut at = case.clone();
        at.start = Start::new(
            StartState::Settled,
            Gaps::Uniform,
            TAU / 14.0 * f64::from(k) / 40.0,
        );
        let e = cageless::equilibrium::solve(&at).unwrap();
        largest[0] = largest[0].max(e.inner_pressure_max_pa);
        largest[1] = largest[1].max(e.outer_pressure_max_pa);
    }
    for (found, largest) in [(inner, largest[0]), (outer, largest[1])] {
        assert!(
            found <= largest * (1.0 + 1e-9) && found > 0.995 * largest,
            "{found} {largest}"
        );
    }
    assert!(inner > 1.05 * outer);
    let job = Job {
        structure: RacewayLayout::from_case(&case).unwrap(),
        point: OperatingPoint::from_case(&case),
        task: Task::PairSeparation,
    };
    match run_jobs(&case, &[&job], &mut go_on).swap_remove(0) {
        Some(Ok(Numbers::PairSeparation(found))) => assert_eq!(found.stress_pa, outer),
        other => panic!("{other:?}"),
    }
}

/// Work that the caller ends, be it while the start is sought, has no outcome: a reason would be recorded as
/// a finding about the raceway.
#[test]
fn work_that_is_ended_has_no_outcome() {
    let mut case = as_searched(4.9, 24.0);
    case.flanks = FlankModel::Elastic;
    let tasks = [
        Task::Motion(UnevenStart::Drawn { seed: 0, number: 0 }),
        Task::Motion(UnevenStart::Bunched),
        Task::PairSeparation,
        Task::AxialLag(100.0),
    ];
    let jobs = tasks.map(|task| Job {
        structure: RacewayLayout::from_case(&case).unwrap(),
        point: OperatingPoint::from_case(&case),
        task,
    });
    for allowed in [0, 1, 5, 20] {
        let mut together: Vec<Vec<&Job>> = jobs.iter().map(|job| vec![job]).collect();
        together.push(jobs.iter().collect());
        for jobs in together {
            let mut asked = 0;
            let outcomes = run_jobs(&case, &jobs, &mut |_| {
                asked += 1;
                match asked > allowed {
                    true => Control::Break(()),
                    false => Control::Continue(()),
                }
            });
            if asked > allowed {
                assert!(outcomes.contains(&None), "after {allowed}");
                let reasons = outcomes.iter().flatten().filter(|outcome| outcome.is_err());
                assert_eq!(reasons.count(), 0, "after {allowed}");
            }
        }
    }
}
