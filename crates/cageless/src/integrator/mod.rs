//! Integration of ordinary differential equations. Nothing here knows of bearings.
//!
//! A method is one file: a struct that implements [`Method::perform_step`] on a [`StepState`]. One
//! that a case can name has a row of [`Properties`] ([`NamedMethod`]) and a line in the list at the
//! end of this file. [`Integrator`] owns the state of the step.
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

mod edges;
mod runge_kutta;
mod step_state;
pub mod tableau;

pub use runge_kutta::{AcceptedStep, RungeKutta, UnresolvedStep};
pub use step_state::StepState;
pub use velocity_verlet::{PlanarVelocities, SecondOrderBlock};

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

    /// Appends functions of a state, that of the last evaluation, each smooth and zero at an edge of
    /// f: where f jumps or is not smooth. Always the same in the same order, in scales in which 1 is
    /// as large as what is of interest; for methods that end their steps there.
    fn edges(&self, _y: &[f64], _values: &mut Vec<f64>) {}

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

/// Names, order, stability and automatic step of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Properties {
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

/// A method that a case can name.
pub trait NamedMethod: Method + Sized {
    /// Names, order, stability and automatic step.
    const PROPERTIES: Properties;

    /// The method for systems of this dimension, with steps of `step_s` or, under error control,
    /// at most that and errors per step up to `tolerance` in the system's [`System::error_norm`].
    fn of_case(dimension: usize, step_s: f64, tolerance: f64) -> Self;
}

/// Declares the list of methods that a case can name and what follows from it.
macro_rules! named_methods {
    ($(
        $(#[$meta:meta])*
        $module:ident: $method:ident,
    )*) => {
        $(mod $module;)*
        $(pub use $module::$method;)*

        /// Integration method of a case.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum IntegrationMethod {
            $($(#[$meta])* $method,)*
        }

        impl IntegrationMethod {
            /// Every name in files with its method.
            pub const NAMES: &'static [(&'static str, Self)] =
                &[$((<$method as NamedMethod>::PROPERTIES.name, Self::$method)),*];

            /// Names, order, stability and automatic step.
            pub fn properties(self) -> Properties {
                match self { $(Self::$method => <$method as NamedMethod>::PROPERTIES,)* }
            }
        }

        /// Evaluates an expression with the method of a case, whichever it is.
        macro_rules! with_method {
            ($chosen:expr, ($dimension:expr, $step_s:expr, $tolerance:expr), $name:ident => $body:expr) => {
                match $chosen {
                    $(crate::integrator::IntegrationMethod::$method => {
                        let $name = <crate::integrator::$method as crate::integrator::NamedMethod>::of_case(
                            $dimension, $step_s, $tolerance,
                        );
                        $body
                    })*
                }
            };
        }
        pub(crate) use with_method;
    };
}

named_methods! {
    /// Fourth-order Adams–Bashforth–Moulton, predict–evaluate–correct–evaluate.
    abm4: Abm4,
    /// Velocity Verlet (leapfrog): one evaluation per step, no artificial damping,
    /// unbiased statistics.
    velocity_verlet: VelocityVerlet,
    /// Order 8(5,3) with error control, for references.
    adaptive: Adaptive,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x″ = −ω²x − λx′.
    struct Oscillator {
        omega: f64,
        decay: f64,
    }

    impl System for Oscillator {
        fn dimension(&self) -> usize {
            2
        }
        fn derivative(&mut self, _time_s: f64, y: &[f64], dydt: &mut [f64]) {
            dydt[0] = y[1];
            dydt[1] = -self.omega * self.omega * y[0] - self.decay * y[1];
        }
        fn second_order_blocks(&self) -> &[SecondOrderBlock] {
            &[SecondOrderBlock {
                positions: 0,
                rates: 1,
                count: 1,
            }]
        }
    }

    /// The state after steps of size `h` from x = x′ = 1.
    fn after(method: IntegrationMethod, mut system: Oscillator, steps: u32, h: f64) -> [f64; 2] {
        with_method!(method, (2, h, 1e-9), method => {
            let mut integrator = Integrator::new(method, 2);
            integrator.restart(&mut system, 0.0, &[1.0, 1.0]);
            for _ in 0..steps {
                integrator.advance(&mut system, f64::INFINITY).unwrap();
            }
            [integrator.step().y1[0], integrator.step().y1[1]]
        })
    }

    fn of_fixed_step() -> impl Iterator<Item = (IntegrationMethod, Properties)> {
        let all = IntegrationMethod::NAMES.iter();
        let all = all.map(|(_, method)| (*method, method.properties()));
        all.filter(|(_, properties)| properties.oscillation_limit.is_finite())
    }

    #[test]
    fn methods_have_the_order_that_they_state() {
        let error = |method, steps| {
            let system = Oscillator {
                omega: 1.0,
                decay: 0.0,
            };
            let h = 2.0 / f64::from(steps);
            (after(method, system, steps, h)[0] - (2f64.cos() + 2f64.sin())).abs()
        };
        for (method, properties) in of_fixed_step() {
            let measured = (error(method, 80) / error(method, 160)).log2();
            let stated = f64::from(properties.order);
            assert!((measured - stated).abs() < 0.3, "{method:?}: {measured}");
        }
    }

    #[test]
    fn methods_are_stable_as_far_as_they_state() {
        for (method, properties) in of_fixed_step() {
            let largest = |omega, decay| {
                let end = after(method, Oscillator { omega, decay }, 600, 1.0);
                end[0].abs().max(end[1].abs())
            };
            let (oscillation, decay) = (properties.oscillation_limit, properties.decay_limit);
            assert!(largest(0.97 * oscillation, 0.0) < 1e3, "{method:?}");
            assert!(largest(1.1 * oscillation, 0.0) > 1e9, "{method:?}");
            assert!(largest(0.0, 0.97 * decay) < 1e3, "{method:?}");
            assert!(largest(0.0, 1.1 * decay) > 1e9, "{method:?}");
        }
    }
}
