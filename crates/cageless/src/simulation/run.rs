//! The loop over the steps.

use std::cell::Cell;

use super::guard::Cause;
use super::outcome::Ending;
use super::run_tracker::RunTracker;
use super::watch::Made;
use crate::control::Control;
use crate::dynamics::world::World;
use crate::integrator::{CaseMethod, Integrator, Method, StepState, UnresolvedStep};

/// Steps between two calls of `control`.
const ASK_EVERY: u64 = 1024;

/// A method that advances bearings, with the step that it last made: compiled where the method is chosen, in this
/// crate for a method of a case.
pub(super) trait Advance {
    /// Makes the next step, which ends at `limit_s` at the latest.
    fn make_step(&mut self, world: &mut World, limit_s: f64) -> Result<(), UnresolvedStep>;

    /// Forgets all history at the end of the last step, where f or the size of the steps changes.
    fn restart_here(&mut self, world: &mut World);

    /// The last step.
    fn step(&self) -> &StepState;
}

impl<M: Method> Advance for Integrator<M> {
    fn make_step(&mut self, world: &mut World, limit_s: f64) -> Result<(), UnresolvedStep> {
        world.advance(self, limit_s)
    }

    fn restart_here(&mut self, world: &mut World) {
        Integrator::restart_here(self, world);
    }

    fn step(&self) -> &StepState {
        Integrator::step(self)
    }
}

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// Steps that the calling thread has made in all of its runs; bearings side by side count one by one.
pub fn steps_of_thread() -> u64 {
    STEPS.get()
}

/// Advances the bearings of a world from a state of all of them until each has ended.
pub(super) fn drive(
    start: &[f64],
    world: &mut World,
    trackers: &mut [RunTracker<'_, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) {
    let solver = &trackers[0].context.case.solver;
    let method = CaseMethod::new(solver.method, start.len(), solver.step_s, solver.tolerance);
    let mut integrator = Integrator::new(method, start.len());
    world.begin(start);
    integrator.restart(world, 0.0, start);
    advance(&mut integrator, world, trackers, solver.duration_s, control);
}

/// Work of the equations so far, and the balance of the rotor in bearing `k` in a state.
pub(super) fn made(world: &World, y: &[f64], k: usize) -> Made {
    Made {
        evaluations: world.evaluations(),
        instruction_set: world.instruction_set(),
        rotor_balance: world.rotor_balance(y, k),
    }
}

/// Passes a step that goes on and ends at its limit at the latest.
#[inline]
pub(super) fn check_forward(step: &StepState, limit_s: f64) -> Result<(), Cause> {
    match step.t1_s > step.t0_s && step.t1_s <= limit_s {
        true => Ok(()),
        false => Err(Cause::NotForward {
            end_s: step.t1_s,
            limit_s,
        }),
    }
}

/// Advances bearings to `until_s`, or until each has ended.
pub(super) fn advance(
    integrator: &mut dyn Advance,
    world: &mut World,
    trackers: &mut [RunTracker<'_, '_>],
    until_s: f64,
    control: &mut dyn FnMut(f64) -> Control,
) {
    let mut steps = 0;
    while trackers.iter().any(RunTracker::under_way) {
        if let Err(error) = integrator.make_step(world, until_s) {
            for tracker in trackers.iter_mut() {
                tracker.stop_unresolved(error.time_s, &integrator.step().y1);
            }
            break;
        }
        steps += 1;
        let step = integrator.step();
        if let Err(cause) = check_forward(step, until_s) {
            for tracker in trackers.iter_mut() {
                tracker.stop_for(cause.clone(), step);
            }
            break;
        }
        world.look(&step.y1);
        for tracker in trackers.iter_mut().filter(|c| c.under_way()) {
            tracker.follow(step, |bearing| world.contacts_of(bearing), until_s);
        }
        if step.t1_s >= until_s {
            break;
        }
        if !world.independent() && !trackers.iter().all(RunTracker::under_way) {
            for tracker in trackers.iter_mut() {
                tracker.end(Ending::Interrupted, &step.y1);
            }
        }
        if steps % ASK_EVERY == 0 && control(step.t1_s).is_break() {
            for tracker in trackers.iter_mut() {
                tracker.end(Ending::Interrupted, &step.y1);
            }
        }
    }
    STEPS.set(STEPS.get() + steps * trackers.len() as u64);
    for (k, tracker) in trackers.iter_mut().enumerate() {
        tracker.made = made(world, &integrator.step().y1, k);
    }
}
