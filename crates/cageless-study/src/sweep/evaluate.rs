//! Evaluation of a range of variants to rows.

use std::ops::Range;

use cageless::Case;
use cageless::equilibrium::settle;
use cageless::numerics::BATCH_WIDTH;
use cageless::simulation::{Control, Ending};
use cageless_design::critical_gap::CriticalGapError;
use cageless_design::judge;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{CaseError, CaseFile, is_spatial};
use cageless_io::plan_file::PlanFile;
use cageless_io::results::{Column, ColumnKind, Row};
use cageless_results::{Cell, Computation, DropRun, Judged, Solved, Subject};

use super::feasibility;
use super::outputs::{Output, Varied, outputs};
use super::variants::Variants;
use crate::StudyError;
use crate::drop::{FiledDrop, run_drops};
use crate::together::{RunRecorder, run_together};

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

/// Passes a file that these computations take.
fn check_space(file: &BearingArrangement, compute: &[Computation]) -> Result<(), CaseError> {
    let at_rest = |computation: &Computation| matches!(computation, Computation::Static);
    match compute.iter().all(at_rest) {
        true => Ok(()),
        false => file.check_motion(),
    }
}

impl Sweep {
    /// Checks what the plan asks for.
    ///
    /// # Errors
    /// Too many variants, columns that there are none of, no variant that is a possible case, or an
    /// environment that asks for too many threads.
    pub fn new(plan: PlanFile) -> Result<Self, StudyError> {
        crate::check_environment()?;
        let compute = plan.compute.clone();
        check_space(&plan.base_file, &compute).map_err(StudyError::Plan)?;
        let normal = plan.normal().map_err(StudyError::Plan)?;
        let variants = Variants::new(plan).map_err(StudyError::Plan)?;
        let base = &variants.plan.base_file;
        let spatial = |file: &CaseFile| file.case().moves_in_space();
        let oiled = |file: &CaseFile| file.case().film.is_some();
        let sweeps = |of: &dyn Fn(&str) -> bool| variants.columns.iter().any(|c| of(&c.name));
        let varied = Varied {
            in_space: base.cases().iter().any(spatial) || sweeps(&is_spatial),
            in_oil: base.cases().iter().any(oiled) || sweeps(&|column| column.starts_with("film_")),
        };
        let outputs = outputs(&variants.plan, varied).map_err(StudyError::Plan)?;
        let mut columns = vec![spec(INDEX, ColumnKind::Index)];
        columns.extend_from_slice(&variants.columns);
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
        self.variants.count
    }

    /// The plan.
    pub fn plan(&self) -> &PlanFile {
        &self.variants.plan
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
        let of_case_file = self.plan().base_file.case().is_some();
        if of_case_file && (self.wants(Computation::Run) || self.wants(Computation::Drop)) {
            BATCH_WIDTH as u64
        } else {
            1
        }
    }

    /// Number of variants that a thread computes before it asks for more: handing them over takes
    /// little of the time, and no thread is left with much when the others are done.
    pub(crate) fn batch(&self) -> u64 {
        let is_quick = |output: &Output| {
            let of = output.quantity.computation();
            matches!(of, Computation::Static | Computation::Design)
        };
        match self.outputs.iter().all(is_quick) {
            true => 16,
            false => self.together(),
        }
    }

    /// The case or the rotor of a variant.
    ///
    /// # Errors
    /// A [`CaseError`] if it is impossible.
    pub fn file(&self, index: u64) -> Result<BearingArrangement, CaseError> {
        self.variants.variant(index).1
    }

    /// Rows of a range of variants, in order; `None` if cancelled. Always the same
    /// rows on one instruction set, however the variants are cut into ranges.
    pub fn evaluate(&self, range: Range<u64>, stop: Cancellation<'_>) -> Option<Vec<Row>> {
        let mut batch: Vec<Variant<'_>> = range.map(|index| self.begin(index)).collect();
        for variant in &mut batch {
            self.alone(variant, stop)?;
        }
        self.run(&mut batch, stop)?;
        self.drop(&mut batch, stop)?;
        Some(batch.into_iter().map(Variant::row).collect())
    }

