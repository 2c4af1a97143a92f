//! Threads of a study's own.

use std::num::NonZeroUsize;

use crate::error::StudyError;

/// More threads than any machine has cores only wait for each other.
pub const THREADS_MAX: usize = 1024;

/// Does `work` on so many threads of its own, [`THREADS_MAX`] at most; on as many as there are
/// cores if `None`.
///
/// # Errors
/// [`StudyError::Input`] if there are too many, [`StudyError::Threads`] if they cannot be
/// started.
pub fn on_threads<T: Send>(
    threads: Option<NonZeroUsize>,
    work: impl FnOnce() -> T + Send,
) -> Result<T, StudyError> {
    let threads = threads.map_or(0, NonZeroUsize::get);
    if threads > THREADS_MAX {
        return Err(StudyError::Input(format!(
            "threads = {threads} is not possible: 1 to {THREADS_MAX} are"
        )));
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| StudyError::Threads(error.to_string()))?;
    Ok(pool.install(work))
}
