//! Drops of which the results alone are kept.

use cageless::Case;
use cageless::equilibrium::EquilibriumError;
use cageless::numerics::BATCH_WIDTH;
use cageless::simulation::{Control, Ending, Observer, RotorDrop, RotorDropOutcome};
use cageless::touchdown::DropRecorder;
use cageless_results::DropRun;

use super::FiledDrop;
use crate::task::Task;
use crate::together::{Lent, Record, run_together};

/// Number of drops like `drop` that are worth computing together: into one bearing each they go side
/// by side, of a linear rotor one after the other.
pub(crate) fn worth_together(drop: &RotorDrop) -> usize {
    match drop.rotor() {
        None => BATCH_WIDTH,
        Some(_) => 1,
    }
}

/// `task` with so many drops like `drop`, those into one bearing side by side.
pub(crate) fn drop_task(
    task: Task,
    drop: &RotorDrop,
    drops: usize,
    steps: f64,
    pieces: usize,
) -> Task {
    match drop.rotor() {
        None => task.with_batch(&drop.cases()[0], drops, steps, pieces),
        Some(_) => task.with_drops(drop, steps, pieces),
    }
}

/// Recorders of the bearings of a drop.
pub(super) fn recorders(drop: &RotorDrop) -> Vec<DropRecorder> {
    let carried = drop.carried_n().into_iter();
    carried.map(DropRecorder::of_bearing).collect()
}

impl Record for DropRecorder {
    fn observers<'s>(&'s mut self, _: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        vec![Lent::of(self)]
    }
}

/// Computes drops in their order; `None` if interrupted. `control` has the control of so many drops
/// together.
pub(crate) fn run_drops<'c>(
    drops: &[FiledDrop<'_>],
    control: impl Fn(usize) -> Box<dyn FnMut(f64) -> Control + 'c>,
) -> Option<Vec<Result<DropRun, EquilibriumError>>> {
    // Short drops end before they ask for the first time.
    if control(1)(0.0).is_break() {
        return None;
    }
    let of_case = drops.iter().map(|filed| &filed.drop);
    let of_case = of_case.filter(|drop| drop.rotor().is_none());
    let cases: Vec<Case> = of_case.map(|drop| drop.cases()[0].clone()).collect();
    let mut of_case = run_together(&cases, |_| DropRecorder::new(), &control)?.into_iter();
    let run = |filed: &FiledDrop<'_>| match filed.drop.rotor() {
        None => Some(of_case.next()?.map(|(recorder, outcome)| {
            let outcome = RotorDropOutcome::from(outcome);
            DropRun::new(&filed.drop, filed.particulars(), vec![recorder], &outcome)
        })),
        Some(_) => run_alone(filed, &mut *control(1)),
    };
    drops.iter().map(run).collect()
}

/// Computes the drop of a linear rotor; `None` if interrupted.
fn run_alone(
    filed: &FiledDrop<'_>,
    control: &mut dyn FnMut(f64) -> Control,
) -> Option<Result<DropRun, EquilibriumError>> {
    let drop = &filed.drop;
    let mut recorders = recorders(drop);
    let mut observers: Vec<Vec<&mut dyn Observer>> = (recorders.iter_mut())
        .map(|recorder| vec![recorder as &mut dyn Observer])
        .collect();
    let outcome = match drop.run(&mut observers, control) {
        Ok(outcome) => outcome,
        Err(EquilibriumError::Interrupted) => return None,
        Err(error) => return Some(Err(error)),
    };
    let mut endings = outcome.bearings.iter().map(|bearing| &bearing.ending);
    let interrupted = endings.any(|ending| matches!(ending, Ending::Interrupted));
    // One that stops interrupts the others.
    match outcome.stopped_bearing() {
        None if interrupted => None,
        _ => Some(Ok(DropRun::new(
            drop,
            filed.particulars(),
            recorders,
            &outcome,
        ))),
    }
}
