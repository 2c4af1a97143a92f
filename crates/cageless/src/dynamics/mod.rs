//! The equations of motion, Zhao 2022, Eq. (12) to (22), in both profiles.

mod lanes;
mod model;
mod right_hand_side;

pub use model::Model;
pub use right_hand_side::{InstructionSet, RightHandSide};
