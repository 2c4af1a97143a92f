//! Evaluation of a range of variants to rows.

use std::ops::Range;

use cageless::Case;
use cageless::critical_gap::CriticalGapError;
use cageless::design::judge;
use cageless::equilibrium;
use cageless::numerics::lanes::BATCH_WIDTH;
use cageless::simulation::{Control, Ending, RunOutcome};
use cageless::touchdown::DropRecorder;
use cageless_io::case_file::CaseError;
use cageless_io::plan_file::{PlanFile, VariantFile};
use cageless_io::results::{Column, ColumnKind, Row};
use cageless_io::rotor_file::RotorFile;
use cageless_results::Cell;
use cageless_results::Computation;

use super::error::SweepError;
use super::feasibility;
use super::outputs::{Output, outputs};
use super::variants::Variants;
use crate::StudyError;
use crate::drop::run_rotor;
use crate::together::{Record, Recorded, RunRecorder, run_together};
use cageless_results::{FinishedDrop, Judged, Solved, Subject};

/// A plan that can be computed.
#[derive(Debug, Clone)]
pub struct Sweep {
    variants: Variants,
    outputs: Vec<Output>,
    columns: Vec<Column>,
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
        let outputs = outputs(variants.plan())?;
        let mut columns = vec![spec(INDEX, ColumnKind::Index)];
        columns.extend_from_slice(variants.columns());
        columns.push(spec(REASON, ColumnKind::Text));
        columns.extend(outputs.iter().map(Output::column));
        feasibility::some_are_possible(&variants)?;
        Ok(Self {
            variants,
            outputs,
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
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|c| c.name == name)
    }

    /// Number of variants worth computing together: shorter ranges leave lanes of the
    /// vectors empty.
    pub fn together(&self) -> u64 {
        let of_case = matches!(self.plan().base_file, VariantFile::Case(_));
        if of_case && (self.wants(Computation::Run) || self.wants(Computation::Drop)) {
            BATCH_WIDTH as u64
        } else {
            1
        }
    }

    /// The case or the rotor of a variant.
    ///
    /// # Errors
    /// A [`CaseError`] if it is impossible.
    pub fn file(&self, index: u64) -> Result<VariantFile, CaseError> {
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
        self.drop(&mut batch, stop)?;
        self.drop_rotors(&mut batch, stop)?;
        Some(batch.into_iter().map(Variant::row).collect())
    }

    fn begin(&self, index: u64) -> Variant {
        let (inputs, case) = self.variants.variant(index);
        let mut variant = Variant {
            index,
            inputs,
            case: None,
            rotor: None,
            results: vec![Cell::Null; self.outputs.len()],
            reasons: Vec::new(),
        };
        match case {
            Ok(VariantFile::Case(file)) => variant.case = Some(file.case().clone()),
            Ok(VariantFile::Rotor(file)) => variant.rotor = Some(*file),
            // Without file and line: the same row wherever the plan lies.
            Err(error) => variant.reasons.push(error.message().to_owned()),
        }
        variant
    }

    fn wants(&self, computation: Computation) -> bool {
        let mut outputs = self.outputs.iter();
        outputs.any(|output| output.quantity.computation() == computation)
    }

    fn solve(&self, variant: &mut Variant) {
        let wanted = self.wants(Computation::Static);
        let Some(case) = variant.case.clone().filter(|_| wanted) else {
            return;
        };
        match equilibrium::solve(&case) {
            Ok(solved) => {
                variant.fill(&self.outputs, Subject::Static(&Solved::new(&case, &solved)))
            }
            Err(error) => variant.failed(Computation::Static, &error),
        }
    }

    fn describe(&self, variant: &mut Variant) {
        let Some(case) = variant.case.clone() else {
            return;
        };
        variant.fill(&self.outputs, Subject::Design(&case));
    }

