//! Integration of ordinary differential equations. Nothing here knows of bearings.
//!
//! A method is one file: a struct that implements [`Method::perform_step`] on a [`StepState`],
//! and a row of [`Properties`]. [`Integrator`] owns the state of the step.
//!
//! ```
//! use cageless::integrator::{Abm4, Integrator, System};
//!
//! /// y″ = −y.
//! struct Oscillator;
//!
//! impl System for Oscillator {
//!     fn dimension(&self) -> usize {
//!         2
//!     }
//!     fn derivative(&mut self, _time_s: f64, y: &[f64], dydt: &mut [f64]) {
//!         (dydt[0], dydt[1]) = (y[1], -y[0]);
//!     }
//! }
//!
//! let mut integrator = Integrator::new(Abm4::new(2, 0.01), 2);
//! integrator.restart(&mut Oscillator, 0.0, &[0.0, 1.0]);
//! while integrator.step().t1_s < 1.0 {
//!     integrator.advance(&mut Oscillator, 1.0)?;
//! }
//! assert!((integrator.step().y1[0] - 1f64.sin()).abs() < 1e-8);
//! # Ok::<(), cageless::integrator::UnresolvedStep>(())
//! ```

mod abm4;
mod adaptive;
mod runge_kutta;
mod step_state;
pub mod tableau;
mod velocity_verlet;

pub use abm4::Abm4;
pub use adaptive::Adaptive;
pub use runge_kutta::{AcceptedStep, RungeKutta, UnresolvedStep};
pub use step_state::StepState;
pub use velocity_verlet::{PlanarVelocities, SecondOrderBlock, VelocityVerlet};

use step_state::FixedSteps;

/// A system of ordinary differential equations dy/dt = f(t, y).
pub trait System {
    /// Length of y.
    fn dimension(&self) -> usize;

    /// Writes f(t, y) into `dydt`.
    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]);

    /// Fingerprint of the smooth piece of f that the last evaluation lay in. Where it
    /// changes between two steps, f has jumped, or changed so abruptly that the history of
    /// a multistep method must not reach across. The system decides what counts.
    fn mode(&self) -> u64 {
        0
    }

    /// Components that are positions and their rates, in ascending order of the positions;
    /// for methods that advance them one after the other.
    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &[]
    }

    /// Velocities of bodies on curved planar paths whose forces depend on the speed along the
    /// path; for methods that extrapolate them.
    fn planar_velocities(&self) -> Option<PlanarVelocities> {
        None
    }

    /// Whether f has a stiff, dissipative part that acts on velocities and that
    /// [`Self::add_stiff_part`] solves for.
    fn has_stiff_part(&self) -> bool {
        false
    }

    /// Writes f(t, y) without its stiff part into `dydt`.
    fn nonstiff_derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.derivative(time_s, y, dydt);
    }

    /// Adds the stiff part g over a step of `h_s` from `y0`, implicitly: y holds what the rest of f
    /// leads to and becomes y + h·g, where g is that at the end, g(y + h·g), or a mean of both ends
    /// as stable; g is added to `dydt`. Positions and what depends on them are as of the last
    /// [`Self::nonstiff_derivative`].
    fn add_stiff_part(&mut self, _h_s: f64, _y0: &[f64], _y: &mut [f64], _dydt: &mut [f64]) {}

    /// Size of a difference of two states in the scales of the problem; 1 is as large
    /// as what is of interest.
    fn error_norm(&self, difference: &[f64]) -> f64 {
        difference.iter().fold(0.0, |m, d| m.max(d.abs()))
    }
}

/// Order, stability and cost of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Properties {
    /// Order of convergence on smooth problems.
    pub order: u32,
    /// Largest ωh on y″ = −ω²y that does not grow violently; infinite under error control.
    pub oscillation_limit: f64,
    /// Largest λh on y′ = −λy; infinite under error control.
    pub decay_limit: f64,
    /// Evaluations of f per step; at least so many under error control.
    pub evaluations: u32,
}

/// A method that advances a system step by step.
pub trait Method {
    /// Forgets all history; the system's last evaluation gave `step.f1` at `step.y1`.
    fn restart<S: System>(&mut self, system: &mut S, step: &StepState);

    /// Makes the step from `t0_s`, `y0`, `f0`: sets `t1_s`, at most `limit_s`, `y1` and `f1`.
    /// The system's last evaluation is at the end of the step.
    ///
    /// # Errors
    /// [`UnresolvedStep`] if no step size resolves the equations.
    fn perform_step<S: System>(
        &mut self,
        system: &mut S,
        step: &mut StepState,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep>;
}

/// A method with the step that it last made.
#[derive(Debug, Clone)]
pub struct Integrator<M> {
    method: M,
    step: StepState,
}

impl<M: Method> Integrator<M> {
    /// Integrates systems of this dimension by `method`.
    pub fn new(method: M, dimension: usize) -> Self {
        Self {
            method,
            step: StepState::new(dimension),
        }
    }

    /// Forgets all history and starts at `y`.
    pub fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        self.step.restart(system, time_s, y);
        self.method.restart(system, &self.step);
    }

    /// Makes the next step, which ends at `limit_s` at the latest.
    ///
    /// # Errors
    /// [`UnresolvedStep`] if no step size resolves the equations.
    #[inline(always)] // into callers compiled for wider vectors
    pub fn advance<S: System>(
        &mut self,
        system: &mut S,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        self.step.begin();
        self.method.perform_step(system, &mut self.step, limit_s)
    }

    /// The last step. The system's last evaluation was at its end.
    pub fn step(&self) -> &StepState {
        &self.step
    }
}
