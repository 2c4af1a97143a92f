//! The outer ring for CAD and machining: STEP, STL and a table of points, in millimetres
//! and in the frame of the bearing (+Y up, the axis along Z, ψ from −Y counter-clockwise).

mod brep;
mod export;
mod format;
mod numbers;
mod outside_faces;
mod part21;
mod points;
mod slot_faces;
mod step;
mod stl;

pub use export::{
    Export, ExportError, ExportOptions, blend_not_simulated, export, names_file, outer_ring,
};
pub use format::Format;
pub use numbers::{Counts, ExportNumbers, SlotNumbers};
pub use part21::DateError;
