//! All tests of the studies, as one program.

mod drops;
mod random_cases;
mod rotor_drops;
mod rotor_sweeps;
mod run_results;
mod studies;
mod sweep_collection;
mod sweep_variants;