    /// Judges the raceway; returns false if cancelled.
    fn judge(&self, variant: &mut Variant, stop: Cancellation<'_>) -> bool {
        let wanted = self.wants(Computation::Verdict);
        let Some(case) = variant.case.clone().filter(|_| wanted) else {
            return true;
        };
        match judge(&case, &mut |_| stop()) {
            Ok(judgement) => {
                let judged = Judged {
                    case: &case,
                    judgement: &judgement,
                };
                variant.fill(&self.outputs, Subject::Verdict(&judged));
                if let Some(passages) = &judgement.passages {
                    variant.fill(&self.outputs, Subject::Passages(passages));
                }
                if let Some(stop) = &judgement.stopped {
                    variant.failed(Computation::Verdict, &stop.reason());
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
        for (variant, run) in together(batch, |_| true, RunRecorder::new, stop)? {
            match run {
                Ok((recorder, outcome)) => self.record(variant, &recorder, &outcome),
                Err(error) => variant.failed(Computation::Run, &error),
            }
        }
        Some(())
    }

    fn drop(&self, batch: &mut [Variant], stop: Cancellation<'_>) -> Option<()> {
        if !self.wants(Computation::Drop) {
            return Some(());
        }
        for (variant, drop) in
            together(batch, |c| c.rotor.is_some(), |_| DropRecorder::new(), stop)?
        {
            match drop {
                Ok((recorder, outcome)) => {
                    let Some(case) = variant.case.clone() else {
                        continue;
                    };
                    if let Ending::Stopped(stop) = &outcome.ending {
                        variant.failed(Computation::Drop, &stop.reason());
                        continue;
                    }
                    let summary = recorder.summary(&outcome.state);
                    let finished = FinishedDrop {
                        case: &case,
                        summary: &summary,
                        outcome: &outcome,
                    };
                    variant.fill(&self.outputs, Subject::Drop(&finished));
                }
                Err(error) => variant.failed(Computation::Drop, &error),
            }
        }
        Some(())
    }

    /// Drops rotors into several bearings, one after the other.
    fn drop_rotors(&self, batch: &mut [Variant], stop: Cancellation<'_>) -> Option<()> {
        for variant in batch.iter_mut().filter(|_| self.wants(Computation::Drop)) {
            let Some(rotor) = &variant.rotor else {
                continue;
            };
            match run_rotor(rotor.drop(), &mut |_| stop()) {
                Ok(run) => match &run.stopped {
                    Some(reason) => variant.failed(Computation::Drop, reason),
                    None => {
                        let outputs = self.outputs.iter();
                        variant.results = outputs.map(|output| output.of_rotor(&run)).collect();
                    }
                },
                Err(StudyError::Interrupted) => return None,
                Err(error) => variant.failed(Computation::Drop, &error),
            }
        }
        Some(())
    }

    fn record(&self, variant: &mut Variant, run: &RunRecorder, outcome: &RunOutcome) {
        let Some(case) = variant.case.clone() else {
            return;
        };
        if let Ending::Stopped(stop) = &outcome.ending {
            return variant.failed(Computation::Run, &stop.reason());
        }
        run.finished(&case, outcome, |finished| {
            variant.fill(&self.outputs, Subject::Run(finished));
        });
    }
}

fn spec(name: &'static str, kind: ColumnKind) -> Column {
    Column {
        name: name.into(),
        unit: "".into(),
        kind,
    }
}

/// One variant on its way to a row.
struct Variant {
    index: u64,
    inputs: Vec<Cell>,
    case: Option<Case>,
    rotor: Option<RotorFile>,
    results: Vec<Cell>,
    reasons: Vec<String>,
}

impl Variant {
    fn fill(&mut self, outputs: &[Output], subject: Subject<'_>) {
        for (cell, output) in self.results.iter_mut().zip(outputs) {
            if let Some(found) = output.quantity.of(subject) {
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
        row.extend(self.results);
        row
    }
}

/// Runs the variants whose case can be run, side by side; `None` if cancelled.
fn together<'b, R: Record>(
    batch: &'b mut [Variant],
    runs: impl Fn(&Case) -> bool,
    record: impl Fn(&Case) -> R,
    stop: Cancellation<'_>,
) -> Option<Vec<(&'b mut Variant, Recorded<R>)>> {
    let (variants, cases): (Vec<&mut Variant>, Vec<Case>) = batch
        .iter_mut()
        .filter_map(|variant| {
            let case = variant.case.clone().filter(&runs)?;
            Some((variant, case))
        })
        .unzip();
    let done = run_together(&cases, record, |_| Box::new(move |_| stop()))?;
    Some(variants.into_iter().zip(done).collect())
}
