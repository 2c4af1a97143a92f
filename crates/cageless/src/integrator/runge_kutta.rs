//! Explicit Runge–Kutta pairs with error control.

use super::edges::Edges;
use super::system::System;
use super::tableau::{DORMAND_PRINCE_5, Tableau};
use crate::numerics::aligned::Aligned;

/// Error per sub-step, in the scales of the system, when crossing an interval.
const CROSSING_TOLERANCE: f64 = 1e-11;

/// A jump takes some tens of sub-steps to cross.
const ATTEMPTS_MAX: u32 = 10_000;

/// The state became so rough or so large that no step resolves it.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the equations cannot be resolved at t = {time_s} s")]
pub struct UnresolvedStep {
    /// Start of the step, s.
    pub time_s: f64,
}

/// A pair with its work arrays.
#[derive(Debug, Clone)]
pub(crate) struct RungeKutta {
    tableau: &'static Tableau,
    /// f at the stages, and at the end of the step in the last place.
    stages: Vec<Aligned>,
    trial: Aligned,
    difference: Aligned,
    /// Where steps end at the edges of f.
    edges: Option<Edges>,
}

/// Outcome of an attempted step.
enum Attempt {
    /// The estimate of its error.
    Error(f64),
    /// An edge lies at this share of it.
    Crossed(f64),
}

impl RungeKutta {
    /// The fifth-order pair, for systems of this dimension.
    pub(crate) fn new(dimension: usize) -> Self {
        Self::with_tableau(&DORMAND_PRINCE_5, dimension)
    }

    /// A given pair.
    pub(crate) fn with_tableau(tableau: &'static Tableau, dimension: usize) -> Self {
        Self {
            tableau,
            stages: vec![Aligned::zeros(dimension); tableau.b.len() + 1],
            trial: Aligned::zeros(dimension),
            difference: Aligned::zeros(dimension),
            edges: None,
        }
    }

    /// The pair with steps that end where f is not smooth ([`System::edges`]).
    pub(crate) fn ending_at_edges(self) -> Self {
        Self {
            edges: Some(Edges::default()),
            ..self
        }
    }

    /// Advances `y` from `from_s` over `h`, in as many sub-steps as the error control
    /// wants, so that whatever jumps within is resolved. `rate` is f at `y`, before
    /// and after; the system's last evaluation is at the end.
    ///
    /// # Errors
    /// [`UnresolvedStep`] when the state is no longer finite or takes too many sub-steps.
    pub(crate) fn integrate_across<S: System>(
        &mut self,
        system: &mut S,
        from_s: f64,
        h: f64,
        y: &mut [f64],
        rate: &mut [f64],
    ) -> Result<(), UnresolvedStep> {
        let mut done = 0.0;
        let mut size = h;
        while done < h {
            let accepted = self.step(
                system,
                from_s + done,
                size.min(h - done),
                CROSSING_TOLERANCE,
                h * 1e-6,
                y,
                rate,
            )?;
            // Rounding must not leave a rest.
            done = if accepted.size >= (h - done) * (1.0 - 1e-12) {
                h
            } else {
                done + accepted.size
            };
            size = accepted.next;
        }
        Ok(())
    }

