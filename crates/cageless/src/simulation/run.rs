//! The loop over the steps.

use std::cell::Cell;

use super::guard::{Cause, Stop};
use super::outcome::Ending;
use super::run_tracker::RunTracker;
use super::watch::Made;
use crate::control::Control;
use crate::dynamics::world::World;
use crate::integrator::{CaseMethod, Integrator, Method, UnresolvedStep};

/// Steps between two calls of `control`.
const ASK_EVERY: u64 = 1024;

/// A step of bearings by a method, compiled where the method is chosen: in this crate for a method of a case, so
/// that a crate with a simulation compiles no equations.
pub(super) type MakeStep<M> = fn(&mut World, &mut Integrator<M>, f64) -> Result<(), UnresolvedStep>;

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
    advance(
        &mut integrator,
        world,
        World::advance,
        trackers,
        solver.duration_s,
        control,
    );
}

/// Work of the equations so far, and the balance of the rotor in bearing `k` in a state.
pub(super) fn made(world: &World, y: &[f64], k: usize) -> Made {
    Made {
        evaluations: world.evaluations(),
        instruction_set: world.instruction_set(),
        rotor_balance: world.rotor_balance(y, k),
    }
}

/// Advances bearings to `until_s`, or until each has ended.
pub(super) fn advance<M: Method>(
    integrator: &mut Integrator<M>,
    world: &mut World,
    make_step: MakeStep<M>,
    trackers: &mut [RunTracker<'_, '_>],
    until_s: f64,
    control: &mut dyn FnMut(f64) -> Control,
) {
    let mut steps = 0;
    while trackers.iter().any(RunTracker::under_way) {
        if let Err(error) = make_step(world, integrator, until_s) {
            for tracker in trackers.iter_mut() {
                let stop = Stop::new(tracker.context.case, error.time_s, Cause::NotResolved);
                tracker.stop(stop, &integrator.step().y1);
            }
            break;
        }
        steps += 1;
        let step = integrator.step();
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
