//! Threads of studies: the only place that starts any, or one thread where none can be started.

use std::error::Error;
use std::num::NonZeroUsize;
use std::sync::OnceLock;

use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator};
use rayon::slice::ParallelSlice;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::error::StudyError;

/// More threads than any machine has cores only wait for each other.
pub const THREADS_MAX: usize = 1024;

/// The variables that say how many threads there are where nothing else does.
const VARIABLES: [&str; 2] = ["RAYON_NUM_THREADS", "RAYON_RS_NUM_CPUS"];

/// Refuses an environment that asks for more than [`THREADS_MAX`] threads, which rayon would
/// start, or for what is no whole number, which it would ignore.
///
/// # Errors
/// [`StudyError::Input`] with the variable.
pub fn check_environment() -> Result<(), StudyError> {
    for name in VARIABLES {
        let Ok(value) = std::env::var(name) else {
            continue;
        };
        // Rayon would ignore what is no whole number; an empty text and 0 are as good as none.
        let threads = if value.is_empty() {
            Ok(0)
        } else {
            value.parse()
        };
        if threads.map_or(true, |threads: usize| threads > THREADS_MAX) {
            return Err(StudyError::Input(format!(
                "the environment variable {name} = {value} is not possible: 1 to {THREADS_MAX} are"
            )));
        }
    }
    Ok(())
}

/// So many threads, [`THREADS_MAX`] at most; as many as the environment says, or else as there are
/// cores, if `None`.
///
/// # Errors
/// [`StudyError::Input`] if there are too many, [`StudyError::Threads`] if they cannot be
/// started.
pub fn pool(threads: Option<NonZeroUsize>) -> Result<ThreadPool, StudyError> {
    let threads = threads.map_or(0, NonZeroUsize::get);
    if threads > THREADS_MAX {
        return Err(StudyError::Input(format!(
            "threads = {threads} is not possible: 1 to {THREADS_MAX} are"
        )));
    }
    if threads == 0 {
        check_environment()?;
    }
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| StudyError::threads(&error))
}

/// Does `work` on a [`pool`] of its own.
///
/// # Errors
/// Those of [`pool`].
pub fn on_threads<T: Send>(
    threads: Option<NonZeroUsize>,
    work: impl FnOnce() -> T + Send,
) -> Result<T, StudyError> {
    Ok(pool(threads)?.install(work))
}

/// Makes sure that work in parallel from this thread has threads. Where the system starts none, as under a limit of
/// processes, this thread does all work itself.
fn ready() {
    static STARTED: OnceLock<bool> = OnceLock::new();
    if rayon::current_thread_index().is_some() {
        return;
    }
    let started = STARTED.get_or_init(|| {
        let built = ThreadPoolBuilder::new().build_global();
        // Without a cause of the system there are threads already.
        built.map_or_else(|error| error.source().is_none(), |()| true)
    });
    if !started {
        let alone = ThreadPoolBuilder::new().num_threads(1).use_current_thread();
        // It starts no thread.
        let _ = alone.build();
    }
}

/// Items that are worked on in parallel.
pub fn each<T: Sync>(items: &[T]) -> rayon::slice::Iter<'_, T> {
    ready();
    items.par_iter()
}

/// Items that are worked on in parallel and used up.
pub fn each_of<I: IntoParallelIterator>(items: I) -> I::Iter {
    ready();
    items.into_par_iter()
}

/// Groups of so many items that are worked on in parallel.
pub fn groups_of<T: Sync>(items: &[T], count: usize) -> rayon::slice::Chunks<'_, T> {
    ready();
    items.par_chunks(count)
}

/// Two pieces of work in parallel.
pub fn both<A: Send, B: Send>(
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    ready();
    rayon::join(one, other)
}

/// Pieces of work in parallel that are begun in the order in which they are spawned.
pub fn in_order<'s, T: Send>(work: impl FnOnce(&rayon::ScopeFifo<'s>) -> T + Send) -> T {
    ready();
    rayon::scope_fifo(work)
}

/// Work on all threads at once, each the same.
pub fn on_each<T: Send>(work: impl Fn() -> T + Sync) -> Vec<T> {
    ready();
    rayon::broadcast(|_| work())
}

/// Number of threads that work in parallel.
pub fn count() -> usize {
    ready();
    rayon::current_num_threads()
}
