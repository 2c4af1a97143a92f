//! All tests of the studies, as one program.

mod announced;
mod design_result;
mod drops;
mod held_gaps;
mod random_cases;
mod rotor_drops;
mod rotor_sweeps;
mod run_results;
mod static_values;
mod stationarity;
mod studies;
mod succession;
mod sweep_analysis;
mod sweep_collection;
mod sweep_variants;
