//! Outer rings compared fairly: each runs in steady operation with the same draws of real balls
//! ([`cageless::steady`]), and a difference is its mean over the draws with its standard error. Ideal balls all roll
//! at one speed and keep their gaps with any ring, so that they compare nothing.

mod benefit;
mod differing_keys;
mod left_out;
mod remedies;
mod result;
mod ring_results;
mod sampling;
mod verdict;

use cageless::Case;
use cageless::equilibrium::settle;
use cageless::simulation::{Observer, batches};
use cageless::steady::{Stationarity, SteadyBlock, SteadyRecorder, SteadySummary};
use cageless::summary::transient_s;
use cageless::vibration::VibrationRecorder;
use cageless_design::RunVerdict;
use cageless_io::case_file::{CaseError, CaseFile};
use rayon::prelude::*;
use serde_json::{Value, to_value};

pub use benefit::{Benefit, BenefitCriterion, BenefitRank, BenefitWord};
pub(crate) use benefit::{TRIFLE, ratio};
pub use differing_keys::DifferingKey;
pub use left_out::LeftOut;
pub use remedies::Remedies;
pub(crate) use remedies::{plain_ring, with_fewer_balls};
pub use result::{ComparedResult, RingComparison};
pub use ring_results::RingResults;
pub use sampling::{DRAWS, Draws, Sampling};
pub use verdict::RingVerdict;

use crate::error::StudyError;
use crate::histories::SAMPLING_HZ;
use crate::progress::{Progress, Work};
use crate::run::{Options, RunRecord, run};
use crate::task::Task;
use crate::threads::{both, each, groups_of};
use crate::together::{Lent, Record, RunRecorder, run_together};
use cageless_results::{
    COMPARED, Provenance, RUN, Results, STATIC, STEADY, Solved, Subject, provenance,
};

/// A ring after all its runs.
pub struct ComparedRing {
    /// The case with the first draw.
    pub file: CaseFile,
    /// Run of the ring from the start, as long as the case says, for figures.
    pub record: RunRecord,
    /// Scalar results of the ring with every draw.
    pub results: RingResults,
}

/// Runs each named case with every sample under the seed of the first case, with which the others are compared.
///
/// # Errors
/// The number of samples is not possible, a case cannot start, a run left the physical range, or the progress
/// ended the work.
pub fn compare(
    rings: &[(String, CaseFile)],
    sampling: Sampling,
    progress: &dyn Progress,
) -> Result<(Vec<ComparedRing>, RingComparison), StudyError> {
    compare_all(rings, sampling, progress, &|_, error| Err(error))
}

/// [`compare`] of rings of which `leaves_out` says whether one goes without a comparison, but the first.
fn compare_all(
    rings: &[(String, CaseFile)],
    sampling: Sampling,
    progress: &dyn Progress,
    leaves_out: &(dyn Fn(&str, StudyError) -> Result<LeftOut, StudyError> + Sync),
) -> Result<(Vec<ComparedRing>, RingComparison), StudyError> {
    sampling.check()?;
    for (_, file) in rings {
        file.checked(Case::check_run)?;
    }
    let seed = rings.first().map_or(0, |(_, file)| file.particulars().seed);
    let task = task(rings, sampling)?;
    progress.whole(std::slice::from_ref(&task));
    let work = progress.begin(TASK, task.steps());
    let work = &work;
    let found: Vec<Result<ComparedRing, LeftOut>> = each(rings)
        .enumerate()
        .map(
            |(k, (name, file))| match ring(name, file, sampling, seed, work) {
                Ok(ring) => Ok(Ok(ring)),
                Err(error) if k == 0 => Err(error),
                Err(error) => leaves_out(name, error).map(Err),
            },
        )
        .collect::<Result<_, _>>()?;
    let (mut compared, mut left_out) = (vec![], vec![]);
    for one in found {
        match one {
            Ok(ring) => compared.push(ring),
            Err(one) => left_out.push(one),
        }
    }
    let results: Vec<RingResults> = compared.iter().map(|ring| ring.results.clone()).collect();
    let draws = Draws::of(&rings[0].1, sampling);
    let is_compared = |name: &str| compared.iter().any(|ring| ring.results.name == *name);
    let of_compared = rings.iter().filter(|(name, _)| is_compared(name));
    let document = |file: &CaseFile| to_value(file.document_as_run()).unwrap_or_default();
    let documents: Vec<Value> = of_compared.map(|(_, file)| document(file)).collect();
    let comparison = RingComparison {
        left_out,
        ..RingComparison::new(&results, draws).of_cases(&documents)
    };
    Ok((compared, comparison))
}

