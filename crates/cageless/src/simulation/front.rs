//! A bearing in motion, stepped from a loop of one's own or run with observers.

use std::sync::Arc;

use super::guard::{Cause, Stop};
use super::observer::{Observer, RunContext, StepView};
use super::outcome::{Ending, RunOutcome};
use super::run::{Advance, advance, made};
use super::run_tracker::RunTracker;
use super::watch::Watch;
use crate::case::{Case, InnerRingDrive};
use crate::control::Control;
use crate::dynamics::Model;
use crate::dynamics::state::State;
use crate::dynamics::world::World;
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::initial_conditions::initial_state_controlled;
use crate::integrator::{CaseMethod, Integrator, Method, System};
use crate::limits::require;

/// A bearing in motion with its equations, its method and its guard.
///
/// ```
/// use cageless::prelude::*;
///
/// let mut simulation = Simulation::new(&reference::Structure::D.case())?;
/// while simulation.time_s() < 1e-3 {
///     simulation.step()?;
/// }
/// let most_n = simulation.view().balls().map(|ball| ball.outer_force_n());
/// assert!(most_n.fold(0.0, f64::max) > 400.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Simulation {
    case: Case,
    model: Arc<Model>,
    world: World,
    integrator: Box<dyn Advance + Send>,
    watch: Watch,
    stop: Option<Stop>,
}

impl Simulation {
    /// The bearing of `case` at its start, with the method of the case.
    ///
    /// # Errors
    /// The case is impossible, or its start has no equilibrium.
    pub fn new(case: &Case) -> Result<Self, EquilibriumError> {
        Self::controlled(case, &mut || Control::Continue(()))
    }

    /// [`Self::new`], with `control` called before every place of the ring that the search of the start tries.
    ///
    /// # Errors
    /// Those of [`Self::new`], or `control` ended the search.
    pub(crate) fn controlled(
        case: &Case,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Self, EquilibriumError> {
        let (state, angle_rad) = initial_state_controlled(case, control)?;
        Ok(Self::at(case, &state, &angle_rad)?)
    }

    /// The bearing of `case` in a given state at t = 0, with ψ of each ball in rad; its energy ledger begins there.
    ///
    /// # Errors
    /// The case is impossible.
    pub fn at(case: &Case, state: &State, angle_rad: &[f64]) -> Result<Self, InputError> {
        let model = Model::new(case)?;
        let start = state.clone().without_ledger();
        let mut world = World::of_bearing(&model);
        let (solver, dimension) = (&case.solver, world.dimension());
        let method = CaseMethod::new(solver.method, dimension, solver.step_s, solver.tolerance);
        let context = RunContext {
            case,
            model: &model,
            start: &start,
            start_angle_rad: angle_rad,
        };
        let watch = Watch::new(&context, world.layout(0), 0);
        let values = world.vector([&start]);
        let mut integrator = Integrator::new(method, dimension);
        world.begin(&values);
        integrator.restart(&mut world, 0.0, &values);
        Ok(Self {
            case: case.clone(),
            model,
            world,
            integrator: Box::new(integrator),
            watch,
            stop: None,
        })
    }

    /// The simulation, continued by a method of one's own.
    #[must_use]
    pub fn with_method(mut self, method: impl Method + Send + 'static) -> Self {
        let step = self.integrator.step();
        let (time_s, values) = (step.t1_s, step.y1.clone());
        let mut integrator = Integrator::new(method, values.len());
        integrator.restart(&mut self.world, time_s, &values);
        self.integrator = Box::new(integrator);
        self
    }

    /// The case, with the speed and load of the moment.
    pub fn case(&self) -> &Case {
        &self.case
    }

    /// Length of the vector that a method advances.
    pub fn dimension(&self) -> usize {
        self.world.dimension()
    }

    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.integrator.step().t1_s
    }

