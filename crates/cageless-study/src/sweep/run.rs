//! A sweep into a file: resumed where it was left, complete at its end.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_io::results::Row;

use super::collection::Collection;
use super::error::SweepError;
use super::evaluate::Sweep;
use super::index_set::Shard;
use super::worker_pool::compute;

/// Computations and output of a sweep.
#[derive(Debug, Clone)]
pub struct Job {
    /// The file of the result; `FILE.parts` beside it holds what is not complete.
    pub result: PathBuf,
    /// The part of the sweep to compute; all of it if `None`.
    pub shard: Option<Shard>,
    /// Threads, [`THREADS_MAX`](crate::THREADS_MAX) at most; as many as there are cores if `None`.
    pub threads: Option<NonZeroUsize>,
}

/// Progress of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Variants of this job.
    pub total: u64,
    /// Computed, by earlier calls as well.
    pub done: u64,
    /// Computed by this call.
    pub done_now: u64,
    /// Time since this call began.
    pub elapsed: Duration,
}

impl Progress {
    /// Variants per second, in this call.
    pub fn rate(&self) -> f64 {
        self.done_now as f64 / self.elapsed.as_secs_f64().max(1e-9)
    }

    /// Fraction done of what was left for this call.
    pub fn fraction(&self) -> f64 {
        self.done_now as f64 / (self.total - self.done + self.done_now) as f64
    }
}

/// Ending of a call.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Done {
    /// Whether the result is there; otherwise the caller stopped it.
    pub complete: bool,
    /// Progress at the end of the call.
    pub progress: Progress,
}

/// Flush interval as a fraction of elapsed time.
const SHARE: u32 = 20;
/// Shortest flush interval.
const OFTEN: Duration = Duration::from_millis(100);
/// Longest flush interval.
const SELDOM: Duration = Duration::from_secs(30);
/// Rows that wait in memory at most.
const WAITING_MAX: usize = 65_536;

/// Computes a sweep, or what is missing of it. `watch` gets the progress ten times a
/// second and cancels with `Break(())`; what was computed is kept.
///
/// # Errors
/// There are too many threads, or the result or the work folder belongs to another plan or is
/// in use, or cannot be written to.
pub fn run(
    sweep: &Sweep,
    job: &Job,
    mut watch: impl FnMut(&Progress) -> Control,
) -> Result<Done, SweepError> {
    let started = Instant::now();
    // Of its own: the thread of the caller waits here, which no worker may do.
    let pool = crate::pool(job.threads)?;
    let collection = Collection::open(sweep, &job.result, job.shard)?;
    let missing = collection.missing()?;
    let left: u64 = missing.iter().map(|r| r.end - r.start).sum();
    let mut progress = Progress {
        total: collection.total(),
        done: collection.total() - left,
        done_now: 0,
        elapsed: Duration::ZERO,
    };
    let mut waiting: Vec<Row> = Vec::new();
    let mut put_away = Instant::now();
    let worked = compute(sweep, missing, &pool, |rows| {
        progress.done += rows.len() as u64;
        progress.done_now += rows.len() as u64;
        progress.elapsed = started.elapsed();
        waiting.extend(rows);
        let due = (progress.elapsed / SHARE).clamp(OFTEN, SELDOM);
        if waiting.len() >= WAITING_MAX || put_away.elapsed() >= due {
            collection.keep(std::mem::take(&mut waiting))?;
            put_away = Instant::now();
        }
        Ok(watch(&progress))
    });
    worked?;
    collection.keep(waiting)?;
    progress.elapsed = started.elapsed();
    Ok(Done {
        complete: collection.finish()?,
        progress,
    })
}
