//! The equations of motion, Zhao 2022, Eq. (12) to (22), in both profiles.

mod contacts;
mod equations;
mod instruction_set;
mod lanes;
mod model;
mod parameters;
mod right_hand_side;

pub use contacts::Contacts;
pub use instruction_set::InstructionSet;
pub use model::Model;
pub use right_hand_side::RightHandSide;
