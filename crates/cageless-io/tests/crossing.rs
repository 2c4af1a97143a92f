//! Jumps of the right-hand side: closing in on them by error control, as `abm4` does,
//! against locating them and starting anew there.
//! `cargo test -p cageless-io --test all crossing -- --nocapture` prints the comparison.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use cageless::IntegrationMethod;
use cageless::dynamics::State;
use cageless::integrator::{Abm4, Method, StepState, System, UnresolvedStep};
use cageless::simulation::Simulation;
use cageless_io::case_file::CaseFile;

/// ABM4 that locates each change of mode within the step by bisection on the cubic
/// through its ends, to a millionth of the step, steps up to it by the classical Runge–Kutta
/// method, and starts anew beyond.
struct Located {
    inner: Abm4,
    h: f64,
    mode: u64,
    y: Vec<f64>,
    rate: Vec<f64>,
    found: Arc<AtomicU32>,
}

impl Located {
    fn new(dimension: usize, h: f64, found: &Arc<AtomicU32>) -> Self {
        Self {
            inner: Abm4::new(dimension, h),
            h,
            mode: 0,
            y: vec![0.0; dimension],
            rate: vec![0.0; dimension],
            found: found.clone(),
        }
    }

    /// Offset of the first change of mode in the step.
    fn locate<S: System>(&mut self, system: &mut S, step: &StepState) -> f64 {
        let (mut same, mut changed) = (0.0, step.t1_s - step.t0_s);
        while changed - same > 1e-6 * self.h {
            let middle = 0.5 * (same + changed);
            for (k, value) in self.y.iter_mut().enumerate() {
                *value = step.interpolate(k, step.t0_s + middle);
            }
            system.derivative(step.t0_s + middle, &self.y, &mut self.rate);
            if system.mode() == self.mode {
                same = middle;
            } else {
                changed = middle;
            }
        }
        changed
    }

    /// Ends the step at the offset `h`, by the classical method of order 4.
    fn shorten<S: System>(&mut self, system: &mut S, step: &mut StepState, h: f64) {
        step.t1_s = step.t0_s + h;
        step.y1.copy_from_slice(&step.y0);
        self.rate.copy_from_slice(&step.f0);
        for (weight, next) in [(1.0, 0.5), (2.0, 0.5), (2.0, 1.0), (1.0, 0.0)] {
            for k in 0..self.y.len() {
                step.y1[k] += weight * h / 6.0 * self.rate[k];
                self.y[k] = step.y0[k] + next * h * self.rate[k];
            }
            if next > 0.0 {
                system.derivative(step.t0_s + next * h, &self.y, &mut self.rate);
            }
        }
        system.derivative(step.t1_s, &step.y1, &mut step.f1);
    }
}

impl Method for Located {
    fn restart<S: System>(&mut self, system: &mut S, step: &StepState) {
        self.inner.restart(system, step);
        self.mode = system.mode();
    }

    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        self.inner.perform_step(system, step, limit_s)?;
        if system.mode() != self.mode {
            self.found.fetch_add(1, Relaxed);
            let edge = self.locate(system, step);
            self.shorten(system, step, edge);
            self.restart(system, step);
        }
        Ok(())
    }
}

const END_S: f64 = 0.002;

/// State at 2 ms and evaluations of the right-hand side.
fn end(mut simulation: Simulation) -> (State, u64) {
    simulation.advance_to(END_S).unwrap();
    (simulation.state(), simulation.outcome().rhs_evaluations)
}

/// Where damped contacts close, the slope of the force is infinite: whatever locates the
/// edge must approach it by small steps from behind all the same. Locating is no more
/// accurate and costs more.
#[test]
fn error_control_crosses_jumps_as_well_as_location() {
    for name in ["clear6_damped", "crowd", "b16_physical", "b16r"] {
        let path = crate::common::folder().join(format!("{name}.toml"));
        let mut case = CaseFile::read(&path, &[]).unwrap().case().clone();
        for step_us in [1.0, 0.5, 0.25] {
            case.solver.step_s = step_us * 1e-6;
            case.solver.method = IntegrationMethod::Abm4;
            let plain = Simulation::new(&case).unwrap();
            let dimension = plain.state().values().len();
            let found = Arc::default();
            let method = Located::new(dimension, case.solver.step_s, &found);
            let located = Simulation::new(&case).unwrap().with_method(method);
            let (y, evaluations) = end(plain);
            let (z, more) = end(located);
            let error = |state| crate::common::scaled_error_of(&case, name, state);
            let (controlled, by_location) = (error(&y), error(&z));
            println!(
                "{name:14} {step_us:4} µs, {:3} changes: error {controlled:.1e} in {evaluations:6} \
                 evaluations, located {by_location:.1e} in {more:6}",
                found.load(Relaxed)
            );
            assert!(
                controlled < 1.5 * by_location + 1e-9,
                "{name}, {step_us} µs"
            );
            assert!(evaluations < more);
        }
    }
}
