//! Tally of contacts between balls, against every step of the same run.

use crate::common::structure;
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::{ContactTally, Gaps, IntegrationMethod, Start, StartState};

/// Force on the outer ring and contacts between balls at every step.
#[derive(Default)]
struct EveryStep {
    rows: Vec<([f64; 2], [f64; 2], f64)>,
    begun: Vec<f64>,
    touching: Vec<bool>,
}

impl Observer for EveryStep {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let c = &view.contacts;
        self.touching.resize(c.balls(), false);
        for k in 0..c.balls() {
            let touches = c.balls_touch() && c.pair_deflection_m(k) > 0.0;
            if touches && !self.touching[k] {
                self.begun.push(view.step.t1_s);
            }
            self.touching[k] = touches;
        }
        let pressed: f64 = (0..c.balls()).map(|k| c.pair_force_n(k)).sum();
        let times = [view.step.t0_s, view.step.t1_s];
        self.rows.push((times, c.outer_ring_force_n(), pressed));
        Ok(Control::Continue(()))
    }
}

/// Contacts, impulse and varying force of balls that start unevenly, in all and at the end.
#[test]
fn the_tally_is_that_of_every_step() {
    let mut case = structure(4.9, 24.0);
    let gaps = Gaps::List(Gaps::uneven_rad(&case.bearing, 11, 3));
    case.start = Start::new(StartState::Settled, gaps, 0.0);
    case.set_method(IntegrationMethod::VelocityVerlet);
    (case.solver.step_s, case.solver.duration_s) = (1e-6, 0.04);
    let late_s = 0.5 * case.solver.duration_s;
    let (mut tally, mut every) = (ContactTally::new(late_s), EveryStep::default());
    run(&case, &mut [&mut tally, &mut every], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    let begun_late = every.begun.iter().filter(|t| **t > late_s).count();
    assert!(begun_late > 0 && every.begun.len() > begun_late);
    let counts = [every.begun.len(), begun_late].map(|count| count as f64);
    assert_eq!([tally.begun, tally.begun_late], counts);
    let mut before = 0.0;
    let impulse: f64 = (every.rows.iter())
        .map(|([from, to], _, pressed)| {
            0.5 * (to - from) * (std::mem::replace(&mut before, *pressed) + pressed)
        })
        .sum();
    assert!((tally.impulse_n_s / impulse - 1.0).abs() < 1e-9);
    let [x, y] = [0, 1].map(|axis| {
        let late = every.rows.iter().filter(|([_, to], ..)| *to > late_s);
        let forces: Vec<f64> = late.map(|(_, force, _)| force[axis]).collect();
        let count = forces.len() as f64;
        let mean = forces.iter().sum::<f64>() / count;
        (forces.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / count).sqrt()
    });
    let ratio = tally.force_deviation_n() / x.hypot(y);
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
}