    /// Balls, ring, rotor and contacts at the end of the last step.
    pub fn view(&self) -> StepView<'_> {
        self.watch
            .view(self.integrator.step(), self.world.contacts_of(0))
    }

    /// Makes one step.
    ///
    /// # Errors
    /// The [`Stop`] of a state outside the physical range, from then on at every call.
    pub fn step(&mut self) -> Result<(), Stop> {
        self.step_until(f64::INFINITY)
    }

    /// Makes steps up to `time_s`, the last of which ends there.
    ///
    /// # Errors
    /// Those of [`Self::step`].
    pub fn advance_to(&mut self, time_s: f64) -> Result<(), Stop> {
        while self.time_s() < time_s {
            self.step_until(time_s)?;
        }
        // The last step was perhaps cut short.
        self.integrator.restart_here(&mut self.world);
        Ok(())
    }

    fn step_until(&mut self, limit_s: f64) -> Result<(), Stop> {
        if let Some(stop) = &self.stop {
            return Err(stop.clone());
        }
        let stop_at = |time_s| Stop::new(&self.case, time_s, Cause::NotResolved);
        let made = self.integrator.make_step(&mut self.world, limit_s);
        let looked = made.map_err(|error| stop_at(error.time_s)).and_then(|()| {
            let (step, world) = (self.integrator.step(), &self.world);
            let contacts_of = |bearing| world.contacts_of(bearing);
            self.watch.look(&self.case, step, &contacts_of, false)
        });
        self.stop = looked.clone().err();
        looked
    }

    /// Runs to `until_s` with these observers, from where the simulation is.
    pub fn run(&mut self, until_s: f64, observers: &mut [&mut dyn Observer]) -> RunOutcome {
        self.run_controlled(until_s, observers, &mut |_| Control::Continue(()))
    }

    /// [`Self::run`], with `control` called every thousand steps or so with the simulated time.
    pub fn run_controlled(
        &mut self,
        until_s: f64,
        observers: &mut [&mut dyn Observer],
        control: &mut dyn FnMut(f64) -> Control,
    ) -> RunOutcome {
        let start = self.state();
        let start_angle_rad = self.watch.angles_rad(self.integrator.step());
        let context = RunContext {
            case: &self.case,
            model: &self.model,
            start: &start,
            start_angle_rad: &start_angle_rad,
        };
        let mut tracker = RunTracker::new(context, &mut self.watch, observers);
        let alone = std::slice::from_mut(&mut tracker);
        advance(
            &mut *self.integrator,
            &mut self.world,
            alone,
            until_s,
            control,
        );
        let outcome = tracker.outcome();
        if let Ending::Stopped(stop) = &outcome.ending {
            self.stop = Some(stop.clone());
        }
        outcome
    }

    /// State at the end of the last step, with the energy ledger.
    pub fn state(&self) -> State {
        self.watch.state_in(&self.integrator.step().y1)
    }

    /// Outcome of the steps so far.
    pub fn outcome(&self) -> RunOutcome {
        let ending = match &self.stop {
            Some(stop) => Ending::Stopped(stop.clone()),
            None => Ending::Interrupted,
        };
        let made = made(&self.world, &self.integrator.step().y1, 0);
        self.watch.outcome(ending, self.state(), made)
    }

    /// Sets the speed of the inner ring from here on, rad/s, counter-clockwise.
    ///
    /// # Errors
    /// It is not finite, the ring turns freely below a rotor or has an unbalance, or its speed is given over time.
    pub fn set_inner_speed_rad_s(&mut self, speed_rad_s: f64) -> Result<(), InputError> {
        let operation = &self.case.operation;
        let constant = matches!(self.case.inner_ring_drive(), InnerRingDrive::Constant(_));
        let free = constant && operation.unbalance.amount_kg_m == 0.0;
        let rule =
            "finite, of a ring without rotor and unbalance whose speed is not given over time";
        let kept = free && speed_rad_s.is_finite();
        require("inner_speed_rad_s", speed_rad_s, kept, rule)?;
        self.case.operation.inner_speed_rad_s = speed_rad_s;
        self.apply_operation();
        Ok(())
    }

    /// Sets the radial load from here on, N, along −Y.
    ///
    /// # Errors
    /// It is not finite or negative, a rotor loads the ring, or the load is given over time.
    pub fn set_radial_load_n(&mut self, load_n: f64) -> Result<(), InputError> {
        let operation = &self.case.operation;
        let under_rotor = matches!(self.case.inner_ring_drive(), InnerRingDrive::Rotor(_));
        let free = !under_rotor && operation.radial_load_table.is_none();
        let rule = "0 or more, of a ring without a rotor whose load is not given over time";
        let kept = free && load_n.is_finite() && load_n >= 0.0;
        require("radial_load_n", load_n, kept, rule)?;
        self.case.operation.radial_load_n = load_n;
        self.apply_operation();
        Ok(())
    }

    /// Sets the torque of the drive of the rotor from here on, N·m, counter-clockwise.
    ///
    /// # Errors
    /// It is not finite, or there is no rotor.
    pub fn set_drive_torque_n_m(&mut self, torque_n_m: f64) -> Result<(), InputError> {
        let rule = "finite, of a case with a rotor";
        let rotor = self.case.rotor.as_mut().filter(|_| torque_n_m.is_finite());
        let Some(rotor) = rotor else {
            return Err(InputError::rule("drive_torque_n_m", torque_n_m, rule));
        };
        rotor.drive_torque_n_m = torque_n_m;
        self.world.set_drive_torque(torque_n_m);
        self.integrator.restart_here(&mut self.world);
        Ok(())
    }

    fn apply_operation(&mut self) {
        let operation = &self.case.operation;
        let (speed_rad_s, load_n) = (operation.inner_speed_rad_s, operation.radial_load_n);
        self.world.bearing_mut().set_operation(speed_rad_s, load_n);
        self.watch.interpolator().set_operation(speed_rad_s, load_n);
        self.watch.look_as_often_as(&self.case);
        // f has jumped: no history may reach across.
        self.integrator.restart_here(&mut self.world);
    }
}

/// Runs a case to its end. `control` is called every thousand steps or so with the simulated time, and with 0 while
/// the start is sought.
///
/// # Errors
/// The case is impossible, its start has no equilibrium, or `control` ended its search. Everything later is an
/// [`Ending`].
pub fn run(
    case: &Case,
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, EquilibriumError> {
    let mut simulation = Simulation::controlled(case, &mut || control(0.0))?;
    let outcome = simulation.run_controlled(case.solver.duration_s, observers, control);
    Ok(outcome.of_whole_run(case))
}
