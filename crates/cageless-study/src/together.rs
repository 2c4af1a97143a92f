//! Runs of several cases side by side, each with observers of its own.

use cageless::Case;
use cageless::equilibrium::EquilibriumError;
use cageless::simulation::{
    Control, Ending, Observer, ObserverError, RunContext, RunOutcome, StepView, batches, run_batch,
};
use cageless::summary::SummaryRecorder;

use crate::passages::Passages;
use cageless_results::Finished;

/// Record of a run, kept by its observers.
pub(crate) trait Record {
    /// Observers of the run of `case`.
    fn observers<'s>(&'s mut self, case: &'s Case) -> Vec<Box<dyn Observer + 's>>;
}

/// Records what the scalar results of a run need.
pub(crate) struct RunRecorder {
    summary: SummaryRecorder,
    passages: Passages,
}

/// An observer that is lent to a run.
pub(crate) struct Lent<'s, O>(&'s mut O);

impl<'s, O: Observer> Lent<'s, O> {
    pub(crate) fn of(observer: &'s mut O) -> Box<dyn Observer + 's> {
        Box::new(Self(observer))
    }
}

impl<O: Observer> Observer for Lent<'_, O> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.0.begin(context)
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.0.step(view)
    }
}

impl RunRecorder {
    pub(crate) fn new(case: &Case) -> Self {
        Self {
            summary: SummaryRecorder::new(),
            passages: Passages::new(case),
        }
    }

    /// Value of `of` for the run of `case` that has ended.
    pub(crate) fn finished<T>(
        &self,
        case: &Case,
        outcome: &RunOutcome,
        of: impl FnOnce(&Finished<'_>) -> T,
    ) -> T {
        let summary = self.summary.summary();
        of(&Finished {
            case,
            outcome,
            summary: summary.as_ref(),
            passages: &self.passages.all,
            verdict: &self.passages.verdict(case, outcome, summary.as_ref()),
            wall_s: f64::NAN,
        })
    }
}

impl Record for RunRecorder {
    fn observers<'s>(&'s mut self, case: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        let mut observers: Vec<Box<dyn Observer + 's>> = vec![Lent::of(&mut self.summary)];
        if !case.raceways.is_empty() {
            observers.push(Box::new(self.passages.recorder(case)));
        }
        observers
    }
}

/// Outcome of a run with what was recorded of it.
pub(crate) type Recorded<R> = Result<(R, RunOutcome), EquilibriumError>;

/// Runs of several cases in their order, each recorded by what `record` makes of its case;
/// `None` if interrupted. Those that can go side by side do, which changes no bit of them.
/// `control` has the control of a run of so many cases together.
pub(crate) fn run_together<'c, R: Record>(
    cases: &[Case],
    record: impl Fn(&Case) -> R,
    control: impl Fn(usize) -> Box<dyn FnMut(f64) -> Control + 'c>,
) -> Option<Vec<Recorded<R>>> {
    let mut done: Vec<Option<Recorded<R>>> = cases.iter().map(|_| None).collect();
    for members in batches(cases) {
        let together: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let mut records: Vec<R> = together.iter().map(|case| record(case)).collect();
        let outcomes = {
            let mut boxed: Vec<Vec<Box<dyn Observer + '_>>> = (records.iter_mut().zip(&together))
                .map(|(record, case)| record.observers(case))
                .collect();
            let mut observers: Vec<Vec<&mut dyn Observer>> = boxed
                .iter_mut()
                .map(|of_run| {
                    let references = of_run.iter_mut().map(|o| &mut **o as &mut dyn Observer);
                    references.collect()
                })
                .collect();
            run_batch(&together, &mut observers, &mut *control(members.len()))
        };
        for ((k, outcome), record) in members.iter().zip(outcomes).zip(records) {
            done[*k] = Some(match outcome {
                Ok(outcome) if matches!(outcome.ending, Ending::Interrupted) => return None,
                Err(EquilibriumError::Interrupted) => return None,
                outcome => outcome.map(|outcome| (record, outcome)),
            });
        }
    }
    done.into_iter().collect()
}
