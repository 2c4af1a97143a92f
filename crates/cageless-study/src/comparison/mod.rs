//! Outer rings compared fairly: each runs from the same uneven starts, and a difference is its
//! mean over the starts with its standard error. Ideal balls that start evenly all roll at one
//! speed and keep their gaps with any ring, so that one even start compares nothing.

mod result;
mod verdict;

use cageless::Case;
use cageless::design::RunVerdict;
use cageless::simulation::Observer;
use cageless::summary::transient_s;
use cageless::vibration::VibrationRecorder;
use cageless_io::OptionError;
use cageless_io::case_file::CaseFile;
use rayon::prelude::*;

pub use result::{ComparedResult, RingComparison, RingResults, Starts};
pub use verdict::RingVerdict;

use crate::error::StudyError;
use crate::histories::SAMPLING_HZ;
use crate::progress::{Progress, Work};
use crate::run::{Options, RunRecord, run};
use crate::together::{Record, RunRecorder, run_together};
use cageless_results::{COMPARED, RUN, Results, Subject};

/// Starts of each ring unless asked for otherwise: as many as run side by side.
pub const STARTS: u64 = 8;
/// More would take days.
const STARTS_MAX: u64 = 10_000;

/// A ring after all its runs.
pub struct ComparedRing {
    /// The case of the first start.
    pub file: CaseFile,
    /// Its run, for figures.
    pub record: RunRecord,
    /// Its scalar results from every start.
    pub results: RingResults,
}

/// Runs each named case from `count` uneven starts under the seed of the first case, with which the
/// others are compared.
///
/// # Errors
/// `count` is not possible, a case cannot start, a run left the physical range, or the progress
/// ended the work.
pub fn compare(
    rings: &[(&str, CaseFile)],
    count: u64,
    progress: &dyn Progress,
) -> Result<(Vec<ComparedRing>, RingComparison), StudyError> {
    if !(2..=STARTS_MAX).contains(&count) {
        let allowed = format!("from 2 to {STARTS_MAX}");
        return Err(OptionError::not_possible("starts", count, &allowed).into());
    }
    let seed = rings.first().map_or(0, |(_, file)| file.case().seed);
    let work = progress.begin("compare", rings.len() as f64 * (count + 1) as f64);
    let work = &work;
    let compared: Vec<ComparedRing> = rings
        .par_iter()
        .map(|(name, file)| ring(name, file, seed, count, work))
        .collect::<Result<_, _>>()?;
    let results: Vec<RingResults> = compared.iter().map(|ring| ring.results.clone()).collect();
    let starts = Starts {
        count,
        seed: Some(seed),
    };
    Ok((compared, RingComparison::new(&results, starts)))
}

fn ring(
    name: &str,
    file: &CaseFile,
    seed: u64,
    count: u64,
    work: &Work<'_>,
) -> Result<ComparedRing, StudyError> {
    let starts: Vec<CaseFile> = (0..count)
        .map(|start| file.with_uneven_start(seed, start))
        .collect::<Result<_, _>>()?;
    let first = starts[0].clone();
    // A block for each thread; who runs beside whom changes no bit.
    let (record, found) = rayon::join(
        || recorded(&first, work),
        || {
            let blocks = starts.par_chunks(STARTS as usize);
            let found: Result<Vec<_>, _> = blocks.map(|block| outcomes(block, work)).collect();
            found
        },
    );
    let (values, verdicts): (Vec<_>, Vec<_>) = found?.into_iter().flatten().unzip();
    let verdict = RunVerdict::of_starts(first.case(), &verdicts);
    Ok(ComparedRing {
        file: first,
        record: record?,
        results: RingResults::of_starts(name, file, &values, verdict.into()),
    })
}

/// The run of the first start with its histories.
fn recorded(file: &CaseFile, work: &Work<'_>) -> Result<RunRecord, StudyError> {
    let mut rows = ();
    let options = Options {
        rows: Some(&mut rows),
        verify: false,
    };
    let record = run(file, options, &Part(work))?;
    let _ = work.add(1.0);
    StudyError::unless_complete(&record.outcome.ending)?;
    Ok(record)
}

/// The work of a comparison as the progress of one of its runs, which only cancels.
struct Part<'w>(&'w Work<'w>);

impl Progress for Part<'_> {
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}

/// What is measured of one start.
struct StartRecorder {
    run: RunRecorder,
    vibration: Option<VibrationRecorder>,
}

impl Record for StartRecorder {
    fn observers<'s>(&'s mut self, case: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        let mut observers = self.run.observers(case);
        if let Some(vibration) = &mut self.vibration {
            observers.push(Box::new(vibration));
        }
        observers
    }
}

/// Scalar results of a run by name.
type Values = Vec<(&'static str, f64)>;

/// Results and verdict of each start of a block, side by side.
fn outcomes(block: &[CaseFile], work: &Work<'_>) -> Result<Vec<(Values, RunVerdict)>, StudyError> {
    let cases: Vec<Case> = block.iter().map(|file| file.case().clone()).collect();
    let record = |case: &Case| StartRecorder {
        run: RunRecorder::new(case),
        vibration: (case.housing.as_ref())
            .map(|housing| VibrationRecorder::new(housing, SAMPLING_HZ, transient_s(case))),
    };
    let duration_s = cases[0].solver.duration_s;
    let control = |runs: usize| work.run_control(duration_s, runs as f64);
    let runs = run_together(&cases, record, control).ok_or(StudyError::Interrupted)?;
    let outcomes = runs.into_iter().zip(&cases).map(|(run, case)| {
        let (recorder, outcome) = run?;
        StudyError::unless_complete(&outcome.ending)?;
        let (results, verdict) = (recorder.run).finished(case, &outcome, |run| {
            (Results::of(RUN, Subject::Run(run)), run.verdict.clone())
        });
        let results = match &recorder.vibration {
            Some(vibration) => {
                let rms_m_s2 = vibration.measurements()[1].rms();
                results.and(Results::of(COMPARED, Subject::Vibration(&rms_m_s2)))
            }
            None => results,
        };
        let values = results.iter();
        let values = values.filter_map(|(quantity, cell)| Some((quantity.name, cell.number()?)));
        Ok((values.collect(), verdict))
    });
    outcomes.collect()
}
