//! The loop over the steps.

use std::cell::Cell;

use super::guard::{Cause, Stop};
use super::outcome::Ending;
use super::run_tracker::RunTracker;
use super::watch::Made;
use crate::control::Control;
use crate::dynamics::{Contacts, InstructionSet, RightHandSide};
use crate::integrator::{self, CaseMethod, Integrator, System, UnresolvedStep};

/// Steps between two calls of `control`.
const ASK_EVERY: u64 = 1024;

/// A step of bearings by a method, compiled where the method is chosen: in this crate for a method of a case, so
/// that a crate with a simulation compiles no equations.
pub(super) type MakeStep<B, M> = fn(&mut B, &mut Integrator<M>, f64) -> Result<(), UnresolvedStep>;

thread_local! {
    static STEPS: Cell<u64> = const { Cell::new(0) };
}

/// Steps that the calling thread has made in all of its runs; bearings side by side count one by one.
pub fn steps_of_thread() -> u64 {
    STEPS.get()
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

impl Bearings for RightHandSide {
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

/// Advances bearings of one kind, method, step and duration side by side, until each has ended.
pub(super) fn drive(
    mut rhs: RightHandSide,
    trackers: &mut [RunTracker<'_, '_>],
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
    trackers: &mut [RunTracker<'_, '_>],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<f64> {
    let solver = &trackers[0].context.case.solver;
    let method = CaseMethod::new(solver.method, start.len(), solver.step_s, solver.tolerance);
    let mut integrator = Integrator::new(method, start.len());
    integrator.restart(bearings, 0.0, start);
    let duration_s = solver.duration_s;
    advance(
        &mut integrator,
        bearings,
        Bearings::advance,
        trackers,
        duration_s,
        control,
    );
    integrator.step().y1.to_vec()
}

/// Work of the equations so far.
pub(super) fn made(bearings: &impl Bearings) -> Made {
    Made {
        evaluations: bearings.evaluations(),
        instruction_set: bearings.instruction_set(),
    }
}

/// Advances bearings to `until_s`, or until each has ended.
pub(super) fn advance<B: Bearings, M: integrator::Method>(
    integrator: &mut Integrator<M>,
    rhs: &mut B,
    make_step: MakeStep<B, M>,
    trackers: &mut [RunTracker<'_, '_>],
    until_s: f64,
    control: &mut dyn FnMut(f64) -> Control,
) {
    let mut steps = 0;
    while trackers.iter().any(RunTracker::under_way) {
        if let Err(error) = make_step(rhs, integrator, until_s) {
            for tracker in trackers.iter_mut() {
                let stop = Stop::new(tracker.context.case, error.time_s, Cause::NotResolved);
                tracker.stop(stop, &integrator.step().y1);
            }
            break;
        }
        steps += 1;
        let step = integrator.step();
        rhs.look(&step.y1);
        for tracker in trackers.iter_mut().filter(|c| c.under_way()) {
            tracker.follow(step, |bearing| rhs.contacts_of(bearing), until_s);
        }
        if step.t1_s >= until_s {
            break;
        }
        if !rhs.independent() && !trackers.iter().all(RunTracker::under_way) {
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
    for tracker in trackers {
        tracker.made = made(rhs);
    }
}
