//! The vector harness: the scalar functions of [`crate::contact`] and [`crate::dynamics`]
//! called lane by lane, compiled for every instruction set.
//!
//! A block holds [`LANES`](crate::numerics::lanes::LANES) numbers: neighbouring balls of one
//! bearing, or two balls of each of several bearings. A loop over its lanes loads plain
//! structs of `f64`, calls one branch-free function and stores the result; the compiler makes
//! vector code of it. No operation depends on the width of a vector and none is fused, so
//! every instruction set gives the same bits.

mod beginning;
mod creep;
mod edges;
mod film;
mod film_block;
mod flank_polynomials;
mod flanks;
mod friction;
mod geometry;
mod harness;
mod hysteresis;
mod implicit_friction;
mod instruction_set;
mod motions;
mod pairs;
mod parameters;
pub(crate) mod published;
mod rotor;
mod sums;
mod traction;
mod workspace;

pub(crate) use edges::{PER_DEPTH, PER_SINE_SQUARE, edges, rotor_edges};
pub(crate) use harness::{add_implicit_friction, evaluate};
pub(crate) use implicit_friction::add_given_friction;
pub use instruction_set::InstructionSet;
pub(crate) use instruction_set::with_instructions;
pub(crate) use motions::{Motions, block_at, block_mut};
pub(crate) use parameters::Parameters;
pub(crate) use workspace::{BlockResults, Workspace};
