//! Time integration of a case, with observers.

mod batch;
mod guard;
mod observer;
mod run;
mod run_tracker;

pub use batch::{batches, run_batch};
pub use guard::{Cause, Stop};
pub use observer::{Observer, ObserverError, RunContext, StepView};
pub use run::{Control, Ending, RunOutcome, run, run_from};
