//! The equations of motion, Zhao 2022, Eq. (12) to (22), in both profiles: bodies, state,
//! energy, and the right-hand side over them.

pub mod ball;
mod contacts;
pub mod coordinates;
pub mod energy;
pub(crate) mod inner_ring;
pub(crate) mod model;
mod right_hand_side;
pub mod state;

pub use crate::simd::InstructionSet;
pub use contacts::Contacts;
pub use model::Model;
pub(crate) use model::STICK_FRACTION;
pub use right_hand_side::RightHandSide;
