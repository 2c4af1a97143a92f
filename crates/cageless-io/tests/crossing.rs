//! Jumps of the right-hand side: closing in on them by error control, as `abm4` does,
//! against locating them and starting anew there.
//! `cargo test -p cageless-io --test all crossing -- --nocapture` prints the comparison.

use cageless::Case;
use cageless::dynamics::state::State;
use cageless::dynamics::{Model, RightHandSide};
use cageless::initial_conditions::initial_state;
use cageless::integrator::{Abm4, Integrator, RungeKutta, System, UnresolvedStep};
use cageless_io::case_file::CaseFile;

/// ABM4 that locates each change of mode within the step by bisection on the cubic
/// through its ends, to a millionth of the step, steps up to it, across it, and starts anew
/// beyond.
struct Located {
    inner: Integrator<Abm4>,
    crossing: RungeKutta,
    h: f64,
    mode: u64,
    y: Vec<f64>,
    rate: Vec<f64>,
    found: u32,
}

impl Located {
    fn new(dimension: usize, h: f64) -> Self {
        Self {
            inner: Integrator::new(Abm4::new(dimension, h), dimension),
            crossing: RungeKutta::new(dimension),
            h,
            mode: 0,
            y: vec![0.0; dimension],
            rate: vec![0.0; dimension],
            found: 0,
        }
    }

    /// Offset of the first change of mode in the last step.
    fn locate<S: System>(&mut self, system: &mut S) -> f64 {
        let step = self.inner.step();
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
}

impl Stepper for Located {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        self.inner.restart(system, time_s, y);
        self.mode = system.mode();
    }

    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), UnresolvedStep> {
        self.inner.advance(system, limit_s)?;
        if system.mode() == self.mode {
            return Ok(());
        }
        self.found += 1;
        let edge = self.locate(system);
        let from_s = self.inner.step().t0_s;
        self.y.copy_from_slice(&self.inner.step().y0);
        self.rate.copy_from_slice(&self.inner.step().f0);
        self.crossing
            .integrate_across(system, from_s, edge, &mut self.y, &mut self.rate)?;
        self.restart(system, from_s + edge, &self.y.clone());
        Ok(())
    }

    fn end(&self) -> (f64, &[f64]) {
        (self.inner.step().t1_s, &self.inner.step().y1)
    }
}

/// What both ways have in common.
trait Stepper {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]);
    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), UnresolvedStep>;
    /// Time and state reached.
    fn end(&self) -> (f64, &[f64]);
}

impl Stepper for Integrator<Abm4> {
    fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        self.restart(system, time_s, y);
    }

    fn advance<S: System>(&mut self, system: &mut S, limit_s: f64) -> Result<(), UnresolvedStep> {
        self.advance(system, limit_s)
    }

    fn end(&self) -> (f64, &[f64]) {
        (self.step().t1_s, &self.step().y1)
    }
}

const END_S: f64 = 0.002;

/// State at 2 ms and evaluations of the right-hand side.
fn end(case: &Case, method: &mut impl Stepper) -> (Vec<f64>, u64) {
    let model = Model::new(case).unwrap();
    let mut rhs = RightHandSide::new(&model);
    let (start, _) = initial_state(case).unwrap();
    method.restart(&mut rhs, 0.0, start.values());
    while method.end().0 < END_S {
        method.advance(&mut rhs, END_S).unwrap();
    }
    (method.end().1.to_vec(), rhs.evaluations())
}

fn error(case: &Case, name: &str, values: &[f64]) -> f64 {
    let layout = Model::new(case).unwrap().layout();
    crate::common::scaled_error_of(case, name, &State::from_vector(layout, values))
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
            let model = Model::new(&case).unwrap();
            let dimension = model.layout().len();
            let method = Abm4::new(dimension, case.solver.step_s);
            let mut plain = Integrator::new(method, dimension);
            let (y, evaluations) = end(&case, &mut plain);
            let mut located = Located::new(dimension, case.solver.step_s);
            let (z, more) = end(&case, &mut located);
            let (controlled, by_location) = (error(&case, name, &y), error(&case, name, &z));
            println!(
                "{name:14} {step_us:4} µs, {:3} changes: error {controlled:.1e} in {evaluations:6} \
                 evaluations, located {by_location:.1e} in {more:6}",
                located.found
            );
            assert!(
                controlled < 1.5 * by_location + 1e-9,
                "{name}, {step_us} µs"
            );
            assert!(evaluations < more);
        }
    }
}
