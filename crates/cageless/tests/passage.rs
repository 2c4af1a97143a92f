//! Passages through a discrete raceway.

use cageless::passage::{Passage, PassageRecorder};
use cageless::simulation::{Control, run};
use cageless::{Case, Gaps, Start};

fn passages(case: &Case) -> Vec<Passage> {
    let mut found = vec![];
    {
        let mut recorder = PassageRecorder::new(|passage| {
            found.push(passage);
            Ok(())
        });
        run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    }
    found
}

/// Ends of the raceway are located within the step: with steps of 2 µs they come out as
/// with steps of 0.25 µs, far closer than a step.
#[test]
fn ends_are_located_within_the_step() {
    let mut case = crate::common::structure(5.1, 25.2);
    // Centre away from the bottom, so that both ends and the turn are told apart.
    case = case
        .clone()
        .with_raceways(vec![crate::common::raceway(&case.bearing, 5.1, 25.2, 30.0)]);
    case.start = Start::Settled {
        gaps: Gaps::Uniform,
        lead_ball_angle_rad: 0.1,
    };
    let mut at = |step_s: f64| {
        case.solver.step_s = step_s;
        passages(&case)
    };
    let (coarse, fine) = (at(2e-6), at(0.25e-6));
    assert!(fine.len() > 10 && coarse.len() == fine.len());
    let orbit = 498.0;
    for (a, b) in coarse.iter().zip(&fine).take(8) {
        assert_eq!((a.ball, a.raceway), (b.ball, b.raceway));
        for (x, y) in [(a.enter_s, b.enter_s), (a.leave_s, b.leave_s)] {
            assert!((x - y).abs() < 0.02e-6, "{x} {y}");
        }
        for (x, y) in [
            (a.gap_enter_rad, b.gap_enter_rad),
            (a.gap_leave_rad, b.gap_leave_rad),
        ] {
            assert!((x - y).abs() < 1e-6, "{x} {y}");
        }
        // Balls are slowed by some percent at most.
        let rolled = orbit * (b.leave_s - b.enter_s) / 50.4f64.to_radians();
        assert!((1.0..1.06).contains(&rolled), "{rolled}");
    }
}
