//! A bearing in motion, stepped from a loop of one's own or run with observers.

use std::sync::Arc;

use super::drop_outcome::RotorDropOutcome;
use super::guard::{Cause, Stop};
use super::observer::{Observer, RunContext, StepView};
use super::outcome::{Ending, RunOutcome};
use super::run::{Advance, advance, check_forward, made};
use super::run_tracker::RunTracker;
use super::watch::Watch;
use crate::case::{Case, InnerRingDrive, Operation};
use crate::control::Control;
use crate::dynamics::Model;
use crate::dynamics::plane_path::PlaneDisplacement;
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
    /// The only bearing, or those below one rotor.
    bearings: Vec<Watched>,
    world: World,
    integrator: Box<dyn Advance + Send>,
}

/// A bearing in motion, and what watches over it.
struct Watched {
    case: Case,
    model: Arc<Model>,
    watch: Watch,
    stop: Option<Stop>,
}

impl Watched {
    /// Outcome of the steps so far with this ending, in a vector of the states of all bearings.
    fn ended(&self, ending: Ending, world: &World, values: &[f64]) -> RunOutcome {
        let made = made(world, values, self.watch.bearing());
        let state = self.watch.state_in(values);
        self.watch.outcome(ending, state, made)
    }
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
        let world = World::of_bearing(&model);
        let values = world.vector([state]);
        let context = RunContext {
            case,
            model: &model,
            start: state,
            start_angle_rad: angle_rad,
        };
        Ok(Self::of_world(world, &values, &[context]))
    }

    /// The bearings of a world in the state `values` of all of them, with the method of the first.
    pub(super) fn of_world(mut world: World, values: &[f64], contexts: &[RunContext<'_>]) -> Self {
        let (solver, dimension) = (&contexts[0].case.solver, values.len());
        let method = CaseMethod::new(solver.method, dimension, solver.step_s, solver.tolerance);
        let watched = |(k, context): (usize, &RunContext<'_>)| Watched {
            case: context.case.clone(),
            model: Arc::clone(context.model),
            watch: Watch::new(context, world.layout(k), k),
            stop: None,
        };
        let bearings = contexts.iter().enumerate().map(watched).collect();
        let mut integrator = Integrator::new(method, dimension);
        world.begin(values);
        integrator.restart(&mut world, 0.0, values);
        Self {
            bearings,
            world,
            integrator: Box::new(integrator),
        }
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

    /// The case, with the speed and load of the moment; of several bearings that of the first.
    pub fn case(&self) -> &Case {
        &self.bearings[0].case
    }

    /// Length of the vector that a method advances.
    pub fn dimension(&self) -> usize {
        self.world.dimension()
    }

    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.integrator.step().t1_s
    }

    /// Balls, ring, rotor and contacts at the end of the last step; of several bearings those of the first.
    pub fn view(&self) -> StepView<'_> {
        self.view_of(&self.bearings[0])
    }

    /// [`Self::view`] of each bearing, in the order of the journals: one, or those of a
    /// [`RotorDrop`](super::RotorDrop).
    pub fn views(&self) -> impl Iterator<Item = StepView<'_>> {
        self.bearings.iter().map(|bearing| self.view_of(bearing))
    }

    fn view_of<'a>(&'a self, bearing: &'a Watched) -> StepView<'a> {
        let watch = &bearing.watch;
        watch.view(
            self.integrator.step(),
            self.world.contacts_of(watch.bearing()),
        )
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
        self.check_under_way()?;
        let made = self.integrator.make_step(&mut self.world, limit_s);
        let step = self.integrator.step();
        let forward = check_forward(step, limit_s);
        if made.is_ok() && forward.is_ok() {
            self.world.look(&step.y1);
        }
        let world = &self.world;
        for bearing in &mut self.bearings {
            let (case, watch) = (&bearing.case, &mut bearing.watch);
            let looked = match (&made, &forward) {
                (Err(error), _) => Err(watch.stop_unresolved(case, error.time_s)),
                (_, Err(cause)) => Err(watch.stop(case, step.t0_s, cause.clone())),
                _ => watch.look(case, step, &|k| world.contacts_of(k), false),
            };
            bearing.stop = looked.err();
        }
        self.check_under_way()
    }

    /// Passes where no bearing has stopped: one that stops ends the motion of all.
    fn check_under_way(&self) -> Result<(), Stop> {
        let stop = self.bearings.iter().find_map(|own| own.stop.clone());
        stop.map_or(Ok(()), Err)
    }

    /// Passes a time that does not lie before that of the simulation but for rounding.
    fn check_ahead(&self, time_s: f64) -> Result<(), Stop> {
        let now_s = self.time_s();
        match time_s >= now_s * (1.0 - ROUNDING) {
            true => Ok(()),
            false => Err(Stop::new(self.case(), now_s, Cause::TimeNotAhead(time_s))),
        }
    }

    /// Runs to `until_s` with these observers, of several bearings on the first, from where the simulation is. A time
    /// that is no number or lies before [`Self::time_s`] stops the run at once, and not the simulation.
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
        let outcomes = self.run_watched(until_s, std::iter::once(observers), control);
        (outcomes.into_iter().next()).expect("a bearing")
    }

    /// [`Self::run_controlled`] with observers of each bearing, of those that are missing with none.
    pub(super) fn run_watched<'s: 'o, 'o>(
        &mut self,
        until_s: f64,
        observers: impl IntoIterator<Item = &'o mut [&'s mut dyn Observer]>,
        control: &mut dyn FnMut(f64) -> Control,
    ) -> Vec<RunOutcome> {
        let stopped = self
            .check_under_way()
            .and_then(|()| self.check_ahead(until_s));
        if let Err(stop) = stopped {
            return self.ended(|| Ending::Stopped(stop.clone()));
        }
        if until_s <= self.time_s() {
            return self.ended(|| Ending::Complete);
        }
        let step = self.integrator.step();
        let states = self.bearings.iter().map(|own| own.watch.state_in(&step.y1));
        let angles_rad = self.bearings.iter().map(|own| own.watch.angles_rad(step));
        let starts: Vec<(State, Vec<f64>)> = states.zip(angles_rad).collect();
        let mut observers = observers.into_iter();
        let tracked = self.bearings.iter_mut().zip(&starts);
        let mut trackers: Vec<RunTracker<'_, '_>> = tracked
            .map(|(own, (start, start_angle_rad))| {
                let context = RunContext {
                    case: &own.case,
                    model: &own.model,
                    start,
                    start_angle_rad,
                };
                let observers = observers.next().unwrap_or(&mut []);
                RunTracker::new(context, &mut own.watch, observers)
            })
            .collect();
        let integrator = &mut *self.integrator;
        advance(integrator, &mut self.world, &mut trackers, until_s, control);
        let outcomes: Vec<RunOutcome> = trackers.into_iter().map(RunTracker::outcome).collect();
        for (bearing, outcome) in self.bearings.iter_mut().zip(&outcomes) {
            if let Ending::Stopped(stop) = &outcome.ending {
                bearing.stop = Some(stop.clone());
            }
        }
        outcomes
    }

    /// State at the end of the last step, with the energy ledger; of several bearings that of the first.
    pub fn state(&self) -> State {
        let watch = &self.bearings[0].watch;
        watch.state_in(&self.integrator.step().y1)
    }

    /// Outcome of the steps so far; of several bearings that of the first.
    pub fn outcome(&self) -> RunOutcome {
        self.drop_outcome().bearings.swap_remove(0)
    }

    /// Outcome of the steps so far of each bearing, and of the rotor.
    pub fn drop_outcome(&self) -> RotorDropOutcome {
        let values = &self.integrator.step().y1;
        let ended = |own: &Watched| {
            let ending = own
                .stop
                .clone()
                .map_or(Ending::Interrupted, Ending::Stopped);
            own.ended(ending, &self.world, values)
        };
        let bearings = self.bearings.iter().map(ended).collect();
        RotorDropOutcome::new(bearings, self.world.planes())
    }

    /// Outcomes of the steps so far with this ending.
    fn ended(&self, ending: impl Fn() -> Ending) -> Vec<RunOutcome> {
        let values = &self.integrator.step().y1;
        let ended = |own: &Watched| own.ended(ending(), &self.world, values);
        self.bearings.iter().map(ended).collect()
    }

    /// Planes of the rotor with their largest displacements so far.
    pub(super) fn planes(&self) -> Vec<PlaneDisplacement> {
        self.world.planes()
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
        let operation = &self.case().operation;
        let constant = matches!(self.case().inner_ring_drive(), InnerRingDrive::Constant(_));
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
        let operation = &self.case().operation;
        let under_rotor = matches!(self.case().inner_ring_drive(), InnerRingDrive::Rotor(_));
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
        if self.case().rotor.is_none() {
            let rule = "left out: the case has no rotor";
            return Err(InputError::rule(field, torque_n_m, rule));
        }
        let rotors = self
            .bearings
            .iter_mut()
            .filter_map(|own| own.case.rotor.as_mut());
        rotors.for_each(|rotor| rotor.drive_torque_n_m = torque_n_m);
        self.world.set_drive_torque(torque_n_m);
        self.integrator.restart_here(&mut self.world);
        Ok(())
    }

    /// Goes on with another speed or load, or as before if the case cannot have it.
    fn operate(&mut self, operation: Operation) -> Result<(), InputError> {
        // Bearings below a rotor have neither of their own: this is the only one.
        let Watched { case, watch, .. } = &mut self.bearings[0];
        let before = std::mem::replace(&mut case.operation, operation);
        if let Err(error) = case.check_operation() {
            case.operation = before;
            return Err(error);
        }
        let (speed_rad_s, load_n) = (
            case.operation.inner_speed_rad_s,
            case.operation.radial_load_n,
        );
        self.world.bearing_mut().set_operation(speed_rad_s, load_n);
        watch.interpolator().set_operation(speed_rad_s, load_n);
        watch.look_as_often_as(case);
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