    fn begin(&self, index: u64) -> Variant<'_> {
        let (inputs, file) = self.variants.variant(index);
        let compute = &self.variants.plan.compute;
        let file = file.and_then(|file| check_space(&file, compute).map(|()| file));
        let mut found = Found {
            outputs: &self.outputs,
            cells: vec![Cell::Null; self.outputs.len()],
            reasons: Vec::new(),
        };
        if let Err(error) = &file {
            // Without file and line: the same row wherever the plan lies.
            found.reasons.push(error.message().to_owned());
        }
        Variant {
            index,
            inputs,
            file: file.ok(),
            found,
        }
    }

    pub(super) fn wants(&self, computation: Computation) -> bool {
        let mut outputs = self.outputs.iter();
        outputs.any(|output| output.quantity.computation() == computation)
    }

    /// Computations of a variant by itself: static equilibrium, design and verdict; `None` if cancelled.
    fn alone(&self, variant: &mut Variant<'_>, stop: Cancellation<'_>) -> Option<()> {
        let Variant { file, found, .. } = variant;
        let Some(file) = file.as_ref().and_then(BearingArrangement::case) else {
            return Some(());
        };
        let case = file.case();
        if self.wants(Computation::Static) {
            match settle(case) {
                Ok(solved) => found.fill(Subject::Static(&Solved::new(
                    case,
                    file.particulars(),
                    &solved,
                ))),
                Err(error) => found.failed(Computation::Static, &error),
            }
        }
        found.fill(Subject::Design(case));
        if stop().is_break() {
            return None;
        }
        match self.wants(Computation::Verdict) {
            true => found.judge(file, stop),
            false => Some(()),
        }
    }

    /// Runs the cases; `None` if cancelled.
    fn run(&self, batch: &mut [Variant<'_>], stop: Cancellation<'_>) -> Option<()> {
        if !self.wants(Computation::Run) {
            return Some(());
        }
        let of_case = batch.iter_mut().filter_map(|variant| {
            let Variant { file, found, .. } = variant;
            let file = file.as_ref()?.case()?;
            Some((found, file.case().clone()))
        });
        let (found, cases): (Vec<_>, Vec<Case>) = of_case.unzip();
        let runs = run_together(&cases, RunRecorder::new, |_| Box::new(move |_| stop()))?;
        for ((found, case), run) in found.into_iter().zip(&cases).zip(runs) {
            match run {
                Ok((recorder, outcome)) => match &outcome.ending {
                    Ending::Stopped(stop) => found.failed(Computation::Run, &stop.reason()),
                    _ => recorder.finished(case, &outcome, |run| found.fill(Subject::Run(run))),
                },
                Err(error) => found.failed(Computation::Run, &error),
            }
        }
        Some(())
    }

    /// Drops the rotors; `None` if cancelled.
    fn drop(&self, batch: &mut [Variant<'_>], stop: Cancellation<'_>) -> Option<()> {
        if !self.wants(Computation::Drop) {
            return Some(());
        }
        let dropped = batch.iter_mut().filter_map(|variant| {
            let Variant { file, found, .. } = variant;
            let file = file.as_ref()?;
            let (drop, files) = (file.drop()?.clone(), file.cases());
            Some((found, FiledDrop { drop, files }))
        });
        let (found, drops): (Vec<_>, Vec<_>) = dropped.unzip();
        let runs = run_drops(&drops, |_| Box::new(move |_| stop()))?;
        for (found, run) in found.into_iter().zip(runs) {
            match run {
                Ok(run) => match &run.stopped {
                    Some(reason) => found.failed(Computation::Drop, reason),
                    None => found.fill_drop(&run),
                },
                Err(error) => found.failed(Computation::Drop, &error),
            }
        }
        Some(())
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
struct Variant<'s> {
    index: u64,
    inputs: Vec<Cell>,
    /// `None` if it is impossible.
    file: Option<BearingArrangement>,
    found: Found<'s>,
}

/// Results of a variant so far.
struct Found<'s> {
    outputs: &'s [Output],
    cells: Vec<Cell>,
    reasons: Vec<String>,
}

impl Found<'_> {
    fn fill(&mut self, subject: Subject<'_>) {
        for (cell, output) in self.cells.iter_mut().zip(self.outputs) {
            if let Some(found) = output.quantity.of(subject) {
                *cell = found;
            }
        }
    }

    fn fill_drop(&mut self, run: &DropRun) {
        let of_drop = |output: &Output| output.quantity.computation() == Computation::Drop;
        let cells = self.cells.iter_mut().zip(self.outputs);
        for (cell, output) in cells.filter(|(_, output)| of_drop(output)) {
            *cell = output.of_drop(run);
        }
    }

    fn failed(&mut self, computation: Computation, why: &dyn ToString) {
        let reason = format!("{}: {}", computation.name(), why.to_string());
        self.reasons.push(reason);
    }

    /// Judges the raceway; `None` if cancelled.
    fn judge(&mut self, file: &CaseFile, stop: Cancellation<'_>) -> Option<()> {
        let case = file.case();
        match judge(case, &mut |_| stop()) {
            Ok(judgement) => {
                let judgement = &judgement;
                let stopped = judgement.stopped.as_ref();
                if let Some(stop) = stopped.filter(|stop| !stop.cause.gives_way()) {
                    self.failed(Computation::Verdict, &stop.reason());
                    return Some(());
                }
                self.fill(Subject::Verdict(&Judged { case, judgement }));
                if let Some(passages) = &judgement.passages {
                    self.fill(Subject::Passages(passages));
                }
                if let Some(stop) = &judgement.stopped {
                    self.failed(Computation::Verdict, &stop.reason());
                }
            }
            Err(CriticalGapError::Interrupted) => return None,
            Err(error) => match StudyError::of_run(file, error) {
                // Without file and line: the same row wherever the plan lies.
                StudyError::File(error) => self.failed(Computation::Verdict, &error.message()),
                error => self.failed(Computation::Verdict, &error),
            },
        }
        Some(())
    }
}

impl Variant<'_> {
    fn row(self) -> Row {
        let reasons = self.found.reasons;
        let reason = (!reasons.is_empty()).then(|| Cell::Text(reasons.join("; ")));
        let mut row = vec![Cell::Integer(self.index as i64)];
        row.extend(self.inputs);
        row.push(reason.unwrap_or(Cell::Null));
        row.extend(self.found.cells);
        row
    }
}
