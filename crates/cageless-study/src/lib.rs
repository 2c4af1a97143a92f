//! Studies of a case: analyses that take one run or many, on all threads of the rayon pool
//! that they are called from, with their results in display units. Results have the same bits on any number of threads.
//!
//! [`run`] records one run, [`verification`] says how far the numbers of a run can be trusted, [`design`] judges a
//! raceway, [`search`] finds the best one, [`tolerance`] gives the probability that it passes
//! as made, [`comparison`] sets rings side by side from the same uneven starts, [`sweep`] computes many variants of a case. A [`Progress`] follows the progress and can end the work.

mod axial;
pub mod benefit_search;
pub mod comparison;
pub mod design;
pub mod drop;
mod entered;
mod error;
mod histories;
mod interruption;
pub mod measured;
mod parameter;
mod passages;
mod progress;
pub mod ring_path;
pub mod run;
pub mod search;
pub mod sheet;
mod structure;
mod summary;
pub mod sweep;
mod task;
pub mod threads;
mod together;
pub mod tolerance;
pub mod toleranced_benefit;
pub mod verification;
mod warnings;

pub use cageless_results::{Provenance, provenance};
pub use design::DesignResult;
pub use entered::{entered, raceway_section, reshaped, turned, with_raceways};
pub use error::StudyError;
pub use histories::{CollisionPoint, Histories, RunHistories, SAMPLING_HZ};
pub use interruption::break_if;
pub use parameter::{Parameter, lines, parameter, parameters};
pub use passages::Passages;
pub use progress::{Expected, Progress, Silent, Work, Workload, time_left};
pub use structure::RacewayLabel;
pub use summary::RunSummary;
pub use task::{Task, about};
pub use threads::{THREADS_MAX, check_environment, on_threads, pool};
pub use warnings::of_case as case_warnings;
