//! Integration of ordinary differential equations. Nothing here knows of bearings.
//!
//! A method is one file: a struct that implements [`Method::perform_step`] on a [`StepState`]. One
//! that a case can name has a row of `Properties` (`NamedMethod`) and a line in the list at the
//! end of this file. The example `own_integrator` has a method of a user's own.
//!
//! ```
//! use cageless::integrator::Abm4;
//! use cageless::reference::Structure;
//! use cageless::simulation::Simulation;
//!
//! let simulation = Simulation::new(&Structure::D.case())?;
//! let method = Abm4::new(simulation.dimension(), 0.2e-6);
//! let mut simulation = simulation.with_method(method);
//! simulation.advance_to(1e-5)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod edges;
mod method;
pub(crate) mod runge_kutta;
mod step_state;
mod system;
pub(crate) mod tableau;

pub use method::Method;
pub(crate) use method::Properties;

pub use crate::numerics::aligned::Aligned;
pub(crate) use method::NamedMethod;
pub use runge_kutta::UnresolvedStep;
pub use step_state::StepState;
pub use system::{SecondOrderBlock, System};

/// A method with the step that it last made.
#[derive(Debug, Clone)]
pub(crate) struct Integrator<M> {
    method: M,
    step: StepState,
}

impl<M: Method> Integrator<M> {
    /// Integrates systems of this dimension by `method`.
    pub(crate) fn new(method: M, dimension: usize) -> Self {
        Self {
            method,
            step: StepState::new(dimension),
        }
    }

    /// Forgets all history and starts at `y`.
    pub(crate) fn restart<S: System>(&mut self, system: &mut S, time_s: f64, y: &[f64]) {
        self.step.restart(system, time_s, y);
        self.method.restart(system, &self.step);
    }

    /// Makes the next step, which ends at `limit_s` at the latest.
    ///
    /// # Errors
    /// [`UnresolvedStep`] if no step size resolves the equations.
    #[inline(always)] // into callers compiled for wider vectors
    pub(crate) fn advance<S: System>(
        &mut self,
        system: &mut S,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        self.step.begin();
        self.method.perform_step(system, &mut self.step, limit_s)
    }

    /// Forgets all history at the end of the last step, where f or the size of the steps changes.
    pub(crate) fn restart_here<S: System>(&mut self, system: &mut S) {
        let end = self.step.y1.clone();
        self.restart(system, self.step.t1_s, &end);
    }

    /// The last step. The system's last evaluation was at its end.
    pub(crate) fn step(&self) -> &StepState {
        &self.step
    }
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

            /// Name in files.
            pub fn name(self) -> &'static str {
                self.properties().name
            }

            /// Name below figures.
            pub fn label(self) -> &'static str {
                self.properties().label
            }

            /// Names, order, stability and automatic step.
            pub(crate) fn properties(self) -> Properties {
                match self { $(Self::$method => <$method as NamedMethod>::PROPERTIES,)* }
            }
        }

        /// The method of a case with its history.
        #[derive(Debug, Clone)]
        #[allow(clippy::large_enum_variant)] // one per simulation
        pub(crate) enum CaseMethod {
            $(#[doc = concat!("[`", stringify!($method), "`].")] $method($method),)*
        }

        impl CaseMethod {
            /// The method for systems of this dimension, with steps of `step_s` or, under error control, at most that
            /// and errors per step up to `tolerance`.
            pub(crate) fn new(method: IntegrationMethod, dimension: usize, step_s: f64, tolerance: f64) -> Self {
                match method {
                    $(IntegrationMethod::$method => {
                        Self::$method($method::of_case(dimension, step_s, tolerance))
                    })*
                }
            }
        }

        impl Method for CaseMethod {
            fn restart<S: System>(&mut self, system: &mut S, step: &StepState) {
                match self { $(Self::$method(method) => method.restart(system, step),)* }
            }

            #[inline(always)] // into callers compiled for wider vectors
            fn perform_step<S: System>(
                &mut self,
                system: &mut S,
                step: &mut StepState,
                limit_s: f64,
            ) -> Result<(), UnresolvedStep> {
                match self { $(Self::$method(method) => method.perform_step(system, step, limit_s),)* }
            }
        }
    };
}

named_methods! {
    /// Fourth-order Adams–Bashforth–Moulton, predict–evaluate–correct–evaluate.
    abm4: Abm4,
    /// Velocity Verlet: one evaluation per step, no artificial damping,
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
        let mut integrator = Integrator::new(CaseMethod::new(method, 2, h, 1e-9), 2);
        integrator.restart(&mut system, 0.0, &[1.0, 1.0]);
        for _ in 0..steps {
            integrator.advance(&mut system, f64::INFINITY).unwrap();
        }
        [integrator.step().y1[0], integrator.step().y1[1]]
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
