//! Motion beside the balls, written once for plane and space: bodies and the joints between them.
//!
//! A body in the plane is the one in space with coordinates held: its table has all of them.
//!
//! ```
//! use cageless::initial_state;
//! use cageless::reference;
//!
//! let (state, _angles) = initial_state(&reference::rotor_drop())?;
//! let speed_rad_s = state.rotor_speed_rad_s().unwrap();
//! assert!((speed_rad_s - 3141.6).abs() < 0.1); // 30 000 rpm
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

pub(crate) mod body;
pub(crate) mod joint;
pub(crate) mod step_change;
pub(crate) mod under_rotor;
