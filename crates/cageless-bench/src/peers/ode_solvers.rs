//! Dormand and Prince's methods in the crate `ode_solvers`.

use std::cell::RefCell;

use anyhow::{Result, anyhow};
use ode_solvers::{Dop853, Dopri5, OutputType, SVector, System};

use super::peer::{EachStep, Follow, Peer, Problem, Reached, TOLERANCES};
use crate::equations::{Equations, Implementation};

/// 14 balls and the ring.
const DIMENSION: usize = 74;
type Vector = SVector<f64, DIMENSION>;

/// Order of the method.
#[derive(Debug, Clone, Copy)]
pub enum Method {
    /// 5(4).
    Dopri5,
    /// 8(5,3).
    Dop853,
}

/// One method on one right-hand side.
pub struct OdeSolvers<'p> {
    /// CB74.
    pub problem: &'p Problem,
    /// Method.
    pub method: Method,
    /// Right-hand side.
    pub equations: Implementation,
}

struct Adapter<'e>(RefCell<&'e mut dyn Equations>);

impl System<f64, Vector> for &Adapter<'_> {
    fn system(&self, _t: f64, y: &Vector, dy: &mut Vector) {
        self.0
            .borrow_mut()
            .derivative(y.as_slice(), dy.as_mut_slice());
    }
}

/// `from_param` with the crate's own defaults, but for the output (whole steps: dense output
/// costs Dop853 three evaluations a step) and no limit on the number of steps.
macro_rules! solve {
    ($solver:ident, $f:expr, $end:expr, $y:expr, $tolerance:expr, $safety:expr, $beta:expr,
     $least:expr, $most:expr, $each_step:expr) => {{
        let mut solver = $solver::from_param(
            $f,
            0.0,
            $end,
            $end,
            $y,
            0.0,
            $tolerance,
            $safety,
            $beta,
            $least,
            $most,
            $end,
            0.0,
            u32::MAX,
            u32::MAX,
            OutputType::Sparse,
        );
        solver.integrate().map_err(|e| anyhow!("{e}"))?;
        for (t, y) in solver.x_out().iter().zip(solver.y_out()) {
            $each_step(*t, y.as_slice());
        }
        solver
            .y_out()
            .last()
            .map(|y| y.as_slice().to_vec())
            .ok_or_else(|| anyhow!("no output"))?
    }};
}

impl Peer for OdeSolvers<'_> {
    fn name(&self) -> String {
        match self.method {
            Method::Dopri5 => "ode_solvers Dopri5".into(),
            Method::Dop853 => "ode_solvers Dop853".into(),
        }
    }

    fn equations(&self) -> &'static str {
        self.equations.name()
    }

    fn setting_name(&self) -> &'static str {
        "tolerance"
    }

    fn settings(&self) -> Vec<f64> {
        TOLERANCES.to_vec()
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        self.follow(setting, duration_s, &mut |_, _| {})
    }
}

impl Follow for OdeSolvers<'_> {
    fn follow(
        &self,
        setting: f64,
        duration_s: f64,
        each_step: &mut EachStep<'_>,
    ) -> Result<Reached> {
        let y = Vector::from_column_slice(&self.problem.start);
        self.equations.with(&self.problem.case, |equations| {
            let before = equations.evaluations();
            let system = Adapter(RefCell::new(equations));
            let z = match self.method {
                Method::Dopri5 => {
                    solve!(
                        Dopri5, &system, duration_s, y, setting, 0.9, 0.04, 0.2, 10.0, each_step
                    )
                }
                Method::Dop853 => {
                    solve!(
                        Dop853, &system, duration_s, y, setting, 0.9, 0.0, 0.333, 6.0, each_step
                    )
                }
            };
            let evaluations = system.0.into_inner().evaluations() - before;
            Ok(Reached { z, evaluations })
        })?
    }
}
