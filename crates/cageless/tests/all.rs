//! Tests of the library from outside, as a user of the crate sees it, as one program. `memory.rs` counts what it
//! allocates; `inside/` is compiled with the library and tests what is not public.

mod automatic_step;
mod border;
mod common;
mod documentation;
mod endurance;
mod falling_ring;
mod fit;
mod front_door;
mod imports;
mod one_place;
mod own_laws;
mod raceway_contact;
mod recorder;
mod static_minimum;
mod stepping;
