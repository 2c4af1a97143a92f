//! A method of integration of one's own, Heun's of order 2, on the equations of a bearing, beside the paper's ABM4 with
//! the same step. Guard, ledger and observers stay.
//!
//! `cargo run -p cageless --example own_integrator`

use cageless::prelude::*;

/// y(1) = y(0) + h/2·(f(0) + f(y(0) + h·f(0))), with one more evaluation at the end of the step.
struct Heun {
    step_s: f64,
}

impl Method for Heun {
    /// A one-step method has no history to forget.
    fn restart<S: System>(&mut self, _system: &mut S, _step: &StepState) {}

    /// `step.t0_s`, `y0` and `f0` are there; `t1_s`, `y1` and `f1` are to be set.
    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        step.t1_s = (step.t0_s + self.step_s).min(limit_s);
        let h = step.size_s();
        for k in 0..step.y0.len() {
            step.y1[k] = step.y0[k] + h * step.f0[k];
        }
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
        for k in 0..step.y0.len() {
            step.y1[k] = step.y0[k] + 0.5 * h * (step.f0[k] + step.f1[k]);
        }
        // The system's last evaluation is to be at the end of the step.
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut case = reference::Structure::D.case();
    case.solver.step_s = 0.2e-6;
    let abm4 = Simulation::new(&case)?.run(2e-3, &mut []);
    let mut heun = Simulation::new(&case)?.with_method(Heun { step_s: 0.2e-6 });
    let heun = heun.run(2e-3, &mut []);
    println!("unexplained energy after 2 ms, as a fraction of all flows");
    println!("  Heun, order 2: {:9.1e}", heun.energy_residual_relative);
    println!("  ABM4, order 4: {:9.1e}", abm4.energy_residual_relative);
    assert!(heun.energy_residual_relative.abs() < 1e-3);
    assert!(abm4.energy_residual_relative.abs() < 1e-5);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
