//! The classical Runge–Kutta method with a fixed step, as a solver to compare with.

use anyhow::{Result, bail};

use crate::equations::{Equations, Implementation};
use crate::peers::peer::{EachStep, Follow, Peer, Problem, Reached};

/// The method on one right-hand side.
pub struct Rk4<'p> {
    /// The problem.
    pub problem: &'p Problem,
    /// Right-hand side.
    pub equations: Implementation,
}

impl Peer for Rk4<'_> {
    fn name(&self) -> String {
        "RK4".into()
    }

    fn equations(&self) -> &'static str {
        self.equations.name()
    }

    fn setting_name(&self) -> &'static str {
        "step, µs"
    }

    fn settings(&self) -> Vec<f64> {
        vec![1.0, 0.5, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.03]
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        self.follow(setting, duration_s, &mut |_, _| {})
    }
}

impl Follow for Rk4<'_> {
    fn follow(
        &self,
        setting: f64,
        duration_s: f64,
        each_step: &mut EachStep<'_>,
    ) -> Result<Reached> {
        let steps = (duration_s / (setting * 1e-6)).ceil();
        let h = duration_s / steps;
        let mut z = self.problem.start.clone();
        let n = z.len();
        self.equations
            .with(&self.problem.case, |equations: &mut dyn Equations| {
                let before = equations.evaluations();
                let mut k = [vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]];
                let mut trial = vec![0.0; n];
                for step in 0..steps as u64 {
                    equations.derivative(&z, &mut k[0]);
                    for (stage, fraction) in [(1, 0.5), (2, 0.5), (3, 1.0)] {
                        for i in 0..n {
                            trial[i] = z[i] + h * fraction * k[stage - 1][i];
                        }
                        equations.derivative(&trial, &mut k[stage]);
                    }
                    for i in 0..n {
                        z[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
                    }
                    if !z[n - 1].is_finite() {
                        bail!("the states are no longer finite");
                    }
                    each_step((step + 1) as f64 * h, &z);
                }
                if z.iter().any(|v| !v.is_finite()) {
                    bail!("the states are no longer finite");
                }
                let evaluations = equations.evaluations() - before;
                Ok(Reached { z, evaluations })
            })?
    }
}
