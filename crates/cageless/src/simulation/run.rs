//! The loop over the steps.

use std::cell::Cell;

use super::guard::{Cause, Stop};
use super::observer::{Observer, RunContext};
use super::outcome::{Ending, RunOutcome};
use super::run_tracker::RunTracker;
use crate::case::Case;
use crate::control::Control;
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, InstructionSet, Model, RightHandSide};
use crate::equilibrium::EquilibriumError;
use crate::error::InputError;
use crate::initial_conditions::initial_state_controlled;
use crate::integrator::{self, Integrator, System, UnresolvedStep, with_method};

/// Steps between two calls of `control`.
const ASK_EVERY: u64 = 1024;

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// Steps that the calling thread has made in all of its runs; bearings side by side count one by one.
pub fn steps_of_thread() -> u64 {
    STEPS.get()
}

/// Runs a case. `control` is called every thousand steps or so with the simulated time, and with 0 while the
/// start is sought.
///
/// # Errors
/// The case is impossible, its start has no equilibrium, or `control` ended its search. Everything later is an
/// [`Ending`].
pub fn run(
    case: &Case,
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, EquilibriumError> {
    let (state, angles) = initial_state_controlled(case, &mut || control(0.0))?;
    Ok(run_from(case, &state, &angles, observers, control)?.of_whole_run(case))
}

/// Runs a case from a given state and ψ of its balls.
///
/// # Errors
/// The case is impossible.
pub fn run_from(
    case: &Case,
    start: &State,
    start_angle_rad: &[f64],
    observers: &mut [&mut dyn Observer],
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<RunOutcome, InputError> {
    let model = Model::new(case)?;
    let rhs = RightHandSide::new(&model);
    let context = RunContext {
        case,
        model: &model,
        start,
        start_angle_rad,
    };
    let mut tracker = RunTracker::new(context, rhs.layout(), observers);
    drive(rhs, std::slice::from_mut(&mut tracker), control);
    Ok(tracker.outcome())
}

/// Equations of motion of bearings that are advanced together.
pub(super) trait Bearings: System {
    /// Whether none of them acts on another, so that each may end at a time of its own.
    fn independent(&self) -> bool {
        true
    }

    /// Contacts of one bearing as of the last evaluation.
    fn contacts_of(&self, bearing: usize) -> Contacts<'_>;

    /// Evaluations so far.
    fn evaluations(&self) -> u64;

    /// Takes the state at the end of a step.
    fn look(&mut self, _y: &[f64]) {}

    /// Instructions in use.
    fn instruction_set(&self) -> InstructionSet;

    /// Lets `integrator` make a step.
    ///
    /// # Errors
    /// Those of the method.
    fn advance<M: integrator::Method>(
        &mut self,
        integrator: &mut Integrator<M>,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep>
    where
        Self: Sized,
    {
        integrator.advance(self, limit_s)
    }
}

impl Bearings for RightHandSide<'_> {
    fn contacts_of(&self, bearing: usize) -> Contacts<'_> {
        self.contacts_of(bearing)
    }

    fn evaluations(&self) -> u64 {
        self.evaluations()
    }

    fn instruction_set(&self) -> InstructionSet {
        self.instruction_set()
    }

    fn advance<M: integrator::Method>(
        &mut self,
        integrator: &mut Integrator<M>,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        self.advance(integrator, limit_s)
    }
}

/// Advances bearings of one kind, method, step and duration, alone or side by side, until each has
/// ended.
pub(super) fn drive<'m>(
    mut rhs: RightHandSide<'m>,
    trackers: &mut [RunTracker<'_, 'm, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) {
    let mut start = vec![0.0; rhs.layout().len()];
    rhs.layout().spread_padding(&mut start);
    for bearing in 0..rhs.layout().width() {
        // Lanes without a bearing of their own repeat the last.
        let tracker = &trackers[bearing.min(trackers.len() - 1)];
        let places = rhs.layout().of_bearing(bearing);
        tracker.context.start.write_to(places, &mut start);
    }
    drive_from(&start, &mut rhs, trackers, control);
}

/// Advances bearings from a state of all of them until each has ended; returns the last state.
pub(super) fn drive_from(
    start: &[f64],
    bearings: &mut impl Bearings,
    trackers: &mut [RunTracker<'_, '_, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<f64> {
    let solver = &trackers[0].context.case.solver;
    let dimension = start.len();
    with_method!(solver.method, (dimension, solver.step_s, solver.tolerance), method => {
        advance(method, bearings, start, trackers, control)
    })
}

fn advance(
    method: impl integrator::Method,
    rhs: &mut impl Bearings,
    start: &[f64],
    trackers: &mut [RunTracker<'_, '_, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<f64> {
    let mut integrator = Integrator::new(method, start.len());
    integrator.restart(rhs, 0.0, start);
    let duration = trackers[0].context.case.solver.duration_s;
    let mut steps = 0;
    while trackers.iter().any(RunTracker::under_way) {
        if let Err(error) = rhs.advance(&mut integrator, duration) {
            for tracker in trackers.iter_mut() {
                let stop = Stop::new(tracker.context.case, error.time_s, Cause::NotResolved);
                tracker.end(Ending::Stopped(stop), &integrator.step().y1);
            }
            break;
        }
        steps += 1;
        let step = integrator.step();
        rhs.look(&step.y1);
        for tracker in trackers.iter_mut().filter(|c| c.under_way()) {
            tracker.follow(step, |bearing| rhs.contacts_of(bearing), steps, duration);
        }
        if step.t1_s >= duration {
            break;
        }
        if !rhs.independent() && !trackers.iter().all(RunTracker::under_way) {
            for tracker in trackers.iter_mut() {
                tracker.end(Ending::Interrupted, &step.y1);
            }
        }
        if steps.is_multiple_of(ASK_EVERY) && control(step.t1_s).is_break() {
            for tracker in trackers.iter_mut() {
                tracker.end(Ending::Interrupted, &step.y1);
            }
        }
    }
    STEPS.set(STEPS.get() + steps * trackers.len() as u64);
    for tracker in trackers {
        tracker.rhs_evaluations = rhs.evaluations();
        tracker.instruction_set = rhs.instruction_set();
    }
    integrator.step().y1.to_vec()
}
