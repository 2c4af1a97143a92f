//! An observer of one's own: the fraction of time that each ball spends without contact with
//! the inner raceway.
//!
//! `cargo run -p cageless --example own_observer`

#[path = "../tests/common/mod.rs"] // the bearing of the paper, Table 1
mod common;

use cageless::simulation::{Control, Observer, ObserverError, RunContext, StepView, run};

/// Time of each ball without inner contact, s.
struct UnloadedTime {
    seconds: Vec<f64>,
    end_s: f64,
}

impl Observer for UnloadedTime {
    /// Before the first step: the case, its equations and its initial state.
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.seconds = vec![0.0; context.case.bearing.balls()];
        Ok(())
    }

    /// After every step: both ends of the step, and the contacts at its end.
    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        for (k, seconds) in self.seconds.iter_mut().enumerate() {
            if view.contacts.inner_force_n(k) == 0.0 {
                *seconds += view.step.size_s();
            }
        }
        self.end_s = view.step.t1_s;
        Ok(Control::Continue(())) // Control::Break(()) ends the run
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = common::structure(5.1, 25.2);
    let mut unloaded = UnloadedTime {
        seconds: vec![],
        end_s: 0.0,
    };
    run(&case, &mut [&mut unloaded], &mut |_| Control::Continue(()))?;
    for (k, seconds) in unloaded.seconds.iter().enumerate() {
        let percent = 100.0 * seconds / unloaded.end_s;
        println!("ball {:2}: {percent:5.1} % without inner contact", k + 1);
    }
    // The load acts downwards: every ball that passes the top is free for a while.
    assert!(unloaded.seconds.iter().any(|&s| s > 0.0));
    assert!(unloaded.seconds.iter().all(|&s| s < unloaded.end_s));
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
