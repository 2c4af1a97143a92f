//! Outcome of the drop of a rotor: impacts, whirl, spin-up, loads, heat and the state at the
//! end.
//!
//! ```
//! use cageless::reference;
//! use cageless::simulation::{Control, run};
//! use cageless::touchdown::{DropRecorder, EndState};
//!
//! let mut case = reference::rotor_drop(); // 20 kg at 30 000 rpm, 0.2 mm above the inner ring
//! case.solver.duration_s = 0.002; // it falls for 6.4 ms
//! let mut drop = DropRecorder::new();
//! let outcome = run(&case, &mut [&mut drop], &mut |_| Control::Continue(()))?;
//! let summary = drop.summary(&outcome.state);
//! assert_eq!(summary.end_state, EndState::Falling);
//! assert_eq!(summary.impacts, 0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod end_state;
mod heat;
mod limit;
mod recorder;
mod scatter;
mod spin_down;
mod thermal;
mod whirl;

pub use end_state::EndState;
pub use heat::{EndPower, InterfaceHeat};
pub use limit::{Limit, LimitSide};
pub use recorder::{DropRecorder, DropSummary, JUDGED_AFTER_S, LAST};
pub use scatter::{Drawn, DrawnBearing, Scatter};
pub use spin_down::{Brake, SpinDown};
pub use thermal::{PARTS, STEEL_SPECIFIC_HEAT_J_KG_K, Thermal};
pub use whirl::{Whirl, WhirlWindow};
