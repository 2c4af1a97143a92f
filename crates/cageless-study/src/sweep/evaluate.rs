//! Evaluation of a range of variants to rows.

use std::ops::Range;

use cageless::Case;
use cageless::critical_gap::CriticalGapError;
use cageless::design::judge;
use cageless::dynamics::state::BATCH_WIDTH;
use cageless::equilibrium;
use cageless::simulation::{Control, Ending, Observer, RunOutcome, batches, run_batch};
use cageless::summary::{Summary, SummaryRecorder};
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_io::plan_file::{Computation, PlanFile};
use cageless_io::results::{Cell, ColumnKind, ColumnSpec, Row};

use super::error::SweepError;
use super::feasibility;
use super::variants::Variants;
use crate::passages::Passages;
use crate::quantities::{Finished, QUANTITIES, Quantity};

/// A plan that can be computed.
#[derive(Debug, Clone)]
pub struct Sweep {
    variants: Variants,
    quantities: Vec<Quantity>,
    columns: Vec<ColumnSpec>,
    normal: String,
}

/// Function that is called now and then; `Break(())` cancels the work.
pub type Cancellation<'a> = &'a (dyn Fn() -> Control + Sync);

/// A column beside the inputs and the quantities.
pub(crate) const INDEX: &str = "variant";
pub(crate) const REASON: &str = "reason";

impl Sweep {
    /// Checks what the plan asks for.
    ///
    /// # Errors
    /// Too many variants, columns that there are none of, no variant that is a possible case, or an
    /// environment that asks for too many threads.
    pub fn new(plan: PlanFile) -> Result<Self, SweepError> {
        crate::check_environment()?;
        let normal = plan.normal()?;
        let variants = Variants::new(plan)?;
        let quantities = kept(variants.plan())?;
        let mut columns = vec![spec(INDEX, ColumnKind::Index)];
        columns.extend_from_slice(variants.columns());
        columns.push(spec(REASON, ColumnKind::Text));
        columns.extend(quantities.iter().map(Quantity::column));
        feasibility::some_are_possible(&variants)?;
        Ok(Self {
            variants,
            quantities,
            columns,
            normal,
        })
    }

    /// Number of variants; their indices count from 0.
    pub fn variants(&self) -> u64 {
        self.variants.count()
    }

    /// The plan.
    pub fn plan(&self) -> &PlanFile {
        self.variants.plan()
    }

    /// The plan in its normal form, which reads back as a plan.
    pub fn normal(&self) -> &str {
        &self.normal
    }

    /// Columns of the rows: the index, the inputs, the reason of a failure, the quantities.
    pub fn columns(&self) -> &[ColumnSpec] {
        &self.columns
    }

    /// Place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|c| c.name == name)
    }

    /// Number of variants worth computing together: shorter ranges leave lanes of the
    /// vectors empty.
    pub fn together(&self) -> u64 {
        if self.wants(Computation::Run) {
            BATCH_WIDTH as u64
        } else {
            1
        }
    }

    /// The case of a variant.
    ///
    /// # Errors
    /// A [`CaseError`] if it is impossible.
    pub fn case(&self, index: u64) -> Result<CaseFile, CaseError> {
        self.variants.variant(index).1
    }

    /// Rows of a range of variants, in order; `None` if cancelled. Always the same
    /// rows on one instruction set, however the variants are cut into ranges.
    pub fn evaluate(&self, range: Range<u64>, stop: Cancellation<'_>) -> Option<Vec<Row>> {
        let mut batch: Vec<Variant> = range.map(|index| self.begin(index)).collect();
        for variant in &mut batch {
            self.solve(variant);
            self.describe(variant);
            if stop().is_break() || !self.judge(variant, stop) {
                return None;
            }
        }
        self.run(&mut batch, stop)?;
        Some(batch.into_iter().map(Variant::row).collect())
    }

    fn begin(&self, index: u64) -> Variant {
        let (inputs, case) = self.variants.variant(index);
        let mut variant = Variant {
            index,
            inputs,
            case: None,
            quantities: vec![Cell::Null; self.quantities.len()],
            reasons: Vec::new(),
        };
        match case {
            Ok(file) => variant.case = Some(file.case().clone()),
            // Without file and line: the same row wherever the plan lies.
            Err(error) => variant.reasons.push(error.message().to_owned()),
        }
        variant
    }

    fn wants(&self, computation: Computation) -> bool {
        self.quantities
            .iter()
            .any(|f| f.computation() == computation)
    }

    fn solve(&self, variant: &mut Variant) {
        let Some(case) = variant
            .case
            .as_ref()
            .filter(|_| self.wants(Computation::Static))
        else {
            return;
        };
        match equilibrium::solve(case) {
            Ok(solved) => variant.fill(&self.quantities, |q| q.of_equilibrium(&solved)),
            Err(error) => variant.failed(Computation::Static, &error),
        }
    }

    fn describe(&self, variant: &mut Variant) {
        let Some(case) = variant.case.clone() else {
            return;
        };
        variant.fill(&self.quantities, |q| q.of_case(&case));
    }

    /// Judges the raceway; returns false if cancelled.
    fn judge(&self, variant: &mut Variant, stop: Cancellation<'_>) -> bool {
        let Some(case) = variant
            .case
            .as_ref()
            .filter(|_| self.wants(Computation::Verdict))
        else {
            return true;
        };
        match judge(case, &mut |_| stop()) {
            Ok(judgement) => {
                variant.fill(&self.quantities, |q| q.of_judgement(&judgement));
                if let Some(stop) = &judgement.stopped {
                    variant.failed(Computation::Verdict, &stopped(stop));
                }
            }
            Err(CriticalGapError::Interrupted) => return false,
            Err(error) => variant.failed(Computation::Verdict, &error),
        }
        true
    }

    fn run(&self, batch: &mut [Variant], stop: Cancellation<'_>) -> Option<()> {
        if !self.wants(Computation::Run) {
            return Some(());
        }
        let cases: Vec<Case> = batch.iter().filter_map(|v| v.case.clone()).collect();
        let mut runs = runs(&cases, stop)?.into_iter();
        for variant in batch.iter_mut().filter(|v| v.case.is_some()) {
            match runs.next() {
                Some(Ok(run)) => self.record(variant, &run),
                Some(Err(reason)) => variant.failed(Computation::Run, &reason),
                None => {}
            }
        }
        Some(())
    }

    fn record(&self, variant: &mut Variant, run: &OneRun) {
        let Some(case) = variant.case.clone() else {
            return;
        };
        let finished = Finished {
            case: &case,
            outcome: &run.outcome,
            summary: run.summary.as_ref(),
            passages: &run.passages.all,
            verdict: &run.passages.verdict(&case),
            wall_s: f64::NAN,
        };
        if let Ending::Stopped(stop) = &run.outcome.ending {
            return variant.failed(Computation::Run, &stopped(stop));
        }
        variant.fill(&self.quantities, |q| q.of_run(&finished));
    }
}

