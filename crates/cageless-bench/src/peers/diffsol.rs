//! The crate `diffsol`.

use std::cell::RefCell;

use anyhow::{Result, anyhow};
use diffsol::{
    NalgebraLU, NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason,
    VectorCommon,
};

use super::peer::{EachStep, Follow, Peer, Problem, Reached, TOLERANCES};
use crate::equations::Implementation;

type Matrix = NalgebraMat<f64>;

/// Method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Explicit Runge–Kutta 5(4) of Tsitouras.
    Tsit45,
    /// Backward differentiation; the Jacobian by finite differences.
    Bdf,
}

/// One method on one right-hand side.
pub struct Diffsol<'p> {
    /// CB74.
    pub problem: &'p Problem,
    /// Method.
    pub method: Method,
    /// Right-hand side.
    pub equations: Implementation,
}

/// Increment of the finite differences in the scales of the states.
const INCREMENT: f64 = 1e-7;

/// Steps until `end_s`.
fn advance<'a, E, S>(solver: &mut S, end_s: f64, each_step: &mut EachStep<'_>) -> Result<Vec<f64>>
where
    E: OdeEquations<T = f64, V = diffsol::NalgebraVec<f64>> + 'a,
    S: OdeSolverMethod<'a, E>,
{
    solver.set_stop_time(end_s)?;
    loop {
        let reason = solver.step()?;
        let state = solver.state();
        each_step(state.t, state.y.inner().as_slice());
        if matches!(reason, OdeSolverStopReason::TstopReached) {
            break;
        }
    }
    Ok(solver.state().y.inner().as_slice().to_vec())
}

impl Peer for Diffsol<'_> {
    fn name(&self) -> String {
        match self.method {
            Method::Tsit45 => "diffsol tsit45".into(),
            Method::Bdf => "diffsol BDF".into(),
        }
    }

    fn equations(&self) -> &'static str {
        self.equations.name()
    }

    fn setting_name(&self) -> &'static str {
        "tolerance"
    }

    fn settings(&self) -> Vec<f64> {
        match self.method {
            Method::Tsit45 => TOLERANCES.to_vec(),
            // Slow: few are enough.
            Method::Bdf => vec![1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7],
        }
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        self.follow(setting, duration_s, &mut |_, _| {})
    }
}

impl Follow for Diffsol<'_> {
    fn follow(
        &self,
        setting: f64,
        duration_s: f64,
        each_step: &mut EachStep<'_>,
    ) -> Result<Reached> {
        let start = &self.problem.start;
        self.equations.with(&self.problem.case, |equations| {
            let before = equations.evaluations();
            let shared = RefCell::new(equations);
            let rhs = |z: &[f64], _p: &[f64], _t: f64, dzdt: &mut [f64]| {
                shared.borrow_mut().derivative(z, dzdt);
            };
            let builder = OdeBuilder::<Matrix>::new()
                .rtol(0.0)
                .atol(vec![setting; start.len()])
                .h0(1e-7);
            let init = |_p: &[f64], _t: f64, z: &mut [f64]| z.copy_from_slice(start);
            let z = match self.method {
                Method::Tsit45 => {
                    let problem = builder.rhs(rhs).init(init, start.len()).build()?;
                    advance(&mut problem.tsit45()?, duration_s, each_step)?
                }
                Method::Bdf => {
                    let work = RefCell::new([vec![0.0; start.len()], vec![0.0; start.len()]]);
                    let jacobian = |z: &[f64], _p: &[f64], _t: f64, v: &[f64], out: &mut [f64]| {
                        let [moved, rate] = &mut *work.borrow_mut();
                        for ((m, z), v) in moved.iter_mut().zip(z).zip(v) {
                            *m = z + INCREMENT * v;
                        }
                        let mut equations = shared.borrow_mut();
                        equations.derivative(moved, out);
                        equations.derivative(z, rate);
                        for (out, rate) in out.iter_mut().zip(rate) {
                            *out = (*out - *rate) / INCREMENT;
                        }
                    };
                    let problem = builder
                        .rhs_implicit(rhs, jacobian)
                        .init(init, start.len())
                        .build()?;
                    advance(
                        &mut problem.bdf::<NalgebraLU<f64>>()?,
                        duration_s,
                        each_step,
                    )?
                }
            };
            let evaluations = shared.borrow().evaluations() - before;
            Ok::<_, diffsol::error::DiffsolError>(Reached { z, evaluations })
                .map_err(|e| anyhow!("{e}"))
        })?
    }
}
