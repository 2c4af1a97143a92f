//! Observers of one's own: a closure that takes the largest load of a ball, and a struct that takes the time each ball
//! spends without contact with the inner raceway.
//!
//! `cargo run -p cageless --example own_observer`

use cageless::prelude::*;

/// Time of each ball without inner contact, s.
struct UnloadedTime {
    seconds: Vec<f64>,
}

fn is_unloaded(ball: &BallView<'_>) -> bool {
    ball.inner_force_n() == 0.0
}

impl Observer for UnloadedTime {
    /// Before the first step: the case, its equations and its initial state.
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.seconds = vec![0.0; context.case.balls()];
        Ok(())
    }

    /// After every step: both ends of the step, and the contacts at its end.
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        for (seconds, ball) in self.seconds.iter_mut().zip(view.balls()) {
            if is_unloaded(&ball) {
                *seconds += view.step.size_s();
            }
        }
        Ok(Control::Continue(())) // Control::Break(()) ends the run
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut simulation = Simulation::new(&reference::Structure::D.case())?;
    let mut unloaded = UnloadedTime { seconds: vec![] };
    let mut most_n = 0.0;
    let mut largest = each_step(|view| {
        most_n = view
            .balls()
            .fold(most_n, |most: f64, ball| most.max(ball.outer_force_n()));
        Control::Continue(())
    });
    let outcome = simulation.run(0.02, &mut [&mut unloaded, &mut largest]);
    println!("largest load of a ball: {most_n:.0} N");
    for (k, seconds) in unloaded.seconds.iter().enumerate() {
        let percent = 100.0 * seconds / outcome.end_s;
        println!("ball {:2}: {percent:5.1} % without inner contact", k + 1);
    }
    // The load acts downwards: every ball that passes the top is free for a while.
    assert!(unloaded.seconds.iter().any(|&s| s > 0.0));
    assert!(unloaded.seconds.iter().all(|&s| s < outcome.end_s));
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
