//! Threads of a study's own.

use std::num::NonZeroUsize;

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