/// Compares remedies ([`compare`]); one that does not run is left out with its reason, but the first.
///
/// # Errors
/// Errors of [`compare`], of the first alone where a run left the physical range.
pub fn compare_remedies(
    remedies: &Remedies,
    sampling: Sampling,
    progress: &dyn Progress,
) -> Result<(Vec<ComparedRing>, RingComparison), StudyError> {
    let (rings, mut comparison) = compare_all(&remedies.rings, sampling, progress, &LeftOut::of)?;
    let earlier = remedies.left_out.iter().cloned();
    comparison.left_out.splice(0..0, earlier);
    Ok((rings, comparison))
}

/// Name of the task of a comparison.
const TASK: &str = "compare";

/// Results of rings in steady operation with so many draws of balls under the seed of the first case, without
/// histories. A ring of which a run stops is not judged, but the first.
///
/// # Errors
/// Errors of [`compare`].
pub fn in_steady_operation(
    rings: &[(String, CaseFile)],
    draws: u64,
    work: &Work<'_>,
) -> Result<RingComparison, StudyError> {
    let sampling = Sampling::Draws(draws);
    let seed = rings.first().map_or(0, |(_, file)| file.particulars().seed);
    let mut drawn: Vec<CaseFile> = vec![];
    for (_, file) in rings {
        drawn.extend(all_draws(file, sampling, seed)?);
    }
    let count = draws as usize;
    let named = |k: usize| format!("{}, draw {}", rings[k / count].0, k % count + 1);
    // Draws of several rings fill the lanes of a batch; who runs beside whom changes no bit.
    let cases: Vec<Case> = drawn.iter().map(|file| file.case().clone()).collect();
    let groups = batches(&cases);
    let found: Vec<_> = each(&groups)
        .with_max_len(1)
        .map(|members| {
            let block: Vec<&CaseFile> = members.iter().map(|k| &drawn[*k]).collect();
            let found = outcomes(&block, work, &|at| named(members[at]))?;
            Ok(members.iter().copied().zip(found).collect::<Vec<_>>())
        })
        .collect::<Result<_, StudyError>>()?;
    let mut found: Vec<_> = found.into_iter().flatten().collect();
    found.sort_by_key(|(k, _)| *k);
    let mut found = found.into_iter().map(|(_, outcome)| outcome);
    let mut results: Vec<RingResults> = vec![];
    for (k, (name, file)) in rings.iter().enumerate() {
        let of_ring: Vec<_> = found.by_ref().take(count).collect();
        let first = drawn[k * count].case();
        results.push(match of_ring.into_iter().collect::<Result<Vec<_>, _>>() {
            Ok(of_draws) => finished(name, file, first, &of_draws)?,
            Err(StudyError::Stopped { run, stop }) if k > 0 => {
                RingResults::stopped(name, file, format!("{run}: {}", stop.by_key()))
            }
            Err(error) => return Err(error),
        });
    }
    Ok(RingComparison::new(
        &results,
        Draws::of(&rings[0].1, sampling),
    ))
}

/// [`in_steady_operation`] as a task of its own, [`steady_task`].
pub(crate) fn judged_rings(
    rings: &[(String, CaseFile)],
    draws: u64,
    task: &str,
    progress: &dyn Progress,
) -> Result<RingComparison, StudyError> {
    let work = progress.begin(task, steady_task(task, rings, draws)?.steps());
    in_steady_operation(rings, draws, &work)
}

/// Provenance of [`judged_rings`] whose first is `plain`.
pub(crate) fn steady_provenance(plain: &CaseFile) -> Provenance {
    let orbits = plain.steady().transient_orbits;
    let discarded = format!("the first {orbits} orbits of each run");
    provenance(&plain.particulars().title, plain.case(), discarded)
}

/// The task of [`judged_rings`].
pub(crate) fn steady_task(
    name: &str,
    rings: &[(String, CaseFile)],
    draws: u64,
) -> Result<Task, StudyError> {
    with_steady_operation(Task::new(name), rings, draws)
}

/// The task with [`in_steady_operation`] added.
///
/// # Errors
/// A case that cannot be drawn.
pub fn with_steady_operation(
    task: Task,
    rings: &[(String, CaseFile)],
    draws: u64,
) -> Result<Task, StudyError> {
    let mut cases: Vec<Case> = vec![];
    for (_, file) in rings {
        let first = Sampling::Draws(draws).sample(file, 0, 0)?;
        cases.extend((0..draws).map(|_| first.case().clone()));
    }
    let groups = batches(&cases);
    Ok(groups.iter().fold(task, |task, members| {
        let together: Vec<Case> = members.iter().map(|k| cases[*k].clone()).collect();
        let steps = together.iter().map(|case| case.solver.steps()).sum();
        task.with_together(together, steps, groups.len())
    }))
}

