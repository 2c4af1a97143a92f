//! A method of integration of one's own, Verlet's of one evaluation a step, on the equations of a bearing, beside the
//! paper's ABM4 with the same step. Guard, ledger and observers stay.
//!
//! `cargo run -p cageless --example own_integrator`

use cageless::prelude::*;

/// y(1) = y(0) + h/2·(f(0) + f(1)), where f(1) is that at the positions of the end: forces of springs depend on no more.
struct Verlet {
    step_s: f64,
}

impl Method for Verlet {
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
        for block in system.second_order_blocks() {
            for (position, rate) in pairs(block) {
                step.y1[position] += 0.5 * h * h * step.f0[rate];
            }
        }
        // The system's last evaluation is to be at the end of the step.
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
        for k in 0..step.y0.len() {
            step.y1[k] = step.y0[k] + 0.5 * h * (step.f0[k] + step.f1[k]);
        }
        for block in system.second_order_blocks() {
            for (position, rate) in pairs(block) {
                step.f1[position] = step.y1[rate];
            }
        }
        Ok(())
    }
}

/// Places of positions, each with that of its rate.
fn pairs(block: &SecondOrderBlock) -> impl Iterator<Item = (usize, usize)> + use<> {
    let (positions, rates) = (block.positions, block.rates);
    (0..block.count).map(move |k| (positions + k, rates + k))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut case = reference::Structure::D.case();
    case.solver.step_s = 0.2e-6;
    let abm4 = Simulation::new(&case)?.run(2e-3, &mut []);
    let mut verlet = Simulation::new(&case)?.with_method(Verlet { step_s: 0.2e-6 });
    let verlet = verlet.run(2e-3, &mut []);
    println!("unexplained energy after 2 ms, as a fraction of all flows");
    println!(
        "  Verlet, order 2: {:9.1e}",
        verlet.energy_residual_relative
    );
    println!("  ABM4, order 4:   {:9.1e}", abm4.energy_residual_relative);
    assert!(verlet.energy_residual_relative.abs() < 1e-3);
    assert!(abm4.energy_residual_relative.abs() < 1e-5);
    Ok(())
}

#[test]
fn runs() {
    main().unwrap();
}
