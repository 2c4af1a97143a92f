//! A method of integration of one's own, Heun's of order 2, on the equations of a bearing,
//! beside the paper's ABM4 with the same step.
//!
//! `cargo run -p cageless --example own_integrator`

#[path = "../tests/common/mod.rs"] // the bearing of the paper, Table 1
mod common;

use cageless::Case;
use cageless::dynamics::state::State;
use cageless::dynamics::{Model, RightHandSide};
use cageless::initial_conditions::initial_state;
use cageless::integrator::{Abm4, Integrator, Method, StepState, System, UnresolvedStep};

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

/// Energy after 2 ms that the ledger does not explain, as a fraction of all flows: the error of the
/// method in one number.
fn integrate(case: &Case, method: impl Method) -> Result<f64, Box<dyn std::error::Error>> {
    let model = Model::new(case)?;
    let mut rhs = RightHandSide::new(&model);
    let (start, _angles) = initial_state(case)?;
    let mut integrator = Integrator::new(method, rhs.layout().len());
    integrator.restart(&mut rhs, 0.0, start.values());
    while integrator.step().t1_s < 2e-3 {
        integrator.advance(&mut rhs, 2e-3)?;
    }
    let end = State::from_vector(rhs.layout(), &integrator.step().y1);
    let (residual_j, flows_j) = model.energy_residual_j(model.energy_j(&start), &end);
    Ok(residual_j / flows_j)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = common::structure(5.1, 25.2);
    let step_s = 0.2e-6;
    let model = Model::new(&case)?;
    let heun = integrate(&case, Heun { step_s })?;
    let abm4 = integrate(&case, Abm4::new(model.layout().len(), step_s))?;
    println!("unexplained energy after 2 ms, as a fraction of all flows");
    println!("  Heun, order 2: {heun:9.1e}");
    println!("  ABM4, order 4: {abm4:9.1e}");
    assert!(heun.abs() < 1e-3 && abm4.abs() < 1e-5);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
