//! Tests of what is not public. The library compiles them with its unit tests.

mod elastic_flanks;
mod film_verdict;
mod given_over_time;
mod perturbed_run;
mod search;
mod slot_design;
mod space_design;
mod tolerance;
mod verdict;
