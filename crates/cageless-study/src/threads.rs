//! Threads of a study's own.

use std::num::NonZeroUsize;

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::error::StudyError;

/// More threads than any machine has cores only wait for each other.
pub const THREADS_MAX: usize = 1024;

/// So many threads, [`THREADS_MAX`] at most; as many as there are cores if `None`.
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
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| StudyError::Threads(error.to_string()))
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
