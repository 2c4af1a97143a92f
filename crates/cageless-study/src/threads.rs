//! Threads of a study's own.

use std::num::NonZeroUsize;

use crate::error::StudyError;

/// Does `work` on so many threads of its own; on as many as there are cores if `None`.
///
/// # Errors
/// [`StudyError::Threads`] if they cannot be started.
pub fn on_threads<T: Send>(
    threads: Option<NonZeroUsize>,
    work: impl FnOnce() -> T + Send,
) -> Result<T, StudyError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.map_or(0, NonZeroUsize::get))
        .build()
        .map_err(|error| StudyError::Threads(error.to_string()))?;
    Ok(pool.install(work))
}
