//! Time integration of a case, with observers.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, Ending, run};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! let outcome = run(&case, &mut [], &mut |_| Control::Continue(()))?;
//! assert!(matches!(outcome.ending, Ending::Complete));
//! assert!(outcome.energy_residual_relative.abs() < 1e-3);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod advice;
mod batch;
mod drop_outcome;
mod front;
mod guard;
mod observer;
mod outcome;
mod rotor_drop;
mod run;
mod run_tracker;
mod views;
mod watch;

pub use crate::control::Control;
pub use crate::dynamics::plane_path::PlaneDisplacement;
pub use batch::{batches, run_batch};
pub use drop_outcome::{RotorDropOutcome, RotorOutcome};
pub use front::{Simulation, run};
pub use guard::{Cause, Stop};
pub(crate) use observer::BallAngle;
pub use observer::{Observer, ObserverError, RunContext, StepView, each_step};
pub use outcome::{Ending, RESIDUAL_FRACTION, RunOutcome};
pub use rotor_drop::RotorDrop;
pub use run::steps_of_thread;
pub use views::{BallView, RingView, RotorView};