    /// One step of error control: from `size` downwards until the error is below
    /// `tolerance` and no edge within, or the size below `least`. The system's last evaluation
    /// is at the start.
    ///
    /// # Errors
    /// [`UnresolvedStep`] when the state is no longer finite or takes too many attempts.
    #[allow(clippy::too_many_arguments)] // the state of the step, in and out
    pub(crate) fn step<S: System>(
        &mut self,
        system: &mut S,
        time_s: f64,
        mut size: f64,
        tolerance: f64,
        least: f64,
        y: &mut [f64],
        rate: &mut [f64],
    ) -> Result<AcceptedStep, UnresolvedStep> {
        let end = self.tableau.b.len();
        // Sizes that errors ask for; an edge says nothing of them.
        let (mut wanted, mut looked) = (size, false);
        if let Some(edges) = &mut self.edges {
            edges.start(system, y);
        }
        for _ in 0..ATTEMPTS_MAX {
            let (error, mut edge) = match self.attempt(system, time_s, size, least, y, rate) {
                Attempt::Error(error) => (error / tolerance, None),
                Attempt::Crossed(share) => (0.0, Some(share)),
            };
            if !error.is_finite() {
                return Err(UnresolvedStep { time_s });
            }
            let factor = 0.9 * error.max(1e-10).powf(-1.0 / self.tableau.order);
            let next = (size * factor.clamp(0.1, 5.0)).max(least);
            // A jump cannot be resolved below the least size; what it leaves is as small.
            if edge.is_none() && error > 1.0 && size > least {
                (size, wanted) = (next, next);
                continue;
            }
            if edge.is_none() {
                if self.tableau.error.len() <= end {
                    system.derivative(time_s + size, &self.trial, &mut self.stages[end]);
                }
                edge = self.edge(system, 1.0, size, least);
                if let (None, Some(edges), false) = (edge, &mut self.edges, looked || size <= least)
                {
                    edge = edges.hidden();
                    looked = edge.is_some();
                }
            }
            let Some(share) = edge else {
                y.copy_from_slice(&self.trial);
                rate.copy_from_slice(&self.stages[end]);
                let next = if size < wanted {
                    next.max(wanted)
                } else {
                    next
                };
                return Ok(AcceptedStep { size, next });
            };
            size = (size * share).max(least);
        }
        Err(UnresolvedStep { time_s })
    }

    /// Share of the step at which an edge is crossed before the state of the last evaluation, at
    /// a share `node` of it. The least step crosses all.
    fn edge<S: System>(&mut self, system: &S, node: f64, size: f64, least: f64) -> Option<f64> {
        let share = (self.edges.as_mut()?).crossed(system, &self.trial, node)?;
        (size > least && size * (1.0 - share) > least).then_some(share)
    }

    /// One step into `self.trial`.
    fn attempt<S: System>(
        &mut self,
        system: &mut S,
        time_s: f64,
        h: f64,
        least: f64,
        y: &[f64],
        rate: &[f64],
    ) -> Attempt {
        let t = self.tableau;
        let count = t.b.len();
        self.stages[0].copy_from_slice(rate);
        if let Some(edges) = &mut self.edges {
            edges.again();
        }
        for s in 1..count {
            combine(&mut self.trial, y, h, t.a[s], &self.stages);
            system.derivative(time_s + t.c[s] * h, &self.trial, &mut self.stages[s]);
            if let Some(share) = self.edge(system, t.c[s], h, least) {
                return Attempt::Crossed(share);
            }
        }
        combine(&mut self.trial, y, h, t.b, &self.stages);
        if t.error.len() > count {
            system.derivative(time_s + h, &self.trial, &mut self.stages[count]);
        }
        let error = self.estimate(system, h, t.error);
        if t.lower_error.is_empty() {
            return Attempt::Error(error);
        }
        // Hairer, Nørsett & Wanner, Eq. (II.10.17): err₅²/√(err₅² + 0.01 err₃²).
        let lower = self.estimate(system, h, t.lower_error);
        let size = error.hypot(0.1 * lower);
        Attempt::Error(if size > 0.0 {
            error * error / size
        } else {
            size
        })
    }

    fn estimate<S: System>(&mut self, system: &S, h: f64, weights: &[f64]) -> f64 {
        self.difference.fill(0.0);
        for (w, stage) in weights.iter().zip(&self.stages) {
            for (d, f) in self.difference.iter_mut().zip(stage.iter()) {
                *d += h * w * f;
            }
        }
        system.error_norm(&self.difference)
    }
}

/// An accepted step and the size suggested for the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AcceptedStep {
    /// Size of the step, s.
    pub size: f64,
    /// Size that the error suggests for the next step, s.
    pub next: f64,
}

/// y + h Σ w_k f_k.
fn combine(out: &mut [f64], y: &[f64], h: f64, weights: &[f64], stages: &[Aligned]) {
    out.copy_from_slice(y);
    for (w, stage) in weights.iter().zip(stages) {
        if *w != 0.0 {
            for (o, f) in out.iter_mut().zip(stage.iter()) {
                *o += h * w * f;
            }
        }
    }
}