/// The task with the runs of a case with every sample side by side.
fn with_samples(
    task: Task,
    file: &CaseFile,
    sampling: Sampling,
    pieces: usize,
) -> Result<Task, StudyError> {
    let (first, count) = (sampling.sample(file, 0, 0)?, sampling.count());
    let (case, together) = (first.case(), count.min(DRAWS) as usize);
    Ok(task.with_batch(case, together, count as f64 * case.solver.steps(), pieces))
}

/// The task of a comparison: each ring once alone, with its histories, and with every draw side by side.
fn task(rings: &[(String, CaseFile)], sampling: Sampling) -> Result<Task, StudyError> {
    let blocks = sampling.count().div_ceil(DRAWS);
    // A ring alone is a piece beside the blocks of others.
    let pieces = rings.len() * (blocks as usize + 1);
    let begun = Ok(Task::new(TASK));
    rings.iter().fold(begun, |task, (_, file)| {
        let alone = file.case();
        let task = task?.with(alone, alone.solver.steps(), pieces);
        with_samples(task, file, sampling, pieces)
    })
}

fn ring(
    name: &str,
    file: &CaseFile,
    sampling: Sampling,
    seed: u64,
    work: &Work<'_>,
) -> Result<ComparedRing, StudyError> {
    let first = sampling.sample(file, seed, 0)?.for_as_long_as(file)?;
    let (record, results) = both(
        || recorded(&first, work),
        || ring_results(name, file, sampling, seed, work),
    );
    Ok(ComparedRing {
        record: record?,
        results: results?,
        file: first,
    })
}

/// Scalar results of a ring with every sample.
fn ring_results(
    name: &str,
    file: &CaseFile,
    sampling: Sampling,
    seed: u64,
    work: &Work<'_>,
) -> Result<RingResults, StudyError> {
    let draws = all_draws(file, sampling, seed)?;
    // A block for each thread; who runs beside whom changes no bit.
    let blocks = groups_of(&draws, DRAWS as usize).enumerate();
    let found = blocks.map(|(k, block)| {
        let first = k * DRAWS as usize;
        let named = |at: usize| format!("{name}, draw {}", first + at + 1);
        let block: Vec<&CaseFile> = block.iter().collect();
        outcomes(&block, work, &named)?.into_iter().collect()
    });
    let found = found.collect::<Result<Vec<Vec<_>>, _>>()?;
    let drawn: Vec<DrawOutcome> = found.into_iter().flatten().collect();
    finished(name, file, draws[0].case(), &drawn)
}

/// A case with every sample.
fn all_draws(file: &CaseFile, sampling: Sampling, seed: u64) -> Result<Vec<CaseFile>, CaseError> {
    let numbers = 0..sampling.count();
    numbers
        .map(|draw| sampling.sample(file, seed, draw))
        .collect()
}

/// Results of a ring from what came out with its draws, of which `first` is the first.
fn finished(
    name: &str,
    file: &CaseFile,
    first: &Case,
    drawn: &[DrawOutcome],
) -> Result<RingResults, StudyError> {
    let verdicts: Vec<RunVerdict> = drawn.iter().map(|d| d.verdict.clone()).collect();
    let verdict = RunVerdict::of_starts(first, &verdicts);
    let blocks: Vec<&[SteadyBlock]> = drawn.iter().map(|d| d.blocks.as_slice()).collect();
    let at_rest = at_rest(file)?;
    let values = drawn
        .iter()
        .map(|d| [d.values.clone(), at_rest.clone()].concat());
    let values: Vec<Values> = values.collect();
    Ok(RingResults::of_draws(name, file, &values, verdict.into())
        .settled_by(Stationarity::all(&blocks)))
}

/// Results at rest that the number of balls changes.
fn at_rest(file: &CaseFile) -> Result<Values, StudyError> {
    let settled = settle(file.case())?;
    let solved = Solved::new(file.case(), file.particulars(), &settled);
    let results = Results::of(STATIC, Subject::Static(&solved));
    let values = results
        .iter()
        .filter(|(q, _)| ring_results::AT_REST.contains(&q.name));
    let values = values.filter_map(|(q, cell)| Some((q.name, cell.number()?)));
    Ok(values.collect())
}

