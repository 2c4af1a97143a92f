//! Methods of integration.

use super::runge_kutta::UnresolvedStep;
use super::step_state::StepState;
use super::system::System;

/// Names, order, stability and automatic step of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Properties {
    /// Name in files.
    pub name: &'static str,
    /// Name below figures.
    pub label: &'static str,
    /// Order of convergence on smooth problems.
    pub order: u32,
    /// Largest ωh on y″ = −ω²y that does not grow violently; infinite under error control.
    pub oscillation_limit: f64,
    /// Largest λh on y′ = −λy; infinite under error control.
    pub decay_limit: f64,
    /// Whether the stiff part of f enters implicitly ([`System::add_stiff_part`]).
    pub solves_stiff_part: bool,
    /// Whether systems side by side may share its steps: they have one size, and no step depends
    /// on those before.
    pub side_by_side: bool,
    /// ωh of the automatic step, without damping and with it.
    pub automatic_oscillation: [f64; 2],
    /// Largest λh of the automatic step; infinite under error control.
    pub automatic_decay: f64,
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

/// A method that a case can name.
pub(crate) trait NamedMethod: Method + Sized {
    /// Names, order, stability and automatic step.
    const PROPERTIES: Properties;

    /// The method for systems of this dimension, with steps of `step_s` or, under error control,
    /// at most that and errors per step up to `tolerance` in the system's [`System::error_norm`].
    fn of_case(dimension: usize, step_s: f64, tolerance: f64) -> Self;
}
