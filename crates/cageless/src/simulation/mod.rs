//! A run: the equations of a case, advanced and watched.

mod course;
mod ensemble;
mod guard;
mod observer;
mod run;

pub use ensemble::{batches, run_batch};
pub use guard::{Cause, Stop};
pub use observer::{Observer, ObserverError, Scene, View};
pub use run::{Control, Ending, RunOutcome, run, run_from};
