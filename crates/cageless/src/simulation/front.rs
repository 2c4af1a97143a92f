//! A bearing in motion, stepped from a loop of one's own or run with observers.

use std::sync::Arc;

use super::guard::{Cause, Stop};
use super::observer::{Observer, RunContext, StepView};
use super::outcome::{Ending, RunOutcome};
use super::run::{Advance, advance, check_forward, made};
use super::run_tracker::RunTracker;
use super::watch::Watch;
use crate::case::{Case, InnerRingDrive, Operation};
use crate::control::Control;
use crate::dynamics::Model;
use crate::dynamics::state::State;
use crate::dynamics::world::World;
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::initial_conditions::initial_state_controlled;
use crate::integrator::{CaseMethod, Integrator, Method, System};
use crate::limits::{finite, require};

/// Difference of two times, as a fraction of them, that is rounding.
const ROUNDING: f64 = 1e-12;

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

    /// The bearing of `case` in a given state at t = 0, with ψ of each ball in rad. Its energy ledger goes on with
    /// what the state has; see [`State::without_ledger`].
    ///
    /// # Errors
    /// The case is impossible.
    pub fn at(case: &Case, state: &State, angle_rad: &[f64]) -> Result<Self, InputError> {
        let model = Model::new(case)?;
        let mut world = World::of_bearing(&model);
        let (solver, dimension) = (&case.solver, world.dimension());
        let method = CaseMethod::new(solver.method, dimension, solver.step_s, solver.tolerance);
        let context = RunContext {
            case,
            model: &model,
            start: state,
            start_angle_rad: angle_rad,
        };
        let watch = Watch::new(&context, world.layout(0), 0);
        let values = world.vector([state]);
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
    /// Those of [`Self::step`]; or the time is no number or lies before [`Self::time_s`], which ends nothing.
    pub fn advance_to(&mut self, time_s: f64) -> Result<(), Stop> {
        self.check_ahead(time_s)?;
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
        let made = self.integrator.make_step(&mut self.world, limit_s);
        let unresolved = |time_s| self.watch.stop_unresolved(&self.case, time_s);
        let made = made.map_err(|error| unresolved(error.time_s));
        let looked = made.and_then(|()| {
            let (step, world) = (self.integrator.step(), &self.world);
            check_forward(step, limit_s)
                .map_err(|cause| self.watch.stop(&self.case, step.t0_s, cause))?;
            let contacts_of = |bearing| world.contacts_of(bearing);
            self.watch.look(&self.case, step, &contacts_of, false)
        });
        self.stop = looked.clone().err();
        looked
    }

    /// Passes a time that does not lie before that of the simulation but for rounding.
    fn check_ahead(&self, time_s: f64) -> Result<(), Stop> {
        let now_s = self.time_s();
        match time_s >= now_s * (1.0 - ROUNDING) {
            true => Ok(()),
            false => Err(Stop::new(&self.case, now_s, Cause::TimeNotAhead(time_s))),
        }
    }

    /// Runs to `until_s` with these observers, from where the simulation is. A time that is no number or lies before
    /// [`Self::time_s`] stops the run at once, and not the simulation.
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
        let stopped = self.stop.clone().or(self.check_ahead(until_s).err());
        if let Some(stop) = stopped {
            return self.ended(Ending::Stopped(stop));
        }
        if until_s <= self.time_s() {
            return self.ended(Ending::Complete);
        }
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
        self.ended(ending)
    }

    /// Outcome of the steps so far with this ending.
    fn ended(&self, ending: Ending) -> RunOutcome {
        let made = made(&self.world, &self.integrator.step().y1, 0);
        self.watch.outcome(ending, self.state(), made)
    }

    /// Sets the speed of the inner ring from here on, rad/s, counter-clockwise; 0 brakes it to a stand.
    ///
    /// The step stays that of the start: a case whose speed rises is built for the largest one, or has its
    /// [`step_s`](crate::CaseBuilder::step_s).
    ///
    /// # Errors
    /// It is not one that a case may have, and not 0; the ring turns freely below a rotor or has an unbalance, or its
    /// speed is given over time.
    pub fn set_inner_speed_rad_s(&mut self, speed_rad_s: f64) -> Result<(), InputError> {
        let operation = &self.case.operation;
        let constant = matches!(self.case.inner_ring_drive(), InnerRingDrive::Constant(_));
        let free = constant && operation.unbalance.amount_kg_m == 0.0;
        let rule = "left as it is: a rotor, an unbalance or a table over time goes with it";
        require("inner_speed_rad_s", speed_rad_s, free, rule)?;
        let mut operation = operation.clone();
        operation.inner_speed_rad_s = speed_rad_s;
        self.operate(operation)
    }

    /// Sets the radial load from here on, N, along −Y.
    ///
    /// The step stays that of the start: a case whose load rises is built for the largest one, or has its
    /// [`step_s`](crate::CaseBuilder::step_s).
    ///
    /// # Errors
    /// It is not one that a case may have, a rotor loads the ring, or the load is given over time.
    pub fn set_radial_load_n(&mut self, load_n: f64) -> Result<(), InputError> {
        let operation = &self.case.operation;
        let under_rotor = matches!(self.case.inner_ring_drive(), InnerRingDrive::Rotor(_));
        let free = !under_rotor && operation.radial_load_table.is_none();
        let rule = "left as it is: a rotor or a table over time loads the ring";
        require("radial_load_n", load_n, free, rule)?;
        let mut operation = operation.clone();
        operation.radial_load_n = load_n;
        self.operate(operation)
    }

    /// Sets the torque of the drive of the rotor from here on, N·m, counter-clockwise.
    ///
    /// # Errors
    /// It is not one that a rotor may have, or there is no rotor.
    pub fn set_drive_torque_n_m(&mut self, torque_n_m: f64) -> Result<(), InputError> {
        let field = "drive_torque_n_m";
        finite(field, torque_n_m)?;
        let Some(rotor) = self.case.rotor.as_mut() else {
            let rule = "left out: the case has no rotor";
            return Err(InputError::rule(field, torque_n_m, rule));
        };
        rotor.drive_torque_n_m = torque_n_m;
        self.world.set_drive_torque(torque_n_m);
        self.integrator.restart_here(&mut self.world);
        Ok(())
    }

    /// Goes on with another speed or load, or as before if the case cannot have it.
    fn operate(&mut self, operation: Operation) -> Result<(), InputError> {
        let before = std::mem::replace(&mut self.case.operation, operation);
        if let Err(error) = self.case.check_operation() {
            self.case.operation = before;
            return Err(error);
        }
        let operation = &self.case.operation;
        let (speed_rad_s, load_n) = (operation.inner_speed_rad_s, operation.radial_load_n);
        self.world.bearing_mut().set_operation(speed_rad_s, load_n);
        self.watch.interpolator().set_operation(speed_rad_s, load_n);
        self.watch.look_as_often_as(&self.case);
        // f has jumped: no history may reach across.
        self.integrator.restart_here(&mut self.world);
        Ok(())
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
