//! Balls whose radii differ.

use crate::common::{conventional, dimensions, structure, undamped};
use cageless::equilibrium;
use cageless::simulation::{Control, Ending, run};
use cageless::{Case, Gaps, IntegrationMethod, Start, StartState};

fn scattered(mut case: Case, deviation: impl Fn(usize) -> f64) -> Case {
    let deviations = (0..case.bearing.balls()).map(deviation).collect();
    let bearing = case.bearing.clone();
    case.bearing = bearing.with_ball_radius_deviations(deviations).unwrap();
    case
}

fn settled(mut case: Case) -> Case {
    case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.2);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 0.5e-6;
    case.solver.duration_s = 0.002;
    case
}

/// Balls that are all larger by the same amount are a bearing of larger balls.
#[test]
fn a_common_deviation_is_another_ball() {
    for deviation in [-0.8e-6, -5e-6] {
        let mut d = dimensions();
        d.ball_radius_m += deviation;
        let other = settled(conventional(d));
        let same = settled(scattered(conventional(dimensions()), |_| deviation));
        let (a, b) = (
            equilibrium::solve(&other).unwrap(),
            equilibrium::solve(&same).unwrap(),
        );
        assert!((a.ring_y_m - b.ring_y_m).abs() < 1e-14);
        let [a, b] = [other, same].map(|case| {
            let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
            assert!(matches!(outcome.ending, Ending::Complete));
            outcome.state
        });
        for (a, b) in a.values().iter().zip(b.values()) {
            assert!((a - b).abs() < 1e-9 * a.abs().max(1e-3), "{a} {b}");
        }
    }
}

/// The ledger closes, through a discrete raceway, too, where the contact geometry of a ball of another
/// radius rises and falls.
#[test]
fn the_ledger_closes() {
    let scatter = |k: usize| 2e-6 * ((7 * k + 3) % 11) as f64 - 10e-6;
    let case = settled(scattered(undamped(structure(5.1, 25.2)), scatter));
    let residual = |step_s: f64| {
        let mut case = case.clone();
        case.solver.step_s = step_s;
        let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        assert!(matches!(outcome.ending, Ending::Complete));
        outcome.energy_residual_relative.abs()
    };
    let (coarse, fine) = (residual(1e-6), residual(0.25e-6));
    assert!(fine < 1e-6, "{coarse:e} {fine:e}");
    assert!(fine < coarse / 4.0, "{coarse:e} {fine:e}");
}

/// So it does in a raceway that is not as deep as designed, and in a deep one.
#[test]
fn the_ledger_closes_in_a_raceway_of_wrong_depth() {
    for (error, depth) in [(-2e-6, 0.0), (2e-6, 0.0), (0.0, 4e-6), (1e-6, 20e-6)] {
        let mut case = settled(undamped(structure(5.1, 25.2)));
        let raceway = case.raceways[0].clone().with_depth_error(error).unwrap();
        case = case.with_raceways(vec![raceway.with_depth(depth).unwrap()]);
        case.solver.step_s = 0.25e-6;
        let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        let residual = outcome.energy_residual_relative.abs();
        assert!(residual < 1e-6, "{error:e} {depth:e}: {residual:e}");
    }
}

/// Whatever stands in the lanes that no ball fills, it is not felt.
#[test]
fn padding_is_not_felt() {
    for balls in 3..=17 {
        let mut d = dimensions();
        d.balls = balls;
        let grow = balls as f64 / 14.0;
        if balls > 14 {
            d.outer_groove_bottom_radius_m *= grow;
            d.inner_groove_bottom_radius_m = d.outer_groove_bottom_radius_m - 9.525e-3;
            d.outer_shoulder_radius_m = d.outer_groove_bottom_radius_m - 1.765e-3;
        }
        let case = conventional(d);
        let wide = crate::common::raceway(&case.bearing, 4.95, 35.0, 0.0);
        let case = scattered(case.with_raceways(vec![wide]), |k| -1e-6 * (k % 3) as f64);
        let (state, _) =
            cageless::initial_conditions::initial_state(&settled(case.clone())).unwrap();
        let model = cageless::dynamics::Model::new(&case).unwrap();
        let mut rate = vec![0.0; state.values().len()];
        let mut rhs = cageless::dynamics::RightHandSide::new(&model);
        cageless::integrator::System::derivative(&mut rhs, 0.0, state.values(), &mut rate);
        assert!(
            rate.iter().all(|r| r.is_finite()),
            "{balls} balls: {rate:?}"
        );
    }
}

/// The largest ball carries the most, the others share what it leaves.
#[test]
fn a_large_ball_carries_more() {
    let mut case = conventional(dimensions());
    case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.0);
    let equal = equilibrium::solve(&case).unwrap();
    let unequal = scattered(case, |k| if k == 0 { 2e-6 } else { 0.0 });
    let e = equilibrium::solve(&unequal).unwrap();
    assert!(e.inner_force_n[0] > 1.1 * equal.inner_force_n[0]);
    assert!(e.inner_force_n[1] < equal.inner_force_n[1]);
    assert!(e.ring_y_m > equal.ring_y_m);
}

/// Balls of two sizes roll at two speeds and meet.
#[test]
fn unequal_balls_meet() {
    let collisions = |deviation: f64| {
        let mut case = conventional(dimensions());
        case.operation.radial_load_n = 500.0;
        case = settled(scattered(case, |k| if k == 5 { deviation } else { 0.0 }));
        case.solver.step_s = 1e-6;
        case.solver.duration_s = 0.1;
        let mut summary = cageless::summary::SummaryRecorder::new();
        run(&case, &mut [&mut summary], &mut |_| Control::Continue(())).unwrap();
        summary.summary().unwrap()
    };
    let (equal, one) = (collisions(0.0), collisions(-20e-6));
    assert!(one.gap_min_rad < equal.gap_min_rad, "{equal:?} {one:?}");
}
