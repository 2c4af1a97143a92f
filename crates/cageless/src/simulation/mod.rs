//! Time integration of a case, with observers.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::simulation::{Control, Ending, run};
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//! let outcome = run(&case, &mut [], &mut |_| Control::Continue(()))?;
//! assert!(matches!(outcome.ending, Ending::Complete));
//! assert!(outcome.energy_residual_relative.abs() < 1e-3);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod batch;
mod guard;
mod observer;
mod outcome;
mod rotor_drop;
mod run;
mod run_tracker;

pub use crate::control::Control;
pub use crate::dynamics::plane_path::PlanePath;
pub use crate::dynamics::rotor_on_bearings::PlaneDisplacement;
pub use batch::{batches, run_batch};
pub use guard::{Cause, Stop};
pub(crate) use observer::BallAngle;
pub use observer::{Observer, ObserverError, RunContext, StepView};
pub use outcome::{Ending, RESIDUAL_FRACTION, RunOutcome};
pub use rotor_drop::{RotorDrop, RotorDropOutcome, RotorOutcome};
pub use run::{run, run_from, steps_of_thread};
