//! One bearing on its way through a run, with its observers.

use super::guard::{Cause, Stop};
use super::observer::{Observer, RunContext};
use super::outcome::{Ending, RunOutcome};
use super::watch::{Made, Watch};
use crate::control::Control;
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, InstructionSet};
use crate::integrator::StepState;

/// Tracks one bearing through the steps of a run, alone or in a batch.
pub(super) struct RunTracker<'s, 'o> {
    pub context: RunContext<'o>,
    watch: &'o mut Watch,
    observers: &'o mut [&'s mut dyn Observer],
    ending: Option<Ending>,
    last: State,
    pub made: Made,
}

impl<'s, 'o> RunTracker<'s, 'o> {
    pub(super) fn new(
        context: RunContext<'o>,
        watch: &'o mut Watch,
        observers: &'o mut [&'s mut dyn Observer],
    ) -> Self {
        let mut ending = None;
        for observer in observers.iter_mut() {
            if let Err(error) = observer.begin(&context) {
                ending = Some(Ending::ObserverFailed(error));
            }
        }
        Self {
            last: context.start.clone(),
            context,
            watch,
            observers,
            ending,
            made: Made {
                evaluations: 0,
                instruction_set: InstructionSet::Baseline,
                rotor_balance: None,
            },
        }
    }

    /// Whether the run of the bearing has not ended.
    pub(super) fn under_way(&self) -> bool {
        self.ending.is_none()
    }

    /// Ends here, unless it has already, at the state in `values`.
    pub(super) fn end(&mut self, ending: Ending, values: &[f64]) {
        if self.under_way() {
            self.last = self.watch.state_in(values);
            self.ending = Some(ending);
        }
    }

    /// Ends at a step that the method could not make.
    pub(super) fn stop_unresolved(&mut self, time_s: f64, values: &[f64]) {
        let stop = self.watch.stop_unresolved(self.context.case, time_s);
        self.stop(stop, values);
    }

    /// Ends at a step for this cause.
    pub(super) fn stop_for(&mut self, cause: Cause, step: &StepState) {
        let stop = self.watch.stop(self.context.case, step.t0_s, cause);
        self.stop(stop, &step.y1);
    }

    fn stop(&mut self, stop: Stop, values: &[f64]) {
        self.end(Ending::Stopped(stop), values);
    }

    /// Looks at a step, at whose end a bearing has these contacts, shows it to the observers, and ends at
    /// `until_s`.
    pub(super) fn follow<'c>(
        &mut self,
        step: &StepState,
        contacts_of: impl Fn(usize) -> Contacts<'c>,
        until_s: f64,
    ) {
        let at_end = step.t1_s >= until_s;
        let case = self.context.case;
        if let Err(stop) = self.watch.look(case, step, &contacts_of, at_end) {
            self.stop(stop, &step.y1);
            return;
        }
        let view = self.watch.view(step, contacts_of(self.watch.bearing()));
        let mut ending = at_end.then_some(Ending::Complete);
        for observer in self.observers.iter_mut() {
            match observer.step(&view) {
                Ok(Control::Continue(())) => {}
                Ok(Control::Break(())) => ending = Some(Ending::Interrupted),
                Err(error) => {
                    ending = Some(Ending::ObserverFailed(error));
                    break;
                }
            }
        }
        if let Some(ending) = ending {
            self.end(ending, &step.y1);
        }
    }

    /// Outcome of a whole run.
    pub(super) fn whole_outcome(self) -> RunOutcome {
        let case = self.context.case;
        self.outcome().of_whole_run(case)
    }

    /// Outcome of the run.
    pub(super) fn outcome(self) -> RunOutcome {
        let ending = self.ending.unwrap_or(Ending::Interrupted);
        self.watch.outcome(ending, self.last, self.made)
    }
}
