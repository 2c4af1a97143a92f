//! Runs the batches of a search on all threads and keeps a journal.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use cageless::Case;
use cageless::numerics::BATCH_WIDTH;
use cageless_design::search::{
    Interrupted, Job, Motion, Numbers, Outcome, PairSeparation, Stage, run_jobs,
};
use cageless_io::case_file::CaseFile;
use cageless_io::journal::{Entry, Journal};
use cageless_io::results::VERSION;
use rayon::prelude::*;

use crate::error::StudyError;
use crate::progress::{Progress, Work};
use crate::threads::{count, each};

/// Name of the journal in the folder of a search.
pub const JOURNAL: &str = "search.journal";
/// Name of the task of a stage.
pub fn task_name(stage: Stage) -> String {
    format!("search: {}", stage.name())
}

/// Runner of the jobs of a search, with its journal.
pub struct TaskRunner<'c> {
    case: &'c Case,
    progress: &'c dyn Progress,
    known: HashMap<String, Outcome>,
    journal: Option<(Mutex<Journal>, PathBuf)>,
    write_error: Mutex<Option<std::io::Error>>,
}

impl<'c> TaskRunner<'c> {
    /// Opens the journal in the folder, if there is one, and takes over what it holds.
    pub fn new(
        file: &'c CaseFile,
        out: Option<&Path>,
        progress: &'c dyn Progress,
    ) -> Result<Self, StudyError> {
        let mut runner = Self {
            case: file.case(),
            progress,
            known: HashMap::new(),
            journal: None,
            write_error: Mutex::new(None),
        };
        let Some(dir) = out else { return Ok(runner) };
        std::fs::create_dir_all(dir).map_err(|error| StudyError::folder(dir, error))?;
        let path = dir.join(JOURNAL);
        let owner = format!(
            "cageless {VERSION} design --search\n{}",
            file.document_as_run().to_toml()?
        );
        let (journal, entries) = Journal::open(&path, &owner)?;
        runner.known = entries
            .into_iter()
            .filter_map(|(key, entry)| Some((key.clone(), outcome(&key, entry)?)))
            .collect();
        runner.journal = Some((Mutex::new(journal), path));
        Ok(runner)
    }

    /// Runs what is not known yet, in any order; the outcomes come in that of the jobs.
    pub fn execute(&mut self, stage: Stage, jobs: &[Job]) -> Result<Vec<Outcome>, Interrupted> {
        let keys: Vec<String> = jobs.iter().map(Job::key).collect();
        let mut seen = HashSet::new();
        let todo: Vec<usize> = (0..jobs.len())
            .filter(|&k| !self.known.contains_key(&keys[k]) && seen.insert(&keys[k]))
            .collect();
        let steps = |job: &Job| job.expected(self.case).map_or(0.0, |(_, steps)| steps);
        let steps: HashMap<usize, f64> = todo.iter().map(|&k| (k, steps(&jobs[k]))).collect();
        let all = todo.iter().map(|k| steps[k]).sum();
        let progress = self.progress.begin(&task_name(stage), all);
        let this = &*self;
        let groups = groups(jobs, &todo, count());
        let done: Vec<Vec<Option<Outcome>>> = each(&groups)
            .with_max_len(1)
            .map(|group| {
                let together: Vec<(&Job, &str)> = group
                    .iter()
                    .map(|&k| (&jobs[k], keys[k].as_str()))
                    .collect();
                let done = this.several(&together, &progress);
                let _ = progress.add(group.iter().map(|k| steps[k]).sum());
                done
            })
            .collect();
        drop(progress);
        for (&k, outcome) in groups.iter().flatten().zip(done.into_iter().flatten()) {
            self.known
                .insert(keys[k].clone(), outcome.ok_or(Interrupted)?);
        }
        keys.iter()
            .map(|key| self.known.get(key).cloned().ok_or(Interrupted))
            .collect()
    }

    /// Outcomes of jobs that are done together, those of the journal included.
    fn several(&self, jobs: &[(&Job, &str)], progress: &Work<'_>) -> Vec<Option<Outcome>> {
        if progress.interrupted() || self.failed() {
            return vec![None; jobs.len()];
        }
        let together: Vec<&Job> = jobs.iter().map(|(job, _)| *job).collect();
        let outcomes = run_jobs(self.case, &together, &mut |_| progress.control());
        let pairs = jobs.iter().zip(outcomes);
        pairs
            .map(|((_, key), outcome)| self.noted(key, outcome?))
            .collect()
    }

    /// The outcome, once it stands in the journal.
    fn noted(&self, key: &str, outcome: Outcome) -> Option<Outcome> {
        if let Some((journal, _)) = &self.journal {
            let written = lock(journal).add(key, &entry(&outcome));
            if let Err(error) = written {
                lock(&self.write_error).get_or_insert(error);
                return None;
            }
        }
        Some(outcome)
    }

    fn failed(&self) -> bool {
        lock(&self.write_error).is_some()
    }

    /// Whether the journal could be written.
    pub fn check(&self) -> Result<(), StudyError> {
        match (lock(&self.write_error).take(), &self.journal) {
            (Some(source), Some((_, path))) => Err(StudyError::Journal {
                path: path.clone(),
                source,
            }),
            _ => Ok(()),
        }
    }
}

/// No thread panics while it holds one of these.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// The jobs to do, those together that are quicker so, without leaving a thread idle.
fn groups(jobs: &[Job], todo: &[usize], threads: usize) -> Vec<Vec<usize>> {
    let (shared, alone): (Vec<usize>, Vec<usize>) =
        todo.iter().copied().partition(|&k| jobs[k].is_shared());
    let rounds = shared.len().div_ceil(BATCH_WIDTH * threads).max(1);
    let size = shared.len().div_ceil(rounds * threads).max(1);
    let alone = alone.into_iter().map(|k| vec![k]);
    alone
        .chain(shared.chunks(size).map(<[usize]>::to_vec))
        .collect()
}

fn entry(outcome: &Outcome) -> Entry {
    outcome.clone().map(|numbers| match numbers {
        Numbers::PairSeparation(s) => vec![s.critical_gap_rad, s.shortfall, s.stress_pa],
        Numbers::Motion(m) => m.values().to_vec(),
        Numbers::AxialLag(lag_rad) => vec![lag_rad],
    })
}

/// The inverse of [`entry`]; the number of values tells what they are.
fn outcome(key: &str, entry: Entry) -> Option<Outcome> {
    let values = match entry {
        Ok(values) => values,
        Err(reason) => return Some(Err(reason)),
    };
    if key.starts_with("axial") {
        let [lag_rad] = values.try_into().ok()?;
        Some(Ok(Numbers::AxialLag(lag_rad)))
    } else if key.starts_with("spacing") {
        let [critical_gap_rad, shortfall, stress_pa] = values.try_into().ok()?;
        Some(Ok(Numbers::PairSeparation(PairSeparation {
            critical_gap_rad,
            shortfall,
            stress_pa,
        })))
    } else {
        let values = values.try_into().ok()?;
        Some(Ok(Numbers::Motion(Motion::from_values(values))))
    }
}
