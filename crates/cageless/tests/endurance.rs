//! The production method without any damping.

use cageless::collision::CollisionDetector;
use cageless::simulation::{Control, Ending, RunOutcome, run};
use cageless::step_limits::StepLimits;
use cageless::summary::{Summary, SummaryRecorder};
use cageless::{Case, IntegrationMethod};

fn second(case: &Case) -> (RunOutcome, Summary, u32) {
    let mut summary = SummaryRecorder::new();
    let mut collisions = 0;
    let mut detector = CollisionDetector::new(|_| {
        collisions += 1;
        Ok(())
    });
    let outcome = run(case, &mut [&mut summary, &mut detector], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    drop(detector);
    let summary = summary.summary().unwrap();
    (outcome, summary, collisions)
}

/// Energy changes by what the ledger explains, and every ball stays in its place.
#[test]
fn a_second_without_damping_keeps_energy_and_balls() {
    let mut case = crate::common::undamped(crate::common::structure(5.1, 25.2));
    case.bearing = {
        let mut d = crate::common::dimensions();
        // As in CB74: little drag on the ring.
        d.inner_ring_damping_n_s_m = 500.0;
        cageless::Bearing::new(d, crate::common::steel()).unwrap()
    };
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.duration_s = 1.0;
    let automatic = StepLimits::new(&case).automatic_s(IntegrationMethod::VelocityVerlet);
    let mut at = |step_s: f64| {
        case.solver.step_s = step_s;
        let (outcome, summary, collisions) = second(&case);
        assert!(matches!(outcome.ending, Ending::Complete));
        assert!(collisions > 100, "{collisions}");
        let change = outcome.end_energy_j / outcome.start_energy_j - 1.0;
        assert!(change.abs() < 0.01, "{change}");
        let gaps = [summary.gap_min_rad, summary.gap_max_rad].map(f64::to_degrees);
        assert!(gaps[0] > -0.1 && gaps[1] < 10.0, "{gaps:?}");
        outcome.energy_residual_relative
    };
    for step_s in [automatic, automatic / 2.0] {
        let residual = at(step_s);
        assert!(residual.abs() < 2e-5, "{residual:e}");
    }
}