/// The run with the first draw and its histories.
fn recorded(file: &CaseFile, work: &Work<'_>) -> Result<RunRecord, StudyError> {
    let mut rows = ();
    let options = Options {
        rows: Some(&mut rows),
        verify: false,
    };
    let record = run(file, options, &Part(work))?;
    let _ = work.add(file.case().solver.steps());
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

/// Recorders of the run with one draw: scalar results, steady operation and vibration.
struct DrawRecorder {
    run: RunRecorder,
    steady: SteadyRecorder,
    vibration: Option<VibrationRecorder>,
}

impl Record for DrawRecorder {
    fn observers<'s>(&'s mut self, case: &'s Case) -> Vec<Box<dyn Observer + 's>> {
        let mut observers = self.run.observers(case);
        observers.push(Lent::of(&mut self.steady));
        if let Some(vibration) = &mut self.vibration {
            observers.push(Lent::of(vibration));
        }
        observers
    }
}

/// Scalar results of a run by name.
type Values = Vec<(&'static str, f64)>;

/// Outcome of the run with one draw.
struct DrawOutcome {
    values: Values,
    verdict: RunVerdict,
    blocks: Vec<SteadyBlock>,
}

/// Outcomes with each draw of a block, side by side.
///
/// # Errors
/// The progress ended the work.
fn outcomes(
    block: &[&CaseFile],
    work: &Work<'_>,
    named: &dyn Fn(usize) -> String,
) -> Result<Vec<Result<DrawOutcome, StudyError>>, StudyError> {
    let cases: Vec<Case> = block.iter().map(|file| file.case().clone()).collect();
    let record = |case: &Case| DrawRecorder {
        run: RunRecorder::new(case),
        steady: SteadyRecorder::new(),
        vibration: (case.housing.as_ref())
            .map(|housing| VibrationRecorder::new(housing, SAMPLING_HZ, transient_s(case))),
    };
    let duration_s = cases[0].solver.duration_s;
    let steps = cases[0].solver.steps();
    let control = |runs: usize| work.run_control(duration_s, runs as f64 * steps);
    let runs = run_together(&cases, record, control).ok_or(StudyError::Interrupted)?;
    let outcomes = runs.into_iter().zip(&cases).enumerate();
    let outcomes = outcomes.map(|(k, (run, case))| {
        let (recorder, outcome) = run?;
        StudyError::unless_complete(&outcome.ending).map_err(|e| e.in_run(|| named(k)))?;
        let (results, verdict) = (recorder.run).finished(case, &outcome, |run| {
            (Results::of(RUN, Subject::Run(run)), run.verdict.clone())
        });
        let blocks = recorder.steady.blocks.to_vec();
        let force_n = recorder.steady.transient_force_max_n;
        let steady = SteadySummary::new(&case.bearing, &blocks, force_n);
        let mut results = results.and(Results::of(STEADY, Subject::Steady(&steady)));
        if let Some(vibration) = &recorder.vibration {
            let rms_m_s2 = vibration.measurements()[1].rms();
            results = results.and(Results::of(COMPARED, Subject::Vibration(&rms_m_s2)));
        }
        let values = results.iter();
        let values = values.filter_map(|(quantity, cell)| Some((quantity.name, cell.number()?)));
        Ok(DrawOutcome {
            values: values.collect(),
            verdict,
            blocks,
        })
    });
    Ok(outcomes.collect())
}

#[cfg(test)]
mod tests {
    use cageless_io::case_file::template;

    use super::*;
    use crate::progress::Silent;

    /// Between six balls in a queue the ring falls: that remedy is named with its reason, the others are compared. The
    /// first, with which they are compared, is indispensable.
    #[test]
    fn a_remedy_that_cannot_run_is_left_out() {
        let sets = ["steady.transient_orbits=2", "steady.measured_orbits=2"].map(str::to_owned);
        let plain = CaseFile::parse(&template(true), "case", &sets).unwrap();
        let ring = |balls: usize| {
            let name = format!("plain, {balls} balls");
            (name, plain.with_balls(balls).unwrap())
        };
        let earlier = LeftOut {
            name: "plain, 2 balls".to_owned(),
            why: "too few".to_owned(),
        };
        let remedies = Remedies {
            rings: vec![ring(14), ring(6), ring(13)],
            left_out: vec![earlier.clone()],
        };
        let (rings, found) = compare_remedies(&remedies, Sampling::Draws(2), &Silent).unwrap();
        assert_eq!(found.runs, ["plain, 14 balls", "plain, 13 balls"]);
        assert_eq!(rings.len(), 2);
        let [first, six] = &found.left_out[..] else {
            panic!("{:?}", found.left_out)
        };
        assert_eq!((first, six.name.as_str()), (&earlier, "plain, 6 balls"));
        assert!(
            six.why.contains("the inner ring fell between the balls"),
            "{six:?}"
        );
        assert!(!six.why.contains("To change"), "{six:?}");
        let remedies = Remedies {
            rings: vec![ring(6), ring(14)],
            left_out: vec![],
        };
        assert!(compare_remedies(&remedies, Sampling::Draws(2), &Silent).is_err());
    }
}
