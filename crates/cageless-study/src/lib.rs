//! Studies of one case: what takes many runs of a bearing, done on all threads of the rayon
//! pool that they are called from. Results have the same bits on any number of threads.
//!
//! [`verification`] says how far the numbers of a run can be trusted, [`design`] judges a
//! raceway, [`search`] finds the best one, [`tolerance`] gives the probability that it passes
//! as made, [`sweep`] computes many variants of a case. A [`Watcher`] follows the progress and can end the work.

pub mod design;
mod entered;
mod error;
pub mod paper;
pub mod search;
pub mod sweep;
mod threads;
pub mod tolerance;
pub mod verification;
mod watcher;

pub use error::StudyError;
pub use threads::{THREADS_MAX, check_environment, on_threads, pool};
pub use watcher::{Silent, Watcher, Work};
