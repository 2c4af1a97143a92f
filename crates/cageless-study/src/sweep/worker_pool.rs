//! The threads that compute a sweep.

use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use cageless::simulation::Control;
use cageless_io::results::Row;
use rayon::ThreadPool;

use super::error::SweepError;
use super::evaluate::Sweep;
use crate::progress::break_if;

/// Time that a batch should take: long against handing it over, short against the sweep.
const BATCH: Duration = Duration::from_millis(50);
/// Most variants of a batch.
const BATCH_MAX: u64 = 1024;
/// Interval between progress reports.
const TICK: Duration = Duration::from_millis(100);

/// Variants that are still to be handed out.
struct Queue {
    ranges: VecDeque<Range<u64>>,
    batch: u64,
    /// Least size of a batch.
    together: u64,
}

impl Queue {
    fn next(&mut self) -> Option<Range<u64>> {
        let range = self.ranges.front_mut()?;
        let end = range.end.min(range.start + self.batch);
        let batch = range.start..end;
        range.start = end;
        if range.is_empty() {
            self.ranges.pop_front();
        }
        Some(batch)
    }

    /// Sizes the next batches by what this one took.
    fn took(&mut self, variants: u64, time: Duration) {
        let ideal = variants as f64 * BATCH.as_secs_f64() / time.as_secs_f64().max(1e-9);
        // Not more than twice at once: the next may be slower.
        let ideal = ideal.min(2.0 * self.batch as f64);
        self.batch = (ideal as u64).clamp(self.together, BATCH_MAX);
    }
}

/// Computes `missing` on the threads of `pool`; `take` gets the rows as they come, and now
/// and then none; `Break(())` cancels. Its error stops the work as well.
pub(crate) fn compute(
    sweep: &Sweep,
    missing: Vec<Range<u64>>,
    pool: &ThreadPool,
    mut take: impl FnMut(Vec<Row>) -> Result<Control, SweepError>,
) -> Result<(), SweepError> {
    let queue = Mutex::new(Queue {
        ranges: missing.into(),
        batch: sweep.together(),
        together: sweep.together(),
    });
    let stop = AtomicBool::new(false);
    let (sender, receiver) = sync_channel(4 * pool.current_num_threads());
    pool.in_place_scope(|scope| {
        for _ in 0..pool.current_num_threads() {
            let (queue, stop, sender) = (&queue, &stop, sender.clone());
            scope.spawn(move |_| one_thread(sweep, queue, stop, &sender));
        }
        drop(sender);
        let done = collect(&receiver, &stop, &mut take);
        stop.store(true, Ordering::Relaxed);
        // Nobody must wait for room in the channel.
        receiver.iter().for_each(drop);
        done
    })
}

fn one_thread(
    sweep: &Sweep,
    queue: &Mutex<Queue>,
    stop: &AtomicBool,
    sender: &SyncSender<Vec<Row>>,
) {
    let lock = || queue.lock().unwrap_or_else(|broken| broken.into_inner());
    let stopped = || break_if(stop.load(Ordering::Relaxed));
    while stopped().is_continue() {
        let Some(range) = lock().next() else {
            return;
        };
        let (variants, started) = (range.end - range.start, Instant::now());
        let Some(rows) = sweep.evaluate(range, &stopped) else {
            return;
        };
        lock().took(variants, started.elapsed());
        if sender.send(rows).is_err() {
            return;
        }
    }
}

fn collect(
    receiver: &Receiver<Vec<Row>>,
    stop: &AtomicBool,
    take: &mut impl FnMut(Vec<Row>) -> Result<Control, SweepError>,
) -> Result<(), SweepError> {
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
}
