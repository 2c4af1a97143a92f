//! The equations of motion, Zhao 2022, Eq. (12) to (22), in both formulations: bodies, state,
//! energy, and the right-hand side over them.
//!
//! ```
//! use cageless::dynamics::{Model, RightHandSide};
//! use cageless::initial_state;
//! use cageless::integrator::System;
//! use cageless::reference::Structure;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! let equations = RightHandSide::new(&Model::new(&case)?);
//! let (state, _angles) = initial_state(&case)?;
//! assert_eq!(equations.dimension(), state.values().len());
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod contacts;
pub(crate) mod coordinates;
pub(crate) mod energy;
pub(crate) mod layout;
pub(crate) mod model;
pub(crate) mod plane_path;
mod right_hand_side;
pub(crate) mod space;
pub(crate) mod state;
mod stored_energy;
pub(crate) mod world;

pub use coordinates::RingCoordinate;
pub use energy::EnergyTerm;
pub use layout::Layout;
pub use state::State;

pub use crate::simd::InstructionSet;
pub(crate) use contacts::Contacts;
pub use model::Model;
pub use right_hand_side::RightHandSide;
pub(crate) use space::BallContacts;

#[cfg(test)]
mod tests;
