//! A sweep into a file: resumed where it was left, complete at its end.

use std::num::NonZeroUsize;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_io::results::Row;
use rayon::ThreadPool;
use rayon::prelude::*;

use super::collection::Collection;
use super::evaluate::Sweep;
use super::shard::Shard;
use crate::StudyError;
use crate::interruption::break_if;

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

/// Interval between progress reports.
const TICK: Duration = Duration::from_millis(100);
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
    watch: impl FnMut(&Progress) -> Control,
) -> Result<Done, StudyError> {
    run_announced(sweep, job, None::<fn(f64, usize)>, watch)
}

/// [`run`], with the time, in s, that it takes on so many threads for `expects` before it starts.
///
/// # Errors
/// Those of [`run`].
pub fn run_announced(
    sweep: &Sweep,
    job: &Job,
    expects: Option<impl FnOnce(f64, usize)>,
    mut watch: impl FnMut(&Progress) -> Control,
) -> Result<Done, StudyError> {
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
    if let Some(expects) = expects.filter(|_| left > 0) {
        expects(sweep.expected_s(left, &pool), pool.current_num_threads());
    }
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

/// Computes `missing` on the threads of `pool`; `take` gets the rows as they come, and now
/// and then none; `Break(())` cancels. Its error stops the work as well.
fn compute(
    sweep: &Sweep,
    missing: Vec<Range<u64>>,
    pool: &ThreadPool,
    mut take: impl FnMut(Vec<Row>) -> Result<Control, StudyError>,
) -> Result<(), StudyError> {
    let stop = AtomicBool::new(false);
    let stopped = || break_if(stop.load(Ordering::Relaxed));
    let (sender, receiver) = sync_channel(4 * pool.current_num_threads());
    let batches = missing
        .into_iter()
        .flat_map(|range| batches(range, sweep.batch()));
    pool.in_place_scope(|scope| {
        scope.spawn(|_| {
            // Ends early where it is stopped, or nobody receives any longer.
            let _ = batches
                .par_bridge()
                .try_for_each_with(sender, |sender, range| {
                    sender.send(sweep.evaluate(range, &stopped)?).ok()
                });
        });
        let mut collect = || {
            loop {
                let rows = match receiver.recv_timeout(TICK) {
                    Ok(rows) => rows,
                    Err(RecvTimeoutError::Timeout) => Vec::new(),
                    Err(RecvTimeoutError::Disconnected) => return Ok(()),
                };
                if take(rows)?.is_break() {
                    // What is under way in the channel is not lost.
                    stop.store(true, Ordering::Relaxed);
                }
            }
        };
        let done = collect();
        stop.store(true, Ordering::Relaxed);
        // Nobody must wait for room in the channel.
        receiver.iter().for_each(drop);
        done
    })
}

/// A range in pieces of `size` and a rest.
fn batches(range: Range<u64>, size: u64) -> impl Iterator<Item = Range<u64>> {
    let starts = range.clone().step_by(size as usize);
    starts.map(move |start| start..range.end.min(start + size))
}