fn spec(name: &str, kind: ColumnKind) -> ColumnSpec {
    ColumnSpec {
        name: name.to_owned(),
        unit: String::new(),
        kind,
    }
}

/// The quantities that the plan keeps.
fn kept(plan: &PlanFile) -> Result<Vec<Quantity>, CaseError> {
    let computed = || {
        let quantities = QUANTITIES.iter().copied().filter(|f| f.in_sweeps);
        quantities.filter(|f| plan.compute.contains(&f.computation()))
    };
    let Some(keep) = &plan.keep else {
        return Ok(computed().collect());
    };
    for kept in keep {
        if computed().any(|f| f.column_name() == kept.name) {
            continue;
        }
        let why = match QUANTITIES
            .iter()
            .find(|f| f.in_sweeps && f.column_name() == kept.name)
        {
            Some(quantity) => format!("compute leaves out \"{}\"", quantity.computation().name()),
            None => format!(
                "there are {}",
                computed()
                    .map(|f| f.column_name())
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
        };
        let message = format!("keep has \"{}\", which is not computed: {why}", kept.name);
        return Err(plan.error(kept.line, "keep", message));
    }
    let wanted = |f: &Quantity| keep.iter().any(|kept| kept.name == f.column_name());
    Ok(computed().filter(wanted).collect())
}

/// One variant on its way to a row.
struct Variant {
    index: u64,
    inputs: Vec<Cell>,
    case: Option<Case>,
    quantities: Vec<Cell>,
    reasons: Vec<String>,
}

impl Variant {
    fn fill(&mut self, quantities: &[Quantity], value: impl Fn(&Quantity) -> Option<Cell>) {
        for (cell, quantity) in self.quantities.iter_mut().zip(quantities) {
            if let Some(found) = value(quantity) {
                *cell = found;
            }
        }
    }

    fn failed(&mut self, computation: Computation, why: &dyn ToString) {
        self.reasons
            .push(format!("{}: {}", computation.name(), why.to_string()));
    }

    fn row(self) -> Row {
        let mut row = vec![Cell::Integer(self.index as i64)];
        row.extend(self.inputs);
        row.push(match self.reasons.is_empty() {
            true => Cell::Null,
            false => Cell::Text(self.reasons.join("; ")),
        });
        row.extend(self.quantities);
        row
    }
}

struct OneRun {
    outcome: RunOutcome,
    summary: Option<Summary>,
    passages: Passages,
}

/// Runs of several cases, in their order; `None` if interrupted. Those that can go side by
/// side do, which changes no bit of them.
fn runs(cases: &[Case], stop: Cancellation<'_>) -> Option<Vec<Result<OneRun, String>>> {
    let mut done: Vec<Option<Result<OneRun, String>>> = cases.iter().map(|_| None).collect();
    for members in batches(cases) {
        let mut summaries: Vec<_> = members.iter().map(|_| SummaryRecorder::new()).collect();
        let together: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let mut passages: Vec<_> = together.iter().map(|case| Passages::new(case)).collect();
        let mut passing: Vec<_> = passages
            .iter_mut()
            .zip(&together)
            .map(|(passages, case)| passages.recorder(case))
            .collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = summaries
            .iter_mut()
            .zip(&mut passing)
            .zip(&together)
            .map(|((summary, passing), case)| {
                let mut observers: Vec<&mut dyn Observer> = vec![summary];
                if !case.raceways.is_empty() {
                    observers.push(passing);
                }
                observers
            })
            .collect();
        let outcomes = run_batch(&together, &mut observers, &mut |_| stop());
        drop(passing);
        for (((k, outcome), summary), passages) in
            members.iter().zip(outcomes).zip(&summaries).zip(passages)
        {
            done[*k] = Some(match outcome {
                Ok(outcome) if matches!(outcome.ending, Ending::Interrupted) => return None,
                Ok(outcome) => Ok(OneRun {
                    outcome,
                    summary: summary.summary(),
                    passages,
                }),
                Err(error) => Err(error.to_string()),
            });
        }
    }
    done.into_iter().collect()
}

fn stopped(stop: &cageless::simulation::Stop) -> String {
    format!("at t = {:.6} s {}", stop.time_s, stop.cause)
}
