//! All tests of the command, as one program.

mod bad_input;
mod bad_plans;
mod comfort;
mod commands;
mod common;
mod compare;
mod drops;
mod endings;
mod export;
mod former_names;
mod limits;
mod paper_structures;
mod pins;
mod places;
mod rotor_files;
mod rotors;
mod search;
mod space;
mod statements;
mod studio;
mod studio_requests;
mod sweeps;
mod terminal;
mod tolerance;
mod verdicts;
mod verify;
